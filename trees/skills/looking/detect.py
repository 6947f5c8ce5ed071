"""See what is there, remember it, and find the object that is meant."""

from __future__ import annotations

import base64
from collections.abc import Mapping
from typing import Literal

from py_trees.common import Status

from kinematics.scene.label import Label
from kinematics.scene.planning_scene import SceneObject
from kinematics.scene.support_of import lowest_point_m, support_of
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.grounding import Ambiguous, Choice, Found, Missing, compares, ground
from trees.beliefs.grounding.questions import which_is_meant
from trees.beliefs.scene.believed_thing import Surroundings
from trees.beliefs.scene.scene_update import kind_of, words_for
from trees.events import Said, ThingPictured
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import optional, ports
from trees.port_values import Target
from trees.readings.odometry import what_is_around
from trees.skills.looking.folded_look import folded_look
from trees.skills.looking.look_leaf import LookLeaf, View
from trees.skills.looking.whole_top import seen_wholly
from trees.tasks import ObjectDescription, ObjectOf
from trees.toolbox import Toolbox

Part = Literal["alone", "first", "side", "last", "again", "closer", "known", "asking"]
"""What a look is for: by itself; one of several, during which nothing is moved; of those, one to the sides
that was asked for, the last of these, and the one ahead after they have lost what had been seen; one at what
may be the thing that is meant, one at where that was seen before, and the last of all, after which a person
is asked whether it is."""


