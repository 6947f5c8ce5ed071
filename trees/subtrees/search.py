"""Look around for the object that is meant."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.alternatives import Alternatives, defect
from trees.failures import Failure
from trees.leaves.detect import Detect
from trees.leaves.look_at import LookAt
from trees.toolbox import Toolbox


def search(name: str, toolbox: Toolbox) -> Alternatives:
    """One gaze after the other, until the object is detected."""
    looks = []
    for gaze in toolbox.policy.search_gazes:
        children: list[Behaviour] = [LookAt("look", toolbox, gaze), Detect("detect", toolbox)]
        looks.append(Sequence(f"look {gaze.name}", memory=True, children=children))
    return Alternatives(name, looks, hopeless=looking_elsewhere_is_useless)


def looking_elsewhere_is_useless(failure: Failure) -> bool:
    """A defect, or several objects in view that fit: that takes an answer, not another look."""
    return defect(failure) or bool(failure.choices)
