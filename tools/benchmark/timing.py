"""Timing of paths, beside the time-optimal bound that knows no jerk limit, and beside stopping at corners.

``python -m tools.benchmark.timing [--quick] [--toppra PYTHON]``, where PYTHON is an interpreter that has
toppra; without one the bound is this project's own, of the same method, on a finer grid.
"""

from __future__ import annotations

import argparse
import itertools
import json
import subprocess
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import ruckig
from rich.console import Console
from scipy.interpolate import CubicHermiteSpline, CubicSpline

from kinematics.arrays import Array
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import BlendedPolyline
from kinematics.standing.free_coordinates import FreeCoordinates
from kinematics.timing.curve_speed import CurveGrid
from kinematics.timing.curve_timing import (
    FOLLOWING,
    JointLimits,
    Pace,
    TimedCurve,
    time_coordinates,
    time_curve,
)
from kinematics.timing.timing_kernel import grid_times
from robots.models.description import load_description
from tools.benchmark.figures import Figure, figure, print_figures

Bound = Callable[[CurveGrid], tuple[float, float]]
"""Least duration of a curve without a jerk limit, s, and the processor time that it took, s."""

DEVIATION = 0.01
BLEND = DEVIATION - FOLLOWING
WAYPOINTS, ARM = 20, "right_arm"
# Length of a step: what the path planner's trees grow by.
STEP = 0.5
# Intervals of a piece of the curve on which the bound is computed; and of what a motion ran through.
FINE = 16
TRAVERSED = 4000
# Points of it that are nearer to each other, rad, are taken as one.
CLOSEST = 2e-3


@dataclass(frozen=True, slots=True)
class Family:
    """One way to draw random paths."""

    name: str
    draw: Callable[[np.random.Generator], Array]


def _walk(rng: np.random.Generator) -> Array:
    steps = rng.normal(size=(WAYPOINTS - 1, 7))
    steps *= STEP / np.linalg.norm(steps, axis=1, keepdims=True)
    return np.concatenate([np.zeros((1, 7)), np.cumsum(steps, axis=0)])


def _far(rng: np.random.Generator) -> Array:
    return rng.uniform(-1.0, 1.0, (WAYPOINTS, 7))


FAMILIES = (Family(f"steps of {STEP} rad", _walk), Family("anywhere in +-1 rad", _far))


def timing(quick: bool, toppra: Path | None = None) -> list[Figure]:
    """Random paths of 20 waypoints, each timed by everybody in turn.

    Args:
        quick: Fewer paths.
        toppra: An interpreter whose environment has toppra.
    """
    model = RobotModel(load_description("talos"))
    arm = model.group(ARM)
    limits = JointLimits(model.velocity[arm], model.acceleration[arm], model.jerk[arm])
    count = 10 if quick else 100
    if toppra is None:
        return _figures(limits, count, "least time without jerk", _own_bound(limits)) + _whole_body(
            model, count
        )
    script = Path(__file__).with_name("timing_toppra.py")
    with subprocess.Popen(
        [str(toppra), str(script)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as peer:
        found = _figures(limits, count, "toppra, without jerk", _peer_bound(limits, peer))
        assert peer.stdin is not None
        peer.stdin.close()
    return found + _whole_body(model, count)


def _figures(limits: JointLimits, count: int, peer: str, bound: Bound) -> list[Figure]:
    figures = []
    for family in FAMILIES:
        rows: dict[str, list[float]] = defaultdict(list)
        for seed in range(-1, count):  # the first warms everybody up
            points = family.draw(np.random.default_rng(seed % 100_000))
            began_s = time.process_time()
            curve = BlendedPolyline(points, np.ones(7), BLEND)
            timed = time_coordinates(curve, _same, limits, np.ones(7))
            seconds = time.process_time() - began_s
            assert timed is not None
            same_s, peer_seconds = bound(CurveGrid.along(curve, FINE))
            widest = BlendedPolyline(points, np.ones(7), DEVIATION)
            widest_s, _ = bound(CurveGrid.along(widest, FINE))
            traversed_s, _ = bound(_traversed(timed))
            row = {
                "duration": timed.t_s[-1],
                "same": same_s,
                "widest": widest_s,
                "traversed": traversed_s,
                "stops": _stopping_s(points, limits),
                "away": _farthest(points, timed.q),
                "ms": 1e3 * seconds,
                "peer ms": 1e3 * peer_seconds,
            }
            for key, value in row.items():
                if seed >= 0:
                    rows[key].append(value)
        name, ours = family.name, rows["duration"]
        figures += [
            figure(f"{name}: duration, s", ours, f"{peer}, corners cut by {DEVIATION} rad", rows["widest"]),
            figure(f"{name}: duration, s", ours, f"{peer}, our blends", rows["same"]),
            figure(f"{name}: duration, s", ours, f"{peer}, where our motion runs", rows["traversed"]),
            figure(f"{name}: duration, s", ours, "a stop at each corner", rows["stops"]),
            figure(f"{name}: distance from the polyline, rad", rows["away"]),
            figure(f"{name}: processor time, ms", rows["ms"], peer, rows["peer ms"]),
        ]
    return figures


def _whole_body(model: RobotModel, count: int) -> list[Figure]:
    """Paths that move pelvis, torso and arm, so that the legs have to follow, at the product's pace."""
    robot = StandingRobot(model, stance_at(model, model.q_home))
    space = FreeCoordinates(robot)
    home = space.from_q(model.q_home)
    columns = [space.index(joint) for group in ("torso", ARM) for joint in model.description.groups[group]]
    milliseconds: list[float] = []
    for seed in range(-1, count // 4):
        rng = np.random.default_rng(seed % 100_000)
        points = np.tile(home, (WAYPOINTS, 1))
        points[1:, :3] += rng.uniform(-0.02, 0.02, (WAYPOINTS - 1, 3)) - [0.0, 0.0, 0.02]
        points[1:, columns] += rng.uniform(-0.3, 0.3, (WAYPOINTS - 1, len(columns)))
        began_s = time.process_time()
        curve = BlendedPolyline(points, space.weights, BLEND)
        trajectory = time_curve(robot, curve, Pace(0.5, 0.7))
        if seed >= 0 and trajectory is not None:
            milliseconds.append(1e3 * (time.process_time() - began_s))
    return [figure("whole body, legs included: processor time, ms", milliseconds)]


def _same(x: Array) -> Array:
    return x


def _traversed(timed: TimedCurve) -> CurveGrid:
    """The very curve that a motion runs through, corners cut as it cuts them."""
    motion = CubicHermiteSpline(timed.t_s, timed.q, timed.rate)
    q = motion(np.linspace(0.0, timed.t_s[-1], 3 * len(timed.t_s)))
    way = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(q, axis=0), axis=1)))
    # slow places would give points so close together that rounding bends the curve
    apart = np.append(np.flatnonzero(np.diff(np.floor(way / CLOSEST))), len(way) - 1)
    curve = CubicSpline(np.append(0.0, way[apart]), np.concatenate([q[:1], q[apart]]))
    points = curve(np.linspace(0.0, way[-1], 2 * TRAVERSED + 1))
    return CurveGrid(np.full(TRAVERSED, way[-1] / TRAVERSED), points)


