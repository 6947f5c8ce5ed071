"""See who speaks to the robot: look for people all around, and take the nearest."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence

from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.destination import Place, aim_of, place_from
from trees.failures import Failure, Reason
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.contract import Contract
from trees.nodes.judgements import judgement, looking_elsewhere_is_useless
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports
from trees.skills.looking.look_around import LookAround
from trees.skills.looking.look_at import LookAt
from trees.skills.telling.note_who_speaks import NoteWhoSpeaks
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.skills.walking.walk_with_room import change_viewpoint
from trees.toolbox import Toolbox


class LookForPeople(LookAround):
    """Take one more look, and add the people in it to those whom earlier looks have shown."""

    INPUT_PORTS = ports(people_before=optional(dict))
    OUTPUT_PORTS = ports(people=dict)
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="everything in view is in the world model; everybody in view is noted",
        deadline_s=2.0,
    )

    LOOKING_ON = True

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Keep the newest sighting of each."""
        people: dict[str, Place] = dict(self.optional("people_before") or {})
        people |= {name: place_from(name, item) for name, item in seen.items() if item.category == "person"}
        self._set_output("people", people)
        self.feedback_message = ", ".join(sorted(people)) or "nobody"
        return DONE


SPEAKER = "me"


class AsksForSpeaker(Leaf):
    """Succeed if the task is aimed at "me", the person who speaks to the robot."""

    ASKS = True
    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="the task is aimed at who speaks",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Look at the word."""
        if aim_of(self.get_input("task")) != SPEAKER:
            return Failure.postcondition("it is not about who speaks")
        return DONE


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


@judgement
def nobody_spoke(failure: Failure) -> bool:
    """A defect, a question, or a look all around that showed nobody: no other look helps."""
    return looking_elsewhere_is_useless(failure) or failure.root.reason is Reason.NOBODY_SEEN


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
