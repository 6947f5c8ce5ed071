"""A way of a hand over nothing but what was looked at."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.nodes.best_effort import BestEffort
from trees.nodes.ports import ports
from trees.nodes.skipping import Skipping
from trees.skills.looking.find_unseen import FindUnseen
from trees.skills.looking.hand_ways import UnseenPlaces
from trees.skills.looking.look_at import LookAtUnseen
from trees.skills.looking.survey import Survey
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


class UnlessSeen(Skipping):
    """Ticks its child if a hand is to pass over places that no look has shown; otherwise succeeds at once."""

    INPUT_PORTS = ports(unseen=UnseenPlaces)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour) -> None:
        super().__init__(f"{child.name} unless seen", child)

    def needed(self) -> bool:
        """Whether there is such a place."""
        return len(self.get_input("unseen").points) > 0
