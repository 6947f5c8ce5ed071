"""Motion of trunk, arms and head as a person jogs them, made tick by tick so that it can always be braked.

Each tick solves for the joint rates that give the wanted velocity of the TCP, slows them down as far as what
lies ahead asks for, and takes them only if the posture in which the robot would come to rest, if it braked
from there, is free. So whatever is asked for, there is a way to stand still, and a way back.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.following.hand_task import HandTask
from kinematics.following.jog_reference import HandJog, Jog, JointJog
from kinematics.model.robot_description import Hand
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample
from kinematics.standing.free_coordinates import free_coordinates

TICK_S = 0.01
"""From one decision to the next."""
_AVERAGED_S = 0.072
"""What is told is the mean over this long, so that accelerations change gradually: 111 rad/s^3 at most."""
_ACCELERATION = 4.0
_TRUNK_ACCELERATION = 1.5
"""rad/s^2: half of what arms and trunk may, so that a stop has room."""
_BRAKED_WITHIN_S = 0.08
"""No rate takes longer than this to brake; with the mean it is at rest 0.15 s after the last word."""
_SHARE = 0.5
"""Of a joint's own limits of speed and acceleration that is used at most."""
_AHEAD_S = 0.5
"""What is not free within so long, at the wanted speed, slows it down: in proportion to how far it is."""
_AHEAD = _AHEAD_S * np.array([1.0 / 32.0, 1.0 / 16.0, 0.125, 0.25, 0.375, 0.5, 0.75, 1.0])
_LIMIT_TIME_S = 0.4
"""A joint needs at least so long, at its present rate, to where its range ends."""
_LIMIT_ROOM_RAD = 0.01
"""Kept from a joint's planning limits."""
_TILT_WEIGHT = 0.35
"""Of the hand's direction, m/rad; position counts 1."""
_CALM = {"torso": 0.02, "arm": 0.004}
"""What a rate costs, m/rad: the trunk helps where the arm alone is slow; near a singularity all fade."""
_COM_WEIGHT, _COM_PULL_S, _COM_FREE_M = 0.5, 0.4, 0.02
"""The trunk leans so that the CoM, once it is farther than this from the middle of the feet, comes back."""
_POSTURE_WEIGHT, _POSTURE_PULL_S = 0.015, 1.5
"""The trunk goes back to where it was at the beginning, as far as hand and balance let it, m/rad."""
_PULL_S = 0.1
"""What the hand has strayed from its line is closed with this time constant."""
_STRAYED = 0.005
"""It never counts for more, m."""
_HELD_BACK_SHARE = 0.6
"""Slower than this share of what was asked for is told, with its reason."""
_FEELS_RAD = 0.03
"""So far a joint alone is tried, to tell whether it leads into what is near."""
_STRAIGHT = "the arm is nearly straight that way, or folded (a singularity)"


class Postures(Protocol):
    """Judges postures by their free coordinates."""

    def points_are_free(self, x: Array) -> bool:
        """Whether every one of many, shape (n, size), is free."""
        ...

    def why_not(self, x: Array) -> str | None:
        """Why one, shape (size,), is not free, in words for people; None when it is."""
        ...


class Resistance(Protocol):
    """What is felt against the motion.

    Attributes:
        told: What it is, for people.
    """

    told: str

    @property
    def easing(self) -> Array:
        """Rates of the body joints that give way to it, shape (n,)."""
        ...

    def presses(self, rates: Array) -> bool:
        """Whether rates of the body joints, shape (n,), press on against it."""
        ...


