"""A motion of joints that somebody outside has planned: judged like the robot's own, then carried out.

It is no skill: nobody says it, a program hands it in.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence

from kinematics.errors import TrajectoryDocumentError
from kinematics.formats.joint_motion import JointMotion, whole_motion
from trees.failures import Failure, FailureKind
from trees.leaves.check_trajectory import CheckTrajectory
from trees.leaves.stream_motion import StreamMotion
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.port_values import Step
from trees.toolbox import Toolbox


@dataclass(frozen=True, slots=True)
class FollowTrajectoryTask:
    """Move joints as somebody else has planned.

    Attributes:
        text: What it is called.
        motion: The joints over time; too long to be told.
    """

    text: str
    motion: JointMotion = field(repr=False)

    action = "follow_trajectory"


class ArrangeMotion(Leaf):
    """Make a motion of the whole robot out of the one of the task, from where the robot stands."""

    INPUT_PORTS = ports(task=FollowTrajectoryTask)
    OUTPUT_PORTS = ports(step=Step)
    CONTRACT = Contract(
        precondition="the motion begins where its joints are, or later than at once",
        postcondition="there is a motion of every joint, made for the present scene",
        deadline_s=5.0,
    )

    def step(self) -> Status | Failure:
        """Compare it with the robot."""
        toolbox, task = self.toolbox, self.get_input("task")
        scene = toolbox.world.scene
        try:
            whole = whole_motion(
                task.motion, toolbox.model, toolbox.motion.reference(), toolbox.motion.stance()
            )
        except TrajectoryDocumentError as unfit:
            return Failure(FailureKind.REFUSED, str(unfit))
        self._set_output("step", Step("the trajectory", whole, scene, scene.version))
        return DONE


def follow_trajectory(toolbox: Toolbox) -> Behaviour:
    """Arrange it, have it checked, stream it. Reads "task"; the robot holds its end."""
    children: list[Behaviour] = [
        ArrangeMotion("arrange", toolbox),
        CheckTrajectory("check", toolbox),
        StreamMotion("stream", toolbox),
    ]
    return Sequence("follow the trajectory", memory=True, children=children)
