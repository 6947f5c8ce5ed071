"""Fold a look into the world model."""

from __future__ import annotations

from kinematics.scene_namespace import reserved_names
from robots.perception.standing import standing_on_tops
from trees.glimpse_of import glimpse_of
from trees.in_hand import not_in_hand
from trees.in_plain_sight import in_plain_sight
from trees.look_leaf import View, estimates_of
from trees.moved_parts import without_moved_parts
from trees.scene_update import SceneUpdate, updated_scene
from trees.toolbox import Toolbox


def folded_look(
    toolbox: Toolbox, views: list[View], *, may_have_moved: bool = True, keeping: bool = False
) -> SceneUpdate:
    """Replace the world model's scene by what a look tells, and remember the look.

    What is in a hand is left out: it is attached, and must not become an obstacle as well. What was out of
    sight, cut off by the picture's edge or hidden stays.

    Args:
        toolbox: Knows the world model.
        views: The look's pictures.
        may_have_moved: As for ``updated_scene``.
        keeping: Whether what an earlier look showed stays in any case.
    """
    world, policy = toolbox.world, toolbox.policy
    estimates = standing_on_tops(not_in_hand(toolbox, estimates_of(views)))
    glimpse, camera = glimpse_of(toolbox, views[-1]), toolbox.model.description.camera
    others = tuple(world.scene.objects.values())
    update = updated_scene(
        without_moved_parts(world.scene, estimates),
        estimates,
        policy,
        lambda item: keeping or not in_plain_sight(item, glimpse, camera, others, policy.hidden_by_hand_m),
        may_have_moved=may_have_moved,
        reserved=reserved_names(toolbox.model),
    )
    world.update(update.scene)
    world.note_glimpse(glimpse)
    return update
