"""Draws what a camera would see without errors: exact depth, and colours in the scene's light."""

from __future__ import annotations

import mujoco
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry.poses import Transform
from robots.interface.depth_camera import DepthCamera
from robots.interface.hardware import RobotData
from robots.scenes.scene_description import SceneDescription
from robots.simulated.body.body_model import robot_spec
from robots.simulated.body.geom_roles import DRAWN_GROUP, FINGER_DRAWN_GROUP, WORLD_GROUP
from robots.simulated.body.person_model import draw_forearms
from robots.simulated.body.scene_model import add_scene
from robots.simulated.camera.looks import add_looks, hide
from robots.simulated.camera.orders import WorldState
from robots.simulated.camera.person_looks import add_person_looks, keeps_forearm
from robots.simulated.camera.picture_looks import add_picture
from robots.simulated.frugal_memory import give_back, let_go_of_compilers
from robots.simulated.pictures.opengl import make_context

NEAR_M, FAR_M = 0.05, 40.0
_SKY_M = 20.0
"""What is drawn farther away than this is the sky."""
_SIDE_LIGHT = (0.15, 0.15, 0.15), (0.75, 0.75, 0.75), (0.15, 0.85, -0.5)
"""Ambient and diffuse light of a lamp at one side, and its direction in the world."""


