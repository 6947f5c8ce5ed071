"""Whole-body motion of one hand, made tick by tick within limits of speed and acceleration.

The hand follows a goal that moves; the pelvis shifts so that the CoM stays where it is wanted, trunk and
arm do the rest, the feet stay where they are. Each tick solves one damped least-squares problem for the
rates of the pelvis's position, trunk and arm, in the box that limits leave. What is told is the mean over the
last instants, so that accelerations change gradually. Legs follow in closed form.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array, Sealed
from kinematics.following.boxed_least_squares import boxed_least_squares
from kinematics.model.robot_description import Hand
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample
from kinematics.standing.free_coordinates import free_coordinates

TICK_S = 0.01
"""From one goal to the next."""
TARGET_STEP_M, TARGET_STEP_RAD = 0.005, 0.015
"""The goal that is followed moves no more than this a tick, wherever it is asked to be: jumps have tipped
the robot over."""
_SPEED = {"base": 0.12, "torso": 0.5, "arm": 0.95}
_ACCELERATION = {"base": 0.35, "torso": 1.5, "arm": 4.0}
"""m/s and m/s^2 of the pelvis, rad/s and rad/s^2 of the joints: below the limits, so that a stop has room."""
_AVERAGED_S = 0.072
"""What is told is the mean over this long. Accelerations of the ticks jump, from one end of their range to
the other at most: spread over it, 111 rad/s^3 of an arm, and 10 m/s^3 of the pelvis, of which knees make
116 rad/s^3."""
_PULL_S = 0.04
"""Errors of the hand are closed with this time constant."""
_COM_PULL_S = 0.25
_POSTURE_PULL_S = 1.5
_TILT_WEIGHT = 0.35
"""Of the bar's direction in the hand, m/rad; position counts 1."""
_COM_WEIGHT = 0.25
_CALM = {"base": 0.006, "torso": 0.006, "arm": 0.002}
"""What a rate costs, squared sum, so that nothing moves that need not."""
_POSTURE = {"base": 0.0, "torso": 0.01, "arm": 0.004}
_LIMIT_ROOM_RAD = 0.02
_PROBE_S = 1e-3
_COM_RATE_M = 0.0008
"""The wanted CoM moves no more than this a tick."""
_ABOVE_HOME_M = 0.04
"""The pelvis rises no more than this above home: knees that are nearly straight must move too fast."""
_RISES, _DRAWN_BACK_M = 21, 0.12
"""Short legs are stretched before that: so many heights are tried, with the pelvis drawn back so far."""
_BASE_ROOM = np.array([0.13, 0.15, 0.16])
"""The pelvis stays within this of where the motion began, m."""
_LOWEST_SHARE = 0.73
"""Of its height at home: arms that want to keep their posture would make the robot squat ever deeper."""


@dataclass(frozen=True, slots=True)
class HandGoal(Sealed):
    """Where a hand shall be at one tick, in the world.

    Attributes:
        position_m: Place of the TCP, shape (3,).
        rotation: ``world_R_tcp``, shape (3, 3).
        spin_weight: How much the turn about ``spin_axis`` matters, m/rad; a hand on a bar may leave it open.
        spin_axis: Unit vector, shape (3,): the bar.
        com_shift_m: Where the CoM shall be over the floor, from the middle between the feet, shape (2,).
    """

    position_m: Array
    rotation: Array
    spin_weight: float
    spin_axis: Array
    com_shift_m: Array


