"""Room between the legs: what the planner's judges leave out, for the few configurations that are kept.

Standing motions hardly change it, so no search pays for it; in a squat with turned knees the thighs can
touch, and the trajectory checker would refuse the plan.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.compiled import readiness
from kinematics.model.robot_build import RobotBuild, robot_build
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.reserves import LEAST_RESERVE_M

if TYPE_CHECKING:
    from kinematics.kernel.collision_kernel import CollisionKernel
    from kinematics.kernel.robot_arrays import RobotArrays


class LegRoom(Protocol):
    """Tells how far a robot's legs are apart."""

    def too_near(self, q: Array) -> NDArray[np.bool_]:
        """Tell whether two links of the legs are nearer than the reserve, at each of q, shape (n, nq)."""
        ...

    def touches(self, q: Array) -> bool:
        """``too_near`` of one configuration, shape (nq,)."""
        ...

    def touching(self, q: Array) -> tuple[str, str] | None:
        """Names of two links that are nearer than the reserve at a configuration, shape (nq,), or None."""
        ...

    def clearances_m(self, q: Array) -> Array:
        """The smallest distance of two links of the legs that may not touch.

        Args:
            q: Configurations, shape (n, nq).

        Returns:
            Shape (n,), m; exact below twice the reserve, more than that where there is more room.
        """
        ...


def leg_room(model: RobotModel, reserve_m: float = LEAST_RESERVE_M) -> LegRoom | None:
    """The judge of a robot's legs, by the kernel where it is compiled; None when it has no such pairs.

    Args:
        model: The robot.
        reserve_m: Links of the legs that are nearer than this are too near.
    """
    return model.derived(_leg_room, reserve_m)


def _leg_room(model: RobotModel, reserve_m: float) -> LegRoom | None:
    geometry = _between_legs(model)
    if not len(geometry.collisionPairs):
        return None
    if not readiness.usable():
        return _CoalLegRoom(model, geometry, reserve_m)
    # imported here: it brings the compiler
    from kinematics.kernel.collision_kernel import CollisionKernel

    arrays = robot_build(model).derived(_leg_arrays)
    return _KernelLegRoom(CollisionKernel(arrays, PlanningScene(), self_margin_m=reserve_m), reserve_m)


def _leg_arrays(build: RobotBuild) -> RobotArrays:
    """Made once for all models of a robot: that takes as long as a whole pick."""
    from kinematics.kernel.robot_arrays import RobotArrays

    geometry = _between_legs(build.model)
    names = [build.model.link_of(item) for item in geometry.geometryObjects]
    return RobotArrays(build.model.pin, geometry, names)


def _between_legs(model: RobotModel) -> pin.GeometryModel:
    """The collision geometry of the legs alone, with the pairs that the planner's judges leave out."""
    whole, legs = model.geometry(), pin.GeometryModel()
    bodies = {
        int(model.pin.getJointId(joint))
        for group, joints in model.description.groups.items()
        if group.endswith("_leg")
        for joint in joints
    }
    number: dict[int, int] = {}
    for k, item in enumerate(whole.geometryObjects):
        if int(item.parentJoint) in bodies:
            number[k] = int(legs.addGeometryObject(item))
    for pair in whole.collisionPairs:
        if pair.first in number and pair.second in number:
            legs.addCollisionPair(pin.CollisionPair(number[pair.first], number[pair.second]))
    return legs


class _KernelLegRoom:
    def __init__(self, kernel: CollisionKernel, reserve_m: float) -> None:
        self._kernel, self._reserve_m = kernel, reserve_m

    def too_near(self, q: Array) -> NDArray[np.bool_]:
        return self._kernel.contacts(q)

    def touches(self, q: Array) -> bool:
        return self._kernel.collides(q)

    def touching(self, q: Array) -> tuple[str, str] | None:
        return self._kernel.colliding_pair(q)

    def clearances_m(self, q: Array) -> Array:
        return np.array([self._kernel.distances_m(row, 2.0 * self._reserve_m).min() for row in q])


class _CoalLegRoom:
    def __init__(
        self, model: RobotModel, geometry: pin.GeometryModel, reserve_m: float = LEAST_RESERVE_M
    ) -> None:
        self._model, self._geometry, self._reserve_m = model.pin, geometry, reserve_m
        self._names = [model.link_of(item) for item in geometry.geometryObjects]
        self._data, self._placed = model.pin.createData(), geometry.createData()
        for request in self._placed.distanceRequests:
            request.enable_signed_distance = True

    def too_near(self, q: Array) -> NDArray[np.bool_]:
        return np.asarray(self.clearances_m(q) <= self._reserve_m)

    def touches(self, q: Array) -> bool:
        return bool(self.too_near(q[None])[0])

    def touching(self, q: Array) -> tuple[str, str] | None:
        if not self.touches(q):
            return None
        distances_m = [result.min_distance for result in self._placed.distanceResults]
        pair = self._geometry.collisionPairs[int(np.argmin(distances_m))]
        return self._names[pair.first], self._names[pair.second]

    def clearances_m(self, q: Array) -> Array:
        found = []
        for row in q:
            pin.computeDistances(self._model, self._data, self._geometry, self._placed, row)
            found.append(min(result.min_distance for result in self._placed.distanceResults))
        return np.array(found)
