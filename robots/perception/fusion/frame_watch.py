"""Notices frames that say nothing of now: too old ones, and the same one again and again."""

from __future__ import annotations

from enum import Enum

from robots.perception.detector import PerceptionFrame

SILENT_S = 0.4
"""A camera that takes fifteen pictures a second has missed six by then."""
OLD_S = 0.5
"""Frames that are older than this when they come tell of another time; a detector takes 0.15 s at most."""
_LATE_IN_A_ROW = 3
"""Of a camera that hangs behind; fewer may be left over."""
_SAME_IN_A_ROW = 4
"""So many pictures of a camera that has noise are never equal to the last digit."""


class Fault(Enum):
    """What is wrong with a source of frames."""

    FROZEN = "the same picture again and again"
    STALE = "pictures that are too old"


class FrameWatch:
    """Watches the frames of one source, from the moment that somebody looks.

    The newest frame is shown to it again and again. It is frozen when no frame is newer than the last for
    ``SILENT_S``, and when frames with new numbers and stamps tell the same to the last digit, although the
    detector declares noise. It is stale when several come in a row that are older than ``OLD_S``: one or two
    may be left over from before anybody looked.
    """

    def __init__(self, now_s: float) -> None:
        """Begin to look."""
        self._since_s = self._shown_s = now_s
        self._last: PerceptionFrame | None = None
        self._same = self._late = 0

    def take(self, frame: PerceptionFrame | None, now_s: float) -> Fault | None:
        """What is wrong with the source, as far as the newest frame tells.

        Args:
            frame: The newest one, or None before the first.
            now_s: When it is shown.
        """
        unseen_s = now_s - self._shown_s
        if unseen_s > 0.5 * SILENT_S:  # nobody looked meanwhile
            self._since_s = now_s
        self._shown_s = now_s
        last = self._last
        if frame is not None and (last is None or frame.sequence != last.sequence):
            self._same = self._same + 1 if last is not None and _is_copy(last, frame) else 0
            if last is None or frame.stamp_s > last.stamp_s:
                if last is not None:
                    self._since_s = now_s
                self._last = frame
        if self._last is None:
            return None
        if self._same >= _SAME_IN_A_ROW - 1:
            return Fault.FROZEN
        if frame is not None and frame.sequence != self._last.sequence:
            return Fault.STALE
        if now_s - self._since_s > SILENT_S:
            return Fault.FROZEN
        if last is not None and self._last is not last:
            late_s = now_s - self._last.stamp_s - unseen_s  # at least so, when it came
            self._late = self._late + 1 if late_s > OLD_S else 0
            return Fault.STALE if self._late >= _LATE_IN_A_ROW else None
        return None


def _is_copy(before: PerceptionFrame, frame: PerceptionFrame) -> bool:
    """Whether two frames of a noisy detector tell the same to the last digit."""
    if not frame.detections or len(before.detections) != len(frame.detections):
        return False
    return all(
        one.error is not None and one.error.is_noisy and (one.camera_T_object == other.camera_T_object).all()
        for one, other in zip(frame.detections, before.detections, strict=True)
    )
