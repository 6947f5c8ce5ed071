"""Plan to take hold of a handle."""

from __future__ import annotations

from py_trees.ports import PortInformation

from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from kinematics.model.stance import Stance
from kinematics.requests.grasp import Grasp
from kinematics.requests.handle import HandlePlan, HandleRequest
from robots.scenes.articulated import DOOR
from trees.beliefs.openings.drawer_inside import without_drawn
from trees.beliefs.openings.handles import HandleTarget, beside_bar
from trees.nodes.contract import Contract
from trees.nodes.job_leaf import PlanningLeaf
from trees.nodes.ports import ports
from trees.port_values import Step
from trees.tasks import CloseTask, OpenTask
from trees.toolbox import Toolbox


class PlanHandle(PlanningLeaf[HandlePlan]):
    """Have the planner choose a grasp of the handle from which the hand can follow its whole path."""

    INPUT_PORTS = ports(
        task=object,
        handle=HandleTarget,
        tried=PortInformation(frozenset, default_value=frozenset()),
    )
    OUTPUT_PORTS = ports(grasp=Grasp, reach=Step, approach=Step, lead_to=float)
    CONTRACT = Contract(
        precondition="the handle is in the world model; the robot is at rest",
        postcondition="reach starts at the reference, approach follows on; from there the hand was found to "
        "reach every point of the handle's way",
        deadline_s=20.0,
    )

    def request(self) -> HandleRequest:
        """From where the robot stands, as it stands."""
        motion = self.toolbox.motion
        return handle_request(
            self.toolbox,
            self.get_input("task"),
            self.get_input("handle"),
            motion.reference(),
            motion.stance(),
            self.get_input("tried"),
        )

    def planned(self, plan: HandlePlan) -> None:
        """Write grasp and steps."""
        self._set_output("grasp", plan.grasp)
        self._set_output("lead_to", plan.lead_to)
        self.write_step("reach", plan.reach)
        self.write_step("approach", plan.approach)
        self.feedback_message = f"{plan.grasp.hand} hand, {plan.grasp.label}"
        self.measured(hand=plan.grasp.hand, grasp=plan.grasp.label, considered=plan.considered)


def handle_request(
    toolbox: Toolbox,
    task: OpenTask | CloseTask,
    target: HandleTarget,
    q_start: Array,
    stance: Stance,
    excluded: frozenset[str] = frozenset(),
) -> HandleRequest:
    """What the planner is asked: the hands of the target, unless the task names one.

    Args:
        toolbox: What is believed, and the robot.
        task: What is to be done.
        target: The door or drawer.
        q_start: Where it begins, shape (nq,).
        stance: Where the feet stand then.
        excluded: Grasps that were tried in vain.
    """
    if target.pushed and target.kind == DOOR:
        lead_to = -toolbox.model.description.pushing.past_rad
    else:
        lead_to = target.open_to if isinstance(task, OpenTask) else target.close_to
    scene = without_drawn(toolbox.world.scene, target.part)
    return HandleRequest(
        q_start=q_start,
        stance=stance,
        scene=scene,
        handle=target.handle,
        parts=tuple(dict.fromkeys((target.part, target.handle))),
        path=target.path,
        s_from=target.opening,
        s_to=lead_to,
        hands=_hands(toolbox, target) if task.hand is None else (task.hand,),
        excluded=excluded,
        seed=int(toolbox.rng.integers(2**31)),
        pushed=target.part if target.pushed else "",
        beside=() if target.pushed else beside_bar(target, scene),
    )


def _hands(toolbox: Toolbox, target: HandleTarget) -> tuple[Hand, ...]:
    """Those that suit the handle, as far as the robot has them; else those that it has."""
    robot = toolbox.model.description
    has = robot.gripping_hands
    if target.pushed and robot.pushing.before_m is not None:  # beyond a hinge the other has more room
        return tuple(sorted(has, key=lambda hand: hand in target.hands))
    return tuple(hand for hand in target.hands if hand in has) or has
