"""Tell what was seen: how many, what, where."""

from __future__ import annotations

from collections.abc import Iterable

from py_trees.common import Status
from py_trees.ports import PortInformation

from trees.believed_thing import BelievedThing, Surroundings
from trees.contract import Contract
from trees.failures import Failure, Number
from trees.grounding import Ambiguous, ground
from trees.handles import MEANT_BY
from trees.ports import ports
from trees.questions import which_is_meant
from trees.report_words import inventory, plural, whereabouts
from trees.tasks import CountTask, DescribeTask, Destination, ObjectDescription
from trees.telling_leaf import TellingLeaf


class TellCount(TellingLeaf):
    """Say how many things fit a description."""

    INPUT_PORTS = ports(task=CountTask, sightings=PortInformation(dict, default_value={}))
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="everything in reach of the eyes was looked at",
        postcondition="the number of things of the world model that fit was said, with its confidence",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Count; none is an answer, too."""
        task: CountTask = self.get_input("task")
        names = self.fitting(task.object, self.around(), task.source)
        if isinstance(names, Failure):
            return names
        count = len(names)
        noun = " ".join(word for word in (task.object.color, task.object.kind or "thing") if word)
        verb = "is" if count == 1 else "are"
        return self.say(
            f"there {verb} {plural(noun, count)}",
            {"count": count, **self.confidence(names)},
        )


class TellDescription(TellingLeaf):
    """Say what is there: everything, what is on a surface, or where one thing is."""

    INPUT_PORTS = ports(task=DescribeTask, sightings=PortInformation(dict, default_value={}))
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="everything in reach of the eyes was looked at",
        postcondition="what the world model holds was said, with its confidence",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Put it into words."""
        task: DescribeTask = self.get_input("task")
        around = self.around()
        wanted = task.object if isinstance(task.object, ObjectDescription) else None
        if wanted is not None and not _is_surface(wanted, around):
            return self._one(wanted, around, task.source)
        source = task.source if task.source is not None else (wanted.kind if wanted is not None else None)
        names = self.fitting(ObjectDescription(), around, source) if around.objects else ()
        if isinstance(names, Failure):
            return names
        things = [thing for thing in around.objects if thing.name in names]
        where = "here" if source is None else f"{'in' if str(source) in MEANT_BY else 'on'} the {source}"
        words = f"{where} I see {inventory(things)}"
        return self.say(
            words,
            {"things": len(things), "names": ", ".join(names), **self.confidence(names)},
        )

    def _one(
        self, wanted: ObjectDescription, around: Surroundings, source: Destination | None
    ) -> Status | Failure:
        names = self.fitting(wanted, around, source)
        if isinstance(names, Failure):
            return names
        if not names:
            return Failure.postcondition(f"no {wanted} seen")
        meant = ground(wanted, around, source)
        if isinstance(meant, Ambiguous):
            return which_is_meant(meant)
        thing = _by_name(around.objects, names[0])
        words = f"the {thing.words} is {whereabouts(thing)}"
        evidence: dict[str, Number] = {"names": names[0], **self.confidence(names)}
        return self.say(words, {**evidence, "things": 1, "height_m": 2.0 * thing.half_height_m})


def _is_surface(wanted: ObjectDescription, around: Surroundings) -> bool:
    return wanted.color is None and any(t.kind == wanted.kind for t in around.things if not t.movable)


def _by_name(things: Iterable[BelievedThing], name: str) -> BelievedThing:
    return next(thing for thing in things if thing.name == name)
