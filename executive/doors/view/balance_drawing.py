"""How the robot keeps its balance and where it looks, in the page.

The area that the feet span, the centre of mass above the floor, the point where the ground carries the robot
(ZMP), and the view of its camera.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import viser
from numpy.typing import NDArray

from executive.doors.view.robot_drawing import RobotDrawing
from kinematics.errors import KinematicsError
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.support_polygon import SupportPolygon
from robots.live.documents.robot_report import RobotReport

_FELT_N = 20.0
"""A foot that feels less force carries nothing."""
_ABOVE_M = 0.004
_COM, _ZMP, _POLYGON = (48, 96, 208), (208, 80, 32), (40, 140, 90)
_VIEW_M = 0.5
_PICTURE_EVERY = 4
"""Pixels of a picture of which one is shown, along each side."""

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Balance:
    """What is known of the balance at one moment, in the odometry frame.

    Attributes:
        polygon: Corners of the support polygon, shape (n, 2); (0, 2) where nothing can tip.
        com: Centre of mass, shape (3,).
        zmp: Where the ground's force acts on the floor, shape (2,); None where no foot feels any.
    """

    polygon: Floats
    com: Floats
    zmp: Floats | None


def balance_of(model: RobotModel, report: RobotReport) -> Balance:
    """How a robot stands by what it knows of itself.

    The ZMP is that of the forces and torques at the soles, taken on the floor below them (M. Vukobratovic,
    1972).
    """
    soles = model.description.soles
    stance, carrying = report.stance, soles
    if report.walking:  # the stance is where it stood before, and feet swing
        felt = report.sensed.readings.foot_wrench[:, 2]
        carrying = tuple(sole for sole, fz in zip(soles, felt, strict=True) if fz >= _FELT_N)
        stance = Stance(tuple((one.frame, model.frame_pose(report.sensed.q, one.frame)) for one in carrying))
    try:
        polygon = SupportPolygon(stance, carrying).vertices_m
    except KinematicsError:
        polygon = np.zeros((0, 2))
    poses = dict(stance.soles)
    pressed, total_n = np.zeros(2), 0.0
    for sole, (_, _, fz, tx, ty, _) in zip(soles, report.sensed.readings.foot_wrench.tolist(), strict=True):
        if fz < _FELT_N or sole.frame not in poses:
            continue
        place = poses[sole.frame] @ np.array([-ty / fz, tx / fz, 0.0, 1.0])
        pressed, total_n = pressed + fz * place[:2], total_n + fz
    zmp = pressed / total_n if total_n > 0.0 else None
    return Balance(polygon, model.com(report.sensed.q), zmp)


class BalanceDrawing:
    """Draws balance and view.

    Args:
        scene: Of the page.
        model: The robot.
        robot: Its drawing, which carries the camera's.
    """

    def __init__(self, scene: viser.SceneApi, model: RobotModel, robot: RobotDrawing) -> None:
        self._scene, self._model = scene, model
        self._corners = np.zeros((0, 2))
        self._polygon: viser.LineSegmentsHandle | None = None
        self._com = scene.add_icosphere("/balance/com", 0.018, _COM, subdivisions=2, cast_shadow=False)
        self._zmp = scene.add_icosphere("/balance/zmp", 0.018, _ZMP, subdivisions=2, cast_shadow=False)
        self._view: viser.CameraFrustumHandle | None = None
        camera = model.description.head_camera
        if camera is not None:
            vertical, horizontal = camera.vertical_fov_rad, camera.horizontal_fov_rad
            self._view = scene.add_camera_frustum(
                f"{robot.path_of(camera.frame)}/view",
                vertical,
                math.tan(0.5 * horizontal) / math.tan(0.5 * vertical),
                scale=_VIEW_M,
                thickness=0.004,
                color=(220, 160, 40),
            )

    def look(self, color: NDArray[np.uint8] | None) -> None:
        """Show a picture of the camera in its view, shape (height, width, 3), or none."""
        if self._view is not None:
            self._view.image = None if color is None else color[::_PICTURE_EVERY, ::_PICTURE_EVERY]

    def show(self, balance: Balance) -> None:
        """Draw it as it is now."""
        self._com.position = (float(balance.com[0]), float(balance.com[1]), _ABOVE_M)
        self._zmp.visible = balance.zmp is not None
        if balance.zmp is not None:
            self._zmp.position = (float(balance.zmp[0]), float(balance.zmp[1]), _ABOVE_M)
        corners = balance.polygon
        if corners.shape == self._corners.shape and np.allclose(corners, self._corners, atol=5e-4):
            return
        self._corners = corners
        if self._polygon is not None:
            self._polygon.remove()
            self._polygon = None
        if len(corners):
            ring = np.column_stack([corners, np.full(len(corners), _ABOVE_M)])
            edges = np.stack([ring, np.roll(ring, -1, axis=0)], axis=1)
            self._polygon = self._scene.add_line_segments(
                "/balance/polygon", edges, _POLYGON, thickness=0.008
            )
