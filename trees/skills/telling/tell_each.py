"""Tell where each of several things or people is."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from py_trees.common import Status
from py_trees.ports import PortInformation

from trees.beliefs.scene.believed_thing import PERSON, BelievedThing
from trees.failures import Failure, Number
from trees.nodes.contract import Contract
from trees.nodes.ports import ports
from trees.skills.telling.tell_found import where_it_is
from trees.skills.telling.telling_leaf import TellingLeaf
from trees.tasks import Count, FindTask, ObjectDescription


class TellEach(TellingLeaf):
    """Say where each of the things is that were looked for, and how sure that is.

    Things that the robot only remembers are left out: they were not found, since they were not seen.
    """

    INPUT_PORTS = ports(task=FindTask, sightings=PortInformation(dict, default_value={}))
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="everything in reach of the eyes was looked at",
        postcondition="where each thing is that fits and was seen was said; there are as many as were asked "
        "for, or more",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Say it; fewer than were asked for are a failure that tells where they are."""
        task: FindTask = self.get_input("task")
        wanted = _wanted(task)
        around = self.around()
        fitting = self.fitting(wanted, around, task.source)
        if isinstance(fitting, Failure):
            return fitting
        found = [thing for name in fitting for thing in self.now_seen(around).things if thing.name == name]
        if not found:
            return Failure.postcondition(f"no {wanted} seen{self._where(task)}")
        told = f"{self.in_words(wanted, len(found))}{self._where(task)}: {self._each(found)}"
        names = [thing.name for thing in found]
        evidence: dict[str, Number] = {"count": len(names), "names": ", ".join(names)}
        evidence |= self.confidence(names)
        if len(found) < _least(task.count):
            return Failure.postcondition(f"I see only {told}", None, **evidence)
        return self.say(f"I see {told}", evidence)

    def _where(self, task: FindTask) -> str:
        """Where they were looked for: what is farther away in a flat may have been out of sight."""
        if task.source is None:
            return " from here" if self.toolbox.places else ""
        if self.region(task.source) is not None:
            return f" in the {task.source}"
        return f" {'on' if isinstance(task.source, str) else 'in or on'} the {task.source}"

    def _each(self, things: Sequence[BelievedThing]) -> str:
        """Each with where it is; those that no word tells apart are "one red cup"."""
        alike = Counter(thing.words for thing in things)
        return "; ".join(
            f"{_called(thing, alone=alike[thing.words] == 1)} {self._place_of(thing)}" for thing in things
        )

    def _place_of(self, thing: BelievedThing) -> str:
        place = self.toolbox.world.scene.objects[thing.name].world_T_object
        return where_it_is(thing.name, float(place[0, 3]), float(place[1, 3]), self.toolbox)


def _wanted(task: FindTask) -> ObjectDescription:
    """What is looked for: without a description anything."""
    wanted = task.object if task.person is None else task.person
    return wanted if isinstance(wanted, ObjectDescription) else ObjectDescription()


def _least(count: Count) -> int:
    """As many have to be there for the answer to be what was asked for."""
    if isinstance(count, int):
        return count
    return 2 if count == "both" else 1


def _called(thing: BelievedThing, *, alone: bool) -> str:
    if thing.is_person:
        return "a person" if thing.kind == PERSON else thing.name
    return f"{'the' if alone else 'one'} {thing.words}"
