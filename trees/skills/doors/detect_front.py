"""See a door that is to be pushed shut, and remember it."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.articulated import DRAWER
from trees.beliefs.openings.handles import HandleTarget
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure, FailureKind
from trees.skills.doors.detect_handle import DetectHandle
from trees.skills.doors.pushed_front import fronts_in
from trees.skills.looking.look_leaf import View


class DetectFront(DetectHandle):
    """See a door that is to be pushed shut, with or without its handle.

    An open door hides its handle from most directions, and a hand can push it without one.
    """

    _drawers = False

    def candidates(self, seen: Mapping[str, ObjectEstimate]) -> list[HandleTarget]:
        """Doors with what they belong to."""
        self._drawers = any(kind_of(name) == DRAWER for name in seen)
        return fronts_in(seen)

    def judge(self, views: list[View]) -> Status | Failure:
        """Drawers are not pushed: told so that nobody looks for a door behind them."""
        outcome = super().judge(views)
        if isinstance(outcome, Failure) and outcome.kind is FailureKind.POSTCONDITION and self._drawers:
            return Failure.infeasible("a drawer is closed by its handle")
        return outcome
