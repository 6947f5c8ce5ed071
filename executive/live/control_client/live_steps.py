"""Time in live mode: a step is waiting until control time has gone on by a period."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from executive.live.control_client.control_link import ControlLink, ControlLostError
from executive.session.lockstep import PERIODS_A_TICK
from robots.clock import WallClock
from robots.control.loop.state_history import StateHistory
from robots.control.period import PERIOD_S
from robots.perception.detector import PerceptionFrame
from robots.perception.fusion.cameras import HEAD
from trees.world_model import WorldModel

_TICK_S = PERIOD_S * PERIODS_A_TICK
_WAIT_S = 0.002
_STANDSTILL_S = 20.0
"""Wall time without control time after which nobody is there any more."""
_LOOKS_FOR_S = 0.4
"""So long after the last question for a frame, frames are wanted."""
_SCAN_IS_OLD_S = 0.35
"""Three scans in a row that did not come: 0.3 m at the fastest walk."""


class LiveClock:
    """The clock of a served robot: it tells control time."""

    def __init__(self, link: ControlLink) -> None:
        """Read it from a link."""
        self._link = link

    def now_s(self) -> float:
        """Control time of the newest state."""
        return self._link.now_s


class DetectorClient:
    """Frames from the control process; satisfies ``robots.perception.detector.Detector``."""

    def __init__(self, link: ControlLink, source: str = HEAD) -> None:
        """Take those of one camera from a link."""
        self._link, self._source = link, source
        self._asked_s = -_LOOKS_FOR_S

    @property
    def looking(self) -> bool:
        """Whether somebody has asked for a frame a short while ago."""
        return self._link.now_s - self._asked_s < _LOOKS_FOR_S

    @property
    def labels(self) -> frozenset[str] | None:
        """The words that it can tell, as the control process said when it was greeted; None: any."""
        told = self._link.about["labels"]
        return None if told is None else frozenset(map(str, told))

    @property
    def fronts(self) -> frozenset[str]:
        """The doors and drawers that it tells apart by the piece that they are of, as it was said then."""
        return frozenset(map(str, self._link.about["fronts"]))

    def latest(self) -> PerceptionFrame | None:
        """The newest frame that has been delivered, or None before the first."""
        self._asked_s = self._link.now_s
        return self._link.frames.get(self._source)


class RangingClient:
    """Range scans from the control process; satisfies ``robots.perception.detector.RangeSensor``."""

    def __init__(self, link: ControlLink) -> None:
        """Take them from a link."""
        self._link = link
        self._asked_s = -_LOOKS_FOR_S

    @property
    def wanted(self) -> bool:
        """Whether somebody has asked for a scan a short while ago."""
        return self._link.now_s - self._asked_s < _LOOKS_FOR_S

    def scan(self) -> NDArray[np.float64] | None:
        """The newest scan, or None when none has come for a while."""
        self._asked_s = self._link.now_s
        newest = self._link.scan
        if newest is None or self._link.now_s - newest.stamp_s > _SCAN_IS_OLD_S:
            return None
        return newest.points_m


class LiveSteps:
    """Lets time pass for the session: satisfies ``executive.session.lockstep.Periods``.

    The heartbeat is sent here, once a tick, and nowhere else: a tick that does not end sends none.

    Attributes:
        sensing: What the robot knows about itself, and a while ago.
        busy: Whether a task is under way.
    """

    def __init__(
        self,
        link: ControlLink,
        detector: DetectorClient,
        ranging: RangingClient,
        world: WorldModel,
        meanwhile: Callable[[], None] = lambda: None,
    ) -> None:
        """Wait on a link; ``meanwhile`` is called again and again while it waits."""
        self._link, self._detector, self._ranging, self._world = link, detector, ranging, world
        self._meanwhile = meanwhile
        self._wall = WallClock()
        self._due_s = link.now_s
        self._steps = 0
        self.sensing = StateHistory(link.report.sensed, float(link.about["state_every_s"]))
        self.busy = False

    def step(self) -> None:
        """Let a control period pass: the last one of a tick waits for them all.

        A machine that is too busy lets everyone who waits sleep for longer; ten waits in a tick were ten
        times as much, and the heartbeat came too late.

        Raises:
            ControlLostError: The control process is gone, or its time stands still.
        """
        if self._steps % PERIODS_A_TICK == 0:
            looking, ranging = self._detector.looking, self._ranging.wanted
            self._link.beat(self.busy, looking, ranging, self._world.scene.version)
        self._steps += 1
        if self._steps % PERIODS_A_TICK == 0:
            self._wait_for_tick()

    def _wait_for_tick(self) -> None:
        self._due_s += _TICK_S
        self._look()
        if self._link.now_s - self._due_s > _TICK_S:  # late: go on from now, without making up for it
            self._due_s = self._link.now_s
        patience_s = self._wall.now_s() + _STANDSTILL_S
        while self._link.now_s < self._due_s:
            self._look(_WAIT_S)
            self._meanwhile()
            if self._wall.now_s() > patience_s:
                raise ControlLostError("control time stands still")

    def _look(self, wait_s: float = 0.0) -> None:
        if self._link.poll(wait_s):
            self.sensing.add(self._link.report.sensed)
