"""How processor time grows: ``python -m tools.benchmark.scaling --repeats 15 --json FILE``.

With the number of obstacles: the Panda among small boxes in a shell about the reach of its arm, so that
most of them are near and few of them in the way; and TALOS's trajectory checker beside as many boxes.
With the number of waypoints: the timing of a polyline, and the check of what comes of it. The exponent
is the slope of a straight line through the upper half of the points, both axes logarithmic.
"""

from __future__ import annotations

import argparse
import functools
import json
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from kinematics.arrays import Array
from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.collision.validity import Validity, validity
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance, stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import PolynomialCurve, RoundedPolyline
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.planning.path_planner import PathPlanner
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.standing.free_coordinates import FreeCoordinates, free_coordinates
from kinematics.timing.curve_timing import Pace, time_curve
from robots.models.description import load_description
from tools.benchmark.figures import timed_s
from tools.benchmark.own_arm_planner import panda_on_floor
from tools.benchmark.scaling_page import Course

OBSTACLES = (1, 3, 10, 30, 100, 300, 1000)
WAYPOINTS = (2, 4, 8, 16, 32, 64, 128)
BOX_M = 0.04
# Distance of the boxes from the arm's shoulder, m.
_SHELL_M = (0.6, 1.4)
_SHOULDER_M = np.array([0.0, 0.0, 0.33])
# Distance of the boxes from the humanoid's pelvis on the ground, m: its hands come as far as 0.7.
_AHEAD_M = (0.85, 3.0)
_EDGE_RAD = 2.0
_PACE = Pace(0.5, 0.7)


def course(name: str, against: str, counts: Sequence[int], samples_s: Sequence[Sequence[float]]) -> Course:
    """Sum up samples of each count, s."""
    low, high = (
        tuple(1e3 * float(np.percentile(samples, share)) for samples in samples_s) for share in (50, 95)
    )
    half = len(counts) // 2
    slope = np.polyfit(np.log(counts[half:]), np.log(low[half:]), 1)[0]
    return Course(name, against, tuple(counts), low, high, float(slope))


def scaling(repeats: int) -> list[Course]:
    """All courses; ``repeats`` scenes or paths for each count."""
    return [*_among_obstacles(repeats), _checks_among_obstacles(repeats), *_along_waypoints(repeats)]


def _among_obstacles(repeats: int) -> list[Course]:
    model, stance = panda_on_floor(), Stance(())
    robot = StandingRobot(model, stance)
    space = FreeCoordinates(robot)
    names = ("Panda: scene taken in", "Panda: line of 2 rad judged", "Panda: path planned and shortened")
    found: dict[str, list[list[float]]] = {name: [] for name in names}
    # what is loaded at the first use does not count
    first = validity(robot, PlanningScene().with_objects(_shell(np.random.default_rng(0), 1)))
    _judge_all(first, [_edge(model, first, np.random.default_rng(0))])
    for count in OBSTACLES:
        samples: dict[str, list[float]] = {name: [] for name in names}
        for number in range(repeats):
            rng = np.random.default_rng([count, number])
            scene = PlanningScene().with_objects(_shell(rng, count))
            samples[names[0]].append(timed_s(functools.partial(validity, robot, scene)))
            judge = validity(robot, scene)
            start, goal = (_free_point(model, judge, rng) for _ in range(2))
            edges = [_edge(model, judge, rng) for _ in range(20)]
            _judge_all(judge, edges)
            samples[names[1]].append(timed_s(functools.partial(_judge_all, judge, edges)) / len(edges))
            # with the product's own settings: a search that finds nothing ends too
            planner = PathPlanner(model, space, judge)
            plan = functools.partial(
                planner.plan, start, goal, list(range(space.size)), np.random.default_rng(number)
            )
            samples[names[2]].append(timed_s(plan))
        for name in names:
            found[name].append(samples[name])
    return [course(name, "obstacles", OBSTACLES, found[name]) for name in names]


def _judge_all(judge: Validity, edges: Sequence[Array]) -> None:
    for edge in edges:
        judge.polyline_is_free(edge)


def _shell(rng: np.random.Generator, count: int) -> list[SceneObject]:
    found = []
    for number in range(count):
        direction = rng.normal(size=3)
        direction[2] = abs(direction[2])
        place = _SHOULDER_M + direction * (rng.uniform(*_SHELL_M) / np.linalg.norm(direction))
        turn = poses.rotation_z(float(rng.uniform(-np.pi, np.pi)))
        found.append(_box(number, place, turn))
    return found


def _box(number: int, place: Array, turn: Array) -> SceneObject:
    return SceneObject(f"box {number}", Box((BOX_M, BOX_M, BOX_M)), poses.transform(turn, place), 0.0)


