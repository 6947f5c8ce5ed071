"""Choose a grasp and plan the whole pick."""

from __future__ import annotations

from py_trees.ports import PortInformation

from kinematics.model.robot_description import Hand
from kinematics.requests.grasp import Grasp
from kinematics.requests.pick import PickPlan, PickRequest
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.job_leaf import PlanningLeaf
from trees.nodes.ports import ports
from trees.port_values import Step, Target
from trees.tasks import PickTask

# So many grasps of one hand in vain, and it is the other one's turn.
_GRASPS_A_HAND = 2


class PlanPick(PlanningLeaf[PickPlan]):
    """Have the planner choose hand and grasp, and plan reach, approach and lift from the posture of now."""

    INPUT_PORTS = ports(
        task=PickTask, target=Target, tried=PortInformation(frozenset, default_value=frozenset())
    )
    OUTPUT_PORTS = ports(grasp=Grasp, reach=Step, approach=Step, lift=Step)
    CONTRACT = Contract(
        precondition="the target is an object of the world model; the robot is at rest",
        postcondition="reach starts at the reference and ends looking at the target; approach and lift "
        "follow on, so nothing else may move the body in between; all are for the present scene",
        deadline_s=20.0,
    )

    def request(self) -> PickRequest | Failure:
        """Either hand, unless one is named or has failed enough; no grasp that was tried in vain."""
        toolbox, task, tried = self.toolbox, self.get_input("task"), self.get_input("tried")
        name = self.get_input("target").name
        if name not in toolbox.world.scene.objects:  # a look since then has shown something else there
            return Failure.postcondition(f"the {name} is no longer there").because(Reason.GONE_SINCE_LOOK)
        return PickRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            target=name,
            hands=hands_to_try(task.hand, tried, self._occupied(), toolbox.model.description.gripping_hands),
            excluded=tried,
            lift_m=toolbox.policy.lift_m,
            seed=int(toolbox.rng.integers(2**31)),
        )

    def _occupied(self) -> frozenset[Hand]:
        """Hands that hold something, as the world model has it."""
        frames = {body.frame for body in self.toolbox.world.scene.attached.values()}
        grippers = self.toolbox.model.description.grippers
        return frozenset(hand for hand, gripper in grippers.items() if gripper.tcp_frame in frames)

    def planned(self, plan: PickPlan) -> None:
        """Write grasp and steps."""
        self._set_output("grasp", plan.grasp)
        self.write_step("reach", plan.reach)
        self.write_step("approach", plan.approach)
        self.write_step("lift", plan.lift)
        self.feedback_message = f"{plan.grasp.hand} hand, {plan.grasp.label}"
        self.measured(hand=plan.grasp.hand, grasp=plan.grasp.label, considered=plan.considered)


def hands_to_try(
    named: Hand | None, tried: frozenset[str], occupied: frozenset[Hand], hands: tuple[Hand, ...]
) -> tuple[Hand, ...]:
    """Which hands the planner may use.

    Args:
        named: The hand that the task asks for, or None.
        tried: Grasps that were tried in vain, as "hand label".
        occupied: Hands that hold something already; they are left alone as long as another is free.
        hands: Those that the robot has.
    """
    if named is not None:
        return (named,)
    free = tuple(hand for hand in hands if hand not in occupied) or hands
    failed = {hand: sum(key.startswith(f"{hand} ") for key in tried) for hand in free}
    rested = tuple(hand for hand in free if failed[hand] < _GRASPS_A_HAND)
    return rested or free
