"""A look that is folded into the world model."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.scene.believed_thing import Surroundings
from trees.failures import Failure
from trees.readings.odometry import what_is_around
from trees.skills.looking.folded_look import folded_look
from trees.skills.looking.look_leaf import LookLeaf, View


class LookAround(LookLeaf):
    """A leaf that takes a look, updates the world model with it, and judges what was seen.

    Attributes:
        keeping: Whether things that this look does not show stay in the world model. They do when nothing has
            moved, since what is half hidden or at the edge of the picture may be overlooked.
        LOOKING_ON: Whether the look is one of several between which nothing moves. A second thing of the same
            kind and colour is then another thing, and not the first one in a new place.
    """

    LOOKING_ON: ClassVar[bool] = False
    keeping = False

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """What follows from the things seen, by their names in the scene."""
        raise NotImplementedError

    def around(self) -> Surroundings:
        """What is believed now, from where the robot stands."""
        return what_is_around(self.toolbox)

    def judge(self, views: list[View]) -> Status | Failure:
        """Update the world model, then judge what was seen."""
        update = folded_look(self.toolbox, views, may_have_moved=not self.LOOKING_ON, keeping=self.keeping)
        self.measured(frames=len(views), things=len(update.seen), scene_version=update.scene.version)
        return self.found(update.seen)
