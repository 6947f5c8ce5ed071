"""Look round once for somebody who was lost from view."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.nodes.alternatives import Alternatives
from trees.skills.follow.see_again import SeeAgain
from trees.skills.looking.look_at import LookAt
from trees.skills.walking.change_viewpoint import ChangeViewpoint
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.toolbox import Toolbox

_KNOWN = {"known": "place"}
_TURNS = 2
"""With the looks to both sides, three headings show the whole circle."""


def look_round(name: str, toolbox: Toolbox) -> Behaviour:
    """From here, to both sides, and turned around; reads and writes "place"."""
    ways = [*_looks(toolbox)]
    for turn in range(1, _TURNS + 1):
        children: list[Behaviour] = [
            ReadyToWalk("stand upright", toolbox, only_if_it_leans=True),
            ChangeViewpoint("turn around", toolbox, "around"),
            Alternatives("look", _looks(toolbox)),
        ]
        ways.append(Sequence(f"turned {turn}", memory=True, children=children))
    return Alternatives(name, ways)


def _looks(toolbox: Toolbox) -> list[Behaviour]:
    looks: list[Behaviour] = [SeeAgain("look from here", toolbox, _KNOWN)]
    for gaze in toolbox.policy.level_gazes:
        children: list[Behaviour] = [LookAt("look", toolbox, gaze), SeeAgain("see", toolbox, _KNOWN)]
        looks.append(Sequence(f"look {gaze.name}", memory=True, children=children))
    return looks
