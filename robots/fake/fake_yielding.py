"""Yielding hands of the fake robot: they follow their path exactly, and nothing pushes back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from kinematics.model.robot_description import Hand
from robots.control.hands.yield_order import YieldOrder
from robots.control.hands.yield_settings import Outcome, YieldReport
from robots.control.motion_handle import MotionHandle, MotionStatus
from robots.fake.fake_gripper import FakeGripper
from robots.fake.fake_motion import FakeMotion

# A path is followed in so many periods.
_PERIODS = 6


class Reach(Protocol):
    """Brings a hand to a place."""

    def __call__(self, q: NDArray[np.float64], hand: Hand, place: NDArray[np.float64]) -> NDArray[np.float64]:
        """Configuration with the TCP of a hand at a place, shape (3,)."""
        ...


class FakeYieldingMotion:
    """One hand that leads, or stays until told to finish; satisfies ``trees.toolbox.YieldingMotion``."""

    def __init__(self, order: YieldOrder, handle: MotionHandle, pull_n: float = 0.0) -> None:
        """Begin where the order does; the hand tells that it pulled so much."""
        self._order, self._handle = order, handle
        self._pull_n = pull_n
        self._made = 0
        self._finishing = False
        self._outcome: Outcome = "running"

    @property
    def handle(self) -> MotionHandle:
        """The motion's."""
        return self._handle

    @property
    def order(self) -> YieldOrder:
        """What was asked for."""
        return self._order

    @property
    def s(self) -> float:
        """Where along the path it is."""
        share = self._made / _PERIODS
        return self._order.s_from + share * (self._order.s_to - self._order.s_from)

    @property
    def report(self) -> YieldReport:
        """No force was felt, but for what it was told to have pulled with."""
        return YieldReport(self._outcome, self.s, self._pull_n, self._pull_n, np.zeros(6))

    def finish(self) -> None:
        """Come to rest where the hand is."""
        self._finishing = True

    def advance(self, holding: bool) -> None:
        """One period more.

        Args:
            holding: Whether the hand has something.
        """
        leads = self._order.s_from != self._order.s_to
        if leads and self._order.holding and not holding:
            self._end("lost")
        elif self._finishing or (leads and self._made == _PERIODS):
            self._end("arrived")
        elif leads:
            self._made += 1
            self._handle.progress = self._made / _PERIODS

    def _end(self, outcome: Outcome) -> None:
        self._outcome = outcome
        self._handle.status, self._handle.progress = MotionStatus.DONE, 1.0


class FakeYielding:
    """Yielding hands of the fake robot; satisfies ``trees.toolbox.Yielding``.

    Attributes:
        hangs: While true, no hand moves.
        pull_n: What hands tell that they pulled with.
    """

    def __init__(self, motion: FakeMotion, grippers: Mapping[Hand, FakeGripper], reach: Reach) -> None:
        """Hands of one robot."""
        self.hangs = False
        self.pull_n = 0.0
        self._motion, self._grippers, self._reach = motion, grippers, reach
        self._active: FakeYieldingMotion | None = None

    def start(self, order: YieldOrder) -> FakeYieldingMotion:
        """Begin where the robot is."""
        moving = FakeYieldingMotion(order, self._motion.note(f"yield {order.hand} hand"), self.pull_n)
        self._active = moving
        return moving

    def advance(self) -> None:
        """Lead the hand a little farther."""
        moving = self._active
        if moving is None or moving.handle.finished or self.hangs:
            return
        order, before = moving.order, moving.s
        moving.advance(self._grippers[order.hand].holding is not None)
        if self._motion.refuse_midway and moving.handle.progress >= 0.5:
            moving.handle.status, moving.handle.reason = MotionStatus.REFUSED, self._motion.refuse_midway
        elif moving.s != before:
            place = order.path.at(moving.s).position_m
            self._motion.be_at(self._reach(self._motion.reference(), order.hand, place))
