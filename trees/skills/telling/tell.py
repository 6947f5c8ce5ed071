"""Tell what was seen: how many, what, where."""

from __future__ import annotations

from dataclasses import replace

from py_trees.common import Status
from py_trees.ports import PortInformation

from trees.beliefs.grounding.furniture_called import called_so
from trees.beliefs.grounding.grounding import Ambiguous, ground
from trees.beliefs.grounding.person_words import looks_of
from trees.beliefs.grounding.questions import which_is_meant
from trees.beliefs.grounding.ranking import compares_all
from trees.beliefs.grounding.report_words import counted, listed, plural, whereabouts
from trees.beliefs.openings.handles import MEANT_BY
from trees.beliefs.scene.believed_thing import PERSON, Surroundings
from trees.beliefs.scene.held_object import is_like
from trees.beliefs.scene.person_looks import posture_in
from trees.failures import Failure, Number
from trees.nodes.contract import Contract
from trees.nodes.ports import ports
from trees.skills.telling.telling_leaf import TellingLeaf
from trees.tasks import CountTask, DescribeTask, Destination, ObjectDescription

SEEN_WHOLE = "seen_whole"
"""Key of the evidence: whether all that was asked about was seen, so that nothing else may be so."""

UNSEEN_SIZES = frozenset({"heaviest", "lightest"})
"""What may be asked about, and cannot be seen."""


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
        around, seen_from_here = self.around(), task.source is None and self._is_big(task.object)
        if seen_from_here or task.object.kind == PERSON:  # furniture stays where it was seen
            around = self.now_seen(around) if seen_from_here else self.people_now_seen(around)
        furniture = self.pieces(task.object, around, task.source)
        names = self.fitting(task.object, around, task.source) if furniture is None else furniture
        if isinstance(names, Failure):
            return names
        if task.object.kind != PERSON and (far := self.too_far(task.source, around)) is not None:
            return far
        held = self._in_hand(task.object, around) if task.source is None and furniture is None else ()
        count = len(names) + len(held)
        counted_words = self.in_words(task.object, count)
        hidden = self.much_is_hidden()
        said = f"there {'is' if count == 1 else 'are'}"
        if (told := self.called_here(task.source, around)) != task.source:
            said = f"on the {told} {said}"
        if self.region(task.source) is not None:  # not all of a room is seen from one place
            said = f"in the {task.source} I see"
        elif seen_from_here or task.object.kind == PERSON or (self.toolbox.places and task.source is None):
            said = "from here I see"
        elif hidden:
            said = f"not all of the {self.called_here(task.source, around)} is to be seen; there I see"
        in_hand = f", {len(held)} of them in my hand{'s' * (len(held) > 1)}" if held else ""
        untold = self._untold(task.object, around, task.source)
        return self.say(
            f"{said} {counted_words}{in_hand}{untold}",
            {"count": count, SEEN_WHOLE: not hidden, **self.confidence(names)},
        )

    def _untold(self, wanted: ObjectDescription, around: Surroundings, source: Destination | None) -> str:
        """Of how many people nothing is known of what was asked about."""
        if not wanted.traits:
            return ""
        everybody = self.fitting(replace(wanted, traits=()), around, source)
        known = {thing.name for thing in around.things if posture_in(thing.label.traits) is not None}
        untold = 0 if isinstance(everybody, Failure) else len(set(everybody) - known)
        return f"; of {plural('person', untold)} I cannot tell" if untold else ""

    @staticmethod
    def _in_hand(wanted: ObjectDescription, around: Surroundings) -> tuple[str, ...]:
        """What hands hold counts, too, where nothing but its kind and colour is asked for."""
        if replace(wanted, kind=None, color=None) != ObjectDescription():
            return ()
        return tuple(name for name, label in around.held.items() if is_like(wanted, label))

    def _is_big(self, wanted: ObjectDescription) -> bool:
        """Whether it stands anywhere in a room, not on something that was looked over."""
        return wanted.kind == PERSON or self.pieces(wanted, self.around(), None) is not None


