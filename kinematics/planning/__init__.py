"""The planners, one for each kind of request."""

from typing import TYPE_CHECKING

from kinematics.handed_on import handed_on

if TYPE_CHECKING:
    from kinematics.planning.gesture_planner import GesturePlanner
    from kinematics.planning.handle_planner import HandlePlanner
    from kinematics.planning.path_planner import PathPlanner
    from kinematics.planning.pick_planner import PickPlanner
    from kinematics.planning.place_planner import PlacePlanner
    from kinematics.planning.view_planner import ViewPlanner
else:
    __getattr__ = handed_on(
        __name__,
        {
            "GesturePlanner": "gesture_planner",
            "HandlePlanner": "handle_planner",
            "PathPlanner": "path_planner",
            "PickPlanner": "pick_planner",
            "PlacePlanner": "place_planner",
            "ViewPlanner": "view_planner",
        },
    )

__all__ = [
    "GesturePlanner",
    "HandlePlanner",
    "PathPlanner",
    "PickPlanner",
    "PlacePlanner",
    "ViewPlanner",
]
