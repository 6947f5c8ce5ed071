"""Choose a spot and plan the way to it."""

from __future__ import annotations

from py_trees.ports import PortInformation

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.model.stance import Stance
from kinematics.requests.place import PlacePlan, PlaceRequest, Spot
from trees.beliefs.scene.held_object import HeldObject
from trees.nodes.contract import Contract
from trees.nodes.job_leaf import PlanningLeaf
from trees.nodes.ports import ports
from trees.port_values import Placement, Step
from trees.toolbox import Toolbox


class PlanPlace(PlanningLeaf[PlacePlan]):
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
        self._spots = tuple(spot for spot in self.get_input("spots") if _key(spot) not in blocked)
        motion = toolbox.motion
        return place_request(
            toolbox, self.get_input("held"), self._spots, motion.reference(), motion.stance()
        )

    def planned(self, plan: PlacePlan) -> None:
        """Write placement and steps."""
        spot = self._spots[plan.spot]
        self._set_output("placement", Placement(plan.hand, plan.world_T_object, spot.touches, _key(spot)))
        self.write_step("transfer", plan.transfer)
        self.write_step("lower", plan.lower)
        x, y, z = (float(value) for value in plan.world_T_object[:3, 3])
        self.feedback_message = f"to {x:.2f}, {y:+.2f} m"
        yaw = poses.yaw_of(plan.world_T_object[:3, :3])
        self.measured(spot=plan.spot, considered=plan.considered, x_m=x, y_m=y, z_m=z, yaw_rad=yaw)


def place_request(
    toolbox: Toolbox, held: HeldObject, spots: tuple[Spot, ...], q: Array, stance: Stance, quick: bool = False
) -> PlaceRequest:
    """Ask for a placing amid what is believed.

    Args:
        toolbox: Knows that, and deals the seed.
        held: What is to be put down.
        spots: Where it could be.
        q, stance: From which posture, shape (nq,), and on which feet.
        quick: As for ``PlaceRequest``.
    """
    return PlaceRequest(
        q_start=q,
        stance=stance,
        scene=toolbox.world.scene,
        held=held.name,
        spots=spots,
        retreat_m=toolbox.policy.retreat_m,
        quick=quick,
        seed=int(toolbox.rng.integers(2**31)),
    )


def _key(spot: Spot) -> tuple[float, float]:
    x, y = spot.world_T_object[:2, 3]
    return round(float(x), 3), round(float(y), 3)
