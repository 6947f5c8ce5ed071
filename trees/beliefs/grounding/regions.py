"""Regions of the map, as places to walk to."""

from __future__ import annotations

from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from robots.scenes.scene_description import Region
from trees.beliefs.grounding.destination import Place

START = "start"
"""What a task calls the place where the robot began."""
_HEIGHT_M = 2.0
_SPOT_M = 0.1


def place_of_region(name: str, region: Region) -> Place:
    """A region as a place, certain as the map is."""
    pose = PlanarPose(*region.position_m, region.yaw_rad).transform(0.5 * _HEIGHT_M)
    return Place(name, "region", Box((*region.size_m, _HEIGHT_M)), pose, 1.0)


def start() -> Place:
    """Where the robot began and how it stood there: the origin of its odometry."""
    return Place(
        START, "region", Box((_SPOT_M, _SPOT_M, _HEIGHT_M)), PlanarPose().transform(0.5 * _HEIGHT_M), 1.0
    )
