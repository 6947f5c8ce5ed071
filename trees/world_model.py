"""What the robot believes about the world: one planning scene, replaced when it learns more."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from kinematics.requests.grasp import Grasp
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.openings.handles import HandleTarget
from trees.beliefs.sight.sight import Glimpse


@dataclass(frozen=True, slots=True)
class Origin(Sealed):
    """A place on a piece of furniture.

    Attributes:
        support: What it stood on, as the planning scene names it.
        odom_T_object: Its pose there, shape (4, 4).
    """

    support: str
    odom_T_object: Transform


@dataclass(frozen=True, slots=True)
class HandAtHandle:
    """A hand that is about a handle, or on its last piece of way to it; it outlives the task.

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
    """Holds the current planning scene.

    Leaves replace the scene; whoever kept an older one sees by its version that it is stale.

    Attributes:
        sightings: The newest estimate of each thing that was seen in this task, by its name, for those that
            are still believed.
        glimpses: From where it was looked at, the newest last; what no look shows is unknown.
        last_acted_on: Name of the object that a task before was about, and did or touched; "the other one" is
            not that.
        asked_at: Where the robot stood when it was asked for what it is doing, shape (4, 4), or None; "the
            other table" is not the one before it there.
        sent_to: Name of the furniture that the errand under way has walked to, or None; of several that fit,
            what stands there is meant.
        put_down: What a hand of this robot let go of, by its name, until a hand takes it up again: where a
            look has shown it since, else where the hand had it.
        taken_from: Where it stood, of each thing that a hand has or that this task put down, by its name.
        at_handle: A hand that is about the handle of a door or drawer; None once it has drawn back. A task
            that was cancelled leaves it there, and the next one has to let go first.
    """

    def __init__(self, scene: PlanningScene | None = None) -> None:
        self._scene = scene or PlanningScene()
        self.sightings: Mapping[str, ObjectEstimate] = {}
        self.glimpses: tuple[Glimpse, ...] = ()
        self.last_acted_on: str | None = None
        self.asked_at: Transform | None = None
        self.sent_to: str | None = None
        self.put_down: Mapping[str, SceneObject] = {}
        self.taken_from: Mapping[str, Origin] = {}
        self.at_handle: HandAtHandle | None = None

    @property
    def scene(self) -> PlanningScene:
        """The current scene."""
        return self._scene

    def begin_task(self) -> None:
        """What was seen in another task is believed, and no more; what that put down is where it goes."""
        self.sightings = {}
        held = self._scene.attached
        self.taken_from = {name: origin for name, origin in self.taken_from.items() if name in held}

    def note_sightings(self, seen: Mapping[str, ObjectEstimate]) -> None:
        """Remember what a look saw, and forget what is no longer believed."""
        known = {**self.sightings, **seen}
        self.sightings = {name: known[name] for name in sorted(known) if name in self._scene.objects}

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

    def note_taken(self, name: str, origin: Origin) -> None:
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
