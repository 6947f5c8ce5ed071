"""Look around for the object that is meant."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.alternatives import Alternatives, defect
from trees.failures import Failure
from trees.leaves.detect import Detect, wants_survey
from trees.leaves.look_at import LookAt
from trees.policy import Gaze
from trees.toolbox import Toolbox


def search(name: str, toolbox: Toolbox) -> Alternatives:
    """One gaze after the other, until the object is detected.

    When several things fit, or the description compares them, the head looks to both sides before one is
    chosen or a question is put: what is out of view counts as well.
    """
    gazes, survey = toolbox.policy.search_gazes, toolbox.policy.survey_gazes
    looks = [_look(gaze, toolbox, surveyed=False) for gaze in gazes]
    looks += [_look(gaze, toolbox, surveyed=gaze is survey[-1]) for gaze in survey]
    return Alternatives(name, looks, looking_elsewhere_is_useless, as_needed)


def as_needed(look: Behaviour, failure: Failure | None) -> bool:
    """The looks to both sides when they are asked for, the others when not."""
    surveys = any(
        isinstance(leaf, LookAt) and leaf.gaze in leaf.toolbox.policy.survey_gazes for leaf in look.children
    )
    return surveys == (failure is not None and wants_survey(failure))


def _look(gaze: Gaze, toolbox: Toolbox, *, surveyed: bool) -> Behaviour:
    detect = Detect("detect", toolbox, surveyed=surveyed, looking_around=True)
    children: list[Behaviour] = [LookAt("look", toolbox, gaze), detect]
    return Sequence(f"look {gaze.name}", memory=True, children=children)


def looking_elsewhere_is_useless(failure: Failure) -> bool:
    """A defect, or several objects in view that fit: that takes an answer, not another look."""
    return defect(failure) or bool(failure.choices)
