"""The planning scene, and where in it things may stand, move and be seen."""

from typing import TYPE_CHECKING

from kinematics.handed_on import handed_on

if TYPE_CHECKING:
    from kinematics.scene.label import Label
    from kinematics.scene.planning_scene import AttachedBody, PlanningScene, SceneObject
else:
    __getattr__ = handed_on(
        __name__,
        {
            "AttachedBody": "planning_scene",
            "Label": "label",
            "PlanningScene": "planning_scene",
            "SceneObject": "planning_scene",
        },
    )

__all__ = [
    "AttachedBody",
    "Label",
    "PlanningScene",
    "SceneObject",
]
