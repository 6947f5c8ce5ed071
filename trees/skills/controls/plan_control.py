"""Plan to turn a knob, or to come to a button."""

from __future__ import annotations

from math import cos as _cosine
from math import sin as _sine

from py_trees.ports import PortInformation

from kinematics.model.robot_description import Hand
from kinematics.requests.control import ControlPlan, ControlRequest, TurnPlan, TurnRequest
from kinematics.requests.grasp import Grasp
from robots.scenes.furniture_names import KNOB
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.job_leaf import PlanningLeaf
from trees.nodes.ports import ports
from trees.port_values import Step
from trees.readings.odometry import feet_pose
from trees.skills.controls.control_target import ON_RAD, ControlTarget
from trees.tasks import Task, TurnKnobTask
from trees.toolbox import Toolbox

BUTTON_SHORT_M = 0.035
"""A hand that feels its way to a button begins so far before it."""


def hand_for(toolbox: Toolbox, control: ControlTarget, task: Task) -> tuple[Hand, ...]:
    """The hand that is named, else those of the robot, the one on the control's side first."""
    named: Hand | None = getattr(task, "hand", None)
    if named is not None:
        return (named,)
    has = toolbox.model.description.gripping_hands
    x, y = (float(value) for value in control.odom_T_control[:2, 3])
    body = feet_pose(toolbox)
    aside = -(x - body.x_m) * _sine(body.yaw_rad) + (y - body.y_m) * _cosine(body.yaw_rad)
    first: Hand = "left" if aside > 0.0 else "right"
    return tuple(sorted(has, key=lambda hand: hand != first))


def turn_for(task: Task, control: ControlTarget) -> float:
    """How far a knob has to be turned, rad, clockwise for who looks at it."""
    off = isinstance(task, TurnKnobTask) and task.off
    return -control.turned_rad if off else ON_RAD - control.turned_rad


class PlanControl(PlanningLeaf[ControlPlan]):
    """Have the planner find a way for a hand to a knob, and to turn it; or to before a button."""

    INPUT_PORTS = ports(
        task=object,
        control=ControlTarget,
        tried=PortInformation(frozenset, default_value=frozenset()),
    )
    OUTPUT_PORTS = ports(grasp=Grasp, reach=Step, approach=Step, short_m=float)
    CONTRACT = Contract(
        precondition="the knob or button is in the world model; the robot is at rest",
        postcondition="reach starts at the reference, approach follows on; of a knob, the hand was found "
        "to be able to turn it from there",
        deadline_s=20.0,
    )

    def request(self) -> ControlRequest | Failure:
        """Of a knob how far it has to be turned; of a button where feeling begins."""
        toolbox, control, task = self.toolbox, self.get_input("control"), self.get_input("task")
        if not control.faces_front:
            return Failure.infeasible(f"the {control.called} faces up or down: I reach what faces me")
        if control.name not in toolbox.world.scene.objects:
            return Failure.infeasible(f"the {control.called} is not in the world model any more")
        knob = control.kind == KNOB
        turn = turn_for(task, control) if knob else None
        return ControlRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            control=control.name,
            turn_rad=turn,
            short_m=0.0 if knob else BUTTON_SHORT_M,
            hands=hand_for(toolbox, control, task) if knob else hand_for(toolbox, control, task)[:1],
            excluded=self.get_input("tried"),
            seed=int(toolbox.rng.integers(2**31)),
        )

    def planned(self, plan: ControlPlan) -> None:
        """Write the way and its steps."""
        self._set_output("grasp", plan.grasp)
        self._set_output("short_m", plan.short_m)
        self.write_step("reach", plan.reach)
        self.write_step("approach", plan.approach)
        self.feedback_message = f"{plan.grasp.hand} hand, {plan.grasp.label}"
        self.measured(hand=plan.grasp.hand, grasp=plan.grasp.label, considered=plan.considered)


class PlanTurn(PlanningLeaf[TurnPlan]):
    """Have the planner find the turn of a knob from where the hand holds it."""

    INPUT_PORTS = ports(task=object, control=ControlTarget, grasp=Grasp)
    OUTPUT_PORTS = ports(turn=Step, back=Step)
    CONTRACT = Contract(
        precondition="the hand holds the knob; the robot is at rest",
        postcondition="turn starts at the reference, back follows on",
        deadline_s=20.0,
    )

    def request(self) -> TurnRequest | Failure:
        """As far as it has to be turned."""
        toolbox, control = self.toolbox, self.get_input("control")
        grasp: Grasp = self.get_input("grasp")
        return TurnRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            control=control.name,
            hand=grasp.hand,
            turn_rad=turn_for(self.get_input("task"), control),
        )

    def planned(self, plan: TurnPlan) -> None:
        """Write both steps."""
        self.write_step("turn", plan.turn)
        self.write_step("back", plan.back)
