"""Plan, check and carry out one reach of a hand in the simulator: whether a robot's data hold together.

    python -m tools.robot_data reach ./robot --hand right --point 0.5 -0.2 1.0

Inverse kinematics bring the hand to the point, a path is planned and timed, the trajectory checker judges it,
and the control loop carries it out in an empty simulated world. Without a point one is drawn that the hand
reaches. Exit code 0: done, and the hand is there; 1: it is not, and the step that failed is named.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.collision.collision_world import CollisionWorld
from kinematics.collision.validity import SampledValidity
from kinematics.errors import KinematicsError
from kinematics.geometry.poses import Transform
from kinematics.ik.result import IkTolerance
from kinematics.ik.solver import inverse_kinematics
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.planning.path_planner import PathPlanner, PathSettings
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import FreeCoordinates
from kinematics.timing.curve_timing import Pace, time_curve
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.control.motion_handle import MotionStatus
from robots.control.period import PERIOD_S
from robots.errors import RobotsError
from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.scenes.scene_description import SceneDescription
from robots.simulated.world import build_world

_ARRIVED_M = 0.02
_SAFE_SHARE, _WIDE_M = 0.6, 0.08
"""Of the CoM's margin at home, up to so much: a robot that stands keeps this share of it."""
_SETTLE_S = 1.0
_LONGEST_S = 60.0
_DRAWN = 400
_TRIED = 25
_LEAST_M = 0.10
"""A reach that was drawn goes at least so far from home."""


@dataclass(frozen=True, slots=True)
class Reach:
    """How a reach ended.

    Attributes:
        done: Whether the hand is at the point.
        step: Where it ended: "home", "inverse kinematics", "path", "check", "motion", "arrival".
        told: In words, with numbers.
    """

    done: bool
    step: str
    told: str


def reach(robot: RobotData, hand: Hand, point_m: Array | None, seed: int) -> Reach:
    """Plan, check and carry out a reach from the home posture.

    Args:
        robot: Its data.
        hand: Which hand.
        point_m: Where the TCP is to be, in the frame that the robot stands or is mounted in, shape (3,);
            None draws one that is reached.
        seed: Of what is drawn.
    """
    model = RobotModel(robot.description)
    standing = StandingRobot.of(model, stance_at(model, model.q_home))
    world = CollisionWorld(model, PlanningScene(), 0.004, 0.005)
    if (pair := world.colliding_pair(model.q_home)) is not None:
        return Reach(False, "home", f"{pair[0]} and {pair[1]} touch in the home posture")
    judge = SampledValidity(standing, world)
    space = FreeCoordinates(standing)
    planner = PathPlanner(model, space, judge, PathSettings(iterations=2000))
    start = space.from_q(model.q_home)
    if (why := judge.why_not(start)) is not None:
        return Reach(False, "home", f"the home posture is not free: {why}")
    rng = np.random.default_rng(seed)
    solver = inverse_kinematics(standing, hand)
    pace = Pace(0.5, 0.5) if robot.description.welded else Pace(0.2, 0.2)
    margin_m = standing.polygon.com_margin_m(model.com(model.q_home)[:2])
    tolerance = IkTolerance(com_margin_m=_SAFE_SHARE * min(margin_m, _WIDE_M))
    moving = [space.index(joint) for joint in _moving(model, hand)]
    failed = Reach(False, "inverse kinematics", "the hand gets to the point in no posture that is free")
    for target in _targets(model, hand, point_m, rng):
        found = solver.solve(target, model.q_home, tolerance)
        goal = space.from_q(found.q)
        if not found.within(tolerance) or not planner.is_free(goal):
            continue
        curve = planner.plan(start, goal, moving, rng)
        timed = None if curve is None else time_curve(standing, curve, pace)
        if timed is None:
            failed = Reach(False, "path", "no path was found between home and the point")
            continue
        verdict = TrajectoryChecker(model).check(timed, PlanningScene())
        if isinstance(verdict, Unsafe):
            failed = Reach(False, "check", str(verdict))
            continue
        return _carry_out(robot, model, hand, verdict, seed)
    return failed


