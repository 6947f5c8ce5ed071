"""One walk under way: pattern, floor, whole body, estimator and stabiliser, one period after the other."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance, stance_at
from kinematics.motion.sampler import MotionSample
from kinematics.walking.body.floor_finding import FloorFinding
from kinematics.walking.body.legged_estimator import LeggedEstimator
from kinematics.walking.body.level_soles import levelled
from kinematics.walking.body.whole_body import OutOfReachError, WholeBody
from kinematics.walking.pattern.pattern import WalkingPattern
from kinematics.walking.pattern.pattern_sample import PatternSample, Phase
from kinematics.walking.pattern.steering import quickened
from robots.control.gate.refusal import Refusal
from robots.control.streaming.motion_streamer import MotionStreamer
from robots.control.walking.fitted_ankles import FittedAnkles
from robots.control.walking.outside_force import OutsideForce
from robots.control.walking.push_watch import PushWatch
from robots.control.walking.soft_ankles import SoftAnkles
from robots.control.walking.stabiliser import Stabiliser
from robots.control.walking.walking_head import WalkingHead
from robots.interface.hardware import Hardware
from robots.interface.robot import RobotState

_AT_REST_PERIODS = 3
"""Periods at rest until the averaged references are at rest too."""


class Walk:
    """One walk under way, from rest to rest.

    Attributes:
        pattern: What the feet do.
        head: Turns to where the walk is told to look.
        held_back: What the body met in the last period, if that was anything.
    """

    def __init__(
        self,
        model: RobotModel,
        hardware: Hardware,
        streamer: MotionStreamer,
        gyro_at_rest: Array,
        period_s: float,
        quick: bool = False,
    ) -> None:
        """Stand.

        Args:
            model: The robot, with what it carries.
            hardware: Its gains.
            streamer: Knows where it stands.
            gyro_at_rest: What the gyro shows at rest, rad/s, shape (3,).
            period_s: Control period.
            quick: Whether in quicker, shorter steps.

        Raises:
            RuntimeError: The robot is not known to walk.
        """
        settings, gains = model.description.walking, hardware.walking
        if settings is None or gains is None:
            raise RuntimeError("the robot is not known to walk")
        settings = quickened(settings) if quick else settings
        self._model, self._period_s = model, period_s
        placed, q = levelled(model, streamer.reference(), dict(streamer.stance().soles))
        soles = {sole.side: sole for sole in model.description.soles}
        feet = {side: PlanarPose.of(placed[sole.frame]) for side, sole in soles.items()}
        self._body = WholeBody(model, q, feet, period_s, settings.first_shift_s)
        self.head = WalkingHead(model, q, period_s)
        com = model.com(q)
        home = {
            side: PlanarPose.of(model.frame_pose(model.q_home, sole.frame)) for side, sole in soles.items()
        }
        self.pattern = WalkingPattern(
            settings,
            soles,
            feet,
            (float(com[0]), float(com[1])),
            self._body.rest_m,
            home["left"].distance_m(home["right"]),
            self._body.omega,
            self._body.sway_s2,
        )
        self._stabiliser = Stabiliser(model, settings, gains, self._body.omega)
        anchors = {side: placed[sole.frame] for side, sole in soles.items()}
        self._estimator = LeggedEstimator(model, q, anchors, gyro_at_rest)
        self._soft_ankles = SoftAnkles(model, hardware.gains, gains)
        self._fitted_ankles = FittedAnkles(model, streamer.reference()[7:] - q[7:], period_s)
        self._floor = FloorFinding(
            {side: round(float(pose[2, 3]), 6) for side, pose in anchors.items()}, period_s
        )
        self._push_watch = PushWatch()
        sides = [sole.side for sole in model.description.soles]
        foot_error_n = 0.0 if model.description.foot_sensors else hardware.health.foot_error_n
        self._outside = OutsideForce(model.mass_kg, sides, period_s, foot_error_n)
        self.held_back: Refusal | None = None
        self._wrench: Array | None = None
        self._most = gains.effort_share * model.effort
        self._read: tuple[Array, Array] | None = None
        self._sample: PatternSample | None = None
        self._motion: MotionSample | None = None
        self._phase = Phase.REST
        self._rejoin: Rejoin | None = None
        self._rested: Array | None = None
        self._resting = 0

    @property
    def at_rest(self) -> bool:
        """Whether it is over."""
        rests = self._resting >= _AT_REST_PERIODS and self._motion is not None
        return rests and self._fitted_ankles.at_rest and self.head.at_rest

    def sense(self, readings: RobotState) -> Array:
        """Take readings in; gives the configuration estimated from them, shape (nq,)."""
        estimator, bodies = self._estimator, len(self._model.joints)
        self._read = readings.q[:bodies], readings.v[:bodies]
        estimator.update(
            readings.stamp_s,
            readings.q[:bodies],
            readings.v[:bodies],
            readings.gyro,
            readings.accelerometer,
            readings.foot_wrench,
        )
        self._wrench = readings.foot_wrench
        return estimator.tilt_rad

    def next(self) -> tuple[MotionSample, Array] | None:
        """The next instant and its efforts; None while a foot of the plan is out of the legs' reach.

        Landings are moved within the legs' reach, but where the body is when they come is not only the
        plan's: whoever is pushed about, loaded or held may end there. The feet go on, and the joints come
        back to the motion as soon as there is one.
        """
        error, loads_n = self._stabiliser.error, self._estimator.loads_n
        push = self._push_watch.felt(error, loads_n, self._sample, self._period_s)
        if push is not None:
            self.pattern.catch(push)
        if self._phase in (Phase.CLOSE, Phase.SETTLE):
            self.pattern.step_on(self._push_watch.mean)
        sample = self._floor.under(self.pattern.advance(self._period_s), loads_n)
        head = self.head.advance(resting=sample.phase in (Phase.SETTLE, Phase.REST))
        if head is not None:
            self._body.pose(self.head.columns, head)
        if sample.phase is Phase.SWING and self._phase is not Phase.SWING:
            self._locate(sample)
        self._phase = sample.phase
        self._resting = self._resting + 1 if sample.phase is Phase.REST else 0
        before, self._sample = self._sample or sample, sample
        try:
            motion = self._body.follow(sample)
        except OutOfReachError:
            self._motion = None
            return None
        if self._read is not None:
            self._fitted_ankles.follow(sample.phase, motion.q[7:], self._read[0])
            self._fitted_ankles.add_to(motion.q[7:], motion.v[6:])
        self._motion = motion
        if self._rested is not None:
            was = motion.q[7:] - self._period_s * motion.v[6:]
            self._rejoin, self._rested = Rejoin(self._rested - was, -motion.v[6:]), None
        efforts = self._stabiliser.efforts(before, motion, self._estimator)
        if self._wrench is not None:
            self.held_back = self._outside.feel(
                self._wrench, before.feet, self._estimator.sole_tilt, self._stabiliser.velocity
            )
        if self._read is not None:
            told, soft = (motion.q[7:], motion.v[6:]), sample.phase not in (Phase.SETTLE, Phase.REST)
            efforts = efforts + self._soft_ankles.efforts(told, self._read, soft, self._period_s)
        return motion, np.clip(efforts, -self._most, self._most)

    def joints(self, motion: MotionSample) -> tuple[Array, Array]:
        """Positions and velocities to command, on the way back to the motion if they are off it."""
        q, v = motion.q[7:], motion.v[6:]
        if self._rejoin is None:
            return q, v
        left, speed = self._rejoin.advance(self._period_s)
        if self._rejoin.over:
            self._rejoin = None
        return q + left, v + speed

    def rejoin(self, told_rad: Array) -> None:
        """Come back to the motion from where the joints rest, for a period or until there is one again."""
        self._rested = told_rad if self._motion is None else None
        if self._motion is not None:
            self._rejoin = Rejoin(told_rad - self._motion.q[7:], -self._motion.v[6:])

    def standing(self) -> tuple[Stance, Array]:
        """Stance and configuration at its end, in the odometry frame."""
        if self._motion is None:
            raise RuntimeError("the walk has not begun")
        feet = self.pattern.feet
        found = PlanarPose.between(self._estimator.sole("left"), self._estimator.sole("right"))
        odom_T_plan = found @ PlanarPose.between(feet["left"], feet["right"]).inverse()
        heights_m = self._floor.heights_m
        floor_m = sum(heights_m.values()) / len(heights_m)
        soles = tuple(
            (sole.frame, (odom_T_plan @ feet[sole.side]).transform(heights_m[sole.side] - floor_m))
            for sole in self._model.description.soles
        )
        q = self._motion.q.copy()
        plan_T_base = poses.transform(poses.rotation_from_quaternion(q[3:7]), q[:3])
        base = odom_T_plan.transform(-floor_m) @ plan_T_base
        q[:3], q[3:7] = base[:3, 3], poses.quaternion_from_rotation(base[:3, :3])
        if self._fitted_ankles.offset_rad.any():
            return stance_at(self._model, q), q
        return Stance(soles), q

    def _locate(self, sample: PatternSample) -> None:
        """Learn where the plan is from the foot that stands."""
        side = sample.carrying[0]
        self.pattern.locate(self._estimator.sole(side) @ sample.feet[side].inverse())


_DURATION_S = 0.2


class Rejoin:
    """A difference of positions and velocities that fades away smoothly."""

    def __init__(self, gap: Array, gap_speed: Array) -> None:
        """Begin with a difference, shape (n,) each; its acceleration begins and ends with nothing."""
        T = _DURATION_S
        d, dv = -gap - gap_speed * T, -gap_speed
        self._coefficients = (
            gap,
            gap_speed,
            (10.0 * d - 4.0 * dv * T) / T**3,
            (-15.0 * d + 7.0 * dv * T) / T**4,
            (6.0 * d - 3.0 * dv * T) / T**5,
        )
        self._t_s = 0.0

    @property
    def over(self) -> bool:
        """Whether nothing is left of it."""
        return self._t_s >= _DURATION_S

    def advance(self, period_s: float) -> tuple[Array, Array]:
        """What is left of it after another period: positions and velocities."""
        self._t_s += period_s
        t = min(self._t_s, _DURATION_S)
        x, v, c3, c4, c5 = self._coefficients
        left = x + t * (v + t * t * (c3 + t * (c4 + t * c5)))
        speed = v + t * t * (3.0 * c3 + t * (4.0 * c4 + t * 5.0 * c5))
        return left, speed
