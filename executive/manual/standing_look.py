"""Looks while a person has the robot: whenever it stands still it sees what is around, and believes it."""

from __future__ import annotations

from trees.skills.looking.folded_look import folded_look
from trees.skills.looking.look_leaf import View
from trees.toolbox import Toolbox

_RESTS_S = 0.3
"""After this long at rest pictures count: the body has stopped swaying."""
_AGAIN_S = 3.0
"""A robot that stands for longer looks again: things may have moved."""


class StandingLook:
    """Takes a look at each standstill, and folds it into the world model.

    Attributes:
        taken: How many looks there were.
    """

    def __init__(self, toolbox: Toolbox) -> None:
        """Begin; the robot stands."""
        self._toolbox = toolbox
        self._rests_since_s: float | None = None
        self._views: list[View] = []
        self._looked_s: float | None = None
        self.taken = 0

    def tick(self, rests: bool) -> None:
        """Go on by a tick.

        Args:
            rests: Whether nothing is commanded to move.
        """
        now_s = self._toolbox.clock.now_s()
        if not rests:
            self._rests_since_s, self._views, self._looked_s = None, [], None
            return
        if self._rests_since_s is None:
            self._rests_since_s = now_s
        if self._looked_s is not None:
            if now_s - self._looked_s >= _AGAIN_S:
                self._rests_since_s, self._views, self._looked_s = now_s, [], None
            return
        self._gather(self._rests_since_s + _RESTS_S)
        if len(self._views) >= self._toolbox.policy.look_frames:
            folded_look(self._toolbox, self._views, keeping=True)
            self._looked_s, self.taken = now_s, self.taken + 1

    def _gather(self, since_s: float) -> None:
        frame = self._toolbox.detector.latest()
        if frame is None or frame.stamp_s < since_s:
            return
        if self._views and frame.sequence <= self._views[-1].frame.sequence:
            return
        model = self._toolbox.model
        q = self._toolbox.sensing.state_at(frame.stamp_s).q
        self._views.append(View(model.frame_pose(q, model.description.camera.frame), frame))
