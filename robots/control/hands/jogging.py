"""Starts jogging on a standing robot, and passes on what a person asks for."""

from __future__ import annotations

from kinematics.arrays import Array
from kinematics.following.jog_reference import Jog
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.planning_scene import PlanningScene
from robots.control.hands.jog_touch import JogTouch
from robots.control.hands.jogged_body import JoggedBody, JogReport
from robots.control.motion_handle import MotionHandle
from robots.control.streaming.motion_streamer import MotionStreamer
from robots.interface.hardware import Hardware


class JoggingControl:
    """Starts jogging in this process; satisfies ``trees.toolbox.Jogging``."""

    def __init__(self, model: RobotModel, streamer: MotionStreamer, hardware: Hardware) -> None:
        """Command through the streamer; the hardware knows what efforts mean contact."""
        self._model, self._streamer = model, streamer
        self._touch = JogTouch(model, hardware, lambda hand: streamer.keeper(hand).reading().holding)
        self._handle: MotionHandle | None = None

    def start(self, scene: PlanningScene) -> JoggingStarted:
        """Begin where the robot is commanded to be now; the handle is refused when it may not.

        Args:
            scene: What is around; it says what may be touched.
        """
        standing = StandingRobot.of(self._model, self._streamer.stance())
        self._touch.begin()
        motion = JoggedBody(standing, self._streamer.reference(), scene, self._touch)
        self._handle = self._streamer.start(motion)
        return JoggingStarted(motion, self._handle)

    def feel(self, effort: Array, needed: Array) -> None:
        """Once a control period: efforts of the actuated joints, measured and needed, Nm, shape (n,)."""
        if self._handle is not None and not self._handle.finished:
            self._touch.take(effort, needed)


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
