"""See a door that is to be pushed shut, and remember it."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from robots.articulated import DRAWER
from robots.perception.object_estimate import ObjectEstimate
from trees.failures import Failure, FailureKind
from trees.handles import HandleTarget
from trees.leaves.detect_handle import DetectHandle
from trees.look_leaf import View
from trees.pushed_front import fronts_in
from trees.scene_update import kind_of


class DetectFront(DetectHandle):
    """As ``DetectHandle``, but the handle need not be seen: an open door hides it from most gazes."""

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
