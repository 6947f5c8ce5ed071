"""The process that draws pictures and looks at them.

``python -m robots.simulated.camera.process DESCRIPTOR``.
It is asked over a private pair of sockets: first how things are (``Setup``), then for one picture after the
other (``Shot``). It ends when whoever asks does.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass, field, replace
from multiprocessing.connection import Connection
from typing import Any

import cv2
import numpy as np

from kinematics.geometry.poses import Transform
from robots.clock import ProcessorClock
from robots.interface.depth_camera import DepthCamera
from robots.models.description import load_robot
from robots.perception.detector import PerceptionFrame
from robots.perception.labels.naming import Labellers
from robots.perception.rgbd.eyes import Eyes
from robots.perception.rgbd.picture import Colors, Depths, Picture
from robots.perception.rgbd.picture_slot import PictureSlotWriter
from robots.perception.rgbd.watch import TOLD, PictureWatch
from robots.simulated.camera.lens import Lens
from robots.simulated.camera.orders import Answer, Setup, Shot
from robots.simulated.camera.studio import Studio

_OWN_M = 0.03
_OWN_PX = 13
"""The robot's own outline is widened by so much: encoders, calibration and meshes err."""


@dataclass(slots=True)
class _Post:
    """One camera.

    Attributes:
        camera: What it is like.
        world_T_camera: Where its calibration has it; None for the robot's own, which moves with it.
        lens: Its errors.
        watch: Whether its pictures are worth looking at.
        last: Colour and depth of the picture before.
    """

    camera: DepthCamera
    world_T_camera: Transform | None
    lens: Lens
    watch: PictureWatch = field(default_factory=PictureWatch)
    last: tuple[Colors, Depths] | None = None


class CameraProcess:
    """The child's side."""

    def __init__(self, setup: Setup) -> None:
        """Prepare to draw.

        Raises:
            RobotsError: There is no such robot, it has no camera, or nothing can be drawn here.
        """
        robot = load_robot(setup.robot)
        fixed = setup.scene.cameras
        cameras = [robot.hardware.cameras[0], *(one.lens for one in fixed)]
        largest = max(one.width_px for one in cameras), max(one.height_px for one in cameras)
        self._studio = Studio(robot, setup.scene, largest)
        places = [None, *(one.world_T_camera for one in fixed)]
        self._posts = [
            _Post(camera, place, Lens(camera, (setup.seed, number)))
            for number, (camera, place) in enumerate(zip(cameras, places, strict=True))
        ]
        self._labellers = setup.labelling.labeller()
        self._eyes = _eyes(setup, self._labellers)
        self._processor = ProcessorClock()
        self._slot = None if setup.slot is None else PictureSlotWriter(setup.slot)

    @property
    def labels(self) -> frozenset[str] | None:
        """The words that can be told."""
        return self._eyes.labels

    def close(self) -> None:
        """Show nothing any more."""
        if self._slot is not None:
            self._slot.close()

    def take(self, shot: Shot) -> Picture:
        """Draw one picture, as the camera gives it."""
        studio, post = self._studio, self._posts[shot.camera]
        camera = post.camera
        studio.place(shot.state)
        if shot.frozen and post.last is not None:
            color, depth = post.last
        else:
            told = studio.frame_pose(camera.frame) if post.world_T_camera is None else post.world_T_camera
            pose = told @ post.lens.place_error(shot.faults)
            exact = studio.draw(camera, pose, shot.light == "side")
            color, depth = post.lens.spoil(*exact, shot.light, shot.sequence, shot.faults)
        post.last = color, depth
        body = studio.draw_body(camera, shot.joints, post.world_T_camera)
        own = ((body > 0.0) & ((depth > body - _OWN_M) | (depth <= 0.0))).astype(np.uint8)
        widened = cv2.dilate(own, np.ones((_OWN_PX, _OWN_PX), np.uint8)) > 0
        return Picture(camera, color, depth, widened, shot.odom_T_camera, shot.stamp_s)

    def answer(self, shot: Shot) -> Answer:
        """Take a picture and look at it."""
        picture = self.take(shot)
        if self._slot is not None and self._posts[shot.camera].world_T_camera is None:
            self._slot.show(picture)
        began = self._processor.now_s()
        watch = self._posts[shot.camera].watch
        trouble = watch.judge(picture)
        if trouble is None:
            frame = replace(self._looked(picture, shot), hindrance=watch.hindrance(picture))
        else:
            frame = PerceptionFrame(shot.stamp_s, shot.sequence, (), TOLD[trouble])
        silence = "" if self._labellers is None else self._labellers.trouble
        return Answer(frame, self._processor.now_s() - began, silence)

    def _looked(self, picture: Picture, shot: Shot) -> PerceptionFrame:
        """What a picture shows. Where looking fails it tells nothing: whoever controls a robot goes on."""
        try:
            return self._eyes.detect(picture, shot.sequence)
        except Exception as wrong:  # whatever it is, it is told as the reason
            why = f"the picture could not be looked at ({type(wrong).__name__}: {wrong})"
            return PerceptionFrame(shot.stamp_s, shot.sequence, (), why)


def _eyes(setup: Setup, labellers: Labellers | None) -> Eyes:
    if labellers is None:
        return Eyes(setup.known)
    return Eyes(setup.known, labellers, setup.labelling.asked(labellers))


def serve(pipe: Connection[Any, Any]) -> None:
    """Answer until whoever asks has gone."""
    process: CameraProcess | None = None
    while True:
        try:
            asked = pipe.recv()
        except (EOFError, OSError):
            break
        reply: Any
        try:
            if isinstance(asked, Setup):
                process = CameraProcess(asked)
                reply = process.labels
            elif process is not None:
                reply = process.answer(asked)
        except Exception as wrong:  # told to whoever asks, who raises it
            reply = wrong
        try:
            pipe.send(reply)
        except OSError:
            break
    if process is not None:
        process.close()


if __name__ == "__main__":
    cv2.setNumThreads(1)
    serve(Connection(int(sys.argv[1])))
