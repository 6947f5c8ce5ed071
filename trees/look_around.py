"""A look that is folded into the world model."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from robots.perception.standing import standing_on_tops
from trees.believed_thing import Surroundings, surroundings
from trees.failures import Failure
from trees.glimpse_of import glimpse_of
from trees.handles import without_moved_parts
from trees.in_hand import not_in_hand
from trees.in_plain_sight import in_plain_sight
from trees.look_leaf import LookLeaf, View, estimates_of
from trees.scene_update import updated_scene


class LookAround(LookLeaf):
    """Gathers a look, replaces the world model's scene by what it tells, and hands on what was seen.

    What is in a hand is left out: it is attached, and must not become an obstacle as well.

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
        toolbox = self.toolbox
        model, q = toolbox.model, toolbox.sensing.state().q
        odom_T_base = model.frame_pose(q, model.description.base_link)
        gap_m = toolbox.policy.support_gap_m
        return surroundings(toolbox.world.scene, odom_T_base, gap_m, toolbox.world.last_acted_on)

    def judge(self, views: list[View]) -> Status | Failure:
        """Update the world model, then judge what was seen."""
        world, policy = self.toolbox.world, self.toolbox.policy
        estimates = standing_on_tops(not_in_hand(self.toolbox, estimates_of(views)))
        glimpse = glimpse_of(self.toolbox, views[-1])
        camera, near_m = self.toolbox.model.description.camera, policy.hidden_by_hand_m
        others = tuple(world.scene.objects.values())
        update = updated_scene(
            without_moved_parts(world.scene, estimates),
            estimates,
            policy,
            lambda item: self.keeping or not in_plain_sight(item, glimpse, camera, others, near_m),
            may_have_moved=not self.LOOKING_ON,
        )
        world.update(update.scene)
        world.note_glimpse(glimpse)
        self.measured(frames=len(views), things=len(update.seen), scene_version=update.scene.version)
        return self.found(update.seen)
