"""Where the base and the CoM are while the feet move: encoders, IMU, and the feet that carry.

The orientation is the integral of the gyro, whose bias is measured while the robot stands. What slowly
goes wrong with it is put right by the soles that carry, which are flat on the floor, and a little by the
accelerometer. The position hangs on the foot that carries most: it stands where it was found to stand when
the load came onto it. So what accumulates is what each landing adds: slips, and soles that give way.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.walking.body.attitude import base_velocity, com_seen, turned


@dataclass(frozen=True, slots=True)
class LeggedSettings:
    """Time constants and thresholds.

    Attributes:
        sole_time_s: The tilt returns to that of flat soles with this time constant.
        sole_rate_rad_s: It returns no faster than this, which is more than a gyro's error of 0.5 degrees per
            second, and so little that a sole that stands tilted on an edge for a step turns it by 6 mrad,
            not by 70.
        sole_yaw_time_s: The heading returns to that of the standing foot with this one: slowly, for
            soles twist a little under turns and a gyro without bias does not.
        gravity_time_s: The tilt returns to the accelerometer's with this one.
        velocity_time_s: The velocity returns to what carrying soles say with this time constant.
        velocity_most_m_s: A difference of the two counts as no more than this: a sole that rocks on an edge
            is not at rest.
        carrying_force_n: A sole with less normal force than this carries nothing.
        shift_share: Another foot becomes the one to rely on with this share of the load.
    """

    sole_time_s: float = 0.4
    sole_rate_rad_s: float = 0.012
    sole_yaw_time_s: float = 10.0
    gravity_time_s: float = 4.0
    velocity_time_s: float = 0.05
    velocity_most_m_s: float = 0.1
    carrying_force_n: float = 30.0
    shift_share: float = 0.6


@dataclass(frozen=True, slots=True)
class ComEstimate:
    """The CoM seen from one sole.

    Attributes:
        position_m: From the sole's origin, along the sole's heading, its left, and up, shape (3,).
        velocity_m_s: Its velocity over the floor, along the same axes, shape (3,).
        heading_rad: Heading of the base, seen from the sole.
    """

    position_m: Array
    velocity_m_s: Array
    heading_rad: float


class LeggedEstimator:
    """Estimates pose and CoM in the odometry frame.

    Attributes:
        gyro_bias_rad_s: What the gyro shows at rest, in the base's frame, shape (3,).
        odom_R_base: Orientation, shape (3, 3).
        loads_n: Normal force on each sole, 0 where it carries nothing.
        turn_rad_s: Angular velocity of the base in its own frame, shape (3,).
    """

    def __init__(
        self,
        model: RobotModel,
        q: Array,
        soles: Mapping[Hand, Array],
        gyro_bias_rad_s: Array,
        settings: LeggedSettings | None = None,
    ) -> None:
        """Begin at rest.

        Args:
            model: The robot.
            q: Its configuration, base in the odometry frame, shape (nq,).
            soles: Where its soles stand then, shape (4, 4) each.
            gyro_bias_rad_s: In the IMU's frame, shape (3,).
            settings: Time constants.
        """
        self._settings = settings or LeggedSettings()
        self._model, self._data = model.pin, model.pin.createData()
        self._sides = tuple(sole.side for sole in model.description.soles)
        self._frames = [model.frame_id(sole.frame) for sole in model.description.soles]
        self._imu = model.frame_id(model.description.imu_link)
        self._q, self._v = pin.neutral(model.pin), np.zeros(model.nv)
        self.odom_R_base = poses.rotation_from_quaternion(q[3:7])
        self._anchors = {
            side: (np.array(pose[:3, 3]), poses.yaw_of(pose[:3, :3])) for side, pose in soles.items()
        }
        self._relied: Hand = self._sides[0]
        self._last_s: float | None = None
        self.gyro_bias_rad_s = gyro_bias_rad_s.copy()
        self.turn_rad_s = np.zeros(3)
        self.loads_n: dict[Hand, float] = dict.fromkeys(self._sides, 0.0)
        count = len(self._sides)
        self._sole_R, self._sole_p, self._sole_v = (np.zeros((count, *rest)) for rest in ((3, 3), (3,), (3,)))
        self._loads = np.zeros(count)
        self._index = {side: k for k, side in enumerate(self._sides)}
        used = self._settings
        self._times_s = np.array([used.sole_time_s, used.sole_yaw_time_s, used.gravity_time_s])
        self._velocity = np.zeros(3)
        self._seen: dict[Hand, ComEstimate] = {}
        self._com, self._com_velocity = np.zeros(3), np.zeros(3)
        self._estimate = q.copy()

    @property
    def tilt_rad(self) -> Array:
        """Whole configuration of the last update: what ``configuration`` is given back, shape (nq,)."""
        return self._estimate

    def configuration(self, joints_rad: Array, foot_wrench: Array, estimate: Array) -> Array:  # noqa: ARG002
        """The configuration of an update, from its ``tilt_rad``; as ``BaseEstimator`` gives it."""
        return estimate.copy()

    def update(
        self,
        stamp_s: float,
        joints_rad: Array,
        joints_rad_s: Array,
        gyro_rad_s: Array,
        accelerometer_m_s2: Array,
        foot_wrench: Array,
    ) -> None:
        """Take one set of readings.

        Args:
            stamp_s: Their time.
            joints_rad, joints_rad_s: Body joints, shape (n,) each.
            gyro_rad_s, accelerometer_m_s2: In the IMU's frame, shape (3,) each.
            foot_wrench: On each sole, sole frame, shape (feet, 6).
        """
        self._q[7:], self._v[6:] = joints_rad, joints_rad_s
        model, data = self._model, self._data
        self._com = np.array(pin.centerOfMass(model, data, self._q, self._v, False))
        self._com_velocity = np.array(data.vcom[0])
        for k, frame in enumerate(self._frames):
            placement = pin.updateFramePlacement(model, data, frame)
            self._sole_R[k], self._sole_p[k] = placement.rotation, placement.translation
            self._sole_v[k] = pin.getFrameVelocity(model, data, frame, pin.LOCAL_WORLD_ALIGNED).linear
        self._seen.clear()
        base_R_imu = pin.updateFramePlacement(model, data, self._imu).rotation
        self.turn_rad_s = base_R_imu.dot(gyro_rad_s - self.gyro_bias_rad_s)
        least = self._settings.carrying_force_n
        np.multiply(foot_wrench[:, 2], foot_wrench[:, 2] >= least, out=self._loads)
        self.loads_n = dict(zip(self._sides, self._loads.tolist(), strict=True))
        if self._last_s is not None and stamp_s > self._last_s:
            dt, force = stamp_s - self._last_s, base_R_imu.dot(accelerometer_m_s2)
            self._turn(dt, force)
            self._move(dt, force)
        self._last_s = stamp_s
        self._place(joints_rad)
        if self._rely():
            self._place(joints_rad)

    def com_from(self, side: Hand) -> ComEstimate:
        """The CoM as a sole sees it."""
        found = self._seen.get(side)
        if found is None:
            k = self._index[side]
            seen = com_seen(
                self.odom_R_base,
                self._sole_R[k],
                self._sole_p[k],
                self._velocity,
                self._com,
                self._com_velocity,
                self.turn_rad_s,
            )
            found = self._seen[side] = ComEstimate(seen[:3], seen[3:6], float(seen[6]))
        return found

    def sole(self, side: Hand) -> PlanarPose:
        """Where a sole is believed to be now."""
        k = self._index[side]
        place = self._estimate[:3] + self.odom_R_base.dot(self._sole_p[k])
        odom_R_sole = self.odom_R_base.dot(self._sole_R[k])
        return PlanarPose(float(place[0]), float(place[1]), poses.yaw_of(odom_R_sole))

    def sole_tilt(self, side: Hand) -> Array:
        """How a sole leans: its rotation without its heading, shape (3, 3)."""
        odom_R_sole = self.odom_R_base.dot(self._sole_R[self._index[side]])
        return np.asarray(poses.rotation_z(-poses.yaw_of(odom_R_sole)) @ odom_R_sole)

    def _turn(self, dt: float, force: Array) -> None:
        """Integrate the gyro, then correct a little."""
        self.odom_R_base = turned(
            self.odom_R_base,
            self.turn_rad_s,
            dt,
            self._loads,
            self._sole_R,
            self._index[self._relied],
            self._anchors[self._relied][1],
            force,
            self._times_s,
            self._settings.sole_rate_rad_s,
        )

    def _move(self, dt: float, force: Array) -> None:
        """Integrate the accelerometer, then correct by the soles that carry."""
        used = self._settings
        self._velocity = base_velocity(
            self._velocity,
            self.odom_R_base,
            force,
            dt,
            self._loads,
            self._sole_p,
            self._sole_v,
            self.turn_rad_s,
            used.velocity_time_s,
            used.velocity_most_m_s,
        )

    def _rely(self) -> bool:
        """Change over to the foot that carries most, standing where it stands now; whether that was done.

        The base has to be where these readings have it: with that of the period before each step is found
        too short by a period's way of the base, 0.9 mm of 181 mm at 0.3 m/s.
        """
        total = sum(self.loads_n.values())
        if total <= 0.0:
            return False
        changed = False
        for side, load in self.loads_n.items():
            if side != self._relied and load > self._settings.shift_share * total:
                place = self.sole(side)
                self._anchors[side] = (np.array((place.x_m, place.y_m, 0.0)), place.yaw_rad)
                self._relied = side
                changed = True
        return changed

    def _place(self, joints_rad: Array) -> None:
        anchor, _ = self._anchors[self._relied]
        estimate = np.empty(len(self._q))
        estimate[:3] = anchor - self.odom_R_base.dot(self._sole_p[self._index[self._relied]])
        estimate[3:7] = poses.quaternion_from_rotation(self.odom_R_base)
        estimate[7:] = joints_rad
        self._estimate = estimate
