"""Whole-body reaches on TALOS: poses that a hand can reach with both feet standing, and the judge."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.collision_world import CollisionWorld
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.ik.result import IkTolerance
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.model.support_polygon import SupportPolygon
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.leg_ik import LegIk
from robots.models.description import load_description

HAND: Hand = "right"
# How far the pelvis may be from home: m along x, y, z, and rad about them.
_PELVIS = np.array([[-0.05, -0.05, -0.15, -0.05, -0.1, -0.1], [0.05, 0.05, 0.02, 0.05, 0.2, 0.1]])
# A pose counts as reachable when something reaches it with this to spare.
_COM_MARGIN_M = 0.035
# Starts beside the first: everybody may try again from the same ones.
_STARTS = 4


@dataclass(frozen=True, slots=True)
class Reach:
    """One pose to reach.

    Attributes:
        world_T_tcp: The pose, shape (4, 4); some whole-body configuration reaches it.
        starts: Configurations to start from, shape (n, nq), all with the feet at the stance.
    """

    world_T_tcp: Transform
    starts: Array


class ReachingBody:
    """TALOS on its two feet, reaching with one hand."""

    def __init__(self) -> None:
        self.model = RobotModel(load_description("talos"))
        self.stance = stance_at(self.model, self.model.q_home)
        self.tcp = self.model.description.grippers[HAND].tcp_frame
        self.polygon = SupportPolygon(self.stance, self.model.description.soles)
        margin = self.model.description.planning_margin_rad
        self.lower, self.upper = self.model.lower_rad + margin, self.model.upper_rad - margin
        self._legs = LegIk(StandingRobot(self.model, self.stance))
        self._alone = CollisionWorld(self.model, PlanningScene())

    def reaches(self, count: int, seed: int) -> Iterator[Reach]:
        """Draw reaches; the same arguments give the same ones."""
        for number in range(count):
            rng = np.random.default_rng([seed, number])
            goal = self._standing(rng, collision_free=True)
            starts = [self._standing(rng, collision_free=False) for _ in range(_STARTS)]
            yield Reach(self.model.frame_pose(goal, self.tcp), np.array(starts))

    def judge(self, reach: Reach, q: Array, tolerance: IkTolerance) -> bool:
        """Tell whether a configuration reaches: hand, both feet, balance and limits, by Pinocchio."""
        wanted = [(self.tcp, reach.world_T_tcp), *self.stance.soles]
        for frame, pose in wanted:
            found = self.model.frame_pose(q, frame)
            if np.linalg.norm(found[:3, 3] - pose[:3, 3]) > tolerance.position_m + 1e-9:
                return False
            if poses.angle_between(found[:3, :3], pose[:3, :3]) > tolerance.orientation_rad + 1e-7:
                return False
        inside = self.polygon.com_margin_m(self.model.com(q)) >= tolerance.com_margin_m - 1e-9
        return bool(inside and np.all(q[7:] >= self.lower - 1e-6) and np.all(q[7:] <= self.upper + 1e-6))

    def _standing(self, rng: np.random.Generator, collision_free: bool) -> Array:
        """A random configuration with the feet at the stance, balanced and within the limits."""
        groups = self.model.description.groups
        arm = self.model.group(f"{HAND}_arm")
        torso = self.model.indices(groups["torso"])
        while True:
            q = self.model.q_home.copy()
            shift = rng.uniform(*_PELVIS)
            q[:3] += shift[:3]
            turn = poses.rotation_from_vector(shift[3:]) @ poses.rotation_from_quaternion(q[3:7])
            q[3:7] = poses.quaternion_from_rotation(turn)
            q[7 + arm] = rng.uniform(self.lower[arm], self.upper[arm])
            q[7 + torso] = 0.5 * rng.uniform(self.lower[torso], self.upper[torso])
            reached = self._legs.fill(q[None, :])[0]
            joints = q[7:]
            if not reached or np.any(joints < self.lower + 0.02) or np.any(joints > self.upper - 0.02):
                continue
            if self.polygon.com_margin_m(self.model.com(q)) < _COM_MARGIN_M:
                continue
            if not collision_free or not self._alone.collides(q):
                return q
