"""Look for a handle from farther away, and to all sides, where it was not seen from here."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Sequence as Many

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure
from trees.nodes.alternatives import Alternatives
from trees.nodes.judgements import judgement, looking_elsewhere_is_useless
from trees.policy import Gaze
from trees.skills.doors.come_to_handle import come_to_handle
from trees.skills.doors.handle_standing import WalkToHandle
from trees.skills.doors.recall_handle import RecallHandle
from trees.skills.walking.change_viewpoint import ChangeViewpoint, Viewpoint
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.skills.walking.walk_with_room import change_viewpoint
from trees.toolbox import Toolbox

_WAYS: tuple[Viewpoint, ...] = ("back", "around", "around", "around")
_AHEAD = 3
"""So many gazes see what is before somebody who has turned."""


def seen_from_elsewhere(
    name: str,
    toolbox: Toolbox,
    search: Callable[[str, Many[Gaze]], Behaviour],
    gazes: Many[Gaze],
    *,
    pushed: bool,
) -> Alternatives:
    """From here, a step back, and turned once around; a robot that cannot walk looks from here.

    To what was seen before, and is far away or behind now, it walks first. An arm, or the picture's lower
    edge, hides what is close before the body.

    Args:
        name: Of the whole.
        toolbox: What leaves may call.
        search: Makes what looks with some gazes, one after the other.
        gazes: All of them.
        pushed: Whether a door's front is enough, without its handle.
    """
    recall = RecallHandle("recall it", toolbox, pushed)
    come = come_to_handle(toolbox, lambda name: search(name, gazes))
    upright = ReadyToWalk("stand upright", toolbox)
    back = [recall, upright, change_viewpoint(toolbox, "room"), come]
    ways = [Sequence("back to it", memory=True, children=back), search("look from here", gazes)]
    for k, way in enumerate(_WAYS):
        steps = [
            ReadyToWalk("stand upright", toolbox),
            change_viewpoint(toolbox, way),
            search("look from there", gazes if way == "back" else gazes[:_AHEAD]),
        ]
        ways.append(Sequence("a step back" if k == 0 else f"turned {k}", memory=True, children=steps))
    return Alternatives(name, ways, looking_elsewhere_is_useless, can_walk)


@judgement
def can_walk(way: Behaviour, _failure: Failure | None) -> bool:
    """Ways that walk only where the robot can; any other always."""
    walks = [leaf for leaf in way.iterate() if isinstance(leaf, ChangeViewpoint | WalkToHandle)]
    return not walks or walks[0].toolbox.can_walk
