"""A scene's truth as solids for the planning scene: for judging stored motions, never for the robot's."""

from __future__ import annotations

from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.scenes import furniture
from robots.scenes.moving_parts import moving_parts
from robots.scenes.person_solid import person_solid
from robots.scenes.scene_description import SceneDescription


def planning_scene(scene: SceneDescription, margin_m: float = 0.0) -> PlanningScene:
    """Everything that a scene file describes, in the world frame.

    Args:
        scene: The scene; furniture becomes its boxes ("table/top", "table/leg_1", ...), a person an
            upright cylinder.
        margin_m: Distance that the robot keeps from each of them.
    """
    solids = [
        SceneObject(solid.name, solid.shape, solid.world_T_solid, margin_m, movable=False)
        for piece in scene.furniture
        for solid in furniture.solids(piece)
    ]
    solids += [
        SceneObject(
            part.name,
            part.shape,
            moving.world_T_solid(furniture.floor_pose(piece), part),
            margin_m,
            movable=False,
        )
        for piece in scene.furniture
        for moving in moving_parts(piece)
        for part in moving.solids
    ]
    solids += [SceneObject(item.name, item.shape, item.world_T_object, margin_m) for item in scene.objects]
    for person in scene.people:
        body, place = person_solid(person)
        solids.append(SceneObject(person.name, body, place, margin_m, movable=False))
    return PlanningScene().with_objects(solids)
