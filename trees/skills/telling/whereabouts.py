"""Where something is, in words for people: on what, in which room, and how far from the robot."""

from __future__ import annotations

from collections.abc import Iterator

from kinematics.scene.support_of import support_of
from robots.scenes.articulated import ARTICULATED_KINDS
from trees.beliefs.grounding.report_words import direction
from trees.beliefs.scene.scene_update import kind_of
from trees.readings.odometry import feet_pose
from trees.toolbox import Toolbox


def where_it_is(name: str, x_m: float, y_m: float, toolbox: Toolbox) -> str:
    """Where a thing or a person is: "on the counter, in the kitchen, 1.20 m ahead".

    Args:
        name: In the planning scene.
        x_m, y_m: Its place in the odometry frame.
        toolbox: What knows where the robot stands.
    """
    ahead = direction(*feet_pose(toolbox).sees(x_m, y_m))
    return ", ".join([*_around(name, x_m, y_m, toolbox), ahead])


def _around(name: str, x_m: float, y_m: float, toolbox: Toolbox) -> Iterator[str]:
    """What it stands on, and in which room, where that is known: who asked may be elsewhere by now."""
    scene, gap_m = toolbox.world.scene, toolbox.policy.support_gap_m
    item = scene.objects.get(name)
    support = support_of(item, scene, gap_m) if item is not None and item.movable else None
    if support is not None and kind_of(support.name) not in ARTICULATED_KINDS:  # in those, mostly
        yield f"on the {kind_of(support.name)}"
    for room, region in toolbox.places.items():
        if region.contains(x_m, y_m):
            yield f"in the {room}"
