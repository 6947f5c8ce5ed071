"""Find out where a thing goes before it is fetched."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure, FailureKind
from trees.nodes.alternatives import Alternatives
from trees.nodes.judgements import judgement, looking_elsewhere_is_useless
from trees.skills.looking.look_at import LookAt
from trees.skills.place.know_destination import KnowDestination
from trees.toolbox import Toolbox


def know_destination(toolbox: Toolbox) -> Behaviour:
    """Looks until what it is put on, beside or into is seen. Reads "task"."""
    looks: list[Behaviour] = [KnowDestination("as seen from here", toolbox)]
    for gaze in (*toolbox.policy.search_gazes, *toolbox.policy.level_gazes):
        children: list[Behaviour] = [
            LookAt("look", toolbox, gaze),
            KnowDestination("know destination", toolbox),
        ]
        looks.append(Sequence(f"look {gaze.name}", memory=True, children=children))
    return Alternatives("where it goes", looks, hopeless=cannot_go_there)


@judgement
def cannot_go_there(failure: Failure) -> bool:
    """Several that fit, or one that things are not put on or into."""
    return looking_elsewhere_is_useless(failure) or failure.kind is FailureKind.INFEASIBLE
