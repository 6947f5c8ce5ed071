"""A robot that stands before a table with its camera, and the cameras of the room: who takes the pictures."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from robots.interface.hardware import RobotData
from robots.perception.rgbd.picture import Picture
from robots.scenes.scene_description import SceneDescription
from robots.simulated.body.geom_roles import in_simulator
from robots.simulated.body.physics import Physics
from robots.simulated.camera.lens import Lens
from robots.simulated.camera.orders import LensFaults, WorldState
from robots.simulated.camera.studio import Studio
from tools.evaluate.perception.scenes import Look

_OWN_PX = 13
_OWN_M = 0.03


class Stand:
    """One look of a robot, ready to take the pictures of it.

    Attributes:
        owner: The object that each geom belongs to.
    """

    def __init__(self, robot: RobotData, what: Look, seed: int) -> None:
        """Put the robot before its table, with head and trunk as the look says."""
        description = robot.description
        aimed = description.camera.aimed(what.pan_rad, what.tilt_rad, what.lean_rad)
        home = {**description.home, **aimed}
        robot = replace(robot, description=replace(description, home=home))
        self._own, self._scene, self._seed = robot.hardware.cameras[0], what.scene, seed
        lenses = [self._own, *(camera.lens for camera in what.scene.cameras)]
        size = max(one.width_px for one in lenses), max(one.height_px for one in lenses)
        self._physics = Physics(robot, what.scene, drawn=False)
        self._studio = Studio(robot, what.scene, size)
        data, model = self._physics.data, self._studio.model
        self._studio.place(WorldState(data.qpos, data.mocap_pos, data.mocap_quat))
        self.owner = {
            geom: item.name
            for item in what.scene.objects
            for body_id in (model.body(in_simulator(item.name)).id,)
            for geom in range(model.ngeom)
            if int(model.geom_bodyid[geom]) == body_id
        }

    def taken(self, number: int = 0) -> tuple[Picture, NDArray[np.int32], Transform]:
        """The picture of one camera, the geom that each pixel shows, and where the camera is believed to be.

        Args:
            number: 0 is the robot's own, the others are the scene's, in their order from 1.
        """
        studio, light = self._studio, self._scene.light.kind
        if number == 0:
            camera, place = self._own, None
            told = studio.frame_pose(camera.frame)
        else:
            fixed = self._scene.cameras[number - 1]
            camera, told = fixed.lens, fixed.world_T_camera
            place = told
        lens = Lens(camera, (self._seed, number))
        real = told @ lens.place_error(LensFaults())
        exact = studio.draw(camera, real, light == "side")
        color, depth = lens.spoil(*exact, light, 0, LensFaults())
        ids = studio.geoms_in_view(camera, real)
        body = studio.draw_body(camera, np.array(self._physics.data.qpos[self._physics.joint_qpos]), place)
        own = ((body > 0.0) & ((depth > body - _OWN_M) | (depth <= 0.0))).astype(np.uint8)
        widened = cv2.dilate(own, np.ones((_OWN_PX, _OWN_PX), np.uint8)) > 0
        odom_T_camera = poses.inverse(world_T_odom(self._scene)) @ told
        return Picture(camera, color, depth, widened, odom_T_camera, 0.0), ids, told

    def close(self) -> None:
        """Give the OpenGL context back."""
        self._studio.close()


def world_T_odom(scene: SceneDescription) -> Transform:
    """Where the robot stands, which is the origin of what it knows."""
    start = scene.robot_start
    return poses.transform(poses.rotation_z(start.yaw_rad), (start.x_m, start.y_m, 0.0))