class TellDescription(TellingLeaf):
    """Say what is there: everything that was seen, what is on a surface, or where one thing is."""

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
        if wanted is None and task.source is None:
            around = self.now_seen(around)
        if wanted is not None and wanted.size in UNSEEN_SIZES:
            return self._not_weighed(wanted, around, task.source)
        if wanted is not None and not _is_surface(wanted, around):
            return self._one(wanted, around, task.source)
        source = task.source if task.source is not None else (wanted.kind if wanted is not None else None)
        names = self.fitting(ObjectDescription(), around, source)
        if isinstance(names, Failure):
            return names
        if (far := self.too_far(task.source, around)) is not None:
            return far
        things = [thing for thing in around.objects if thing.name in names]
        region = self.region(source)
        people = self._people(around, source)
        inside = region is not None or str(source) in MEANT_BY
        told = self.called_here(source, around)
        there = "in" if inside else "on" if isinstance(source, str) else "in or on"
        where = "here" if source is None else f"{there} the {told}"
        furniture = self.furniture(around, region) if source is None or region is not None else []
        words = f"{where} I see {listed([*furniture, *counted(things), *people]) or 'nothing'}"
        return self.say(
            words,
            {"things": len(things), "names": ", ".join(names), **self.confidence(names)},
        )

    def _people(self, around: Surroundings, source: Destination | None) -> list[str]:
        """Who is here, or in a room; nobody stands on anything."""
        region = self.region(source)
        if source is not None and region is None:
            return []
        people = {thing.name: thing for thing in around.things if thing.is_person}
        return [
            thing.name if thing.kind != PERSON else "a person"
            for name, thing in people.items()
            if name in self.inside(region, people)
        ]

    def _not_weighed(
        self, wanted: ObjectDescription, around: Surroundings, source: Destination | None
    ) -> Status | Failure:
        """Nobody sees what weighs most: say so, and what there is to choose from."""
        names = self.fitting(replace(wanted, size=None), around, source)
        if isinstance(names, Failure):
            return names
        seen = listed(counted([thing for thing in around.things if thing.name in names])) or "nothing of that"
        words = f"I cannot weigh things by looking at them, so which is the {wanted.size} I do not know"
        where = "there" if source is not None else "here"
        return self.say(f"{words}; {where} I see {seen}", {"things": len(names), **self.confidence(names)})

    def _one(
        self, wanted: ObjectDescription, around: Surroundings, source: Destination | None
    ) -> Status | Failure:
        if compares_all(wanted.size) and wanted.ordinal is None:
            several = self._of_one_size(wanted, around, source)
            if several is not None:
                return several
        names = self.fitting(wanted, around, source)
        if isinstance(names, Failure):
            return names
        if not names and wanted == ObjectDescription(relation=wanted.relation):
            return self.say(f"nothing is {wanted.relation}", {"things": 0, **self.confidence(names)})
        if not names:
            return Failure.postcondition(f"no {wanted} seen")
        meant = ground(wanted, around, source)
        if isinstance(meant, Ambiguous):
            return which_is_meant(meant)
        compared = wanted.size is not None or wanted.ordinal is not None
        if compared and (far := self.too_far(source, around)) is not None:
            return far
        hidden = compared and self.much_is_hidden()
        thing = next(thing for thing in around.things if thing.name == names[0])
        called = thing.name if thing.is_person and thing.kind != PERSON else f"the {thing.words}"
        evidence: dict[str, Number] = {"names": names[0], **self.confidence(names)}
        looks = looks_of(thing.label.traits) if thing.is_person else ""
        words = f"{called} {f'{looks}, ' if looks else 'is '}{whereabouts(thing)}"
        if hidden:
            where = self.called_here(source, around)
            words = (
                f"not all of the {where} is to be seen; of what I see it is {called}, {whereabouts(thing)}"
            )
        return self.say(
            words,
            {**evidence, SEEN_WHOLE: not hidden, "things": 1, "height_m": 2.0 * thing.half_height_m},
        )

    def _of_one_size(
        self, wanted: ObjectDescription, around: Surroundings, source: Destination | None
    ) -> Status | Failure | None:
        """Tell all that are about as big, and ask nobody back; None where it is one, or the kind unclear."""
        region = self.region(source)
        alike = ground(wanted, self.of_room(region, around), None if region is not None else source)
        compared = self.fitting(replace(wanted, size=None), around, source)
        if not isinstance(alike, Ambiguous) or isinstance(compared, Failure):
            return None
        names = self.inside(region, (choice.name for choice in alike.choices))
        if len(names) < 2:
            return None
        if (far := self.too_far(source, around)) is not None:
            return far
        called = [f"the {thing.words}" for thing in around.things if thing.name in names]
        words, hidden = f"{listed(called)} are of nearly one size", self.much_is_hidden()
        words = f"none is clearly the {wanted.size}: {words}"
        if hidden:
            words = f"not all of the {self.called_here(source, around)} is to be seen; of what I see {words}"
        told = {"names": ", ".join(names), **self.confidence(names)}
        return self.say(words, {**told, SEEN_WHOLE: not hidden, "things": len(names)})


def _is_surface(wanted: ObjectDescription, around: Surroundings) -> bool:
    return wanted.color is None and bool(called_so(wanted.kind or "", around.furniture_words))
