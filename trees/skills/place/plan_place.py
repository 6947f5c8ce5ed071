"""Choose a spot and plan the way to it."""

from __future__ import annotations

from typing import Any

from py_trees.ports import PortInformation

from kinematics.geometry import poses
from kinematics.requests.place import PlacePlan, PlaceRequest
from kinematics.requests.step import NoPlan
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.job_leaf import JobLeaf
from trees.nodes.plan_failures import no_plan_failure
from trees.nodes.ports import ports
from trees.port_values import Placement, Step


class PlanPlace(JobLeaf):
    """Have the planner choose one of the spots, and plan the motion to it and the way down."""

    INPUT_PORTS = ports(
        held=HeldObject, spots=tuple, blocked=PortInformation(frozenset, default_value=frozenset())
    )
    OUTPUT_PORTS = ports(placement=Placement, transfer=Step, lower=Step)
    CONTRACT = Contract(
        precondition="the object is an attached body; the robot is at rest",
        postcondition="transfer starts at the reference; lowering follows on; both are for the present scene",
        deadline_s=20.0,
    )

    def request(self) -> PlaceRequest:
        """Every spot but those that turned out to be blocked."""
        toolbox, blocked = self.toolbox, self.get_input("blocked")
        self._world_version = toolbox.world.scene.version
        self._spots = tuple(spot for spot in self.get_input("spots") if _key(spot) not in blocked)
        return PlaceRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            held=self.get_input("held").name,
            spots=self._spots,
            retreat_m=toolbox.policy.retreat_m,
            seed=int(toolbox.rng.integers(2**31)),
        )

    def accept(self, answer: Any) -> Failure | None:
        """Write placement and steps."""
        if isinstance(answer, NoPlan):
            return no_plan_failure(answer)
        if not isinstance(answer, PlacePlan):
            raise TypeError(f"the planner answered {type(answer).__name__} to a place")
        spot = self._spots[answer.spot]
        self._set_output("placement", Placement(answer.hand, answer.world_T_object, spot.touches, _key(spot)))
        for port, step in (("transfer", answer.transfer), ("lower", answer.lower)):
            self._set_output(port, Step.of(step, self._world_version))
        x, y, z = (float(value) for value in answer.world_T_object[:3, 3])
        self.feedback_message = f"to {x:.2f}, {y:+.2f} m"
        yaw = poses.yaw_of(answer.world_T_object[:3, :3])
        self.measured(spot=answer.spot, considered=answer.considered, x_m=x, y_m=y, z_m=z, yaw_rad=yaw)
        return None


def _key(spot: Any) -> tuple[float, float]:
    x, y = spot.world_T_object[:2, 3]
    return round(float(x), 3), round(float(y), 3)
