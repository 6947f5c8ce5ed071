"""Judges what follows a stop, from the simulator's truth and from the setpoints that reached the robot.

Fingers that press on something creep by micro-slips (0.4 mrad within 20 ms, also while the robot has
been standing still for seconds), so their speed is a mean over ``FINGER_MEAN_S``; that of every other
joint is the present one.
"""

from __future__ import annotations

from collections import deque

import numpy as np

from executive.session.assembly import Assembly
from kinematics.arrays import Array
from robots.control.period import PERIOD_S

REST_RAD_S = 0.02
"""A joint slower than this rests."""
REST_WITHIN_S = 0.5
STAND_WITHIN_S = 2.2
"""A robot that walks makes its last steps first."""
FINGER_MEAN_S = 0.1
HELD_FOR_S = 0.1
"""What touches nothing but the fingers' pads for so long is held. Fingers that close lift what they press by
a hair, for an instant, while it still stands."""
_EVERY = 5
_OURS = ("stop", "hold", "stop of a walk")
_GRIP = "grip of "
_JOIN = "+"


class StopJudge:
    """Watches a run; ``on_period`` is called after each control period, before and after the stop.

    Attributes:
        rest_within_s: Speeds count later than that after the stop.
        settle_s: From the stop until the last joint was slower than ``REST_RAD_S`` for good.
        late_rad_s: Speed of the fastest joint later than ``REST_WITHIN_S``, and its name.
        finger_rad_s: Present speed of the fastest finger joint later than that, for the record.
        acceleration, jerk: Largest of the setpoints after the stop, as shares of the limits, with the joint.
            In the last steps of a walk the limits of steps count, and no jerk: there is no limit for it.
        fell: Whether the robot fell.
        dropped: What was held at the stop and touched anything but the hand later.
        held: What was held at the stop, and which hand held it.
        foreign: Owners of setpoints after the stop that are neither stop, hold, nor a grip.
        bypassed: Setpoints that reached the robot after the stop past the gate.
        moved: Whether a setpoint moved a body joint after it had come to rest.
    """

    def __init__(self, assembly: Assembly) -> None:
        self._assembly = assembly
        self._truth, self._loop = assembly.world.truth, assembly.loop
        description = assembly.model.description
        self._joints, self._bodies = description.actuated, len(description.joints)
        self._pads = {hand: set(grip.pad_links) for hand, grip in description.grippers.items()}
        limits = [description.limits[name] for name in self._joints]
        self._acceleration = np.array([limit.acceleration for limit in limits])
        self._jerk = np.array([limit.jerk for limit in limits])
        self._v: list[Array] = []
        self._fingers: deque[Array] = deque(maxlen=1 + round(FINGER_MEAN_S / PERIOD_S))
        self._in_pads: deque[dict[str, str]] = deque(maxlen=round(HELD_FOR_S / PERIOD_S / _EVERY))
        self._periods = 0
        self._since: int | None = None
        self._watching_setpoints = False
        self._q_rest: Array | None = None
        self._uncounted = 0
        gains = assembly.world.robot.hardware.walking
        walking = gains.joint_acceleration if gains is not None else {}
        steps = [
            walking.get(name, limit.acceleration) for name, limit in zip(self._joints, limits, strict=True)
        ]
        self._step_acceleration = np.array(steps)
        self.rest_within_s = REST_WITHIN_S
        self.settle_s = 0.0
        self.late_rad_s: tuple[float, str] = (0.0, "")
        self.finger_rad_s = 0.0
        self.acceleration: tuple[float, str] = (0.0, "")
        self.jerk: tuple[float, str] = (0.0, "")
        self.fell = False
        self.dropped: set[str] = set()
        self.held: dict[str, str] = {}
        self.foreign: set[str] = set()
        self.bypassed = 0
        self.moved = False

    def begin(self) -> None:
        """From now on everything counts."""
        self._since = self._periods
        if self._loop.walking.active:
            self.rest_within_s = STAND_WITHIN_S
        self._watching_setpoints = True
        self._uncounted = self._assembly.world.robot.taken - self._loop.statistics.accepted
        self.held = self._held()

    def let_move(self) -> None:
        """From now on the robot may move again; falls and drops go on counting."""
        self._watching_setpoints = False

    def on_period(self) -> None:
        """Look at robot and world."""
        self._periods += 1
        self._v = [*self._v[-2:], self._loop.setpoint.v]
        if self._since is None:
            if self._periods % _EVERY == 0:
                self._in_pads.append(self._now_in_pads())
            return
        elapsed = self._periods - self._since
        if self._watching_setpoints:
            self._look_at_speeds(elapsed * PERIOD_S)
            self._look_at_setpoint()
        if elapsed % _EVERY == 0:
            self.fell = self.fell or self._truth.fallen()
            for name, hand in self.held.items():
                pads = next(links for key, links in self._pads.items() if key == hand)
                if not set(self._truth.contacts.of_object(name)) <= pads:
                    self.dropped.add(name)

    def _now_in_pads(self) -> dict[str, str]:
        return {name: str(hand) for name, hand in self._truth.contacts.in_pads_only().items()}

    def _held(self) -> dict[str, str]:
        now = self._now_in_pads()
        return {name: hand for name, hand in now.items() if all(name in then for then in self._in_pads)}

    def _look_at_speeds(self, elapsed_s: float) -> None:
        speed = np.abs(self._truth.joint_velocities())
        self._fingers.append(self._truth.joint_positions()[self._bodies :])
        self.finger_rad_s = max(self.finger_rad_s, self._finger_speed(elapsed_s, speed))
        passed_s = max((len(self._fingers) - 1) * PERIOD_S, PERIOD_S)
        if elapsed_s >= FINGER_MEAN_S:
            speed[self._bodies :] = np.abs(self._fingers[-1] - self._fingers[0]) / passed_s
        worst = int(np.argmax(speed))
        if speed[worst] >= REST_RAD_S:
            self.settle_s = elapsed_s
        if elapsed_s >= self.rest_within_s and speed[worst] > self.late_rad_s[0]:
            self.late_rad_s = float(speed[worst]), self._joints[worst]

    def _finger_speed(self, elapsed_s: float, speed: Array) -> float:
        return float(speed[self._bodies :].max()) if elapsed_s >= self.rest_within_s else 0.0

    def _look_at_setpoint(self) -> None:
        setpoint = self._loop.setpoint
        self.foreign |= {
            part for part in setpoint.owner.split(_JOIN) if part not in _OURS and not part.startswith(_GRIP)
        }
        self.bypassed = self._assembly.world.robot.taken - self._loop.statistics.accepted - self._uncounted
        if len(self._v) == 3:
            a = np.diff(self._v, axis=0) / PERIOD_S
            walks = self.rest_within_s > REST_WITHIN_S
            most = self._step_acceleration if walks else self._acceleration
            self.acceleration = self._worse(self.acceleration, np.abs(a[1]) / most)
            if not walks:
                self.jerk = self._worse(self.jerk, np.abs(a[1] - a[0]) / PERIOD_S / self._jerk)
        body = setpoint.q[: self._bodies]
        if setpoint.v[: self._bodies].any():
            self.moved = self.moved or self._q_rest is not None
        elif self._q_rest is None:
            self._q_rest = body.copy()
        elif np.any(body != self._q_rest):
            self.moved = True

    def _worse(self, before: tuple[float, str], shares: Array) -> tuple[float, str]:
        worst = int(np.argmax(shares))
        return max(before, (float(shares[worst]), self._joints[worst]))
