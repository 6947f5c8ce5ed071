"""See who speaks to the robot: look for people all around, and take the nearest."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.alternatives import Alternatives
from trees.best_effort import BestEffort
from trees.failures import Failure
from trees.leaves.asks_for_speaker import AsksForSpeaker
from trees.leaves.look_at import LookAt
from trees.leaves.look_for_people import LookForPeople
from trees.leaves.note_who_speaks import NoteWhoSpeaks
from trees.leaves.ready_to_walk import ReadyToWalk
from trees.subtrees.look_elsewhere import change_viewpoint
from trees.subtrees.search import looking_elsewhere_is_useless
from trees.toolbox import Toolbox

_TURNS = 2
"""Turns of 1.9 rad: with a look to both sides before each, nothing around the robot is left out."""


def who_speaks(toolbox: Toolbox) -> Behaviour:
    """Fails at once when the task is about somebody else. Reads "task", writes "place"."""
    ways = [_view("from here", toolbox, [])]
    for k in range(1, _TURNS + 1):
        turn: list[Behaviour] = [
            ReadyToWalk("stand upright", toolbox),
            change_viewpoint(toolbox, "around"),
        ]
        ways.append(_view(f"turned {k}", toolbox, turn))
    ways.append(NoteWhoSpeaks("the nearest one", toolbox, anybody=True))
    looks = Alternatives("look for who speaks", ways)
    return Sequence("see who speaks", memory=True, children=[AsksForSpeaker("asked for", toolbox), looks])


def nobody_spoke(failure: Failure) -> bool:
    """A defect, a question, or a look all around that showed nobody: no other look helps."""
    return looking_elsewhere_is_useless(failure) or "people" in failure.root.numbers


def _view(name: str, toolbox: Toolbox, before: list[Behaviour]) -> Behaviour:
    children = list(before)
    for gaze in toolbox.policy.level_gazes:
        pair: list[Behaviour] = [
            LookAt("look", toolbox, gaze),
            LookForPeople("see who is there", toolbox, {"people_before": "people"}),
        ]
        children.append(BestEffort(Sequence(f"look {gaze.name}", memory=True, children=pair)))
    children.append(NoteWhoSpeaks("near enough", toolbox))
    return Sequence(name, memory=True, children=children)
