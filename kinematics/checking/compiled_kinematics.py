"""Forward kinematics of the trajectory checker, compiled."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array, Indices, as_float64
from kinematics.checking.compiled_effort import loads_of
from kinematics.checking.compiled_placing import FIRST_JOINT, Links, place_all
from kinematics.checking.kinematics import WORLD, BatchedKinematics, BodyPoses
from kinematics.checking.plain_limits import plainly_within
from kinematics.checking.settings import CheckSettings
from kinematics.checking.timeline import Configurations, Timeline
from kinematics.model.robot_model import RobotModel


class CompiledKinematics(BatchedKinematics):
    """The forward kinematics of ``BatchedKinematics`` in compiled code, ten times as fast.

    Attributes:
        links: The tree for other compiled code.
    """

    def __init__(self, model: RobotModel) -> None:
        super().__init__(model)
        self.links = Links(
            parent=np.array(self.parent, np.int64),
            offset=as_float64(self.offset_m),
            axis=self.axis,
            fixed=self.fixed,
            sine=self.sine,
            versine=self.versine,
        )

    def poses(self, configurations: Configurations, bodies: frozenset[int] | None = None) -> BodyPoses:
        """Poses of all bodies, or of some and all that they hang on; the rest is left undefined."""
        n = len(configurations.t_s)
        needed = np.ones(self.count, np.int64)
        if bodies is not None:
            needed[:] = 0
            needed[[WORLD, *(b for body in bodies for b in self.chain(body))]] = 1
        rotation, origin = np.empty((self.count, n, 3, 3)), np.empty((self.count, n, 3))
        place_all(
            self.links,
            as_float64(configurations.base_rotation),
            as_float64(configurations.base_position_m),
            as_float64(configurations.joints_rad),
            needed,
            self.mass_kg,
            self.lever_m,
            rotation,
            origin,
            moment := np.empty((n, 3)),
        )
        com = moment / self.mass_kg.sum() if bodies is None else None
        return BodyPoses(rotation, origin, com)

    def loads(
        self, poses: BodyPoses, v: Array, a: Array, feet: Indices, soles_m: Array, share: Array
    ) -> tuple[Array, Array]:
        """Joint torques, shape (n, joints), and the ZMP, shape (n, 2), of a robot on its soles.

        Args:
            poses: Of all bodies at n instants.
            v, a: Velocities and accelerations there, in Pinocchio's convention, shape (n, nv).
            feet: Bodies of the m soles, shape (m,).
            soles_m: Where these stand, shape (m, 3).
            share: Their parts of the wrench of the ground for each ZMP (x, y, 1), shape (m, 3).
        """
        torques, zmp = np.empty((len(v), self.count - FIRST_JOINT)), np.empty((len(v), 2))
        loads_of(
            self.links,
            self.mass_kg,
            self.lever_m,
            self.inertia,
            poses.rotation,
            poses.origin_m,
            as_float64(v),
            as_float64(a),
            feet,
            soles_m,
            share,
            torques,
            zmp,
        )
        return torques, zmp

    @staticmethod
    def keeps_limits(model: RobotModel, timeline: Timeline, settings: CheckSettings) -> bool:
        """Tell whether joints plainly keep all limits; when not, ``check_limits`` has to look closer."""
        if settings.discontinuity_factor < 1.0 + settings.acceleration_fraction:
            return False
        return plainly_within(
            as_float64(timeline.t_s),
            as_float64(timeline.joints_rad),
            as_float64(timeline.joint_velocity),
            model.lower_rad - settings.position_rad,
            model.upper_rad + settings.position_rad,
            model.velocity * (1.0 + settings.velocity_fraction),
            model.acceleration * (1.0 + settings.acceleration_fraction),
            model.jerk * (1.0 + settings.jerk_fraction),
            settings.jerk_window_s,
        )
