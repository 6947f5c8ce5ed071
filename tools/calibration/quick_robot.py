"""A robot that is at once where its checked trajectories end, before the camera of a real simulated scene.

Planning, looking, the world model and the telling are the product's; only time and physics are left out,
so that hundreds of answers can be had in minutes.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from executive.session.planning_jobs import PlanningJobs
from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.motion_planner import MotionPlanner
from kinematics.requests.check import CheckRequest
from robots.control.guarded.guarded_motion import GuardedMotion
from robots.control.motion_handle import MotionHandle, MotionStatus
from robots.fake.fake_motion import FakeMotion
from robots.fake.fake_world import FakeWorld
from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.perception.stub import PerceptionStub
from robots.perception.told_labels import told_fronts
from robots.scenes.scene_description import SceneDescription
from robots.seeded import Seeded
from robots.simulated.world import SimulatedWorld, build_world
from trees.build import build_tree
from trees.task_tree import TaskTree
from trees.tasks import Task
from trees.toolbox import Toolbox
from trees.world_model import WorldModel

_PERIOD_S = 0.02
_LONGEST = 5000


class QuickMotion(FakeMotion):
    """Every checked trajectory is at its end after one period."""

    def start(self, motion: CheckedTrajectory | GuardedMotion) -> MotionHandle:
        """Jump to the end.

        Raises:
            TypeError: It is a guarded motion.
        """
        handle = super().start(motion)
        if handle.status is MotionStatus.RUNNING and isinstance(motion, CheckedTrajectory):
            self._q = np.array(motion.trajectory.q[-1])
            handle.status = MotionStatus.DONE
            self._active = None
        return handle


class QuickRobot:
    """One robot in one scene.

    Attributes:
        world: The simulator, for the truth.
    """

    def __init__(self, model: RobotModel, scene: SceneDescription, seed: int) -> None:
        chance = Seeded.by(seed)
        hardware = load_robot(model.description.name).hardware
        self.world: SimulatedWorld = build_world(RobotData(model.description, hardware), scene, chance.world)
        checker = TrajectoryChecker(model)
        fake = FakeWorld(model, hardware, partial(_checked, checker), (), _PERIOD_S)
        fake.motion = QuickMotion(model, fake.clock)
        self._fake = fake
        camera = model.description.camera
        self._eyes = PerceptionStub(
            self.world.truth,
            camera,
            scene.perception,
            fake.clock,
            chance.perception,
            told_fronts(scene.furniture),
        )
        self.toolbox = Toolbox(
            clock=fake.clock,
            model=model,
            motion=fake.motion,
            sensing=fake.sensing,
            grippers=fake.grippers,
            detector=self._eyes,
            planning=PlanningJobs(MotionPlanner(model), checker, fake.clock, lambda _event: None),
            world=WorldModel(),
            events=lambda _event: None,
            rng=chance.trees,
        )

    def do(self, task: Task) -> TaskTree:
        """Carry a task out, and return its tree at its end.

        Raises:
            RuntimeError: It never ended.
        """
        tree = build_tree(task, self.toolbox)
        for _ in range(_LONGEST):
            tree.tick()
            if tree.status != "running":
                return tree
            self._fake.step()
            self._follow()
            self._eyes.tick()
        raise RuntimeError(f"{task.action} never ended")

    def _follow(self) -> None:
        """Put the simulated body where the quick one is."""
        physics = self.world.physics
        physics.data.qpos[physics.joint_qpos] = self._fake.robot.read().q
        physics.refresh_after_change()


def _checked(checker: TrajectoryChecker, question: CheckRequest) -> CheckedTrajectory | Unsafe:
    return checker.check(question.trajectory, question.scene, question.concessions)
