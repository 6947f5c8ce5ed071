"""How well a standing robot's hands reach what is around it: the map for choosing places to stand.

    python -m tools.robot_data.reachability_map talos > robots/models/talos/reachability.toml

At each place of a grid around a robot that stands at home, each hand is brought to poses from the side,
slanting and from above, turned by up to 60 degrees out of the direction in which its shoulder sees the place,
with whole-body inverse kinematics, straight in from 10 cm before them: feet fixed, limits and balance kept
with the planner's reserves, no link nearer to another one than planning allows. What is around the robot is
not in the map: the planner knows it.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Sequence

import numpy as np

from kinematics.collision.validity import validity
from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.poses import Transform
from kinematics.ik.arm_frames import link_moved_by
from kinematics.ik.result import DEFAULT_TOLERANCE
from kinematics.ik.solver import along_line, inverse_kinematics
from kinematics.model.reachability import Cells, GridAxis, ReachabilityMap
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.planning.path_planner import PathPlanner
from kinematics.planning.pick_task import APPROACH_M
from kinematics.planning.planning_task import CARTESIAN_POINTS
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import free_coordinates
from robots.models.description import load_description
from robots.models.reachability_file import reachability_text

AHEAD = GridAxis(0.2, 0.1, 9)
ASIDE = GridAxis(-0.9, 0.1, 19)
HEIGHT = GridAxis(0.3, 0.1, 11)
TURNED_RAD = tuple(math.radians(angle) for angle in (0.0, -30.0, 30.0, -60.0, 60.0))
TILTED_RAD = tuple(math.radians(angle) for angle in (0.0, 40.0, 80.0))
"""From the side, slanting, from above."""
_ROLLED = (np.eye(3), np.diag([1.0, -1.0, -1.0]))
"""Both ways in which two fingers take hold."""
_SELF_M = 0.005


class HandSampler:
    """Tries one hand of a robot that stands at home, its feet on both sides of the origin."""

    def __init__(self, model: RobotModel, hand: Hand) -> None:
        """Put the robot where the map is seen from.

        Raises:
            MissingPartError: The robot has no such hand.
        """
        at_home = stance_at(model, model.q_home)
        soles = [PlanarPose.of(sole) for _, sole in at_home.soles]
        to_origin = PlanarPose.between(soles[0], soles[-1]).inverse().transform()
        stance = type(at_home)(tuple((name, to_origin @ sole) for name, sole in at_home.soles))
        robot = StandingRobot(model, stance)
        self._seed = robot.q_home
        self._ik = inverse_kinematics(robot, hand)
        self._space = free_coordinates(robot)
        self._judge = PathPlanner(model, self._space, validity(robot, PlanningScene(), 0.0, _SELF_M))
        shoulder = link_moved_by(model, model.description.groups[f"{hand}_arm"][1])
        self._shoulder_m = model.frame_pose(self._seed, shoulder)[:3, 3]

    def share(self, x_m: float, y_m: float, z_m: float) -> float:
        """Of the directions of a place, the share that the hand gets to."""
        place = np.array([x_m, y_m, z_m])
        seen = place - self._shoulder_m
        natural_rad = math.atan2(seen[1], seen[0])
        reached = [
            any(self._reaches(target) for target in _both_ways(place, natural_rad + turned, tilted))
            for turned in TURNED_RAD
            for tilted in TILTED_RAD
        ]
        return sum(reached) / len(reached)

    def _reaches(self, world_T_tcp: Transform) -> bool:
        found = self._ik.solve(world_T_tcp, self._seed)
        if not found.within(DEFAULT_TOLERANCE) or not self._judge.is_free(self._space.from_q(found.q)):
            return False
        before = world_T_tcp @ poses.translation(-APPROACH_M, 0.0, 0.0)
        line = along_line(self._ik, found.q, world_T_tcp, before, CARTESIAN_POINTS)
        return line is not None and self._judge.is_free(self._space.from_q(line[-1]))


def _both_ways(place: Sequence[float] | np.ndarray, yaw_rad: float, tilt_rad: float) -> list[Transform]:
    """Poses of the TCP, x along the approach; tilted, it comes from above."""
    facing = poses.rotation_z(yaw_rad) @ poses.rotation_y(tilt_rad)
    return [poses.transform(facing @ rolled, place) for rolled in _ROLLED]


def reachability_of(
    model: RobotModel, ahead: GridAxis = AHEAD, aside: GridAxis = ASIDE, height: GridAxis = HEIGHT
) -> ReachabilityMap:
    """The map of a robot, place by place.

    Args:
        model: The robot; all its hands are looked at.
        ahead, aside, height: The grid.
    """
    shares: dict[str, Cells] = {}
    for hand in model.description.hands:
        sampler = HandSampler(model, hand)
        layers = []
        for z_m in height.values_m():
            rows = (
                tuple(sampler.share(x_m, y_m, z_m) for y_m in aside.values_m()) for x_m in ahead.values_m()
            )
            layers.append(tuple(rows))
            print(f"{hand} hand, {z_m:.2f} m", file=sys.stderr)
        shares[hand] = tuple(layers)
    return ReachabilityMap(ahead, aside, height, shares)


def main() -> None:
    """Print a robot's map."""
    parser = argparse.ArgumentParser(
        prog="tools.robot_data.reachability_map", description=__doc__.split("\n")[0]
    )
    parser.add_argument("robot")
    chosen = parser.parse_args()
    found = reachability_of(RobotModel(load_description(chosen.robot)))
    print(
        reachability_text(found, chosen.robot, f"python -m tools.robot_data.reachability_map {chosen.robot}"),
        end="",
    )


if __name__ == "__main__":
    main()
