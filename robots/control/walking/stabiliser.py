"""Keeps a walk upright: compares what the sensors say with the pattern, and corrects by efforts."""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.walking_settings import WalkingSettings
from kinematics.motion.sampler import MotionSample
from kinematics.walking.body.attitude import righting_moment
from kinematics.walking.body.foot_wrenches import WrenchDistribution
from kinematics.walking.body.legged_estimator import LeggedEstimator
from kinematics.walking.body.walking_dynamics import WalkingDynamics
from kinematics.walking.pattern.dcm import Point
from kinematics.walking.pattern.pattern_sample import PatternSample
from robots.interface.hardware import WalkingGains


class Stabiliser:
    """Feed-forward efforts that carry a walk out and bring its DCM back.

    Joint references are the plan's; what is measured enters through the efforts alone.

    Attributes:
        error: The DCM's error of the last period in the plan's frame, m.
        velocity: Of the CoM, as measured, in that frame, m/s.
    """

    def __init__(
        self, model: RobotModel, settings: WalkingSettings, gains: WalkingGains, omega: float
    ) -> None:
        soles = {sole.side: sole for sole in model.description.soles}
        self._distribution = WrenchDistribution(settings, soles, model.mass_kg, omega)
        self._dynamics = WalkingDynamics(model)
        self._gains, self._omega = gains, omega
        self._most = gains.effort_share * model.effort
        self.error: Point = (0.0, 0.0)
        self.velocity: Point = (0.0, 0.0)

    def efforts(self, pattern: PatternSample, motion: MotionSample, measured: LeggedEstimator) -> Array:
        """Efforts of the body joints for one instant, Nm, shape (n,).

        Args:
            pattern: The plan's instant.
            motion: The same as a motion of all joints.
            measured: What the sensors say.
        """
        shares = self._shares(pattern, measured)
        x = y = vx = vy = 0.0
        for side, share in shares.items():
            seen, foot = measured.com_from(side), pattern.feet[side]
            px, py, _ = seen.position_m.tolist()
            sx, sy, _ = seen.velocity_m_s.tolist()
            c, s = math.cos(foot.yaw_rad), math.sin(foot.yaw_rad)
            x += share * (foot.x_m + c * px - s * py)
            y += share * (foot.y_m + s * px + c * py)
            vx += share * (c * sx - s * sy)
            vy += share * (s * sx + c * sy)
        self.velocity = vx, vy
        w, dcm = self._omega, pattern.com.dcm
        self.error = (x + vx / w - dcm[0], y + vy / w - dcm[1])
        wanted = self._distribution.wrenches(
            pattern.com.zmp,
            self.error,
            (x - pattern.com.pivot[0], y - pattern.com.pivot[1]),
            pattern.feet,
            pattern.carrying,
            self._righting(pattern, motion, measured, max(shares, key=lambda side: shares[side])),
        )
        efforts = self._dynamics.efforts(motion, wanted.soles)
        return np.clip(efforts, -self._most, self._most)

    def _shares(self, pattern: PatternSample, measured: LeggedEstimator) -> dict[Hand, float]:
        """How much each foot's view counts: by its load, among those that the plan has on the floor."""
        loads = {side: measured.loads_n[side] for side in pattern.carrying}
        total = sum(loads.values())
        if total <= 0.0:
            return {side: 1.0 / len(loads) for side in loads}
        return {side: load / total for side, load in loads.items()}

    def _righting(
        self, pattern: PatternSample, motion: MotionSample, measured: LeggedEstimator, side: Hand
    ) -> Array:
        """Moment that turns the trunk to where the plan has it, shape (3,)."""
        s = self._gains
        heading = pattern.feet[side].yaw_rad + measured.com_from(side).heading_rad
        return righting_moment(
            measured.odom_R_base,
            heading,
            motion.q[3:7],
            measured.turn_rad_s,
            float(motion.v[5]),
            s.trunk_stiffness_nm,
            s.trunk_damping_nms,
        )
