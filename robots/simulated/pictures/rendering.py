"""Pictures and films of a simulated world."""

from __future__ import annotations

import math
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import TracebackType
from typing import Literal

import mujoco
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from kinematics.model.robot_description import Hand
from robots.errors import RenderingUnavailableError
from robots.simulated.body.geom_roles import DRAWN_GROUP, FINGER_DRAWN_GROUP, WORLD_GROUP
from robots.simulated.body.person_model import draw_forearms
from robots.simulated.pictures.opengl import make_context, require_opengl
from robots.simulated.pictures.plan_view import Point, draw_path, plan_camera
from robots.simulated.pictures.point_of_view import clearest_view
from robots.simulated.world import SimulatedWorld

Camera = Literal["overview", "grasp", "plan"]
"""The whole robot with what is in front of it; the hand that holds something, else the higher one; or the
whole scene from above."""

Picture = NDArray[np.uint8]

SNAPSHOT_SIZE = (960, 720)
VIDEO_SIZE = (640, 480)
VIDEO_RATE_HZ = 25
SMOOTH_SAMPLES = 4
"""Samples a pixel of a single picture; films have one, which is several times faster in software."""
_STANDS_STILL_S = 0.5
"""The last picture of a film, which is seen before a player closes."""


@dataclass(frozen=True, slots=True)
class _View:
    distance_m: float
    azimuth_rad: float
    elevation_rad: float


_OVERVIEW = _View(2.7, math.radians(145.0), math.radians(-14.0))
_GRASP = _View(0.62, math.radians(115.0), math.radians(-16.0))


def require_ffmpeg() -> str:
    """Path of the program that makes films.

    Raises:
        RenderingUnavailableError: It is not installed; names the Debian package.
    """
    path = shutil.which("ffmpeg")
    if path is None:
        raise RenderingUnavailableError("films need the program ffmpeg; install the Debian package ffmpeg")
    return path


def require_rendering(video: bool) -> None:
    """Find out, before anything moves, whether pictures (and films) can be made here.

    Raises:
        RenderingUnavailableError: They cannot; one line that names the Debian packages.
    """
    require_opengl()
    if video:
        require_ffmpeg()


class Renderer:
    """Draws one world; close it, or use it in a ``with`` statement.

    Raises:
        RenderingUnavailableError: No OpenGL library works here.
    """

    def __init__(
        self, world: SimulatedWorld, size: tuple[int, int] = SNAPSHOT_SIZE, fine: bool = True
    ) -> None:
        self._world, (self._width, self._height), self._fine = world, size, fine
        model = world.physics.model
        self._context = make_context(self._width, self._height)
        model.vis.global_.offwidth, model.vis.global_.offheight = size
        model.vis.quality.offsamples = SMOOTH_SAMPLES if fine else 0
        self._scene = mujoco.MjvScene(model, maxgeom=2000)
        self._drawing = mujoco.MjrContext(model, int(mujoco.mjtFontScale.mjFONTSCALE_100))
        mujoco.mjr_setBuffer(int(mujoco.mjtFramebuffer.mjFB_OFFSCREEN), self._drawing)
        self._clearest: tuple[float, float] | None = None
        self._option = mujoco.MjvOption()
        self._option.geomgroup[:] = 0
        self._option.geomgroup[[WORLD_GROUP, FINGER_DRAWN_GROUP, DRAWN_GROUP]] = 1

    def draw(self, camera: Camera = "overview", path: Sequence[Point] = ()) -> Picture:
        """Draw the world as it is now, shape (height, width, 3).

        Args:
            camera: From where.
            path: A line on the floor, in the world: where the robot went.
        """
        physics = self._world.physics
        physics.refresh()
        self._context.make_current()
        mujoco.mjv_updateScene(
            physics.model,
            physics.data,
            self._option,
            None,
            self._camera(camera, path),
            int(mujoco.mjtCatBit.mjCAT_ALL),
            self._scene,
        )
        draw_path(self._scene, path)
        draw_forearms(self._scene, physics.model, physics.data, physics.scene.people)
        flags = self._scene.flags
        flags[mujoco.mjtRndFlag.mjRND_SHADOW] = self._fine
        flags[mujoco.mjtRndFlag.mjRND_REFLECTION] = False
        picture = np.zeros((self._height, self._width, 3), dtype=np.uint8)
        room = mujoco.MjrRect(0, 0, self._width, self._height)
        mujoco.mjr_render(room, self._scene, self._drawing)
        mujoco.mjr_readPixels(picture, None, room, self._drawing)
        return np.ascontiguousarray(picture[::-1])

    def close(self) -> None:
        """Give the OpenGL context back; twice is fine."""
        if self._drawing is not None:
            self._context.make_current()
            self._drawing.free()
            self._drawing = None
            self._context.free()

    def __enter__(self) -> Renderer:
        """Use it until the end of the block."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Close it."""
        self.close()

    def _camera(self, name: Camera, path: Sequence[Point]) -> mujoco.MjvCamera:
        if name == "plan":
            physics = self._world.physics
            fovy_deg = float(physics.model.vis.global_.fovy)
            return plan_camera(physics.scene, path, self._width, self._height, fovy_deg)
        truth = self._world.truth
        world_T_base = truth.world_T_base()
        heading = math.atan2(world_T_base[1, 0], world_T_base[0, 0])
        camera = mujoco.MjvCamera()
        camera.type = mujoco.mjtCamera.mjCAMERA_FREE
        if name == "overview":
            view, side = _OVERVIEW, 1.0
            ahead = np.array([0.25 * math.cos(heading), 0.25 * math.sin(heading), 0.0])
            camera.lookat = world_T_base[:3, 3] * (1.0, 1.0, 0.0) + ahead + (0.0, 0.0, 0.88)
            if self._clearest is None:  # a film keeps the view that it began with
                aspect = self._width / self._height
                self._clearest = clearest_view(self._world, camera.lookat, view.elevation_rad, aspect)
            view = replace(view, azimuth_rad=self._clearest[0], distance_m=self._clearest[1])
        else:
            hand = self._busy_hand()
            view, side = _GRASP, 1.0 if hand == "left" else -1.0
            camera.lookat = truth.world_T_tcp(hand)[:3, 3]
        camera.distance = view.distance_m
        camera.azimuth = math.degrees(heading + side * view.azimuth_rad)
        camera.elevation = math.degrees(view.elevation_rad)
        return camera

    def _busy_hand(self) -> Hand:
        truth = self._world.truth
        touched = {contact.pad for name in truth.objects() for contact in truth.contacts.of_pads(name)}
        grippers = self._world.physics.description.grippers
        for hand in grippers:
            if touched & set(grippers[hand].pad_links):
                return hand
        return max(grippers, key=lambda hand: float(truth.world_T_tcp(hand)[2, 3]))


