"""What the robot believes about the world: one planning scene, replaced when it learns more."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from kinematics.requests.grasp import Grasp
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.fusion.felt_top import FeltTop
from robots.perception.object_estimate import ObjectEstimate
from robots.perception.position_error import PositionError
from trees.beliefs.openings.handles import HandleTarget
from trees.beliefs.scene.person_looks import PersonLooks
from trees.beliefs.sight.sight import Glimpse


@dataclass(frozen=True, slots=True)
class FormerPlace(Sealed):
    """Where an object stood on a piece of furniture before a hand took it.

    Attributes:
        support: What it stood on, as the planning scene names it.
        odom_T_object: Its pose there, shape (4, 4).
    """

    support: str
    odom_T_object: Transform


@dataclass(frozen=True, slots=True)
class HandAtHandle:
    """A hand whose fingers are around a handle, or on the last part of the way to it.

    It is remembered beyond the task that brought it there, so that a later task lets go of the handle first.

    Attributes:
        target: Which handle.
        grasp: Which hand, and how.
    """

    target: HandleTarget
    grasp: Grasp


# Looks taken from elsewhere, before a walk, say little in a frame that has drifted since.
_SAME_PLACE_M = 0.8
_MOST_GLIMPSES = 40


class WorldModel:
    """What the robot believes about the world: the current planning scene, and how it came to be known.

    Leaves replace the scene by a newer one. Whoever kept an older one sees by its version that it is stale.

    Attributes:
        sightings: The newest estimate of each thing that was seen in this task, by its name, for those that
            are still believed.
        people: What the looks of this task have told of each person, by name.
        glimpses: The looks that were taken from about here, the newest last; what no look has shown is
            unknown.
        last_acted_on: Name of the object that an earlier task was about, if the task was done or a hand has
            touched the object; "the other one" then means a different object.
        asked_at: Where the robot stood when it was given the command that it is carrying out, shape (4, 4),
            or None; "the other table" is a different one than the table that it stood before.
        sent_to: Name of the furniture that the command under way has made the robot walk to, or None; of
            several things that fit, the one on this furniture is meant.
        put_down: The objects that a hand of this robot has let go of, by name, until a hand takes them up
            again. Each is where a later look has shown it, or else where the hand let go of it.
        taken_from: Where each object stood, by name, that a hand holds or that this task has put down.
        leans: Names of what a hand holds and nobody knows how far it leans there: fingers on a palm took it
            steeply, which turns a thing, and looks do not show by how much.
        felt_widths: What fingers have felt of a thing's width, m, by its name, where that is another one
            than the camera tells; the newest counts.
        top_errors: How wrong the newest look at each piece of furniture may be, by its name; of a detector
            that declares it.
        felt_tops: At which height a hand has felt a top in this task, by the top's name; the newest counts.
        sees_badly: What has been wrong with the robot's pictures in this task, for people; empty when nothing
            has.
        at_handle: The hand that is at the handle of a door or drawer; None once it has drawn back. A
            cancelled task leaves the hand there, and the next task has to let go first.
    """

    def __init__(self, scene: PlanningScene | None = None) -> None:
        self._scene = scene or PlanningScene()
        self.sightings: Mapping[str, ObjectEstimate] = {}
        self.glimpses: tuple[Glimpse, ...] = ()
        self.last_acted_on: str | None = None
        self.asked_at: Transform | None = None
        self.sent_to: str | None = None
        self.put_down: Mapping[str, SceneObject] = {}
        self.taken_from: Mapping[str, FormerPlace] = {}
        self.leans: frozenset[str] = frozenset()
        self.felt_widths: Mapping[str, float] = {}
        self.top_errors: Mapping[str, PositionError] = {}
        self.felt_tops: Mapping[str, FeltTop] = {}
        self.at_handle: HandAtHandle | None = None
        self.people: Mapping[str, PersonLooks] = {}
        self.sees_badly = ""
        self._reasons: set[str] = set()

    @property
    def scene(self) -> PlanningScene:
        """The current scene."""
        return self._scene

    def begin_task(self) -> None:
        """What was seen in another task is believed, and no more; what that put down is where it goes."""
        self.sightings = {}
        self.felt_widths = {}
        self.felt_tops = {}
        self.people = {}
        self.sees_badly = ""
        self._reasons.clear()
        held = self._scene.attached
        self.taken_from = {name: origin for name, origin in self.taken_from.items() if name in held}
        self.leans = self.leans & held.keys()

    def is_new_reason(self, because: str) -> bool:
        """Note why something was taken for what is meant; whether this task has not said so yet.

        Args:
            because: The reason, for people; an empty one is none.
        """
        new = bool(because) and because not in self._reasons
        self._reasons.add(because)
        return new

    def note_sightings(self, seen: Mapping[str, ObjectEstimate]) -> None:
        """Remember what a look saw, and forget what is no longer believed."""
        known = {**self.sightings, **seen}
        self.sightings = {name: known[name] for name in sorted(known) if name in self._scene.objects}

    def note_person(self, name: str, traits: tuple[str, ...]) -> tuple[str, ...]:
        """Remember what a look told of a person; all that this task's looks have told.

        Args:
            name: Whom it showed, as the planning scene names them.
            traits: What it told.
        """
        looks = self.people.get(name, PersonLooks()).and_seen(traits)
        self.people = {**self.people, name: looks}
        return looks.traits

    def note_glimpse(self, glimpse: Glimpse) -> None:
        """Remember a look; those from another standing place are forgotten."""
        eye = glimpse.odom_T_camera[:3, 3]
        near = [
            one
            for one in self.glimpses
            if float(np.linalg.norm(one.odom_T_camera[:3, 3] - eye)) <= _SAME_PLACE_M
        ]
        self.glimpses = (*near, glimpse)[-_MOST_GLIMPSES:]

    def note_put_down(self, name: str) -> None:
        """Remember that a hand let go of something; the scene has it already."""
        self.put_down = {**self.put_down, name: self._scene.objects[name]}

    def note_felt_width(self, name: str, width_m: float) -> None:
        """Remember how wide fingers have felt a thing to be; the camera's word counts less from now on."""
        self.felt_widths = {**self.felt_widths, name: width_m}

    def note_top_errors(self, seen: Mapping[str, ObjectEstimate]) -> None:
        """Remember how wrong what a look shows of furniture may be, and forget what is no longer believed."""
        new = {
            name: one.error
            for name, one in seen.items()
            if one.category == "furniture" and one.error is not None
        }
        known = {**self.top_errors, **new}
        self.top_errors = {name: error for name, error in known.items() if name in self._scene.objects}

    def note_felt_top(self, name: str, felt: FeltTop) -> None:
        """Remember at which height a hand has felt a top."""
        self.felt_tops = {**self.felt_tops, name: felt}

    def note_taken(self, name: str, origin: FormerPlace) -> None:
        """Remember where a thing stood before a task took it, though that puts it down and takes it again."""
        self.taken_from = {name: origin, **self.taken_from}

    def update(self, scene: PlanningScene) -> None:
        """Replace the scene by a newer one.

        What was put down and is not in it any more is remembered where it was: a look may have missed it.

        Raises:
            ValueError: Its version is not higher.
        """
        if scene.version <= self._scene.version:
            raise ValueError(f"scene version {scene.version} is not newer than {self._scene.version}")
        self._scene = scene
        self.put_down = {
            name: scene.objects.get(name, item)
            for name, item in self.put_down.items()
            if name not in scene.attached
        }
