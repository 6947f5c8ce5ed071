"""Starts yielding hands on a standing robot, and tells what they feel."""

from __future__ import annotations

from collections.abc import Mapping

from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from robots.control.hands.yield_order import MANNERS, YieldOrder
from robots.control.hands.yield_settings import YieldReport
from robots.control.hands.yielding_hand import YieldingHand
from robots.control.motion_handle import MotionHandle
from robots.control.streaming.motion_streamer import MotionStreamer
from robots.interface.hardware import GripSettings


class YieldingControl:
    """Starts hands that lead and yield in this process; satisfies ``trees.toolbox.Yielding``."""

    def __init__(
        self, model: RobotModel, grips: Mapping[Hand, GripSettings], streamer: MotionStreamer
    ) -> None:
        """Command through the streamer."""
        self._model, self._grips, self._streamer = model, grips, streamer

    def start(self, order: YieldOrder) -> YieldingStarted:
        """Begin where the robot is commanded to be now; the handle is refused when it may not."""
        motion = YieldingHand(
            StandingRobot.of(self._model, self._streamer.stance()),
            order.hand,
            self._streamer.reference(),
            order.scene,
            order.parts,
            order.path,
            order.s_from,
            order.s_to,
            grip=self._grips[order.hand],
            bias=order.bias,
            stop_from=order.stop_from,
            holding=order.holding,
            settings=MANNERS[order.manner],
        )
        return YieldingStarted(motion, self._streamer.start(motion))


class YieldingStarted:
    """A yielding hand under way; satisfies ``trees.toolbox.YieldingMotion``.

    Attributes:
        handle: The motion's.
    """

    def __init__(self, motion: YieldingHand, handle: MotionHandle) -> None:
        self._motion = motion
        self.handle = handle

    @property
    def report(self) -> YieldReport:
        """What was felt so far."""
        return self._motion.report

    def finish(self) -> None:
        """Come to rest where the hand is."""
        self._motion.finish()
