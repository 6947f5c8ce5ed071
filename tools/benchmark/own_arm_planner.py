"""This project's planner as a contestant: the path planner of the product on its Panda model."""

from __future__ import annotations

import importlib.metadata
import time
from dataclasses import replace

import numpy as np

from executive.config import APPLICATION
from kinematics.collision.validity import validity
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.planning.path_planner import PathPlanner, PathSettings
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import FreeCoordinates
from robots.models.description import load_description
from tools.benchmark.contest import Answer
from tools.benchmark.problems.problem import Problem

# Points of the smooth curve that stand for it when it is judged and measured.
_SAMPLES = 400
# More than the product's default: a contest is lost by giving up early.
_SETTINGS = PathSettings(iterations=20_000)


def panda_on_floor() -> RobotModel:
    """The Panda as its peers have it: bolted to the floor at the origin."""
    return RobotModel(replace(load_description("panda"), mount_xyz_m=(0.0, 0.0, 0.0)))


class OwnArmPlanner:
    """Straight line, else RRT-Connect, shortcuts and rounded corners, with the product's settings."""

    def __init__(self) -> None:
        self.name = f"{APPLICATION} {importlib.metadata.version(APPLICATION)}"
        self._model = panda_on_floor()
        self._robot = StandingRobot(self._model, Stance(()))
        self._space = FreeCoordinates(self._robot)

    def plan(self, problem: Problem, seed: int) -> Answer:
        """Plan; the product's planner shortens as it goes, so that all counts as planning."""
        began_s = time.process_time()
        scene = PlanningScene().with_objects(problem.objects)
        judge = validity(self._robot, scene)
        planner = PathPlanner(self._model, self._space, judge, _SETTINGS)
        set_up_s = time.process_time()
        columns = list(range(self._space.size))
        curve = planner.plan(problem.start, problem.goal, columns, np.random.default_rng(seed))
        ended_s = time.process_time()
        return Answer(
            path=None if curve is None else curve(np.linspace(0.0, 1.0, _SAMPLES)),
            set_up_s=set_up_s - began_s,
            plan_s=ended_s - set_up_s,
            shorten_s=0.0,
        )
