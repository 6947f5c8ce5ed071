"""Names that things of a scene cannot have: of the robot's parts and of the floor.

What may touch goes by name, so a box that is called as a link is would be allowed what the link is, and one
that is called "floor" would be the floor.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import replace

from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import FLOOR, PlanningScene, SceneObject


def reserved_names(model: RobotModel) -> frozenset[str]:
    """Names of a robot's links, joints and frames, and the floor's."""
    return frozenset({FLOOR, *(str(frame.name) for frame in model.pin.frames)})


def with_names_of_their_own(scene: PlanningScene, model: RobotModel) -> PlanningScene:
    """A scene in which no object is called as a part of the robot or the floor: "floor" is "floor (object)".

    Args:
        scene: Its objects have names that people gave; nothing may touch anything yet.
        model: The robot.
    """
    reserved = reserved_names(model)
    if reserved.isdisjoint(scene.objects):
        return scene
    return scene.with_objects(_renamed(scene.objects.values(), {*reserved, *scene.objects}, reserved))


def _renamed(
    objects: Iterable[SceneObject], taken: set[str], reserved: Collection[str]
) -> Iterable[SceneObject]:
    for item in objects:
        name = item.name
        if name in reserved:
            while name in taken:
                name = f"{name} (object)"
            taken.add(name)
        yield replace(item, name=name)