def _own_bound(limits: JointLimits) -> Bound:
    def bound(grid: CurveGrid) -> tuple[float, float]:
        began_s = time.process_time()
        rates = grid.bounded(grid.points, limits.velocity, limits.acceleration).rates()
        return float(grid_times(rates, grid.step)[-1]), time.process_time() - began_s

    return bound


def _peer_bound(limits: JointLimits, peer: subprocess.Popen[str]) -> Bound:
    def bound(grid: CurveGrid) -> tuple[float, float]:
        s = np.append(0.0, np.cumsum(np.repeat(grid.step / 2.0, 2)))
        problem = {
            "s": s.tolist(),
            "q": grid.points.tolist(),
            "velocity": limits.velocity.tolist(),
            "acceleration": limits.acceleration.tolist(),
            "grid": s.tolist(),
        }
        assert peer.stdin is not None
        assert peer.stdout is not None
        peer.stdin.write(json.dumps(problem) + "\n")
        peer.stdin.flush()
        answer = json.loads(peer.stdout.readline())
        return answer["bound_s"], answer["solve_s"]

    return bound


def _stopping_s(points: Array, limits: JointLimits) -> float:
    """Every straight piece from rest to rest, as fast as its joints' limits allow."""
    total = 0.0
    for a, b in itertools.pairwise(points):
        way = np.abs(b - a)
        request = ruckig.InputParameter(1)
        request.target_position = [1.0]
        request.max_velocity = [float(np.min(limits.velocity / way))]
        request.max_acceleration = [float(np.min(limits.acceleration / way))]
        request.max_jerk = [float(np.min(limits.jerk / way))]
        profile = ruckig.Trajectory(1)
        ruckig.Ruckig(1).calculate(request, profile)
        total += profile.duration
    return total


def _farthest(polyline: Array, points: Array) -> float:
    """The farthest that a joint is from the nearest point of the polyline, from above."""
    euclidean, largest = np.full(len(points), np.inf), np.full(len(points), np.inf)
    for a, b in itertools.pairwise(polyline):
        share = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0)
        gap = points - a - share[:, None] * (b - a)
        distance = np.linalg.norm(gap, axis=1)
        largest = np.where(distance < euclidean, np.abs(gap).max(axis=1), largest)
        euclidean = np.minimum(euclidean, distance)
    return float(largest.max())


def main(arguments: Sequence[str] | None = None) -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(prog="python -m tools.benchmark.timing", description="Timing of paths.")
    parser.add_argument("--quick", action="store_true", help="fewer paths")
    parser.add_argument("--toppra", type=Path, metavar="PYTHON", help="an interpreter that has toppra")
    parser.add_argument("--json", type=Path, metavar="FILE")
    options = parser.parse_args(arguments)
    figures = timing(options.quick, options.toppra)
    print_figures("timing", figures, Console())
    if options.json is not None:
        document = {
            "suite": "timing", "quick": options.quick, "figures": [item.to_json() for item in figures]
        }  # fmt: skip
        options.json.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
