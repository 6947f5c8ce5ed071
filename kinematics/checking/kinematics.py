"""Forward kinematics of many configurations in one pass, for the trajectory checker."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.checking.timeline import Configurations
from kinematics.errors import ModelError
from kinematics.model.robot_model import RobotModel

WORLD = 0
"""Index of the world among the bodies."""
BASE = 1
"""Index of the floating base."""
_FIRST_JOINT = 2


@dataclass(frozen=True, slots=True)
class BodyPoses:
    """Poses of all bodies (Pinocchio's joint frames; 0 is the world) at n instants.

    Attributes:
        rotation: ``world_R_body``, shape (bodies, n, 3, 3).
        origin_m: Origin of the body's frame in the world, shape (bodies, n, 3).
        com_m: Centre of mass in the world, shape (n, 3), where it is known.
    """

    rotation: Array
    origin_m: Array
    com_m: Array | None = None


class BatchedKinematics:
    """Forward kinematics of a robot at many instants at once: its kinematic tree as arrays.

    Attributes:
        parent: Parent body of each body.
        offset_m: Origin of each body in its parent's frame, shape (bodies, 3).
        axis: Joint axis in the body's own frame, shape (bodies, 3).
        fixed, sine, versine: Rotation of a body in its parent's frame as a sum of these, times 1, the
            sine and one less the cosine of its joint's angle, shape (bodies, 3, 3).
        mass_kg, lever_m: Mass of each body and its centre in the body's frame, shapes (bodies,) and
            (bodies, 3).
        inertia: Of each body about that centre, in the body's axes, shape (bodies, 3, 3), kg m^2.

    Raises:
        ModelError: A joint other than the floating base is not a hinge.
    """

    def __init__(self, model: RobotModel) -> None:
        tree = model.pin
        self.count = int(tree.njoints)
        self.parent = [int(parent) for parent in tree.parents]
        self.offset_m = np.array([np.array(place.translation) for place in tree.jointPlacements])
        self.axis = np.zeros((self.count, 3))
        self.fixed = np.zeros((self.count, 3, 3))
        self.sine = np.zeros((self.count, 3, 3))
        self.versine = np.zeros((self.count, 3, 3))
        for body in range(_FIRST_JOINT, self.count):
            subspace = np.array(tree.joints[body].createData().S).reshape(6, -1)
            hinge = subspace.shape[1] == 1 and not subspace[:3].any()
            if not hinge or abs(np.linalg.norm(subspace[3:]) - 1.0) > 1e-9:
                raise ModelError(f"joint {tree.names[body]!r} is not a hinge")
            axis = subspace[3:, 0]
            skew = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
            placement = np.array(tree.jointPlacements[body].rotation)
            self.axis[body] = axis
            # Rodrigues' formula with the constant placement multiplied in
            self.fixed[body] = placement
            self.sine[body] = placement @ skew
            self.versine[body] = placement @ skew @ skew
        self.mass_kg = np.array([float(inertia.mass) for inertia in tree.inertias])
        self.lever_m = np.array([np.array(inertia.lever) for inertia in tree.inertias])
        self.inertia = np.array([np.array(inertia.inertia) for inertia in tree.inertias])

    def chain(self, body: int) -> list[int]:
        """Bodies from ``body`` up to the floating base, both included; empty for the world."""
        chain = []
        while body != WORLD:
            chain.append(body)
            body = self.parent[body]
        return chain

    def reaches(self, body: int, reach_m: float, axis_reach_m: float) -> list[float]:
        """How far any point of a solid can be from the axis of each body of its chain, m.

        The farthest distance over all configurations: offsets along the chain add up. Of the base it
        is the distance from its origin.

        Args:
            body: What carries the solid.
            reach_m, axis_reach_m: The farthest that a point is from that body's origin and axis.
        """
        reaches: list[float] = []
        reach, from_axis = reach_m, axis_reach_m
        for below in self.chain(body):
            if below == BASE:
                return [*reaches, reach]
            reaches.append(from_axis)
            parent, offset = self.parent[below], self.offset_m[below]
            axis = self.axis[parent]
            from_axis = float(np.linalg.norm(offset - axis * (axis @ offset))) + reach
            reach += float(np.linalg.norm(offset))
        return reaches

    def carrying(self, model: RobotModel, masses: Sequence[tuple[str, float, Array]]) -> Self:
        """The same robot with point masses, each a frame, its mass in kg and its place there, shape (3,).

        Raises:
            UnknownNameError: There is no such frame.
        """
        heavier = copy.copy(self)
        heavier.mass_kg, heavier.lever_m = self.mass_kg.copy(), self.lever_m.copy()
        heavier.inertia = self.inertia.copy()
        for name, mass_kg, point_m in masses:
            frame = model.pin.frames[model.frame_id(name)]
            body = int(frame.parentJoint)
            own = pin.Inertia(heavier.mass_kg[body], heavier.lever_m[body], heavier.inertia[body])
            total = own + pin.Inertia(mass_kg, frame.placement.act(point_m), np.zeros((3, 3)))
            heavier.mass_kg[body], heavier.lever_m[body] = total.mass, total.lever
            heavier.inertia[body] = total.inertia
        return heavier

    def poses(self, configurations: Configurations, bodies: frozenset[int] | None = None) -> BodyPoses:
        """Poses of all bodies, or of some and all that they hang on; the rest is left undefined."""
        n = len(configurations.t_s)
        rotation = np.empty((self.count, n, 3, 3))
        origin = np.empty((self.count, n, 3))
        rotation[WORLD], origin[WORLD] = np.eye(3), 0.0
        rotation[BASE] = configurations.base_rotation
        origin[BASE] = configurations.base_position_m
        wanted = range(self.count) if bodies is None else {b for body in bodies for b in self.chain(body)}
        angles = configurations.joints_rad.T
        sine, versine = np.sin(angles), 1.0 - np.cos(angles)
        for body in sorted(wanted):
            if body < _FIRST_JOINT:
                continue
            k, parent = body - _FIRST_JOINT, self.parent[body]
            turn = sine[k][:, None, None] * self.sine[body]
            turn += versine[k][:, None, None] * self.versine[body]
            turn += self.fixed[body]
            np.matmul(rotation[parent], turn, out=rotation[body])
            np.matmul(rotation[parent], self.offset_m[body], out=origin[body])
            origin[body] += origin[parent]
        return BodyPoses(rotation, origin)

    def com(self, poses: BodyPoses) -> Array:
        """Centre of mass in the world, shape (n, 3)."""
        if poses.com_m is not None:
            return poses.com_m
        levers = np.einsum("b,bnij,bj->ni", self.mass_kg, poses.rotation, self.lever_m, optimize=True)
        origins = np.einsum("b,bni->ni", self.mass_kg, poses.origin_m)
        return np.asarray((levers + origins) / self.mass_kg.sum(), dtype=np.float64)
