"""The last judge before the motors, and the only caller of ``Robot.command``."""

from __future__ import annotations

import dataclasses

import numpy as np

from kinematics.arrays import Array
from kinematics.checking.settings import DEFAULT_SETTINGS
from kinematics.motion.verdict import SETPOINT_FRACTION
from robots.clock import Clock
from robots.control.gate.authority import HOLD, Authority
from robots.control.gate.refusal import Limit, Refusal
from robots.control.gate.setpoint_limits import moves_any, within_limits
from robots.interface.robot import JointSetpoint, Robot

_ROUNDING = 1e-9
"""Room for rounding: a motion may reach a limit."""
_JUMP_RAD = 1e-5
"""A position may differ by this from where the last one and the speeds lead: the jerk inside one
control period gives 1e-7 rad, a step that a servo would feel 1e-4."""
_CHECKS = (Limit.POSITION, Limit.VELOCITY, Limit.EFFORT, Limit.ACCELERATION, Limit.JUMP)


class SetpointGate:
    """Lets a setpoint through to the robot, or refuses it with the reason. It never changes one.

    Attributes:
        last: The setpoint that the robot follows now.
        accepted, refused: How many there were.
    """

    def __init__(
        self, robot: Robot, authority: Authority, clock: Clock, period_s: float, start_rad: Array
    ) -> None:
        """Guard a robot that rests.

        Args:
            robot: The body.
            authority: Who may move which joint.
            clock: What a setpoint's age is judged by.
            period_s: The control period; a setpoint older than two of them is stale.
            start_rad: Where the actuated joints rest, shape (n,): the first setpoint must begin there.
        """
        self._robot = robot
        self._authority = authority
        self._clock = clock
        self._max_age_s = 2.0 * period_s
        description = robot.description
        self._joints = description.actuated
        limits = [description.limits[name] for name in self._joints]
        n = len(limits)
        upper = np.empty((5, n))
        upper[0] = [limit.position[1] for limit in limits]
        upper[1] = [limit.velocity for limit in limits]
        upper[2] = [limit.effort for limit in limits]
        upper[3] = [limit.acceleration for limit in limits]
        upper[4] = _JUMP_RAD
        lower = -upper
        lower[0] = [limit.position[0] for limit in limits]
        self._upper, self._lower = upper, lower
        # What the checker let pass as numerical noise, and brakes of it, must not be refused on the way.
        room = _ROUNDING * np.maximum(np.abs(upper), 1.0)
        room[0] += DEFAULT_SETTINGS.position_rad
        room[1] += SETPOINT_FRACTION * upper[1]
        room[3] += SETPOINT_FRACTION * upper[3]
        self._most, self._least = upper + room, lower - room
        walking = robot.hardware.walking.joint_acceleration if robot.hardware.walking is not None else {}
        steps = np.array(
            [walking.get(name, limit.acceleration) for name, limit in zip(self._joints, limits, strict=True)]
        )
        self._stepping = False
        self._accelerations = {False: upper[3].copy(), True: steps}
        self._acceleration_room = room[3]
        self._judged = np.empty((5, n))
        rest = np.zeros(n)
        self.last = JointSetpoint(clock.now_s() - period_s, 0, HOLD, start_rad.copy(), rest, rest.copy())
        self.accepted = 0
        self.refused = 0

    def expect_steps(self, stepping: bool) -> None:
        """Judge accelerations by the limits of a robot that walks, or of one that stands."""
        if stepping == self._stepping:
            return
        self._stepping, bound = stepping, self._accelerations[stepping]
        self._upper[3], self._lower[3] = bound, -bound
        self._most[3], self._least[3] = bound + self._acceleration_room, -bound - self._acceleration_room

    def submit(self, setpoint: JointSetpoint) -> Refusal | None:
        """Command the robot, or say why not; a refused setpoint changes nothing."""
        refusal = self._judge(setpoint)
        if refusal is None:
            self._robot.command(setpoint)
            self.last = setpoint
            self.accepted += 1
        else:
            self.refused += 1
        return refusal

    def repeat(self) -> None:
        """Command the last accepted positions once more, at rest: what to do when nothing better is left."""
        last = self.last
        self.last = dataclasses.replace(
            last, stamp_s=self._clock.now_s(), sequence=last.sequence + 1, owner=HOLD, v=np.zeros(len(last.v))
        )
        self._robot.command(self.last)

    def go_on(self, period_s: float) -> None:
        """The robot followed the last setpoint for longer than a period: judge the next one from now on."""
        self.last = dataclasses.replace(self.last, stamp_s=self._clock.now_s() - period_s)

    def go_limp(self, measured_rad: Array, measured_rad_s: Array) -> None:
        """Command where the joints are anyway, without feed-forward, so that the servos push nothing.

        Only for a stop of category 0, which a person asked for; the robot will sink down.
        """
        self.last = JointSetpoint(
            self._clock.now_s(),
            self.last.sequence + 1,
            HOLD,
            measured_rad.copy(),
            measured_rad_s.copy(),
            np.zeros(len(measured_rad)),
        )
        self._robot.command(self.last)

    def _judge(self, setpoint: JointSetpoint) -> Refusal | None:
        last = self.last
        n = len(self._joints)
        if not setpoint.q.shape == setpoint.v.shape == setpoint.tau.shape == (n,):
            wrong = next(each for each in (setpoint.q, setpoint.v, setpoint.tau) if each.shape != (n,))
            return Refusal(Limit.SHAPE, setpoint.owner, float(wrong.size), float(n))
        if setpoint.sequence != last.sequence + 1:
            return Refusal(Limit.SEQUENCE, setpoint.owner, float(setpoint.sequence), float(last.sequence + 1))
        age_s = self._clock.now_s() - setpoint.stamp_s
        if not -_ROUNDING <= age_s <= self._max_age_s + _ROUNDING:
            return Refusal(Limit.AGE, setpoint.owner, age_s, self._max_age_s)
        dt = setpoint.stamp_s - last.stamp_s
        if dt <= 0.0:
            return Refusal(Limit.AGE, setpoint.owner, setpoint.stamp_s, last.stamp_s)
        if not within_limits(
            setpoint.q, setpoint.v, setpoint.tau, last.q, last.v, dt, self._least, self._most, self._judged
        ):
            return self._explain()
        forbidden = self._authority.forbidden(setpoint.owner)
        if forbidden is not None and moves_any(setpoint.q, setpoint.v, last.q, forbidden):
            moved = setpoint.q - last.q
            worst = int(np.argmax(forbidden * (np.abs(moved) + np.abs(setpoint.v))))
            culprit = f"{self._joints[worst]} (moved by {setpoint.owner})"
            return Refusal(Limit.OWNER, culprit, float(moved[worst]), 0.0)
        return None

    def _explain(self) -> Refusal:
        """Find what was broken: the first kind in the order of the checks, there the worst joint."""
        judged = self._judged
        finite = np.isfinite(judged[:3])
        if not finite.all():
            row, joint = np.argwhere(~finite)[0]
            return Refusal(Limit.NOT_FINITE, self._joints[joint], float(judged[row, joint]), 0.0)
        excess = np.maximum(judged - self._most, self._least - judged)
        row = int(np.argmax((excess > 0.0).any(axis=1)))
        joint = int(np.argmax(excess[row]))
        value = float(judged[row, joint])
        bound = self._upper[row, joint] if value > self._upper[row, joint] else self._lower[row, joint]
        return Refusal(_CHECKS[row], self._joints[joint], value, float(bound))