def _free_point(model: RobotModel, judge: Validity, rng: np.random.Generator) -> Array:
    while True:
        x = rng.uniform(model.lower_rad + 0.02, model.upper_rad - 0.02)
        if judge.points_are_free(x[None]):
            return np.asarray(x)


def _edge(model: RobotModel, judge: Validity, rng: np.random.Generator) -> Array:
    """A line within the limits that begins where the robot is free, shape (2, size)."""
    while True:
        a = _free_point(model, judge, rng)
        direction = rng.normal(size=len(a))
        direction[7:] = 0.0
        b = a + direction * (_EDGE_RAD / np.linalg.norm(direction))
        if np.all(b > model.lower_rad + 0.02) and np.all(b < model.upper_rad - 0.02):
            return np.stack([a, b])


def _checks_among_obstacles(repeats: int) -> Course:
    model = RobotModel(load_description("talos"))
    judge = TrajectoryChecker(model)
    found = []
    for count in OBSTACLES:
        samples = []
        for number in range(repeats):
            rng = np.random.default_rng([count, number, 1])
            trajectory = _reaching(model, rng)
            places = rng.uniform((_AHEAD_M[0], -1.5, 0.0), (_AHEAD_M[1], 1.5, 1.8), (count, 3))
            boxes = [_box(k, place, np.eye(3)) for k, place in enumerate(places)]
            scene = PlanningScene().with_objects(boxes)
            judge.check(trajectory, scene)
            samples.append(timed_s(functools.partial(judge.check, trajectory, scene)))
        found.append(samples)
    return course("TALOS: motion of both arms checked", "obstacles", OBSTACLES, found)


def _reaching(model: RobotModel, rng: np.random.Generator) -> Trajectory:
    """A motion of both arms by some tenths of a radian, from home."""
    robot = StandingRobot(model, stance_at(model, model.q_home))
    space = free_coordinates(robot)
    while True:
        ends = space.from_q(model.q_home)[None].repeat(2, axis=0)
        for hand in ("left", "right"):
            for joint in model.description.groups[f"{hand}_arm"]:
                ends[1, space.index(joint)] += rng.uniform(-0.3, 0.3)
        trajectory = time_curve(robot, PolynomialCurve(ends), _PACE)
        if trajectory is not None and isinstance(_check(model, trajectory), CheckedTrajectory):
            return trajectory


def _check(model: RobotModel, trajectory: Trajectory) -> object:
    return TrajectoryChecker(model).check(trajectory, PlanningScene())


def _along_waypoints(repeats: int) -> list[Course]:
    model = RobotModel(load_description("talos"))
    robot = StandingRobot(model, stance_at(model, model.q_home))
    space = free_coordinates(robot)
    judge = TrajectoryChecker(model)
    joints = model.description.groups["left_arm"]
    columns = [space.index(joint) for joint in joints]
    timing, checking = [], []
    for count in WAYPOINTS:
        one, other = [], []
        for number in range(repeats):
            rng = np.random.default_rng([count, number, 2])
            points = space.from_q(model.q_home)[None].repeat(count, axis=0)
            points[1:, columns] += rng.uniform(-0.25, 0.25, (count - 1, len(columns)))
            curve = RoundedPolyline(points, space.weights, 0.12)
            make = functools.partial(time_curve, robot, curve, _PACE)
            trajectory = make()
            one.append(timed_s(make))
            if trajectory is not None:
                other.append(timed_s(functools.partial(judge.check, trajectory, PlanningScene())))
        timing.append(one)
        checking.append(other)
    return [
        course("TALOS: polyline timed", "waypoints", WAYPOINTS, timing),
        course("TALOS: what comes of it checked", "waypoints", WAYPOINTS, checking),
    ]


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure, print, and keep."""
    parser = argparse.ArgumentParser(prog="python -m tools.benchmark.scaling", description=__doc__)
    parser.add_argument("--repeats", type=int, default=15, metavar="N", help="scenes or paths of each count")
    parser.add_argument("--json", type=Path, metavar="FILE")
    options = parser.parse_args(arguments)
    courses = scaling(options.repeats)
    _print(courses, Console())
    if options.json is not None:
        document = {
            "suite": "scaling",
            "repeats": options.repeats,
            "courses": [asdict(item) for item in courses],
        }
        options.json.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    return 0


def _print(courses: Sequence[Course], console: Console) -> None:
    form: Callable[[float], str] = "{:.3g}".format
    for against in dict.fromkeys(item.against for item in courses):
        rows = [item for item in courses if item.against == against]
        table = Table("median ms", *map(str, rows[0].counts), "exponent", title=f"against {against}")
        for item in rows:
            table.add_row(item.name, *map(form, item.median_ms), f"{item.exponent:.2f}")
        console.print(table)


if __name__ == "__main__":
    sys.exit(main())
