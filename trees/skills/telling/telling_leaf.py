"""A leaf that reads the world model and says something about it."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from statistics import fmean

import numpy as np
from py_trees.common import Status

from kinematics.scene.planning_scene import PlanningScene
from robots.scenes.articulated import DOOR, DRAWER, PART_KINDS
from robots.scenes.furniture import FURNITURE_KINDS
from robots.scenes.furniture_names import kind_called
from robots.scenes.scene_description import Region
from trees.beliefs.grounding.furniture_called import called_so, is_said_of
from trees.beliefs.grounding.grounding import Ambiguous, Found, Missing, ground, ground_furniture, says_which
from trees.beliefs.grounding.person_words import people_who
from trees.beliefs.grounding.questions import which_is_meant
from trees.beliefs.grounding.report_words import kinds_in, plural
from trees.beliefs.openings.drawer_inside import inside_of_drawer
from trees.beliefs.openings.fridge_inside import door_opening_rad
from trees.beliefs.openings.handles import INSIDE_KINDS, MEANT_BY
from trees.beliefs.scene.believed_thing import PERSON, BelievedThing, Surroundings
from trees.beliefs.scene.furniture_pieces import belong_together, gap_to_furniture_m
from trees.beliefs.scene.scene_update import kind_of
from trees.beliefs.sight.hidden_places import HIDDEN_WORTH, hidden_places
from trees.events import Said
from trees.failures import Failure, FailureKind, Number, Reason
from trees.nodes.leaf import DONE, Leaf
from trees.readings.odometry import base_pose, what_is_around
from trees.skills.telling.settings import TellingSettings
from trees.tasks import Destination, ObjectDescription, Relation

# A thing that was seen less surely is told as perhaps being there.
_SURE = 0.5

_OVERLOOKED_M = 1.2
"""What stands on furniture that is farther away than this may be in no look of a survey: those see what is
within reach of the arms, and the robot stands up to a metre before what is tall."""

_MANY_PLACES = 24
"""Of the grid of ``hidden_places``, at two heights: room for two cups side by side."""

_NO_FURNITURE = frozenset({"wall", *PART_KINDS, *INSIDE_KINDS})
"""Nobody asks what these are: walls, and parts of furniture."""


class TellingLeaf(Leaf):
    """A leaf that answers a question from the world model, with the evidence for its answer."""

    def around(self) -> Surroundings:
        """What is believed, from where the robot stands."""
        return what_is_around(self.toolbox)

    def now_seen(self, around: Surroundings) -> Surroundings:
        """What the looks of this task showed; what is remembered from elsewhere is not here."""
        sightings = self.get_input("sightings")
        return replace(around, things=tuple(thing for thing in around.things if thing.name in sightings))

    def people_now_seen(self, around: Surroundings) -> Surroundings:
        """What is believed, without people whom no look of this task showed: they may have gone."""
        sightings = self.get_input("sightings")
        gone = [thing.name for thing in around.things if thing.is_person and thing.name not in sightings]
        return around.without(tuple(gone))

    @staticmethod
    def in_words(wanted: ObjectDescription, count: int) -> str:
        """So many of what is wanted: "two red cups", "two people who are sitting"."""
        if wanted.kind == PERSON and wanted.traits:
            return people_who(wanted.traits, count)
        return plural(" ".join(word for word in (wanted.color, wanted.kind or "thing") if word), count)

    def say(self, words: str, evidence: dict[str, Number]) -> Status:
        """Give words out, with what they rest on."""
        self.toolbox.events(Said(self.toolbox.clock.now_s(), words))
        self.measured(**evidence)
        self._set_output("evidence", {"said": words, **evidence})
        self.feedback_message = words
        return DONE

    def confidence(self, names: Iterable[str]) -> dict[str, Number]:
        """Evidence of how often such an answer is right, from how surely things were seen.

        Things are seen or missed each on its own, and what was not seen was missed about as easily as
        what was seen was seen badly; from that to a share of right answers goes a fitted line.
        """
        sightings, settings = self.get_input("sightings"), self.toolbox.policy.of(TellingSettings)
        there = math.prod(float(sightings.get(name, _SURE)) for name in names)
        complete = fmean(map(float, sightings.values())) if sightings else _SURE
        raw = there * complete
        stated = calibrated(raw, settings.confidence_slope, settings.confidence_offset)
        return {"confidence": stated, "seen_confidence": raw}

    def fitting(
        self, wanted: ObjectDescription, around: Surroundings, source: Destination | None
    ) -> tuple[str, ...] | Failure:
        """Names of all things that fit; none is no failure, if where they would be was seen."""
        region = self.region(source)
        if isinstance(source, str) and region is None:
            if not called_so(source, around.furniture_words):
                known = kinds_in(thing.name for thing in around.things)
                return Failure.postcondition(f"no {source} seen", seen=known).because(Reason.NOT_SEEN)
            called = str(self.called_here(source, around))
            if (shut := why_shut(self.toolbox.world.scene, called)) is not None:
                return shut
        people = [thing for thing in around.things if thing.is_person] if wanted.kind == PERSON else None
        at = None if region is not None else source
        if says_which(wanted):
            around = self.of_room(region, around)
        if people is not None and isinstance(at, str) and wanted.relation is None:
            wanted, at = replace(wanted, relation=Relation("next_to", at)), None
        answer = ground(wanted, around, at, "all", people)
        if isinstance(answer, Ambiguous):
            return which_is_meant(answer)
        return () if isinstance(answer, Missing) else self.inside(region, answer.names)

    def too_far(self, source: Destination | None, around: Surroundings) -> Failure | None:
        """Why not all that stands on furniture can be told from here, where the robot could walk to it."""
        if self.region(source) is not None or not self.toolbox.can_walk:
            return None
        scene, base = self.toolbox.world.scene, base_pose(self.toolbox)
        names = self._furniture_meant(source, around)
        gap_m = min((gap_to_furniture_m(scene.objects[name], base) for name in names), default=0.0)
        if gap_m <= _OVERLOOKED_M:
            return None
        message = f"the {self.called_here(source, around)} is too far away to see all that is on it"
        return Failure.postcondition(message, gap_m=gap_m).because(Reason.SEEN_FROM_AFAR)

    def much_is_hidden(self) -> bool:
        """Whether, on the furniture that the task is about, something may stand behind what was seen."""
        source, toolbox = self.get_input("task").source, self.toolbox
        meant = () if self.region(source) is not None else self._furniture_meant(source, self.around())
        if not meant and not isinstance(source, str):
            return False
        scene, policy = toolbox.world.scene, toolbox.policy
        others = [name for name, item in scene.objects.items() if not item.movable and name not in meant]
        for name in others:  # they stand in no line of sight to what is on a top before them
            scene = scene.without_object(name)
        camera = toolbox.model.description.camera
        _, worth = hidden_places(scene, toolbox.world.glimpses, camera, policy.blocked_by_hand_m)
        return int(np.count_nonzero(worth == HIDDEN_WORTH)) >= _MANY_PLACES

    def _furniture_meant(self, source: Destination | None, around: Surroundings) -> tuple[str, ...]:
        """Names of the solids of the furniture that is called or described so; none where it is not known."""
        fixed = [thing for thing in around.things if not thing.movable]
        if isinstance(source, str):
            meant = called_so(source, around.furniture_words)
            return tuple(thing.name for thing in fixed if thing.kind in meant)
        if not isinstance(source, ObjectDescription):
            return ()
        found = ground_furniture(source, around)
        return found.names if isinstance(found, Found) else ()

    def called_here(self, source: Destination | None, around: Surroundings) -> Destination | None:
        """What furniture is called by what was seen: of "the table" perhaps "coffee table"."""
        if not isinstance(source, str) or self.region(source) is not None:
            return source
        meant = called_so(source, around.furniture_words)
        return " and ".join(sorted(meant)) if meant else source

    def pieces(
        self, wanted: ObjectDescription, around: Surroundings, source: Destination | None
    ) -> tuple[str, ...] | None:
        """One solid of each piece of furniture that is called so; None when no furniture is meant."""
        if wanted.kind is None or replace(wanted, kind=None) != ObjectDescription():
            return None
        region = self.region(source)
        known = around.furniture_words
        words = {one for one in known if is_said_of(wanted.kind, one)} | called_so(wanted.kind, known)
        is_furniture = bool(words) or kind_called(wanted.kind) in FURNITURE_KINDS
        if not is_furniture or (source is not None and region is None):
            return None
        alike = [thing for thing in around.things if not thing.movable and thing.kind in words]
        found: list[BelievedThing] = []
        for thing in sorted(alike, key=lambda one: -one.radius_m):  # legs stand about their table's top
            if not any(belong_together(thing.name, thing.place_m, one.name, one.place_m) for one in found):
                found.append(thing)
        return self.inside(region, (thing.name for thing in found))

    def region(self, source: Destination | None) -> Region | None:
        """The room of the map that a question is about."""
        return self.toolbox.places.get(source) if isinstance(source, str) else None

    def inside(self, region: Region | None, names: Iterable[str]) -> tuple[str, ...]:
        """Those of some things that are in a room; all without one."""
        objects = self.toolbox.world.scene.objects
        places = {name: objects[name].world_T_object[:2, 3] for name in names}
        return tuple(
            name for name, (x, y) in places.items() if region is None or region.contains(float(x), float(y))
        )

    def of_room(self, region: Region | None, around: Surroundings) -> Surroundings:
        """What is believed, of a room with no objects but its own: sizes and orders compare these alone."""
        if region is None:
            return around
        return around.only(self.inside(region, (thing.name for thing in around.objects)))

    def furniture(self, around: Surroundings, region: Region | None) -> list[str]:
        """What stands in a room, or anywhere without one, each once: "the counter", "the fridge"."""
        names = (thing.name for thing in around.things if not thing.movable and not thing.is_person)
        kinds = {kind_of(name) for name in self.inside(region, names)}
        return [f"the {kind}" for kind in sorted(kinds - _NO_FURNITURE)]


_AJAR_RAD = math.radians(10.0)
"""A door that is less open shows nothing."""


def why_shut(scene: PlanningScene, word: str) -> Failure | None:
    """Why nothing can be told of the inside of what is called so; None where it is open, or has no inside.

    Args:
        scene: What is believed.
        word: "fridge", "drawer"; anything else is no matter.
    """
    told = Failure.infeasible(f"the {word} is shut: open it first ('open the {word}')")
    if MEANT_BY.get(word) == DOOR:
        opening = door_opening_rad(scene)
        return told if opening is not None and opening < _AJAR_RAD else None
    if MEANT_BY.get(word) == DRAWER:
        inside = inside_of_drawer(scene)
        return told if isinstance(inside, Failure) and inside.kind is FailureKind.INFEASIBLE else None
    return None


_NEAREST = 1e-3
"""Raw confidences are kept this far from 0 and 1: nothing is that certain."""


def log_odds(chance: float) -> float:
    """Log of p / (1 - p), of a chance kept off 0 and 1."""
    kept = min(max(chance, _NEAREST), 1.0 - _NEAREST)
    return math.log(kept / (1.0 - kept))


def calibrated(raw: float, slope: float, offset: float) -> float:
    """Platt's map (1999): a line in the log-odds.

    Args:
        raw: Product of the confidences with which each thing was seen.
        slope, offset: Of the line; 1 and 0 leave the chance as it is.
    """
    return 1.0 / (1.0 + math.exp(-(slope * log_odds(raw) + offset)))
