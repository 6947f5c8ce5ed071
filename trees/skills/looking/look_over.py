"""Look one way after the other: over all that is about, or past what the hands hold."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import looking_elsewhere_is_useless
from trees.skills.looking.hands_aside import HandsAside
from trees.skills.looking.look_at import LookAt
from trees.skills.looking.survey import Survey
from trees.toolbox import Toolbox


def look_over(toolbox: Toolbox) -> Behaviour:
    """Both sides, as far as the head gets there; what was seen, and from where, is in the world model."""
    looks: list[Behaviour] = []
    for gaze in toolbox.policy.survey_gazes:
        children: list[Behaviour] = [
            LookAt("look", toolbox, gaze),
            Survey("survey", toolbox, {"sightings_now": "sightings"}),
        ]
        looks.append(BestEffort(Sequence(f"look {gaze.name}", memory=True, children=children)))
    return Sequence("look it over", memory=True, children=looks)


def look_past_hands(name: str, find: Callable[[], Behaviour], toolbox: Toolbox) -> Alternatives:
    """One gaze after the other until something is found; early on with the hands drawn in.

    Args:
        name: Of the whole.
        find: Makes the leaf that judges each look.
        toolbox: What the leaves may call.
    """
    first, *others = toolbox.policy.search_gazes
    looks: list[Behaviour] = []
    for look, gaze, before in (
        ("look ahead", first, []),
        ("draw the hand in", first, [HandsAside("hand away", toolbox)]),
        *((f"look {gaze.name}", gaze, []) for gaze in others),
    ):
        children: list[Behaviour] = [*before, LookAt("look", toolbox, gaze), find()]
        looks.append(Sequence(look, memory=True, children=children))
    return Alternatives(name, looks, hopeless=looking_elsewhere_is_useless)
