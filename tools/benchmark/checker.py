"""The trajectory checker: what judging a motion of five seconds costs, amid things on a table."""

from __future__ import annotations

import functools
from collections.abc import Iterator

import numpy as np

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.motion.sampler import TrajectorySampler
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.motion_planner import MotionPlanner
from kinematics.requests.move import MovePlan, MoveRequest
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description
from tools.benchmark.figures import Figure, figure, timed_s

DURATION_S = 5.0
SAMPLES = 1000
_TABLE_M = 0.9


def checker(quick: bool) -> list[Figure]:
    """Each motion judged with the others in turn; the peer is forward kinematics alone of its samples."""
    model = RobotModel(load_description("talos"))
    judge = TrajectoryChecker(model)
    motions = list(_motions(model, 6 if quick else 60))
    whole: list[float] = []
    walk: list[float] = []
    accepted = 0
    judge.check(*motions[0])
    for trajectory, scene in motions:
        accepted += isinstance(judge.check(trajectory, scene), CheckedTrajectory)
        whole.append(1e3 * timed_s(functools.partial(judge.check, trajectory, scene)))
        walk.append(1e3 * timed_s(functools.partial(_centres_of_mass, model, trajectory)))
    peer = "CoM of each sample by Pinocchio, one by one"
    share = [100.0 * accepted / len(motions)]
    return [
        figure("motion of 5 s with 1,000 samples, ms", whole, peer, walk),
        figure("motions found safe, %", share),
    ]


def _centres_of_mass(model: RobotModel, trajectory: Trajectory) -> None:
    for q in trajectory.q:
        model.com(q)


def _motions(model: RobotModel, count: int) -> Iterator[tuple[Trajectory, PlanningScene]]:
    """Planned motions of both arms beside a table with things on it, stretched to five seconds."""
    planner = MotionPlanner(model)
    stance = stance_at(model, model.q_home)
    arms = [j for hand in ("left", "right") for j in model.description.groups[f"{hand}_arm"]]
    columns = model.indices(arms)
    made, seed = 0, 0
    while made < count:
        rng = np.random.default_rng([5, seed])
        seed += 1
        scene = _table_with_things(rng)
        goal = model.q_home[7 + columns] + rng.uniform(-0.8, 0.8, len(arms))
        goal = np.clip(goal, model.lower_rad[columns] + 0.05, model.upper_rad[columns] - 0.05)
        joints = dict(zip(arms, goal.tolist(), strict=True))
        plan = planner.answer(MoveRequest(model.q_home, stance, scene, joints, seed=seed))
        if isinstance(plan, MovePlan):
            made += 1
            yield _stretched(plan.step.trajectory), scene


def _table_with_things(rng: np.random.Generator) -> PlanningScene:
    table = Box((0.6, 1.2, 0.04))
    place = poses.translation(0.75, 0.0, _TABLE_M - 0.02)
    objects = [SceneObject("table", table, place, 0.01, movable=False)]
    for i in range(int(rng.integers(3, 13))):
        x, y = rng.uniform((0.5, -0.5), (0.95, 0.5)).tolist()
        height = float(rng.uniform(0.08, 0.2))
        shape = Cylinder(float(rng.uniform(0.02, 0.04)), height)
        objects.append(SceneObject(f"thing {i}", shape, poses.translation(x, y, _TABLE_M + height / 2), 0.01))
    return PlanningScene().with_objects(objects)


def _stretched(trajectory: Trajectory) -> Trajectory:
    """The same motion in five seconds, sampled anew."""
    rate = float(trajectory.t_s[-1]) / DURATION_S
    t_s = np.linspace(0.0, DURATION_S, SAMPLES)
    ones = np.ones(SAMPLES)
    sample = TrajectorySampler(trajectory).many(t_s * rate, rate * ones, 0.0 * ones)
    sample.v[0] = sample.v[-1] = 0.0
    return Trajectory(trajectory.joints, trajectory.stance, t_s, sample.q, sample.v)