def snapshot(
    world: SimulatedWorld,
    path: Path | str,
    size: tuple[int, int] = SNAPSHOT_SIZE,
    camera: Camera = "overview",
    walked: Sequence[Point] = (),
) -> None:
    """Write a picture of a world as it is now, as PNG.

    Args:
        world: What to draw.
        path: Where to.
        size: Width and height in pixels.
        camera: From where.
        walked: A line on the floor, in the world: where the robot went.

    Raises:
        RenderingUnavailableError: No OpenGL library works here.
        OSError: The file cannot be written.
    """
    with Renderer(world, size) as renderer:
        Image.fromarray(renderer.draw(camera, walked)).save(path, format="PNG")


Panel = Callable[[int, float], Picture]
"""Draws what stands beside the frames of a film, from its height in pixels and the simulated time."""


class VideoRecorder:
    """Makes an MP4 film of a world in simulated time; call ``tick`` after each control period.

    Raises:
        RenderingUnavailableError: OpenGL or the program ffmpeg is missing.
    """

    def __init__(
        self,
        world: SimulatedWorld,
        path: Path | str,
        size: tuple[int, int] = VIDEO_SIZE,
        camera: Camera = "overview",
        rate_hz: int = VIDEO_RATE_HZ,
        panel: Panel | None = None,
    ) -> None:
        program = require_ffmpeg()
        self._world, self._path, self._camera, self._rate_hz = world, Path(path), camera, rate_hz
        self._renderer = Renderer(world, size, fine=False)
        self._messages = tempfile.TemporaryFile()  # noqa: SIM115 - lives as long as the recorder
        self._panel, self._height = panel, size[1]
        width, height = size
        if panel is not None:
            width += panel(height, world.truth.time_s).shape[1]
        raw = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r", str(rate_hz)]
        # yuv420p with even sizes: what every player shows.
        coded = ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-movflags", "+faststart"]
        self._encoder: subprocess.Popen[bytes] | None = subprocess.Popen(
            [program, "-y", "-loglevel", "error", *raw, "-i", "-", *coded, "-f", "mp4", str(self._path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=self._messages,
            start_new_session=True,  # Ctrl-C in a terminal is for the run, which ends the film itself
        )
        self._next_s = world.truth.time_s
        self._last = b""

    def tick(self) -> None:
        """Draw a frame if one is due.

        Raises:
            RenderingUnavailableError: The encoder gave up; with its reason.
        """
        if self._encoder is None or self._world.truth.time_s < self._next_s - 1e-6:
            return
        self._next_s += 1.0 / self._rate_hz
        picture = self._renderer.draw(self._camera)
        if self._panel is not None:
            picture = np.hstack([picture, self._panel(self._height, self._world.truth.time_s)])
        if self._encoder.stdin is None:
            return
        self._last = picture.tobytes()
        try:
            self._encoder.stdin.write(self._last)
        except BrokenPipeError:
            self.close()

    def close(self) -> None:
        """Finish the film, whose last picture stands still for a while; twice is fine.

        Raises:
            RenderingUnavailableError: The encoder failed; with its reason.
        """
        if self._encoder is None:
            return
        encoder, self._encoder = self._encoder, None
        try:
            encoder.communicate(self._last * round(_STANDS_STILL_S * self._rate_hz))
        except BrokenPipeError:  # the encoder is gone; its messages say why
            encoder.wait()
        self._renderer.close()
        self._messages.seek(0)
        said = self._messages.read().decode("utf-8", "replace").strip().splitlines()
        self._messages.close()
        if encoder.returncode != 0:
            reason = said[-1] if said else f"exit code {encoder.returncode}"
            raise RenderingUnavailableError(f"ffmpeg could not write {self._path}: {reason}")