class JogTracker:
    """Moves trunk, arms and head as they are jogged; the feet and the pelvis stay where they are.

    Attributes:
        q: Configuration now, shape (nq,).
        held_back: What slows it down or stops it, in words for people; empty when nothing does.
    """

    def __init__(
        self, robot: StandingRobot, q: Array, postures: Postures, resistance: Resistance | None = None
    ) -> None:
        """Begin at rest.

        Args:
            robot: Where it stands.
            q: Where to begin, shape (nq,).
            postures: Which postures are free.
            resistance: What is felt on the way, if anything can be felt.
        """
        self._model = model = robot.model
        groups = model.description.groups
        legs = {joint for group in ("left_leg", "right_leg") for joint in groups.get(group, ())}
        self._joints = tuple(joint for joint in model.joints if joint not in legs)
        self._at = model.indices(self._joints)
        self._postures, self._resistance = postures, resistance
        space = free_coordinates(robot)
        self._row = space.from_q(q)
        self._columns = np.array([space.index(joint) for joint in self._joints])
        torso = np.array([joint in groups.get("torso", ()) for joint in self._joints])
        usual = np.where(torso, _TRUNK_ACCELERATION, _ACCELERATION)
        self._acceleration = np.minimum(usual, _SHARE * model.acceleration[self._at])
        self._speed = np.minimum(_BRAKED_WITHIN_S * self._acceleration, _SHARE * model.velocity[self._at])
        room = model.description.planning_margin_rad + _LIMIT_ROOM_RAD
        self._lower, self._upper = model.lower_rad[self._at] + room, model.upper_rad[self._at] - room
        self._x = q[7:][self._at].copy()
        self._preferred = self._x.copy()
        self._rate = np.zeros(len(self._joints))
        self._recent = np.stack([self._x, self._rate, self._rate])[None]
        self._data = model.pin.createData()
        self._middle: Array | None = None
        if not model.description.welded:
            corners = robot.polygon.vertices_m
            self._middle = 0.5 * (corners.max(axis=0) + corners.min(axis=0))
        self._jog: Jog | None = None
        self._met = ""
        self._anchor: tuple[Array, Array] | None = None
        self._share = 0.0
        self.q = q.copy()
        self.held_back = ""

    @property
    def at_rest(self) -> bool:
        """Whether nothing moves, what is told included."""
        return not self._rate.any() and not self._recent[:, 1:].any()

    def fastest(self, joint: str) -> float:
        """The highest rate at which a joint is jogged, rad/s.

        Raises:
            ValueError: It is none of those that are jogged.
        """
        return float(self._speed[self._joints.index(joint)])

    def tick(self, jog: Jog | None, times_s: Array) -> list[MotionSample]:
        """Go on by one tick.

        Args:
            jog: What is asked for; None to come to rest.
            times_s: Instants at equal distances, the last at the tick's end, shape (k,).

        Returns:
            The motion at those instants.
        """
        rate = self._braked() if jog is None else self._towards(jog)
        samples = self._between(rate, times_s)
        self._x = self._x + 0.5 * TICK_S * (self._rate + rate)
        self._rate = rate
        self.q = self.q.copy()
        self.q[7 + self._at] = self._x
        self._jog = jog
        return samples

    # ---------------------------------------------------------------- what is wanted

    def _towards(self, jog: Jog) -> Array:
        """The next rates on the way to what is asked for."""
        self.held_back = ""
        if not _same(jog, self._jog):
            self._anchor, self._share, self._met = None, 0.0, ""
        task: HandTask | None = None
        if isinstance(jog, JointJog):
            wanted = self._of_joint(jog)
        else:
            task = self._task(jog)
            wanted = self._within(task, self._box())
        if self._resistance is not None and (self._met or self._is_resisted(wanted, self._resistance)):
            self.held_back, self._anchor = self._met, None
            self._share, wanted = 1.0, self._resistance.easing[self._at]
            wanted = np.clip(wanted, -self._speed, self._speed)
        else:
            self._share = self._free_share(wanted)
            if task is not None and self._share < _HELD_BACK_SHARE:
                wanted = self._around(task, wanted)
        most = self._acceleration * TICK_S
        rate = self._rate + np.clip(self._share * wanted - self._rate, -most, most)
        if self._can_rest_from(rate):
            return rate
        self._share = 0.0
        return self._braked()

    def _of_joint(self, jog: JointJog) -> Array:
        k = self._joints.index(jog.joint)
        low, high = self._box()
        wanted = np.zeros(len(self._joints))
        asked = float(np.clip(jog.rate_rad_s, -self._speed[k], self._speed[k]))
        wanted[k] = np.clip(asked, low[k], high[k])
        if abs(wanted[k]) < _HELD_BACK_SHARE * abs(asked):
            self.held_back = self._limit_of(k)
        return wanted

    def _task(self, jog: HandJog) -> HandTask:
        """What the TCP is asked for now: its own velocity, and back onto its line."""
        model, (at, turned, jacobian) = self._model, self._tcp(jog.hand)
        groups = model.description.groups
        torso, arm = groups.get("torso", ()), groups[f"{jog.hand}_arm"]
        k = np.array([self._joints.index(joint) for joint in (*torso, *arm)])
        axes = self._axes(jog, turned)
        twist = np.concatenate([axes @ jog.linear_m_s, axes @ jog.angular_rad_s])
        if self._anchor is None:
            self._anchor = at.copy(), turned.copy()
        line, facing = self._anchor
        line = line + self._share * TICK_S * twist[:3]
        line = at + _at_most(line - at, _STRAYED)
        facing = pin.exp3(self._share * TICK_S * twist[3:]) @ facing
        off = _at_most(pin.log3(facing @ turned.T), _STRAYED / _TILT_WEIGHT)
        self._anchor = line, pin.exp3(off) @ turned
        rows = jacobian[:, 6 + self._at[k]].copy()
        rows[3:] *= _TILT_WEIGHT
        weigh = np.array([1.0] * 3 + [_TILT_WEIGHT] * 3)
        asked = weigh * twist
        goal = asked + weigh * np.concatenate([line - at, off]) / _PULL_S
        com_rows, com_goal = self._balancing(k)
        trunk = np.array([1.0] * len(torso) + [0.0] * len(arm))
        back = (_POSTURE_WEIGHT * trunk) ** 2 * (self._preferred[k] - self._x[k]) / _POSTURE_PULL_S
        calm = np.array([_CALM["torso"]] * len(torso) + [_CALM["arm"]] * len(arm))
        normal = rows.T @ rows + com_rows.T @ com_rows + np.diag(calm**2 + (_POSTURE_WEIGHT * trunk) ** 2)
        return HandTask(k, rows, asked, normal, rows.T @ goal + com_rows.T @ com_goal + back)

    def _within(self, task: HandTask, box: tuple[Array, Array]) -> Array:
        """Rates within bounds that move the TCP as asked for, as far as joints and their limits can."""
        k, (low, high) = task.joints, (bound[task.joints] for bound in box)
        rates = task.solved(low, high)
        slowed = rates / float(np.max(np.abs(rates) / self._speed[k], initial=1.0))
        if task.share_of(slowed) < _HELD_BACK_SHARE:
            full = (rates >= high - 1e-9) | (rates <= low + 1e-9)
            self.held_back = self._limit_of(int(k[np.argmax(full)])) if full.any() else _STRAIGHT
        wanted = np.zeros(len(self._joints))
        wanted[k] = slowed
        return wanted

    def _around(self, task: HandTask, wanted: Array) -> Array:
        """Rates without those joints that lead into what is near, where the hand gets on better so.

        With a joint to spare, what the hand is asked for and its opposite may both begin with an elbow that
        turns into the trunk: then neither would lead away.
        """
        told, share = self.held_back, self._share
        gained = share * task.share_of(wanted[task.joints])
        other = self._within(task, self._leading_away(task.joints))
        self._share = self._free_share(other)
        around = self._share * task.share_of(other[task.joints])
        self.held_back = told if around < _HELD_BACK_SHARE else ""
        if around > gained:
            return other
        self._share = share
        return wanted

    def _leading_away(self, joints: NDArray[np.intp]) -> tuple[Array, Array]:
        """The box of rates, closed where a joint alone would soon come to what is not free."""
        low, high = self._box()
        for k in joints:
            for bound, way in ((low, -_FEELS_RAD), (high, _FEELS_RAD)):
                x = self._x.copy()
                x[k] += way
                if not self._postures.points_are_free(self._rows(x[None])):
                    bound[k] = 0.0
        return low, high

    def _balancing(self, k: Array) -> tuple[Array, Array]:
        """What brings the CoM back over the feet, as rows for these rates; none for a robot on a mount."""
        if self._middle is None:
            return np.zeros((0, len(k))), np.zeros(0)
        jacobian = pin.jacobianCenterOfMass(self._model.pin, self._data, self.q, False)
        off = self._middle - self._data.com[0][:2]
        beyond = off - _at_most(off, _COM_FREE_M)
        return _COM_WEIGHT * jacobian[:2, 6 + self._at[k]], _COM_WEIGHT * beyond / _COM_PULL_S

    def _axes(self, jog: HandJog, turned: Array) -> Array:
        if jog.frame == "tool":
            return turned
        if jog.frame == "base":
            return np.asarray(pin.Quaternion(self.q[3:7]).toRotationMatrix())
        return np.eye(3)

    def _tcp(self, hand: Hand) -> tuple[Array, Array, Array]:
        """Place, direction and Jacobian of a TCP, in the world."""
        model, data = self._model.pin, self._data
        frame = self._model.frame_id(self._model.description.tcp_frames[hand])
        pin.computeJointJacobians(model, data, self.q)
        pin.updateFramePlacement(model, data, frame)
        placed = data.oMf[frame]
        jacobian = pin.getFrameJacobian(model, data, frame, pin.LOCAL_WORLD_ALIGNED)
        return placed.translation.copy(), placed.rotation.copy(), jacobian

    def _box(self) -> tuple[Array, Array]:
        """Rates at which no joint is at the end of its range too soon; back is always possible."""
        high = np.maximum(self._upper - self._x, 0.0) / _LIMIT_TIME_S
        low = -np.maximum(self._x - self._lower, 0.0) / _LIMIT_TIME_S
        return low, high

    def _limit_of(self, k: int) -> str:
        return f"{self._joints[k]} is near the end of its range"

    # ---------------------------------------------------------------- what is free

    def _is_resisted(self, wanted: Array, resistance: Resistance) -> bool:
        """Whether the wanted rates press on against what is felt; it counts for all that is asked so."""
        rates = np.zeros(len(self._model.joints))
        rates[self._at] = wanted
        if resistance.presses(rates):
            self._met = resistance.told
        return bool(self._met)

    def _free_share(self, wanted: Array) -> float:
        """How much of the wanted rates what lies ahead leaves."""
        if not wanted.any():
            return 0.0
        rows = self._rows(self._x + _AHEAD[:, None] * wanted)
        if self._postures.points_are_free(rows):
            return 1.0
        for k, row in enumerate(rows):
            if not self._postures.points_are_free(row[None]):
                share = float(_AHEAD[k - 1] / _AHEAD_S) if k else 0.0
                if share < _HELD_BACK_SHARE:
                    self.held_back = self._postures.why_not(row) or "something is near"
                return share
        return 1.0

    def _can_rest_from(self, rate: Array) -> bool:
        """Whether the robot can brake from there, on postures that are free."""
        after = self._x + 0.5 * TICK_S * (self._rate + rate)
        way = 0.5 * self._braking_s(rate) * rate
        return self._postures.points_are_free(self._rows(after + np.array([[0.0], [0.5], [1.0]]) * way))

    def _braking_s(self, rate: Array) -> float:
        return float(np.max(np.abs(rate) / self._acceleration, initial=0.0))

    def _braked(self) -> Array:
        """Rates of a tick later, on the straight way to rest."""
        left_s = self._braking_s(self._rate)
        return self._rate * (1.0 - TICK_S / left_s) if left_s > 1.001 * TICK_S else np.zeros_like(self._rate)

    def _rows(self, x: Array) -> Array:
        rows = np.repeat(self._row[None], len(x), axis=0)
        rows[:, self._columns] = x
        return rows

    def _between(self, rate: Array, times_s: Array) -> list[MotionSample]:
        """The motion within the tick: rates change linearly, and all is averaged."""
        count, t = len(times_s), times_s[:, None]
        bend = (rate - self._rate) / TICK_S
        made = np.empty((count, 3, len(rate)))
        made[:, 0] = self._x + t * self._rate + 0.5 * t**2 * bend
        made[:, 1] = self._rate + t * bend
        made[:, 2] = bend
        averaged = round(_AVERAGED_S * count / TICK_S)
        earlier = np.repeat(self._recent[:1], max(0, averaged - len(self._recent)), axis=0)  # it was at rest
        recent = np.concatenate([earlier, self._recent, made])
        self._recent = recent[-averaged:]
        samples = []
        for k in range(1, count + 1):
            x, rates, bends = recent[k : k + averaged].mean(axis=0)
            q, v, a = self.q.copy(), np.zeros(self._model.nv), np.zeros(self._model.nv)
            q[7 + self._at], v[6 + self._at], a[6 + self._at] = x, rates, bends
            samples.append(MotionSample(q, v, a))
        return samples


def _same(one: Jog, other: Jog | None) -> bool:
    """Whether both ask for the same."""
    if not isinstance(one, HandJog) or not isinstance(other, HandJog):
        return one == other
    if (one.hand, one.frame) != (other.hand, other.frame):
        return False
    return np.array_equal(one.linear_m_s, other.linear_m_s) and np.array_equal(
        one.angular_rad_s, other.angular_rad_s
    )


def _at_most(vector: Array, length: float) -> Array:
    """The vector, shortened where it is longer."""
    return vector * min(1.0, length / max(float(np.linalg.norm(vector)), 1e-12))
