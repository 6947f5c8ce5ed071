"""Look around for the object that is meant."""

from __future__ import annotations

from py_trees.composites import Sequence

from trees.alternatives import Alternatives, defect
from trees.failures import Failure, FailureKind
from trees.leaves.detect import Detect
from trees.leaves.look_at import LookAt
from trees.toolbox import Toolbox

_NAMES = ("ahead", "left", "right", "far ahead", "far left", "far right")


def search(name: str, toolbox: Toolbox) -> Alternatives:
    """One gaze after the other, until the object is detected."""
    looks = []
    for number, gaze in enumerate(toolbox.policy.search_gazes_rad):
        place = _NAMES[number] if number < len(_NAMES) else f"place {number + 1}"
        children = [LookAt("look", toolbox, gaze), Detect("detect", toolbox)]
        looks.append(Sequence(f"look {place}", memory=True, children=list(children)))
    return Alternatives(name, looks, hopeless=looking_elsewhere_is_useless)


def looking_elsewhere_is_useless(failure: Failure) -> bool:
    """A defect, or several objects in view that fit: that takes an answer, not another look."""
    return defect(failure) or (failure.kind is FailureKind.INFEASIBLE and "choices" in failure.numbers)
