"""Know where something goes before it is picked up."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence

from kinematics.geometry.shapes import Box, Shape
from kinematics.scene.free_spots import footprint_radius_m
from kinematics.scene.support_of import support_of
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.destination import furniture_named
from trees.beliefs.grounding.grounding import Ambiguous, Found, Missing, ground
from trees.beliefs.grounding.questions import which_is_meant
from trees.beliefs.grounding.report_words import kinds_in
from trees.beliefs.openings.handles import MEANT_BY
from trees.beliefs.scene.believed_thing import Surroundings
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure, FailureKind, Reason
from trees.nodes.alternatives import Alternatives
from trees.nodes.contract import Contract
from trees.nodes.judgements import judgement, looking_elsewhere_is_useless
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.registry import skill_of
from trees.skill import Before
from trees.skills.looking.look_around import LookAround
from trees.skills.looking.look_at import LookAt
from trees.skills.place.placement import not_taken, why_not_there
from trees.tasks import WHERE_IT_WAS, Bringing, Destination, ObjectDescription, ObjectOf, PlaceTask
from trees.toolbox import Toolbox


class KnowDestination(LookAround):
    """Look once, before anything is picked up, to find what the object goes onto, next to or into.

    If that is not clear, the person is asked before a hand has moved. The object itself is never taken for
    its own destination. Some destinations are left for later: that of several objects, or one that cannot be
    told apart yet, until the object is in a hand; drawers and doors, which have to be opened; and rooms of
    the map, where the robot has to go.
    """

    ASKS = True
    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="one thing that fits what the task names as its destination was seen, and it is "
        "something that this skill puts things on, beside or into",
        deadline_s=2.0,
    )
    LOOKING_ON = True
    keeping = True

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Everything believed counts, also what is out of view now."""
        del seen
        task = self.get_input("task")
        around = self._besides_the_object(task)
        if around is None:
            return DONE
        skill, failure = skill_of(task), None
        if skill is not None and Before.AT_SURFACE in skill.before:
            failure = self._not_there(task, around)
        elif skill is not None and Before.GOAL_OPEN in skill.before:
            failure = self._not_into(skill.goal(task), around)
        return DONE if failure is None else failure

    def _besides_the_object(self, task: Bringing) -> Surroundings | None:
        """What else there is than what is to be moved; None where it is not known which one that is."""
        around = self.around()
        if task.count != 1 or not isinstance(task.object, ObjectDescription):
            return None
        match ground(task.object, around, task.source):
            case Found(names):
                return replace(around.without(names), last_acted_on=names[0])
            case Ambiguous():
                return None
            case Missing():
                return around

    def _not_there(self, task: PlaceTask, around: Surroundings) -> Failure | None:
        toolbox = self.toolbox
        if isinstance(task.to, ObjectOf) or isinstance(task.on, ObjectOf):
            raise TypeError("the object of an earlier task was not filled in")
        if task.to == WHERE_IT_WAS:
            return not_taken(task.object)
        if task.on is None and (task.to is None or task.to in toolbox.places):
            return None
        scene, gap_m = toolbox.world.scene, toolbox.policy.support_gap_m
        moved = scene.objects.get(around.last_acted_on or "")
        leaves = None if moved is None else support_of(moved, scene, gap_m)
        below, shape = (None if leaves is None else leaves.name), (None if moved is None else moved.shape)
        return why_not_there(task.on, task.to, scene, around, gap_m, below, shape)

    def _not_into(self, goal: Destination | None, around: Surroundings) -> Failure | None:
        to = ObjectDescription(goal) if isinstance(goal, str) else goal
        if not isinstance(to, ObjectDescription) or to.kind in MEANT_BY:
            return None
        if to.kind is not None and to.color is None and furniture_named(to.kind, self.toolbox.world.scene):
            return None  # which room there is in a part of furniture, a look at the time tells
        match ground(to, around):
            case Ambiguous() as unclear:
                return which_is_meant(unclear, "to")
            case Missing(message):
                known = kinds_in(thing.name for thing in around.things)
                return Failure.postcondition(message, seen=known).because(Reason.NOT_SEEN)
            case Found(names):
                return self._too_wide(around.last_acted_on, names[0])

    def _too_wide(self, thing: str | None, container: str) -> Failure | None:
        objects = self.toolbox.world.scene.objects
        if thing is None or thing not in objects:
            return None
        if room_beside_m(objects[container].shape, objects[thing].shape).min() >= 0.0:
            return None
        return Failure.infeasible(f"the {kind_of(thing)} is too wide for the {kind_of(container)}")


# Left between the object and the walls: a perception error.
_ROOM_M = 0.01


def room_beside_m(container: Shape, thing: Shape) -> NDArray[np.float64]:
    """How far a thing can stand from the middle of a container, along its sides; below 0 it is too wide.

    Args:
        container: Its solid.
        thing: The solid that goes into it, upright, however it is turned.

    Returns:
        Shape (2,), in the container's frame.
    """
    size = container.size_m[:2] if isinstance(container, Box) else (2.0 * footprint_radius_m(container),) * 2
    room: NDArray[np.float64] = np.array(size) * 0.5 - footprint_radius_m(thing) - _ROOM_M
    return room


def know_destination(toolbox: Toolbox) -> Behaviour:
    """Looks until what it is put on, beside or into is seen. Reads "task"."""
    looks: list[Behaviour] = [KnowDestination("as seen from here", toolbox)]
    for gaze in (*toolbox.policy.search_gazes, *toolbox.policy.level_gazes):
        children: list[Behaviour] = [
            LookAt("look", toolbox, gaze),
            KnowDestination("know destination", toolbox),
        ]
        looks.append(Sequence(f"look {gaze.name}", memory=True, children=children))
    return Alternatives("where it goes", looks, hopeless=cannot_go_there)


@judgement
def cannot_go_there(failure: Failure) -> bool:
    """Several that fit, or one that things are not put on or into."""
    return looking_elsewhere_is_useless(failure) or failure.kind is FailureKind.INFEASIBLE
