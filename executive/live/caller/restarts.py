"""How often an executive that ended is replaced: a rate, for a robot may be served for weeks."""

from __future__ import annotations

MOST = 5
WITHIN_S = 300.0
"""``MOST`` replacements within this time did not help: one more would end as well."""
WELL_AFTER_S = 60.0
"""An executive that has commanded the robot for so long is well, and what was before it counts no more."""


class Restarts:
    """Counts replacements within a window; times are those of the wall, in seconds."""

    def __init__(
        self, most: int = MOST, within_s: float = WITHIN_S, well_after_s: float = WELL_AFTER_S
    ) -> None:
        self._most, self._within_s, self._well_after_s = most, within_s, well_after_s
        self._taken_s: list[float] = []
        self._well_since_s: float | None = None

    def note_health(self, commands: bool, now_s: float) -> None:
        """Note whether the executive of the moment commands the robot; for long enough, and it is well."""
        if not commands:
            self._well_since_s = None
        elif self._well_since_s is None:
            self._well_since_s = now_s
        elif now_s - self._well_since_s >= self._well_after_s:
            self._taken_s.clear()

    def take(self, now_s: float) -> bool:
        """Take one replacement; False when there were too many within the window."""
        self._well_since_s = None
        self._taken_s = [taken_s for taken_s in self._taken_s if now_s - taken_s < self._within_s]
        if len(self._taken_s) >= self._most:
            return False
        self._taken_s.append(now_s)
        return True