class HandTracker:
    """Moves the body so that one hand follows goals that are only known as it goes, one tick after the other.

    Attributes:
        q: Configuration now, shape (nq,).
        tcp_m, tcp_rotation: The hand's TCP at that configuration, in the world, shapes (3,) and (3, 3).
        followed_m: The point that the hand is led to now: it goes to the goal no faster than the hand may.
        standing: Whether the legs reach the ground there.
    """

    def __init__(self, robot: StandingRobot, hand: Hand, q: Array, tick_s: float = TICK_S) -> None:
        """Begin at rest at a configuration with the feet at the stance.

        Args:
            robot: Where it stands.
            hand: The hand that follows.
            q: Where to begin, shape (nq,).
            tick_s: From one goal to the next; longer for a rehearsal, which is only looked at.
        """
        self._tick_s, model = tick_s, robot.model
        self._model, description = model, model.description
        self._space = free_coordinates(robot)
        self._base = 3 if self._space.base_size else 0  # a welded one follows with its arm alone
        self._middle = robot.polygon.middle_m
        self._data = model.pin.createData()
        self._tcp_id = model.frame_id(description.tcp_frames[hand])
        kinds = ["base"] * self._base
        joints = []
        for kind, group in (("torso", "torso"), ("arm", f"{hand}_arm")):
            joints += list(description.groups[group])
            kinds += [kind] * len(description.groups[group])
        self._columns = np.array([*range(self._base), *(self._space.index(joint) for joint in joints)])
        self._v_columns = 6 + model.indices(joints)
        self._speed = np.array([_SPEED[kind] for kind in kinds])
        self._acceleration = np.array([_ACCELERATION[kind] for kind in kinds])
        self._calm = np.array([_CALM[kind] for kind in kinds]) ** 2
        self._posture = np.array([_POSTURE[kind] for kind in kinds]) ** 2
        self._x = self._space.from_q(q)
        at = model.indices(joints)
        start = self._x[: self._base]
        room = description.planning_margin_rad + _LIMIT_ROOM_RAD
        base_room = _BASE_ROOM[: self._base]
        self._lower = np.concatenate([start - base_room, model.lower_rad[at] + room])
        self._upper = np.concatenate([start + base_room, model.upper_rad[at] - room])
        self._preferred = self._x[self._columns].copy()
        self._rate = np.zeros(len(self._columns))
        self._recent = np.stack([self._preferred, self._rate, self._rate])[None]
        if self._base:
            home_m = float(self._space.from_q(robot.q_home)[2])
            self._lower[2] = min(start[2], max(self._lower[2], _LOWEST_SHARE * home_m))
            highest = home_m + _room_above_home_m(robot)
            self._upper[2] = max(start[2], min(self._upper[2], highest))
        self.standing = True
        self._locate(q)
        self.followed_m, self._followed = self.tcp_m.copy(), self.tcp_rotation.copy()
        self._com_wanted = self._com[:2].copy()

    @property
    def at_rest(self) -> bool:
        """Whether nothing moves, what is told included."""
        return not self._rate.any() and not self._recent[:, 1:].any()

    @property
    def speed(self) -> float:
        """The fastest coordinate, as a share of its limit."""
        return float(np.max(np.abs(self._rate) / self._speed))

    def tick(self, goal: HandGoal | None, times_s: Array) -> list[MotionSample]:
        """Go on by one tick.

        Args:
            goal: Where to; None to come to rest.
            times_s: Instants at equal distances, the last at the tick's end, shape (k,), as many each tick;
                none when only the end matters.

        Returns:
            The motion at those instants.
        """
        most = self._acceleration * self._tick_s
        x = self._x[self._columns]
        if goal is None:
            rate = self._rate - np.clip(self._rate, -most, most)
        else:
            self._approach(goal)
            rate = self._solve(goal, x, most)
        samples = self._between(rate, times_s) if len(times_s) else []
        self._x[self._columns] += 0.5 * self._tick_s * (self._rate + rate)
        self._rate = rate
        q, reached = self._space.to_q(self._x[None, :])
        self.standing = bool(reached[0])
        self._locate(q[0])
        return samples

    def _approach(self, goal: HandGoal) -> None:
        """Bring what is followed nearer to what is asked."""
        ticks = self._tick_s / TICK_S
        step = goal.position_m - self.followed_m
        self.followed_m = self.followed_m + step * min(
            1.0, ticks * TARGET_STEP_M / max(float(np.linalg.norm(step)), 1e-12)
        )
        turn = pin.log3(self._followed.T @ goal.rotation)
        self._followed = self._followed @ pin.exp3(
            turn * min(1.0, ticks * TARGET_STEP_RAD / max(float(np.linalg.norm(turn)), 1e-12))
        )
        shift = self._middle + goal.com_shift_m - self._com_wanted
        self._com_wanted = self._com_wanted + shift * min(
            1.0, ticks * _COM_RATE_M / max(float(np.linalg.norm(shift)), 1e-12)
        )

    def _solve(self, goal: HandGoal, x: Array, most: Array) -> Array:
        """Rates for the next tick, shape (n,)."""
        n, k, base = len(x), self._v_columns, self._base
        jacobian = pin.getFrameJacobian(self._model.pin, self._data, self._tcp_id, pin.LOCAL_WORLD_ALIGNED)
        rows = np.zeros((8 if base else 6, n))
        rows[:3, :base], rows[:3, base:] = np.eye(3)[:, :base], jacobian[:3, k]
        error = self.tcp_rotation @ pin.log3(self.tcp_rotation.T @ self._followed)
        axis = goal.spin_axis
        weigh = _TILT_WEIGHT * (np.eye(3) - np.outer(axis, axis)) + goal.spin_weight * np.outer(axis, axis)
        rows[3:6, base:] = weigh @ jacobian[3:, k]
        wanted = np.concatenate([(self.followed_m - self.tcp_m) / _PULL_S, weigh @ error / _PULL_S])
        if base:
            com = self._data.Jcom
            rows[6:, :2] = _COM_WEIGHT * _COM_OF_BASE * np.eye(2)
            rows[6:, 3:] = _COM_WEIGHT * com[:2, k]
            pull = _COM_WEIGHT * (self._com_wanted - self._com[:2]) / _COM_PULL_S
            wanted = np.concatenate([wanted, pull])
        normal = rows.T @ rows
        normal[np.diag_indices(n)] += self._calm + self._posture
        right = rows.T @ wanted + self._posture * (self._preferred - x) / _POSTURE_PULL_S
        room_up, room_down = np.maximum(self._upper - x, 0.0), np.maximum(x - self._lower, 0.0)
        share = 0.8 * self._acceleration
        high = np.minimum(np.minimum(self._speed, np.sqrt(2.0 * share * room_up)), self._rate + most)
        low = np.maximum(np.maximum(-self._speed, -np.sqrt(2.0 * share * room_down)), self._rate - most)
        high, low = np.maximum(high, self._rate - most), np.minimum(low, self._rate + most)
        return boxed_least_squares(normal, right, low, high)

    def _between(self, rate: Array, times_s: Array) -> list[MotionSample]:
        """The motion within the tick: rates change linearly; all is averaged; legs by their closed form."""
        count, t = len(times_s), times_s[:, None]
        bend = (rate - self._rate) / self._tick_s
        made = np.empty((count, 3, len(rate)))
        made[:, 0] = self._x[self._columns] + t * self._rate + 0.5 * t**2 * bend
        made[:, 1] = self._rate + t * bend
        made[:, 2] = bend
        averaged = round(_AVERAGED_S * count / self._tick_s)
        earlier = np.repeat(self._recent[:1], max(0, averaged - len(self._recent)), axis=0)  # it was at rest
        recent = np.concatenate([earlier, self._recent, made])
        self._recent = recent[-averaged:]
        x, rates, bends = np.stack(
            [recent[k : k + averaged].mean(axis=0) for k in range(1, count + 1)], axis=1
        )
        rows = np.repeat(self._x[None, :], 3 * count, axis=0)
        for k, probe_s in enumerate((-_PROBE_S, 0.0, _PROBE_S)):
            rows[k::3, self._columns] = x + probe_s * rates + 0.5 * probe_s**2 * bends
        q, _ = self._space.to_q(rows)
        before, here, after = q[0::3], q[1::3], q[2::3]
        v = np.zeros((count, self._model.nv))
        a = np.zeros_like(v)
        v[:, 6:] = (after[:, 7:] - before[:, 7:]) / (2.0 * _PROBE_S)
        a[:, 6:] = (after[:, 7:] - 2.0 * here[:, 7:] + before[:, 7:]) / _PROBE_S**2
        if self._base:
            base = pin.Quaternion(here[0, 3:7]).toRotationMatrix()
            v[:, :3], a[:, :3] = rates[:, :3] @ base, bends[:, :3] @ base
        return [MotionSample(here[i], v[i], a[i]) for i in range(count)]

    def _locate(self, q: Array) -> None:
        model, data = self._model.pin, self._data
        pin.computeJointJacobians(model, data, q)
        pin.updateFramePlacement(model, data, self._tcp_id)
        pin.jacobianCenterOfMass(model, data, q, False)
        self.q = q
        self._com = data.com[0].copy()
        self.tcp_m = data.oMf[self._tcp_id].translation.copy()
        self.tcp_rotation = data.oMf[self._tcp_id].rotation.copy()


def _room_above_home_m(robot: StandingRobot) -> float:
    """How far the pelvis may rise with the legs still on the ground, drawn back as for a pull."""
    space = free_coordinates(robot)
    rises_m = np.linspace(0.0, _ABOVE_HOME_M, _RISES)
    x = np.repeat(space.from_q(robot.q_home)[None, :], _RISES, axis=0)
    ahead = np.sum([pose[:2, 0] for _, pose in robot.stance.soles], axis=0)
    x[:, :2] -= _DRAWN_BACK_M * ahead / np.linalg.norm(ahead)
    x[:, 2] += rises_m
    _, reached = space.to_q(x)
    return float(rises_m[np.cumprod(reached).sum() - 1]) if reached[0] else 0.0


_COM_OF_BASE = 0.8
"""How far the CoM goes with the pelvis while the feet stay: the legs lag behind."""
