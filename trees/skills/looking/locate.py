"""See where what a task is aimed at is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.scene_description import Region
from trees.beliefs.grounding.destination import (
    SLOTS,
    Place,
    aim_of,
    aims_at_person,
    compares_people,
    is_anybody,
    resolve,
    slot_of,
    where_person_is,
)
from trees.beliefs.grounding.grounding import Found, Missing, exactly, ground
from trees.beliefs.grounding.report_words import kinds_in
from trees.beliefs.openings.handles import MEANT_BY
from trees.beliefs.scene.believed_thing import PERSON, Surroundings
from trees.events import Said
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.looking.look_around import LookAround
from trees.tasks import Destination, ObjectDescription, Relation
from trees.toolbox import Toolbox

_CONFIDENCE = 0.5
"""Of a person who was seen, and is not in view now."""


class Locate(LookAround):
    """Look once, and find the object, piece of furniture or person that the task is aimed at.

    A search looks in several directions; that one look does not show it is an answer, not a failure.
    """

    ASKS = True
    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports(place=Place)
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="exactly one thing that fits was seen; everything seen is in the world model",
        deadline_s=2.0,
    )

    def __init__(
        self, name: str, toolbox: Toolbox, slots: Sequence[str] = SLOTS, settles: bool = True
    ) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            slots: Of the task, that say what is looked for, the one that counts first.
            settles: Whether enough was seen to say which of several is meant: the leftmost of those in the
                first picture may not be the leftmost of all.
        """
        super().__init__(name, toolbox)
        self._slots, self._settles = slots, settles

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Choose what is meant."""
        task = self.get_input("task")
        slot, aim = slot_of(task, self._slots), aim_of(task, self._slots)
        somebody = aims_at_person(task, slot)
        said_at = where_person_is(task, slot)
        whoever = said_at is not None and is_anybody(aim)
        if not self._settles and (whoever or _compares(aim, somebody)):
            message = f"looking whether there is more than this {aim}"
            return Failure.postcondition(message).because(Reason.MORE_LOOKS_NEEDED)
        around = self.around()
        if said_at is not None:
            seen, around, aim = self._among_those_there(said_at, seen, around, aim)
        if slot == "object":
            seen, around = self._among_things_there(aim, getattr(task, "source", None), seen, around)
            there = self._where_it_is_said_to_be(aim, getattr(task, "source", None), around)
            if isinstance(there, Failure):
                return there
            aim = there
        whoever = whoever and said_at in self.toolbox.places
        people = self._people(around)
        place = resolve(aim, seen, around, slot or "object", somebody, people, whoever=whoever)
        if isinstance(place, Failure):
            return place
        self._set_output("place", place)
        if self.toolbox.world.is_new_reason(place.because):
            self.toolbox.events(Said(self.toolbox.clock.now_s(), place.because))
        x, y, z = place.odom_T_place[:3, 3]
        self.feedback_message = f"{place.name} at {x:.2f}, {y:+.2f}, {z:.2f} m"
        return DONE

    def _where_it_is_said_to_be(
        self, aim: Destination | None, source: Destination | None, around: Surroundings
    ) -> Destination | Failure | None:
        """What is looked for, as the one that is there: "the cup on the side table" is on no other table.

        Of a room other things were left out before; what is behind a door is left to those who look there.
        """
        if not isinstance(aim, ObjectDescription) or aim.name is not None:
            return aim
        if source is None or source in self.toolbox.places or str(source) in MEANT_BY:
            return aim
        match ground(aim, around, source):
            case Missing(message, had) if had:
                known = kinds_in(thing.name for thing in around.things)
                return Failure.postcondition(message, seen=known).because(Reason.NOT_SEEN)
            case Found(names):
                return exactly(names[0])
            case _:
                return aim

    def _among_things_there(
        self,
        aim: Destination | None,
        source: Destination | None,
        seen: Mapping[str, ObjectEstimate],
        around: Surroundings,
    ) -> tuple[Mapping[str, ObjectEstimate], Surroundings]:
        """What is seen and believed, without things in another room than the one that is said to be in."""
        region = self.toolbox.places.get(source) if isinstance(source, str) else None
        if region is None or not isinstance(aim, ObjectDescription) or aim.name is not None:
            return seen, around
        return self._inside(region, seen, around, people=False)

    def _inside(
        self,
        region: Region,
        seen: Mapping[str, ObjectEstimate],
        around: Surroundings,
        *,
        people: bool,
    ) -> tuple[Mapping[str, ObjectEstimate], Surroundings]:
        """The same without people, or without things, that are not in a room."""
        objects = self.toolbox.world.scene.objects
        judged = (one for one in around.things if (one.is_person if people else one.movable))
        places = {one.name: objects[one.name].world_T_object for one in judged if one.name in objects}
        outside = tuple(
            name
            for name, place in places.items()
            if not region.contains(float(place[0, 3]), float(place[1, 3]))
        )
        return {name: item for name, item in seen.items() if name not in outside}, around.without(outside)

    def _among_those_there(
        self,
        said_at: Destination,
        seen: Mapping[str, ObjectEstimate],
        around: Surroundings,
        aim: Destination | None,
    ) -> tuple[Mapping[str, ObjectEstimate], Surroundings, Destination | None]:
        """What is seen and believed, without people who are in another room than somebody is said to be in.

        Who is said to be at some furniture is next to it.
        """
        region = self.toolbox.places.get(said_at) if isinstance(said_at, str) else None
        if region is None:
            if is_anybody(aim):
                aim = ObjectDescription(PERSON)
            if isinstance(aim, ObjectDescription) and aim.relation is None:
                aim = replace(aim, relation=Relation("next_to", said_at))
            return seen, around, aim
        return *self._inside(region, seen, around, people=True), aim

    def _people(self, around: Surroundings) -> dict[str, Place]:
        """Everybody, where they were seen last."""
        scene = self.toolbox.world.scene
        people = (scene.objects[thing.name] for thing in around.things if thing.is_person)
        return {
            item.name: Place(item.name, "person", item.shape, item.world_T_object, _CONFIDENCE)
            for item in people
        }


def _compares(aim: Destination | None, somebody: bool) -> bool:
    if not isinstance(aim, ObjectDescription) or aim.name:
        return False
    return aim.ordinal not in (None, "other") or aim.size is not None or compares_people(aim, somebody)
