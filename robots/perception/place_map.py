"""What a robot knows of the rooms: a map, which it was put down on with a declared error."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from kinematics.geometry.planar import PlanarPose
from robots.scenes.scene_description import Region, SceneDescription

START_M = 0.05
START_RAD = 0.01
"""Standard deviations of where the robot believes it stands on its map at first: each axis, and heading."""


def place_map(scene: SceneDescription, rng: np.random.Generator) -> Mapping[str, Region]:
    """The named regions of a scene in the odometry frame, as the robot believes them to be.

    Args:
        scene: Where they really are.
        rng: The error is drawn from it, once for all of them.
    """
    start = scene.robot_start
    world_T_odom = PlanarPose(start.x_m, start.y_m, start.yaw_rad)
    dx, dy, turn = (float(value) for value in rng.normal(0.0, (START_M, START_M, START_RAD)))
    odom_T_world = PlanarPose(dx, dy, turn) @ world_T_odom.inverse()
    known = {}
    for region in scene.places:
        pose = odom_T_world @ PlanarPose(*region.position_m, region.yaw_rad)
        known[region.name] = Region(region.name, (pose.x_m, pose.y_m), region.size_m, pose.yaw_rad)
    return MappingProxyType(known)
