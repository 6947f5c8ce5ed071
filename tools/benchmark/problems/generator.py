"""Draw problems from a seed: scenes of a family with a start and a goal that are free by the referee."""

from __future__ import annotations

import zlib
from collections.abc import Iterator

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import FLOOR, SceneObject
from tools.benchmark.problems.arm_judge import Arm, ArmJudge
from tools.benchmark.problems.families import FAMILIES, Place, Rng, Setting
from tools.benchmark.problems.problem import Problem

READY = np.array([0.0, -np.pi / 4, 0.0, -3 * np.pi / 4, 0.0, np.pi / 2, np.pi / 4])
# Start and goal keep so far away from everything that no planner's rounding decides.
CLEARANCE_M = 0.005
# The line from start to goal is judged this finely before it counts as not trivial.
LINE_STEP_RAD = 0.02
_SCENES, _POSES, _SEEDS = 200, 12, 4
# Every scene has the same floor, a centimetre below the base, so that the base itself never touches it.
GROUND = SceneObject(FLOOR, Box((4.0, 4.0, 0.1)), poses.translation(0.0, 0.0, -0.06), movable=False)


class NoProblemError(RuntimeError):
    """A family gave no valid problem in many scenes: its sizes are out of the arm's reach."""


def problems(arm: Arm, family: str, count: int, seed: int) -> Iterator[Problem]:
    """Draw ``count`` problems; the same arguments give the same problems, in this order.

    Every problem needs planning: its straight line collides.

    Raises:
        KeyError: There is no such family.
        NoProblemError: No valid problem was found.
    """
    setting = FAMILIES[family]
    for number in range(count):
        # a stream of its own for each, so that problem 7 is the same whether 10 or 100 are asked for
        rng = np.random.default_rng([seed, zlib.crc32(family.encode()), number])
        for _ in range(_SCENES):
            problem = _draw(arm, family, number, setting(rng), rng)
            if problem is not None:
                yield problem
                break
        else:
            raise NoProblemError(f"no valid problem of family {family!r} in {_SCENES} scenes")


def _draw(arm: Arm, family: str, number: int, setting: Setting, rng: Rng) -> Problem | None:
    objects = (GROUND, *setting.objects)
    judge = ArmJudge(arm, objects, CLEARANCE_M)
    start = _near_ready(judge, rng) if setting.start is None else _at(arm, judge, setting.start, rng)
    if start is None:
        return None
    goal = _at(arm, judge, setting.goal, rng)
    if goal is None or ArmJudge(arm, objects).edge_is_free(start, goal, LINE_STEP_RAD):
        return None
    return Problem(family, number, objects, start, goal)


def _near_ready(judge: ArmJudge, rng: Rng) -> Array | None:
    for _ in range(_POSES):
        q = READY + rng.uniform(-0.3, 0.3, len(READY))
        if judge.within_limits(q) and not judge.collides(q):
            return q
    return None


def _at(arm: Arm, judge: ArmJudge, place: Place, rng: Rng) -> Array | None:
    for _ in range(_POSES):
        pose = place(rng)
        for _ in range(_SEEDS):
            seed = READY + rng.uniform(-1.0, 1.0, len(READY))
            q = arm.reach(pose, np.clip(seed, arm.lower + 0.05, arm.upper - 0.05))
            if q is not None and not judge.collides(q):
                return q
    return None
