"""From the pattern to the joints: legs under the pelvis, the CoM brought to where it belongs.

The pelvis stays level and at one height, the upper body keeps its posture; where the pelvis is follows
from where the CoM is to be. Positions are averaged over three periods, (1, 2, 1)/4, so that the central
differences are exactly their velocities: a setpoint's position then leads from the one before along the
mean of both velocities, which is what the gate expects.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.errors import KinematicsError
from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import HANDS, Hand
from kinematics.model.robot_model import RobotModel
from kinematics.motion.sampler import MotionSample
from kinematics.walking.body.walking_legs import walking_legs
from kinematics.walking.pattern.pattern_sample import PatternSample

_BASE = 4
"""Base coordinates before the joints: x, y, z, heading."""
_GRAVITY_M_S2 = 9.81
_AROUND = 3
"""Instants that a reference is the mean of."""


class OutOfReachError(KinematicsError):
    """A foot is farther from the hip than the leg is long."""


class WholeBody:
    """References of all joints, one control period after the other.

    Attributes:
        omega: Natural frequency of the pendulum that the robot is, 1/s.
        rest_m: Where the CoM rests, seen from the middle between the feet, with this upper body.
        sway_s2: How far a swinging foot moves the ZMP for each m/s^2 of its acceleration.
    """

    def __init__(
        self, model: RobotModel, q: Array, feet: Mapping[Hand, PlanarPose], period_s: float, blend_s: float
    ) -> None:
        """Begin at rest.

        Args:
            model: The robot.
            q: Configuration at the start, in the plan's frame, shape (nq,).
            feet: Where its soles are then.
            period_s: The control period.
            blend_s: Time in which the pelvis comes level and to the home posture's height.

        Raises:
            ModelError: A leg is not a chain of six hinges.
        """
        self._model, self._pin, self._data = model, model.pin, model.pin.createData()
        self._period_s, self._blend_s = period_s, blend_s
        self._sides = tuple(side for side in HANDS for sole in model.description.soles if sole.side == side)
        self._legs = walking_legs(model)
        self._columns, self._leg_joints = self._legs.columns, self._legs.joints
        self._feet = np.zeros((len(self._leg_joints), 4))
        self._t_s = 0.0
        self._q = q.copy()
        base_R = poses.rotation_from_quaternion(q[3:7])
        heading = PlanarPose.between(feet["left"], feet["right"]).yaw_rad
        self._tilt = poses.vector_from_rotation(poses.rotation_z(-heading) @ base_R)
        self._start_z_m = float(q[2])
        self._rest_z_m = float(model.q_home[2])
        com = model.com(q)
        self._offset = q[:2] - com[:2]
        rest = self._at_rest(q)
        com = model.com(rest)
        self.rest_m = (float(com[0]), float(com[1]))
        self.sway_s2 = self._sway(rest)
        self.omega = _natural_frequency(float(com[2]), self.sway_s2, len(self._leg_joints))
        first = np.concatenate([q[:3], [heading], q[7:]])
        self._rows = [first, first.copy(), first.copy()]

    def _at_rest(self, q: Array) -> Array:
        """Home posture of the legs at the origin, with this upper body."""
        rest = self._model.q_home.copy()
        legs = set(self._columns.ravel().tolist())
        others = [k for k in range(7, len(q)) if k not in legs]
        rest[others] = q[others]
        return rest

    def _sway(self, rest: Array) -> float:
        """Moment about the CoM that a foot's acceleration forwards takes, over the weight, s^2.

        The foot is accelerated by 1 m/s^2 at rest, by the leg alone, while the CoM stays: what turns then is
        the rate of the angular momentum.
        """
        model, data = self._pin, self._data
        pin.computeJointJacobians(model, data, rest)
        pin.updateFramePlacements(model, data)
        A = pin.computeCentroidalMap(model, data, rest)
        legs = []
        for sole, joints in zip(self._model.description.soles, self._leg_joints, strict=True):
            frame = self._model.frame_id(sole.frame)
            J = pin.getFrameJacobian(model, data, frame, pin.LOCAL_WORLD_ALIGNED)
            legs.append((np.array(J), np.array([int(model.joints[j].idx_v) for j in joints])))
        v = np.zeros(model.nv)
        for _ in range(30):  # the base yields so that the CoM stays, and the other foot does too
            for k, (J, columns) in enumerate(legs):
                wanted = np.array([1.0 if k == 0 else 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
                v[columns] = np.linalg.solve(J[:, columns], wanted - J[:, :3] @ v[:3])
            v[:3] -= (A[:3] @ v) / self._model.mass_kg
        return float(A[4] @ v) / (self._model.mass_kg * _GRAVITY_M_S2)

    def pose(self, columns: NDArray[np.intp], values: Array) -> None:
        """Have joints of the upper body elsewhere from the next instant on; the CoM is kept.

        Args:
            columns: Of a configuration, shape (n,).
            values: Where they are, shape (n,), a period's motion away from where they were.
        """
        self._q[columns] = values

    def follow(self, sample: PatternSample) -> MotionSample:
        """Take the pattern's next instant in; gives the reference of the instant before it.

        Raises:
            OutOfReachError: A foot cannot be reached, or could not be a moment ago: the reference of an
                instant needs those around it.
        """
        self._t_s += self._period_s
        row = self._row(sample)
        self._rows = [] if row is None else [*self._rows[-2:], row]
        if len(self._rows) < _AROUND:
            raise OutOfReachError("a step is out of the legs' reach")
        before, now, after = self._rows
        dt = self._period_s
        smooth = 0.25 * (before + 2.0 * now + after)
        velocity = (after - before) / (2.0 * dt)
        return self._sample(smooth, velocity, (after - 2.0 * now + before) / (dt * dt))

    def _row(self, sample: PatternSample) -> Array | None:
        q = self._q
        legs = q[self._columns]
        left, right = sample.feet["left"], sample.feet["right"]
        heading = PlanarPose.between(left, right).yaw_rad
        share = min(1.0, self._t_s / self._blend_s)
        share = share * share * share * (10.0 - 15.0 * share + 6.0 * share * share)
        base_R = _rotation(heading, (1.0 - share) * self._tilt)
        q[0], q[1] = sample.com.com[0] + self._offset[0], sample.com.com[1] + self._offset[1]
        q[2] = self._start_z_m + share * (self._rest_z_m - self._start_z_m)
        q[3:7] = poses.quaternion_from_rotation(base_R) if share < 1.0 else _quaternion(heading)
        for k, side in enumerate(self._sides):
            foot = sample.feet[side]
            self._feet[k] = (foot.x_m, foot.y_m, sample.lift_m[side], foot.yaw_rad)
        if not self._legs.fill(q, base_R, self._feet):
            q[self._columns] = legs
            return None
        com = pin.centerOfMass(self._pin, self._data, q, False)
        self._offset += np.array(sample.com.com) - com[:2]
        row: Array = np.empty(_BASE + len(q) - 7)
        row[:3], row[3], row[_BASE:] = q[:3], heading, q[7:]
        return row

    def _sample(self, row: Array, velocity: Array, acceleration: Array) -> MotionSample:
        heading, rate = float(row[3]), float(velocity[3])
        share = min(1.0, self._t_s / self._blend_s)
        q = np.empty(self._model.nq)
        q[:3], q[7:] = row[:3], row[_BASE:]
        if share < 1.0:
            share = share * share * share * (10.0 - 15.0 * share + 6.0 * share * share)
            q[3:7] = poses.quaternion_from_rotation(_rotation(heading, (1.0 - share) * self._tilt))
        else:
            q[3:7] = _quaternion(heading)
        v, a = np.zeros(self._model.nv), np.zeros(self._model.nv)
        c, s = math.cos(heading), math.sin(heading)
        vx, vy = c * velocity[0] + s * velocity[1], c * velocity[1] - s * velocity[0]
        v[0], v[1], v[2], v[5], v[6:] = vx, vy, velocity[2], rate, velocity[_BASE:]
        ax, ay = c * acceleration[0] + s * acceleration[1], c * acceleration[1] - s * acceleration[0]
        # the free-flyer's acceleration is the derivative of its velocity in its own, turning, frame
        a[0], a[1], a[2], a[5] = ax + rate * vy, ay - rate * vx, acceleration[2], acceleration[3]
        a[6:] = acceleration[_BASE:]
        return MotionSample(q, v, a)


def _natural_frequency(com_m: float, sway_s2: float, legs: int) -> float:
    """Of a pendulum whose legs turn with the CoM's way over soles that stay, 1/s.

    Seen from the CoM, soles that stay are all accelerated by ``-c''``, each of which moves the ZMP by the
    sway: ``c - zmp = c'' (z / g - n sway)``. Of a point mass in the CoM, the bodies of G1 and TALOS are 7
    percent faster than they are: on the spot their DCM was off by 30 and 8 mm at each landing, 3 with this.
    """
    return 1.0 / math.sqrt(com_m / _GRAVITY_M_S2 - legs * sway_s2)


def _quaternion(heading: float) -> tuple[float, float, float, float]:
    return 0.0, 0.0, math.sin(0.5 * heading), math.cos(0.5 * heading)


def _rotation(heading: float, tilt: Array) -> Array:
    turn = poses.rotation_z(heading)
    return turn if not tilt.any() else np.asarray(turn @ poses.rotation_from_vector(tilt))
