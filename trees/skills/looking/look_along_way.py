"""A way of a hand over nothing but what was looked at."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.nodes.best_effort import BestEffort
from trees.skills.looking.find_unseen import FindUnseen
from trees.skills.looking.look_at import LookAtUnseen
from trees.skills.looking.survey import Survey
from trees.skills.looking.unless_seen import UnlessSeen
from trees.toolbox import Toolbox


def seen_way(
    name: str, toolbox: Toolbox, find: type[FindUnseen], plan: Callable[[], Behaviour], looks: int
) -> Behaviour:
    """Look at what is unseen below a planned way, and plan anew; a new way may be unseen in its turn.

    Args:
        name: What the looking is called.
        toolbox: What leaves may call.
        find: Finds what is unseen.
        plan: Makes the leaf that plans the way again.
        looks: So many, one after the other, at the most.
    """
    steps: list[Behaviour] = [
        BestEffort(LookAtUnseen("look", toolbox)),
        Survey("survey", toolbox, {"sightings_now": "sightings"}, keeping=True),
        plan(),
    ]
    if looks > 1:
        steps.append(seen_way(name, toolbox, find, plan, looks - 1))
    children: list[Behaviour] = [
        find("find what is unseen", toolbox),
        UnlessSeen(Sequence(name, memory=True, children=steps)),
    ]
    return Sequence("its way is seen", memory=True, children=children)
