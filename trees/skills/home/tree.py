"""Go to the home posture."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from kinematics.ik.gaze import gaze_joints
from trees.leaves.go_home import GoHome
from trees.nodes.arrival import is_told_to_be_home
from trees.nodes.best_effort import BestEffort
from trees.nodes.ports import ports
from trees.nodes.skipping import Skipping
from trees.skills.home.leave_object import leave_what_stands
from trees.skills.home.lift_clear import LiftClear
from trees.skills.looking.aiming_leaf import AimingLeaf
from trees.skills.looking.survey import Survey
from trees.toolbox import Toolbox


class IfNothingIsKnown(Skipping):
    """Ticks its child if nothing has been seen yet and the body is not at home; otherwise succeeds at once.

    This is so when a program has taken over a robot that another one left in the middle of a task.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour, toolbox: Toolbox) -> None:
        super().__init__(f"{child.name} if nothing is known", child)
        self._toolbox = toolbox

    def needed(self) -> bool:
        """Whether hands would move among what nobody has seen."""
        scene = self._toolbox.world.scene
        return not (scene.objects or scene.attached or is_told_to_be_home(self._toolbox))


class LookAtHands(AimingLeaf):
    """Turn the head to between the hands, and move nothing else.

    What is around the trunk is not known yet, so it must not move.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()

    def joints(self) -> Mapping[str, float]:
        """The head joints' goal, rad."""
        model, q = self.toolbox.model, self.toolbox.motion.reference()
        places = [model.frame_pose(q, frame)[:3, 3] for frame in model.description.tcp_frames.values()]
        return gaze_joints(model, q, np.mean(places, axis=0))


def go_home(toolbox: Toolbox) -> Behaviour:
    """Bring the whole body home; hands keep what they hold.

    Who took over a robot that another one left over a table looks first where its hands are, and takes its
    fingers off what stands between them.
    """
    looks: list[Behaviour] = [
        LookAtHands("look at the hands", toolbox),
        Survey("see what is about them", toolbox, {"sightings_now": "sightings"}),
        leave_what_stands(toolbox),
    ]
    look = Sequence("look", memory=True, children=looks)
    children = [
        IfNothingIsKnown(BestEffort(look), toolbox),
        BestEffort(LiftClear("lift it clear", toolbox)),
        GoHome("move home", toolbox),
    ]
    return Sequence("go home", memory=True, children=children)
