"""The process that draws pictures and looks at them.

``python -m robots.simulated.camera.process DESCRIPTOR``.
It is asked over a private pair of sockets: first how things are (``Setup``), then for one picture after the
other (``Shot``). It ends when whoever asks does.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from multiprocessing.connection import Connection
from typing import Any

import cv2
import numpy as np

from robots.clock import ProcessorClock
from robots.models.description import load_robot
from robots.perception.detector import PerceptionFrame
from robots.perception.rgbd.eyes import Eyes
from robots.perception.rgbd.picture import Picture
from robots.perception.rgbd.watch import TOLD, PictureWatch
from robots.simulated.camera.lens import Lens
from robots.simulated.camera.orders import Answer, Setup, Shot
from robots.simulated.camera.studio import Studio

_OWN_M = 0.03
_OWN_PX = 13
"""The robot's own outline is widened by so much: encoders, calibration and meshes err."""


class CameraProcess:
    """The child's side."""

    def __init__(self, setup: Setup) -> None:
        """Prepare to draw.

        Raises:
            RobotsError: There is no such robot, it has no camera, or nothing can be drawn here.
        """
        robot = load_robot(setup.robot)
        self._camera = robot.hardware.cameras[0]
        self._studio = Studio(robot, setup.scene, (self._camera.width_px, self._camera.height_px))
        self._lens = Lens(self._camera, (setup.seed, 0))
        self._eyes, self._watch = _eyes(setup), PictureWatch()
        self._processor = ProcessorClock()
        self._last: tuple[Any, Any] | None = None

    @property
    def labels(self) -> frozenset[str] | None:
        """The words that can be told."""
        return self._eyes.labels

    def take(self, shot: Shot) -> Picture:
        """Draw one picture, as the camera gives it."""
        studio, camera = self._studio, self._camera
        studio.place(shot.state)
        if shot.frozen and self._last is not None:
            color, depth = self._last
        else:
            pose = studio.frame_pose(camera.frame) @ self._lens.place_error(shot.faults)
            exact = studio.draw(camera, pose, shot.light == "side")
            color, depth = self._lens.spoil(*exact, shot.light, shot.sequence, shot.faults)
        self._last = color, depth
        body = studio.draw_body(camera, shot.joints)
        own = ((body > 0.0) & ((depth > body - _OWN_M) | (depth <= 0.0))).astype(np.uint8)
        widened = cv2.dilate(own, np.ones((_OWN_PX, _OWN_PX), np.uint8)) > 0
        return Picture(camera, color, depth, widened, shot.odom_T_camera, shot.stamp_s)

    def answer(self, shot: Shot) -> Answer:
        """Take a picture and look at it."""
        picture = self.take(shot)
        began = self._processor.now_s()
        trouble = self._watch.judge(picture)
        if trouble is None:
            frame = self._eyes.detect(picture, shot.sequence)
            frame = replace(frame, hindrance=self._watch.hindrance(picture))
        else:
            frame = PerceptionFrame(shot.stamp_s, shot.sequence, (), TOLD[trouble])
        return Answer(frame, self._processor.now_s() - began)


def _eyes(setup: Setup) -> Eyes:
    labellers = setup.labelling.labeller()
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
            return
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
            return


if __name__ == "__main__":
    cv2.setNumThreads(1)
    serve(Connection(int(sys.argv[1])))
