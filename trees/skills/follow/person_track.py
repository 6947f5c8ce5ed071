"""Where somebody is who is watched, from sighting to sighting."""

from __future__ import annotations

import math
from collections import deque

_FASTEST_M_S = 2.0
"""Nobody in a house walks faster."""
_GATE_M = 0.5
"""Off by so much at most a sighting may be: two people stand no nearer to each other."""
_SPAN_S = 0.8
"""Velocities are told from so much of the past: longer than a step of the robot, whose sway is in them."""


class PersonTrack:
    """The estimate of one person's place on the floor, in the odometry frame.

    Attributes:
        name: What the person is called, as the detector tells it.
        x_m, y_m: Where the person was seen last.
        seen_s: When that was.
        walked: Whether the person has gone somewhere since the track began.
    """

    def __init__(self, name: str, x_m: float, y_m: float, now_s: float, still_m: float) -> None:
        """Begin where the person was seen.

        Args:
            name: Of the person.
            x_m, y_m: Place on the floor.
            now_s: When that was.
            still_m: Who moves less than this stands.
        """
        self.name, self.x_m, self.y_m, self.seen_s = name, x_m, y_m, now_s
        self.walked = False
        self._still_m = still_m
        self._rested = x_m, y_m
        self._rested_s = now_s
        self._past: deque[tuple[float, float, float]] = deque([(now_s, x_m, y_m)])

    def fits(self, name: str | None, x_m: float, y_m: float, seen_s: float) -> bool:
        """Whether a sighting may be of this person: by the name if it is told, and by how far one walks.

        Args:
            name: As the detector tells it; None where nobody was recognised.
            x_m, y_m: Of the sighting.
            seen_s: When the picture was taken.
        """
        if name is not None and name != self.name:
            return False
        reach_m = _GATE_M + _FASTEST_M_S * max(seen_s - self.seen_s, 0.0)
        return math.dist((x_m, y_m), (self.x_m, self.y_m)) <= reach_m

    def take(self, x_m: float, y_m: float, seen_s: float) -> None:
        """Take a sighting of the person in."""
        self.x_m, self.y_m, self.seen_s = x_m, y_m, seen_s
        self._past.append((seen_s, x_m, y_m))
        while len(self._past) > 2 and seen_s - self._past[0][0] > _SPAN_S:
            self._past.popleft()
        if math.dist((x_m, y_m), self._rested) > self._still_m:
            self._rested, self._rested_s, self.walked = (x_m, y_m), seen_s, True

    @property
    def still_s(self) -> float:
        """For how long the person was seen to stand; who is out of sight may have walked on."""
        return self.seen_s - self._rested_s

    def velocity_m_s(self) -> tuple[float, float]:
        """How the person walked of late."""
        (t0, x0, y0), (t1, x1, y1) = self._past[0], self._past[-1]
        if t1 - t0 < 0.5 * _SPAN_S:
            return 0.0, 0.0
        return (x1 - x0) / (t1 - t0), (y1 - y0) / (t1 - t0)

    def place(self, now_s: float) -> tuple[float, float]:
        """Where the person is by now if the walk went on; a sighting is a while old."""
        ahead_s = min(max(now_s - self.seen_s, 0.0), _SPAN_S)
        vx, vy = self.velocity_m_s()
        return self.x_m + ahead_s * vx, self.y_m + ahead_s * vy