class Detect(LookLeaf):
    """Take a look, update the world model with it, and choose the object that the task means.

    Everything that the robot believes to be there counts, also what is out of view now. When the task means
    several objects, the nearest becomes the target, and the names of the others are written as well. It fails
    when nothing that fits is seen, when several things fit (the failure's ``choices`` name them), and when
    the furniture below the target is not known, since a motion would hit a table that was not seen; what is
    on the floor is left there. A search looks in several directions; that one look does not show the object
    is an answer, not a failure.
    """

    ASKS = True
    INPUT_PORTS = ports(task=object, besides=optional(object))
    OUTPUT_PORTS = ports(target=Target, others=tuple)
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="as many objects as are meant fit, and no more; the target was seen, in half of the "
        "frames at least, on known furniture; everything seen is in the world model",
        deadline_s=2.0,
    )

    def __init__(
        self,
        name: str,
        toolbox: Toolbox,
        wiring: Mapping[str, str] | None = None,
        *,
        part: Part = "alone",
    ) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            wiring: As for every leaf.
            part: What the look is for. The first ones of a search, and all but the last to the sides, ask for
                more looks (``wants_survey``) when several things are to be compared, or another one may stand
                where nobody has looked. Among looks to the sides, one that shows nothing says little.
        """
        super().__init__(name, toolbox, wiring)
        self.part = part
        self._because = ""

    def judge(self, views: list[View]) -> Status | Failure:
        """Update the world model, then choose."""
        update = folded_look(self.toolbox, views, may_have_moved=self.part == "alone")
        self.measured(frames=len(views), things=len(update.seen), scene_version=update.scene.version)
        chosen = self._choose(update.seen)
        if isinstance(chosen, Failure):
            return chosen
        self._set_output("target", chosen)
        if self.toolbox.world.is_new_reason(self._because):
            self.toolbox.events(Said(self.toolbox.clock.now_s(), self._because))
        x, y, z = chosen.odom_T_object[:3, 3]
        self.feedback_message = f"{chosen.name} at {x:.2f}, {y:+.2f}, {z:.2f} m"
        return DONE

    def _choose(self, seen: Mapping[str, ObjectEstimate]) -> Target | Failure:
        task, world = self.get_input("task"), self.toolbox.world
        if isinstance(task.object, ObjectOf):
            raise TypeError("the object of an earlier task was not filled in")
        around = what_is_around(self.toolbox)
        source, count = getattr(task, "source", None), getattr(task, "count", 1)
        if count != 1:
            around = around.without(self._besides(around))
        grounding = ground(task.object, around, source, count)
        more_to_come = self.part in ("first", "side")
        if more_to_come and self._unsure(grounding, compares(task.object, count), seen):
            message = f"looking whether there is more than this {task.object}"
            return Failure.postcondition(message).because(Reason.MORE_LOOKS_NEEDED)
        match grounding:
            case Missing(message):
                reason = Reason.LOST_FROM_VIEW if self.part == "last" else Reason.NOT_SEEN
                message = "; ".join(filter(None, (message, world.sees_badly)))
                return Failure.postcondition(message, seen=_words(seen)).because(reason)
            case Ambiguous(_, choices) as unclear:
                unseen = sum(choice.name not in world.sightings for choice in choices)
                return which_is_meant(unclear, unseen=unseen)
            case Found(names, because):
                self._because = because
                return self._target(names, seen)

    def _besides(self, around: Surroundings) -> tuple[str, ...]:
        """What is not one of several, for they go into it or next to it."""
        besides: object = self.optional("besides")
        if isinstance(besides, str):
            besides = ObjectDescription(besides)
        found = ground(besides, around) if isinstance(besides, ObjectDescription) else None
        return found.names if isinstance(found, Found) else ()

    def _unsure(
        self, grounding: Found | Ambiguous | Missing, comparing: bool, seen: Mapping[str, ObjectEstimate]
    ) -> bool:
        """Whether it takes more looks to say which one is meant."""
        match grounding:
            case Missing():
                return self.part == "side"
            case Found(names) if not comparing and self.part == "first":
                looks = self.toolbox.policy.looks_for_twins and names[0] in seen
                return looks and not seen_wholly(self.toolbox, names[0])
            case _:
                return True

    def _target(self, names: tuple[str, ...], seen: Mapping[str, ObjectEstimate]) -> Target | Failure:
        """The first of those that are meant; the others are left for later."""
        name, world = names[0], self.toolbox.world
        scene = world.scene
        words = kind_of(name)
        # What an earlier look showed counts only among looks between which nothing was moved.
        several = self.part in ("last", "again")
        before = world.sightings.get(name)
        estimate = before if several else seen.get(name)
        if estimate is None:
            message = f"the {words} was seen before, but is not in view now"
            reason = Reason.NOT_SEEN
            if self.part != "asking" and before is not None and self._doubts(before):
                reason = Reason.UNSURE
            elif self.part not in ("known", "asking"):
                reason = Reason.OUT_OF_VIEW
                self._set_output("target", _as_believed(name, scene.objects[name]))
            return Failure.postcondition(message, seen=_words(seen)).because(reason)
        gap_m = self.toolbox.policy.support_gap_m
        if support_of(scene.objects[name], scene, gap_m) is None:
            if abs(lowest_point_m(scene.objects[name])) <= gap_m:
                message = f"the {words} is on the floor; hands take only what is on furniture"
                return Failure.infeasible(message).because(Reason.ON_FLOOR)
            message = f"what the {words} stands on is not seen"
            return Failure.postcondition(message, seen=_words(seen)).because(Reason.NOT_SEEN)
        self._set_output("others", names[1:])
        target = Target(
            name, estimate.kind, estimate.color, estimate.shape, estimate.odom_T_object, estimate.confidence
        )
        if not self._doubts(estimate):
            return target
        self._set_output("target", target)  # it is what a closer look is aimed at
        return self._whether_it_is(target)

    def _doubts(self, estimate: ObjectEstimate) -> bool:
        """Whether a sighting is too unsure to act on; what a person has pointed out is not doubted."""
        wanted = self.get_input("task").object
        said_which = isinstance(wanted, ObjectDescription) and wanted.name is not None
        return not said_which and estimate.confidence < self.toolbox.policy.sure_from

    def _show(self, name: str, wanted: str) -> None:
        """Keep the picture of what a person is asked about, if the detector gives one."""
        estimate = self.toolbox.world.sightings.get(name)
        if estimate is not None and estimate.picture is not None:
            png = base64.b64encode(estimate.picture).decode("ascii")
            self.toolbox.events(ThingPictured(self.toolbox.clock.now_s(), wanted, png))

    def _whether_it_is(self, target: Target) -> Failure:
        """Look again, or ask a person in the end."""
        wanted = self.get_input("task").object
        if self.part == "asking":
            self._show(target.name, str(wanted))
            choice = Choice(target.name, kind_of(target.name))
            return which_is_meant(Ambiguous(f"is this the {wanted}?", (choice,)))
        message = f"what may be the {wanted} is not seen well enough"
        return Failure.postcondition(message, confidence=target.confidence).because(Reason.UNSURE)


def wants_survey(failure: Failure) -> bool:
    """Tell whether a look failed only because others are needed to compare."""
    return failure.root.reason is Reason.MORE_LOOKS_NEEDED


def is_unsure(failure: Failure) -> bool:
    """Tell whether a look failed only because what it showed may be something else."""
    return failure.root.reason is Reason.UNSURE


def is_sure(failure: Failure) -> bool:
    """Tell whether this task has seen everything that it asks about: the rest may be gone by now."""
    choice = failure.root.open_choice
    return choice is None or choice.unseen == 0


def out_of_view(failure: Failure) -> bool:
    """Tell whether a look failed because what is meant was seen before, and elsewhere."""
    return failure.root.reason is Reason.OUT_OF_VIEW


def lost(failure: Failure) -> bool:
    """Tell whether looks to the sides showed nothing any more of what they were to be compared with."""
    return failure.root.reason is Reason.LOST_FROM_VIEW


def _as_believed(name: str, item: SceneObject) -> Target:
    """What is meant where it is believed to be."""
    words = item.label or Label(kind_of(name))
    return Target(name, words.kind, words.color, item.shape, item.world_T_object, 0.0)


def _words(seen: Mapping[str, ObjectEstimate]) -> str:
    """What was seen, each thing once."""
    return ", ".join(sorted({words_for(estimate) for estimate in seen.values()})) or "nothing"