def _moving(model: RobotModel, hand: Hand) -> tuple[str, ...]:
    groups = model.description.groups
    return (*groups["torso"], *groups[f"{hand}_arm"])


def _targets(
    model: RobotModel, hand: Hand, point_m: Array | None, rng: np.random.Generator
) -> Iterator[Transform]:
    """Poses of the TCP that random postures of the arm have, the nearest to the point first, moved there.

    Without a point the nearest to home, and not all too near.
    """
    frame = model.description.tcp_frames[hand]
    home = model.frame_pose(model.q_home, frame)[:3, 3]
    joints = model.group(f"{hand}_arm")
    low = np.maximum(model.lower_rad[joints] + 0.05, -math.pi)
    high = np.minimum(model.upper_rad[joints] - 0.05, math.pi)
    drawn = []
    for posture in rng.uniform(low, high, (_DRAWN, len(joints))):
        q = model.q_home.copy()
        q[7 + joints] = posture
        drawn.append(model.frame_pose(q, frame))
    if point_m is None:
        away = [float(np.linalg.norm(pose[:3, 3] - home)) for pose in drawn]
        near = sorted(range(len(drawn)), key=lambda k: away[k])
        yield from (drawn[k] for k in near if away[k] > _LEAST_M)
        return
    for pose in sorted(drawn, key=lambda one: float(np.linalg.norm(one[:3, 3] - point_m)))[:_TRIED]:
        target = pose.copy()
        target[:3, 3] = point_m
        yield target


def _carry_out(
    robot: RobotData, model: RobotModel, hand: Hand, motion: CheckedTrajectory, seed: int
) -> Reach:
    world = build_world(robot, SceneDescription("empty"), np.random.default_rng(seed), drawn=False)
    loop = ControlLoop(world.robot, model, ManualClock(), lambda _event: None, PERIOD_S)
    for _ in range(round(_SETTLE_S / PERIOD_S)):
        loop.step()
    handle = loop.motion.start(motion)
    for _ in range(round(_LONGEST_S / PERIOD_S)):
        if handle.finished:
            break
        loop.step()
    if handle.status is not MotionStatus.DONE:
        return Reach(False, "motion", f"{handle.status.name.lower()}: {handle.reason}")
    for _ in range(round(_SETTLE_S / PERIOD_S)):
        loop.step()
    wanted = model.frame_pose(motion.trajectory.q[-1], robot.description.tcp_frames[hand])
    truth = world.truth
    there = truth.world_T_tcp(hand)
    away = float(np.linalg.norm(there[:3, 3] - (truth.world_T_odom() @ wanted)[:3, 3]))
    point = ", ".join(f"{value:.2f}" for value in wanted[:3, 3])
    told = (
        f"the {hand} hand is {1000 * away:.1f} mm from ({point}) m, after {motion.trajectory.t_s[-1]:.1f} s"
    )
    if truth.fallen():
        return Reach(False, "arrival", "the robot fell")
    return Reach(away < _ARRIVED_M, "arrival", told)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    parser.add_argument("robot", help="a robot's name, or the path of its folder")
    parser.add_argument("--hand", choices=("left", "right"), help="the right one, or the only one")
    parser.add_argument(
        "--point", type=float, nargs=3, metavar=("X", "Y", "Z"), help="m; drawn when left out"
    )
    parser.add_argument("--seed", type=int, default=0)


def run(chosen: argparse.Namespace) -> int:
    """Reach, and tell how it ended."""
    try:
        robot = load_robot(chosen.robot)
        hands = robot.description.hands
        hand = chosen.hand or hands[-1]
        if hand not in hands:
            print(f"{robot.description.name} has no {hand} hand; it has: {', '.join(hands)}", file=sys.stderr)
            return 2
        point = None if chosen.point is None else np.array(chosen.point)
        ended = reach(robot, hand, point, chosen.seed)
    except (OSError, ValueError, RobotsError, KinematicsError) as wrong:
        print(f"{chosen.robot}: {wrong}", file=sys.stderr)
        return 2
    print(f"{'done' if ended.done else 'failed'}: {ended.step}: {ended.told}")
    return 0 if ended.done else 1
