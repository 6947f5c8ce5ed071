"""Where the camera looks, and what it could see from there."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, Sealed, sealed
from kinematics.geometry.poses import Transform
from kinematics.model.camera_description import CameraDescription
from kinematics.model.robot_model import RobotModel


def off_axis_rad(odom_T_camera: Transform, point: Array) -> tuple[float, float]:
    """Angles of a point, shape (3,), to the right of and below the optical axis."""
    x, y, z = _from_camera(odom_T_camera, point)
    return math.atan2(x, z), math.atan2(y, z)


def _from_camera(odom_T_camera: Transform, point: Array) -> list[float]:
    """A point in the camera's frame; in plain numbers: sums over arrays of three take ten times as long."""
    seen: list[float] = (point - odom_T_camera[:3, 3]).dot(odom_T_camera[:3, :3]).tolist()
    return seen


def in_view(camera: CameraDescription, odom_T_camera: Transform, point: Array) -> bool:
    """Whether a point lies in the camera's field of view and range."""
    x, y, z = _from_camera(odom_T_camera, point)
    return (
        abs(math.atan2(x, z)) <= 0.5 * camera.horizontal_fov_rad
        and abs(math.atan2(y, z)) <= 0.5 * camera.vertical_fov_rad
        and camera.range_m[0] <= math.hypot(x, y, z) <= camera.range_m[1]
    )


def middle_of_most(points: Array, eye: Array, within_rad: float) -> Array:
    """Where to look in order to see as many points as one picture can show.

    Args:
        points: What is to be seen, at least one, shape (n, 3).
        eye: Where the camera is, shape (3,), in the frame of the points.
        within_rad: Half the angle that a picture shows.

    Returns:
        The middle of the largest group about one of them, shape (3,). Two groups far apart have their
        common middle where there is nothing to be seen.
    """
    rays = points - eye
    rays = rays / np.linalg.norm(rays, axis=1, keepdims=True)
    together: NDArray[np.bool_] = rays @ rays.T >= math.cos(within_rad)
    middle: Array = points[together[int(together.sum(axis=1).argmax())]].mean(axis=0)
    return middle


def behind_a_hand(model: RobotModel, q: Array, eye: Array, point: Array, within_m: float) -> bool:
    """Whether the line of sight from ``eye`` to ``point`` passes a TCP nearer than ``within_m``."""
    frames = list(model.description.tcp_frames.values())
    return any(
        passes(eye, point, world_T_tcp[:3, 3], within_m) for world_T_tcp in model.frame_poses(q, frames)
    )


@dataclass(frozen=True, slots=True, eq=False)
class Glimpse(Sealed):
    """One look: where the camera was, and which parts of the robot itself may have hidden something.

    Attributes:
        odom_T_camera: Pose of the camera, shape (4, 4).
        in_the_way: Middles of hands, forearms and what is held, odometry frame, shape (3,) each.
    """

    odom_T_camera: Transform
    in_the_way: tuple[Array, ...]
    _parts: list[list[float]] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        """Note where the parts are from the eye: a glimpse is asked about many points."""
        Sealed.__post_init__(self)
        object.__setattr__(self, "in_the_way", tuple(sealed(part, "in_the_way") for part in self.in_the_way))
        eye = self.odom_T_camera[:3, 3]
        object.__setattr__(self, "_parts", [(part - eye).tolist() for part in self.in_the_way])

    def shows(self, camera: CameraDescription, point: Array, within_m: float) -> bool:
        """Whether something at a point, shape (3,), would have been seen.

        Args:
            camera: Field of view and range.
            point: Odometry frame.
            within_m: A line of sight that passes a part of the robot nearer than this may be blocked.
        """
        if not in_view(camera, self.odom_T_camera, point):
            return False
        if not self.in_the_way:
            return True
        ray = (point - self.odom_T_camera[:3, 3]).tolist()
        return not any(_passes(ray, part, within_m) for part in self._parts)


def passes(eye: Array, point: Array, part: Array, within_m: float) -> bool:
    """Whether the line of sight from ``eye`` to ``point`` passes something nearer than that."""
    return _passes((point - eye).tolist(), (part - eye).tolist(), within_m)


def _passes(ray: list[float], part: list[float], within_m: float) -> bool:
    """The same in plain numbers, both as seen from the eye."""
    x, y, z = ray
    u, v, w = part
    along = min(max((u * x + v * y + w * z) / (x * x + y * y + z * z), 0.0), 1.0)
    return math.hypot(along * x - u, along * y - v, along * z - w) < within_m
