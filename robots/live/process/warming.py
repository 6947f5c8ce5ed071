"""Makes a robot without physics move once, so that the served one never waits for what is loaded late."""

from __future__ import annotations

from kinematics.model.robot_model import RobotModel
from kinematics.scene.opening_path import DrawerLine
from kinematics.scene.planning_scene import PlanningScene
from kinematics.walking.pattern.steering import VelocitySteering
from robots.clock import ManualClock
from robots.control.hands.yield_order import YieldOrder
from robots.control.loop.control_loop import ControlLoop
from robots.fake.fake_robot import FakeRobot
from robots.interface.hardware import Hardware

_PERIODS = 60
_AHEAD_M = 0.02


def warm_up(model: RobotModel, hardware: Hardware) -> None:
    """Let a hand yield, brake it, and take a step, each for a moment.

    The first whole-body motion loads a second of compiled code and the first walk another library.
    """
    description = model.description
    for hand in description.gripping_hands:
        loop = _loop(model, hardware)
        q = loop.motion.reference()
        tcp_m = model.frame_pose(q, description.grippers[hand].tcp_frame)[:3, 3]
        line = DrawerLine(tcp_m, 0.0)
        loop.yielding.start(YieldOrder(hand, PlanningScene(), (), line, 0.0, _AHEAD_M, holding=False))
        _run(loop)
        loop.stop(1, "it was to warm up")
        _run(loop)
    if description.walking is not None:
        loop = _loop(model, hardware)
        loop.walking.walk(VelocitySteering(description.walking, 0.1, 0.0), "walk")
        _run(loop)


def _loop(model: RobotModel, hardware: Hardware) -> ControlLoop:
    clock = ManualClock()
    robot = FakeRobot(model, hardware, clock)
    return ControlLoop(robot, model, clock, lambda _event: None)


def _run(loop: ControlLoop) -> None:
    for _ in range(_PERIODS):
        loop.step()
