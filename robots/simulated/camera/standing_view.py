"""Pictures of a scene in which nothing moves by itself, taken by a robot that stands at its start."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from kinematics.geometry import poses
from robots.interface.hardware import RobotData
from robots.perception.rgbd.picture import Picture
from robots.scenes.scene_description import SceneDescription
from robots.simulated.body.physics import Physics
from robots.simulated.camera.lens import Lens
from robots.simulated.camera.orders import LensFaults, WorldState
from robots.simulated.camera.studio import Studio

_OWN_M, _OWN_PX = 0.03, 13


@dataclass(frozen=True, slots=True)
class Gaze:
    """How a robot stands to look: head down and to its left, and trunk ahead, rad."""

    tilt_rad: float = 0.72
    pan_rad: float = 0.0
    lean_rad: float = 0.15


class StandingView:
    """What a robot's first camera shows of a scene, with the camera's errors.

    Args:
        robot: Who looks.
        scene: At what; the robot stands where the scene has it.
        gaze: Where to.
        seed: Of the camera's errors.

    Raises:
        RenderingUnavailableError: No OpenGL library works here.
    """

    def __init__(self, robot: RobotData, scene: SceneDescription, gaze: Gaze, seed: int) -> None:
        head, camera = robot.description.camera, robot.hardware.cameras[0]
        home = {**robot.description.home, **head.aimed(gaze.pan_rad, gaze.tilt_rad, gaze.lean_rad)}
        robot = replace(robot, description=replace(robot.description, home=home))
        self._physics, self._camera, self._scene = Physics(robot, scene, drawn=False), camera, scene
        self._studio = Studio(robot, scene, (camera.width_px, camera.height_px))
        self._lens, self._taken = Lens(camera, (seed, 0)), 0

    def picture(self) -> Picture:
        """Take the next picture."""
        physics, studio, camera = self._physics, self._studio, self._camera
        data, faults = physics.data, LensFaults()
        studio.place(WorldState(data.qpos, data.mocap_pos, data.mocap_quat))
        told, light = studio.frame_pose(camera.frame), self._scene.light.kind
        exact = studio.draw(camera, told @ self._lens.place_error(faults), light == "side")
        color, depth = self._lens.spoil(*exact, light, self._taken, faults)
        self._taken += 1
        body = studio.draw_body(camera, np.array(data.qpos[physics.joint_qpos]))
        own = ((body > 0.0) & ((depth > body - _OWN_M) | (depth <= 0.0))).astype(np.uint8)
        widened = cv2.dilate(own, np.ones((_OWN_PX, _OWN_PX), np.uint8)) > 0
        start = self._scene.robot_start
        world_T_odom = poses.transform(poses.rotation_z(start.yaw_rad), (start.x_m, start.y_m, 0.0))
        return Picture(camera, color, depth, widened, poses.inverse(world_T_odom) @ told, 0.0)

    def turn(self, name: str, yaw_rad: float) -> None:
        """Turn an object that stands, as a person does who shows it from all sides."""
        at = self._physics.object_qpos[name]
        x, y, z, w = poses.quaternion_from_rotation(poses.rotation_z(yaw_rad))
        self._physics.data.qpos[at + 3 : at + 7] = (w, x, y, z)

    def close(self) -> None:
        """Give the OpenGL context back."""
        self._studio.close()


def standing_picture(robot: RobotData, scene: SceneDescription, gaze: Gaze, seed: int) -> Picture:
    """One picture; see ``StandingView``."""
    view = StandingView(robot, scene, gaze, seed)
    try:
        return view.picture()
    finally:
        view.close()
