"""Find, count and describe: looks from several points of view, then an answer."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.alternatives import Alternatives
from trees.best_effort import BestEffort
from trees.leaves.go_home import GoHome
from trees.leaves.locate import Locate
from trees.leaves.look_at import LookAt
from trees.leaves.look_past import LookPast
from trees.leaves.survey import Survey
from trees.leaves.tell import TellCount, TellDescription
from trees.leaves.tell_found import TellFound
from trees.subtrees.search_place import everywhere, search_place
from trees.subtrees.tidily import tidily
from trees.subtrees.who_speaks import nobody_spoke, who_speaks
from trees.toolbox import Toolbox


def find(toolbox: Toolbox) -> Behaviour:
    """Look everywhere, at last past what hides things, and say where. Reads "task", writes "evidence"."""
    past: list[Behaviour] = [
        Sequence(
            f"look past {k}",
            memory=True,
            children=[LookPast("peer", toolbox), Locate("locate", toolbox)],
        )
        for k in range(1, toolbox.policy.looks_past + 1)
    ]
    looks = search_place("look for it", toolbox, everywhere(toolbox), further=past)
    looks = Alternatives("see it", [who_speaks(toolbox), looks], nobody_spoke)
    looks.transparent = True
    children: list[Behaviour] = [looks, TellFound("tell", toolbox)]
    return tidily("find", children, toolbox)


def count(toolbox: Toolbox) -> Behaviour:
    """Look everywhere, then say how many. Reads "task", writes "evidence"."""
    return tidily("count", [*_looks(toolbox), TellCount("tell", toolbox)], toolbox)


def describe(toolbox: Toolbox) -> Behaviour:
    """Look everywhere, then say what is there. Reads "task", writes "evidence"."""
    return tidily("describe", [*_looks(toolbox), TellDescription("tell", toolbox)], toolbox)


def _looks(toolbox: Toolbox) -> list[Behaviour]:
    """A survey from each gaze, and home again: a posture that cannot be reached is left out."""
    looks: list[Behaviour] = []
    for gaze in toolbox.policy.inventory_gazes:
        pair: list[Behaviour] = [
            LookAt("look", toolbox, gaze),
            Survey("survey", toolbox, {"sightings_now": "sightings"}),
        ]
        looks.append(BestEffort(Sequence(f"look {gaze.name}", memory=True, children=pair)))
    return [*looks, GoHome("go home", toolbox)]
