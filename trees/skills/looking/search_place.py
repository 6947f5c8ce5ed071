"""Look around for what a task is aimed at."""

from __future__ import annotations

from collections.abc import Sequence as Many

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.beliefs.grounding.destination import SLOTS
from trees.nodes.alternatives import Alternatives
from trees.nodes.judgements import looking_elsewhere_is_useless
from trees.policy import Gaze
from trees.skills.looking.locate import Locate
from trees.skills.looking.look_at import LookAt
from trees.toolbox import Toolbox


def search_place(
    name: str,
    toolbox: Toolbox,
    gazes: Many[Gaze],
    slots: Many[str] = SLOTS,
    further: Many[Behaviour] = (),
) -> Alternatives:
    """From here, then one gaze after the other, then further looks, until it is seen; writes "place".

    Which of several is meant is not said before the looks to both sides.
    """
    sides = [k for k, gaze in enumerate(gazes) if gaze in toolbox.policy.level_gazes]
    settled = max(sides, default=-1)
    looks: list[Behaviour] = [Locate("look from here", toolbox, slots, settles=not sides)]
    for k, gaze in enumerate(gazes):
        locate = Locate("locate", toolbox, slots, settles=k >= settled)
        children: list[Behaviour] = [LookAt("look", toolbox, gaze), locate]
        looks.append(Sequence(f"look {gaze.name}", memory=True, children=children))
    return Alternatives(name, [*looks, *further], hopeless=looking_elsewhere_is_useless)


def everywhere(toolbox: Toolbox) -> tuple[Gaze, ...]:
    """Gazes for what may be a thing or a person: at the table ahead, at people, then the rest."""
    policy = toolbox.policy
    return (*policy.search_gazes[:1], *policy.level_gazes, *policy.search_gazes[1:])
