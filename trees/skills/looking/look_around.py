"""A look that is folded into the world model."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.scene.believed_thing import Surroundings
from trees.failures import Failure
from trees.readings.around import what_is_around
from trees.skills.looking.folded_look import folded_look
from trees.skills.looking.look_leaf import LookLeaf, View


class LookAround(LookLeaf):
    """Gathers a look, folds it into the world model, and hands on what was seen.

    Attributes:
        keeping: Whether what an earlier look showed stays, though this one does not show it: nothing has
            moved, and what is at the picture's edge or half hidden may be overlooked.
        LOOKING_ON: Whether it goes with other looks between which nothing moves: a second thing of a kind
            and colour is another one then, and not the first one that was moved.
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
