"""What a robot knows of the furniture beforehand: a map, with the error of where it believes it stands."""

from __future__ import annotations

import numpy as np

from kinematics.geometry.planar import PlanarPose
from robots.perception.place_map import START_M, START_RAD
from robots.scenes.scene_description import Furniture, MovingPart, SceneDescription

PIECE_M, PIECE_RAD = 0.01, 0.01
"""Standard deviations of where each piece stands on the map, beside the error that all have in common."""
SIZE_M = 0.003


def furniture_map(scene: SceneDescription, rng: np.random.Generator) -> tuple[Furniture, ...]:
    """The furniture of a scene in the odometry frame, as the robot believes it to be.

    Args:
        scene: Where it really is.
        rng: The errors are drawn from it.
    """
    start = scene.robot_start
    world_T_odom = PlanarPose(start.x_m, start.y_m, start.yaw_rad)
    dx, dy, turn = (float(value) for value in rng.normal(0.0, (START_M, START_M, START_RAD)))
    odom_T_world = PlanarPose(dx, dy, turn) @ world_T_odom.inverse()
    return tuple(_believed(piece, odom_T_world, rng) for piece in scene.furniture)


def _believed(piece: Furniture, odom_T_world: PlanarPose, rng: np.random.Generator) -> Furniture:
    x, y, turn = rng.normal(0.0, (PIECE_M, PIECE_M, PIECE_RAD)).tolist()
    depth, width, height = (np.array(piece.size_m) + rng.normal(0.0, SIZE_M, 3)).tolist()
    pose = odom_T_world @ PlanarPose(*piece.position_m, piece.yaw_rad)
    return Furniture(
        name=piece.name,
        kind=piece.kind,
        size_m=(depth, width, height),
        position_m=(pose.x_m + x, pose.y_m + y),
        yaw_rad=pose.yaw_rad + turn,
        friction=piece.friction,
        opens=None if piece.opens is None else _known_of(piece.opens),
        names=piece.names,
        categories=piece.categories,
    )


def _known_of(part: MovingPart) -> MovingPart:
    """What a map says of a door or drawer: on which side it hangs. All else of it is to be seen."""
    return MovingPart(hinge=part.hinge, mass_kg=part.mass_kg, friction=part.friction)
