"""Starts jogging on a standing robot, and passes on what a person asks for."""

from __future__ import annotations

from kinematics.following.jog_reference import Jog
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.planning_scene import PlanningScene
from robots.control.hands.jogged_body import JoggedBody, JogReport
from robots.control.motion_handle import MotionHandle
from robots.control.streaming.motion_streamer import MotionStreamer


class JoggingControl:
    """Starts jogging in this process; satisfies ``trees.toolbox.Jogging``."""

    def __init__(self, model: RobotModel, streamer: MotionStreamer) -> None:
        """Command through the streamer."""
        self._model, self._streamer = model, streamer

    def start(self, scene: PlanningScene) -> JoggingStarted:
        """Begin where the robot is commanded to be now; the handle is refused when it may not.

        Args:
            scene: What is around; it says what may be touched.
        """
        standing = StandingRobot.of(self._model, self._streamer.stance())
        motion = JoggedBody(standing, self._streamer.reference(), scene)
        return JoggingStarted(motion, self._streamer.start(motion))


class JoggingStarted:
    """Jogging under way; satisfies ``trees.toolbox.JoggingMotion``.

    Attributes:
        handle: The motion's.
    """

    def __init__(self, motion: JoggedBody, handle: MotionHandle) -> None:
        self._motion = motion
        self.handle = handle

    @property
    def report(self) -> JogReport:
        """How it goes."""
        return self._motion.report

    def steer(self, jog: Jog) -> None:
        """Go on as asked for, for as long as a word is good for."""
        self._motion.steer(jog)

    def brake(self) -> None:
        """Come to rest now, and go on listening."""
        self._motion.brake()

    def finish(self) -> None:
        """Come to rest, and end."""
        self._motion.finish()
