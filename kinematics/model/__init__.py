"""The robot as geometry: description, model, stance, support polygon, forward kinematics."""

from typing import TYPE_CHECKING

from kinematics.handed_on import handed_on

if TYPE_CHECKING:
    from kinematics.model.robot_description import HANDS, Hand, RobotDescription
    from kinematics.model.robot_model import RobotModel
    from kinematics.model.stance import Stance
    from kinematics.model.standing_robot import StandingRobot
    from kinematics.model.support_polygon import SupportPolygon
else:
    __getattr__ = handed_on(
        __name__,
        {
            "HANDS": "robot_description",
            "Hand": "robot_description",
            "RobotDescription": "robot_description",
            "RobotModel": "robot_model",
            "Stance": "stance",
            "StandingRobot": "standing_robot",
            "SupportPolygon": "support_polygon",
        },
    )

__all__ = [
    "HANDS",
    "Hand",
    "RobotDescription",
    "RobotModel",
    "Stance",
    "StandingRobot",
    "SupportPolygon",
]