class Studio:
    """One world to be drawn, and the OpenGL context to draw it with.

    Args:
        robot, scene: What is drawn.
        size: Of the largest picture, px: width and height.

    Raises:
        RenderingUnavailableError: No OpenGL library works here.
    """

    def __init__(self, robot: RobotData, scene: SceneDescription, size: tuple[int, int]) -> None:
        spec = robot_spec(robot, collides=False)
        add_scene(spec, scene, robot.description)
        hidden = {item.name for item in scene.objects if add_looks(spec, item)}
        for item in scene.objects:
            add_picture(spec, item)
        for person in scene.people:
            hidden |= add_person_looks(spec, person)
        spec.visual.global_.offwidth, spec.visual.global_.offheight = size
        spec.visual.quality.offsamples = 0
        self._people = tuple(filter(keeps_forearm, scene.people))
        self._context = make_context(*size)
        self._model = spec.compile()
        del spec
        give_back()
        hide(self._model, hidden)
        self._data, self._body = mujoco.MjData(self._model), mujoco.MjData(self._model)
        self._actuated = [int(self._model.joint(name).qposadr[0]) for name in robot.description.actuated]
        self._scene = mujoco.MjvScene(self._model, maxgeom=2000)
        self._drawing = mujoco.MjrContext(self._model, int(mujoco.mjtFontScale.mjFONTSCALE_100))
        mujoco.mjr_setBuffer(int(mujoco.mjtFramebuffer.mjFB_OFFSCREEN), self._drawing)
        self._all, self._self = mujoco.MjvOption(), mujoco.MjvOption()
        for option, groups in (
            (self._all, [WORLD_GROUP, FINGER_DRAWN_GROUP, DRAWN_GROUP]),
            (self._self, [FINGER_DRAWN_GROUP, DRAWN_GROUP]),
        ):
            option.geomgroup[:] = 0
            option.geomgroup[groups] = 1
        self._usual_light, self._has_shaders = self._light(), False

    @property
    def model(self) -> mujoco.MjModel:
        """What is drawn."""
        return self._model

    def place(self, state: WorldState) -> None:
        """Put everything where it is."""
        self._data.qpos[:] = state.qpos
        self._data.mocap_pos[:], self._data.mocap_quat[:] = state.mocap_pos, state.mocap_quat
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_camlight(self._model, self._data)

    def frame_pose(self, frame: str) -> Transform:
        """``world_T_frame`` of a frame of the robot."""
        body = self._data.body(frame)
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = body.xmat.reshape(3, 3), body.xpos
        return pose

    def draw(
        self, camera: DepthCamera, world_T_camera: Transform, from_the_side: bool
    ) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
        """Colours, shape (height, width, 3), and depth along the axis, m, 0 where nothing is in reach."""
        self._set_light(from_the_side)
        return self._draw(self._data, self._all, camera, world_T_camera)

    def draw_body(
        self, camera: DepthCamera, joints: Array, world_T_camera: Transform | None = None
    ) -> NDArray[np.float32]:
        """Depth of the robot alone, as its encoders have it; 0 where it is not.

        Args:
            camera: Who looks.
            joints: In the order of ``RobotDescription.actuated``.
            world_T_camera: Where a camera is that does not move with the robot.
        """
        data = self._body
        data.qpos[:] = self._data.qpos
        data.qpos[self._actuated] = joints
        mujoco.mj_kinematics(self._model, data)
        if world_T_camera is None:
            frame = data.body(camera.frame)
            world_T_camera = np.eye(4)
            world_T_camera[:3, :3], world_T_camera[:3, 3] = frame.xmat.reshape(3, 3), frame.xpos
        return self._draw(data, self._self, camera, world_T_camera)[1]

    def geoms_in_view(self, camera: DepthCamera, world_T_camera: Transform) -> NDArray[np.int32]:
        """Which geom each pixel shows, -1 where none; for who judges perception."""
        flags = self._scene.flags
        self._update(self._data, self._all, camera, world_T_camera)
        flags[mujoco.mjtRndFlag.mjRND_SEGMENT] = flags[mujoco.mjtRndFlag.mjRND_IDCOLOR] = True
        color, _ = self._read(camera)
        flags[mujoco.mjtRndFlag.mjRND_SEGMENT] = flags[mujoco.mjtRndFlag.mjRND_IDCOLOR] = False
        told = color.astype(np.int32) @ np.array([1, 256, 65536], dtype=np.int32)
        geoms = np.full(self._scene.ngeom + 1, -1, dtype=np.int32)
        for item in self._scene.geoms[: self._scene.ngeom]:
            if item.objtype == mujoco.mjtObj.mjOBJ_GEOM and item.segid >= 0:
                geoms[item.segid + 1] = item.objid
        return np.asarray(geoms[np.clip(told, 0, len(geoms) - 1)])

    def close(self) -> None:
        """Give the OpenGL context back."""
        self._context.make_current()
        self._drawing.free()
        self._context.free()

    def _draw(
        self,
        data: mujoco.MjData,
        option: mujoco.MjvOption,
        camera: DepthCamera,
        world_T_camera: Transform,
    ) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
        self._update(data, option, camera, world_T_camera)
        return self._read(camera)

    def _update(
        self,
        data: mujoco.MjData,
        option: mujoco.MjvOption,
        camera: DepthCamera,
        world_T_camera: Transform,
    ) -> None:
        self._context.make_current()
        free = mujoco.MjvCamera()
        category = int(mujoco.mjtCatBit.mjCAT_ALL)
        mujoco.mjv_updateScene(self._model, data, option, None, free, category, self._scene)
        if option is self._all:
            draw_forearms(self._scene, self._model, data, self._people)
        flags = self._scene.flags
        flags[mujoco.mjtRndFlag.mjRND_SHADOW] = flags[mujoco.mjtRndFlag.mjRND_REFLECTION] = False
        across = 0.5 * camera.width_px / camera.focal_px * NEAR_M
        up = 0.5 * camera.height_px / camera.focal_px * NEAR_M
        for view in self._scene.camera:
            view.pos, view.forward = world_T_camera[:3, 3], world_T_camera[:3, 2]
            view.up = -world_T_camera[:3, 1]
            view.frustum_near, view.frustum_far = NEAR_M, FAR_M
            view.frustum_center, view.frustum_width = 0.0, across
            view.frustum_bottom, view.frustum_top = -up, up

    def _read(self, camera: DepthCamera) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
        color = np.zeros((camera.height_px, camera.width_px, 3), dtype=np.uint8)
        raw = np.zeros((camera.height_px, camera.width_px), dtype=np.float32)
        room = mujoco.MjrRect(0, 0, camera.width_px, camera.height_px)
        mujoco.mjr_render(room, self._scene, self._drawing)
        mujoco.mjr_readPixels(color, raw, room, self._drawing)
        if not self._has_shaders:
            let_go_of_compilers()
            self._has_shaders = True
        depth = NEAR_M * FAR_M / (FAR_M - raw * (FAR_M - NEAR_M))
        depth[depth > _SKY_M] = 0.0
        return np.ascontiguousarray(color[::-1]), np.ascontiguousarray(depth[::-1])

    def _light(self) -> tuple[Array, Array, Array, Array]:
        model = self._model
        head = model.vis.headlight
        return (
            np.array(model.light_diffuse),
            np.array(model.light_dir),
            np.array(head.ambient),
            np.array(head.diffuse),
        )

    def _set_light(self, from_the_side: bool) -> None:
        model, head = self._model, self._model.vis.headlight
        diffuse, direction, ambient, headlight = self._usual_light
        model.light_diffuse[:], model.light_dir[:] = diffuse, direction
        head.ambient[:], head.diffuse[:] = ambient, headlight
        if from_the_side:
            head.ambient[:], head.diffuse[:] = _SIDE_LIGHT[0], 0.0
            model.light_diffuse[:] = 0.0
            model.light_diffuse[0] = _SIDE_LIGHT[1]
            model.light_dir[0] = np.array(_SIDE_LIGHT[2]) / np.linalg.norm(_SIDE_LIGHT[2])
        mujoco.mj_camlight(model, self._data)
