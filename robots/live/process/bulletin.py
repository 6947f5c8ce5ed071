"""What the control process tells unasked: its condition, events, motions under way, pictures, range scans."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable

from robots.clock import Clock
from robots.control.events import ControlEvent
from robots.control.loop.control_loop import ControlLoop
from robots.live.documents.frame_message import write_frame
from robots.live.documents.scan_message import RangeScan, write_scan
from robots.live.process.condition import emergency_json, health_json
from robots.live.process.motion_desk import MotionDesk
from robots.live.wire.connection import Connection
from robots.live.wire.messages import write_message
from robots.perception.detector import Detector, RangeSensor
from robots.perception.fusion.cameras import HEAD, PlacedCamera

_PROGRESS_EVERY = 25
"""Polls between two reports of a motion's progress."""

_SCAN_EVERY = 50
"""Polls between two range scans."""


@dataclasses.dataclass(frozen=True, slots=True)
class Wanted:
    """What the commander wants to see at present."""

    pictures: bool
    scans: bool


class Bulletin:
    """Tells everyone what has changed, and the commander what it has begun and wants to see."""

    def __init__(
        self,
        loop: ControlLoop,
        clock: Clock,
        detector: Detector,
        ranging: RangeSensor | None,
        motions: MotionDesk,
        cameras: Iterable[PlacedCamera] = (),
    ) -> None:
        """Begin with the present condition, which everyone is told when they connect."""
        self._loop, self._clock, self._motions = loop, clock, motions
        self._detectors = {HEAD: detector, **{camera.name: camera.detector for camera in cameras}}
        self._ranging = ranging
        self._events: list[ControlEvent] = []
        self._frames = dict.fromkeys(self._detectors, -1)
        self._polls = self._scan_due = 0
        self._told_emergency, self._told_health = emergency_json(loop), health_json(loop)

    def note(self, event: ControlEvent) -> None:
        """Take an event, to be told next."""
        self._events.append(event)

    def tell(self, commander: Connection | None, listeners: Iterable[Connection], wanted: Wanted) -> None:
        """Tell what there is; once a poll.

        Args:
            commander: Who commands, if anybody does.
            listeners: Everyone who has said hello, the commander among them.
            wanted: What the commander wants to see.
        """
        self._polls += 1
        for message in (*self._condition(), *self._happened()):
            for listener in listeners:
                listener.send(message)
        motions = self._motions.told(self._polls % _PROGRESS_EVERY == 0)
        if commander is None:
            return
        for message in motions:
            commander.send(message)
        if wanted.scans:  # first: pictures come more often, and fill the socket of who reads slowly
            self._show_scan(commander)
        if wanted.pictures:
            self._show_frame(commander)

    def _condition(self) -> list[bytes]:
        engaged, health = emergency_json(self._loop), health_json(self._loop)
        told = [] if engaged == self._told_emergency else [write_message("emergency", **engaged)]
        told += [] if health == self._told_health else [write_message("health", **health)]
        self._told_emergency, self._told_health = engaged, health
        return told

    def _happened(self) -> list[bytes]:
        events, self._events = self._events, []
        return [
            write_message("event", event=type(event).__name__, **dataclasses.asdict(event))
            for event in events
        ]

    def _show_frame(self, commander: Connection) -> None:
        """Send a new frame of one camera if the one before has left; a late one is of no use.

        The camera that has waited longest comes first.
        """
        if not commander.idle:
            return
        newest = {source: detector.latest() for source, detector in self._detectors.items()}
        for source in tuple(self._frames):
            frame = newest[source]
            if frame is not None and frame.sequence != self._frames[source]:
                del self._frames[source]
                self._frames[source] = frame.sequence
                commander.send(write_frame(frame, source))
                return

    def _show_scan(self, commander: Connection) -> None:
        """The same with what the range sensor sees, as soon as it can go."""
        if self._ranging is None or self._polls < self._scan_due or not commander.idle:
            return
        self._scan_due = self._polls + _SCAN_EVERY
        points_m = self._ranging.scan()
        if points_m is not None:
            commander.send(write_scan(RangeScan(self._clock.now_s(), points_m)))
