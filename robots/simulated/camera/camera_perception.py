"""A detector that looks at what cameras show of a simulated world: the robot's own, and those of the room."""

from __future__ import annotations

import contextlib
import importlib.util
import subprocess
import sys
import weakref
from collections import deque
from collections.abc import Callable
from functools import partial
from multiprocessing.connection import Connection, Pipe
from pathlib import Path
from typing import Any

import numpy as np

from kinematics.geometry.poses import Transform
from robots.clock import Clock
from robots.errors import DescriptionError, RenderingUnavailableError
from robots.interface.depth_camera import DepthCamera
from robots.interface.hardware import RobotData
from robots.perception.detector import PerceptionFrame
from robots.perception.fusion.cameras import calibrated_places
from robots.perception.labels.labelling import BY_SHAPE, Labelling
from robots.perception.rgbd.furniture_map import furniture_map
from robots.perception.told_labels import told_fronts
from robots.scenes.furniture_names import FIXTURE
from robots.scenes.scene_description import SceneDescription
from robots.simulated.body.physics import Physics
from robots.simulated.camera.feed import Believed, CameraFaults, CameraFeed
from robots.simulated.camera.orders import Answer, Setup, Shot
from robots.simulated.pictures.opengl import require_opengl

_MODULE = "robots.simulated.camera.process"
_END_WITHIN_S = 5.0


class CameraPerception:
    """A ``Detector`` over the robot's first camera; and the cameras of its scene beside it.

    Whoever advances the world calls ``tick`` once each control period. Pictures are taken when somebody
    looks, drawn and looked at in a process of their own, one for all cameras. Live, what is in them comes
    when it is done. In lockstep each is drawn when it is due to be told, and waited for, if somebody still
    looks then; nobody misses the others.

    Attributes:
        cameras: Those that stand in the room, in the scene's order; each a ``Detector`` of its own.
        silences: Why some who were asked what things are called could tell nothing, each reason once.

    Raises:
        DescriptionError: The robot has no camera for pictures.
        RenderingUnavailableError: Nothing can be drawn here.
    """

    def __init__(
        self,
        physics: Physics,
        robot: RobotData,
        scene: SceneDescription,
        clock: Clock,
        rng: np.random.Generator,
        believed: Callable[[], Believed],
        *,
        waits: bool = True,
        labelling: Labelling = BY_SHAPE,
        slot: Path | None = None,
    ) -> None:
        self._waits = waits
        self.silences: tuple[str, ...] = ()
        map_rng, seed_rng = rng.spawn(2)
        setup = Setup(
            robot.description.name,
            scene,
            furniture_map(scene, map_rng),
            int(seed_rng.integers(2**31)),
            labelling,
            slot,
        )
        self._own = CameraFeed(0, picture_camera(robot), physics, scene.light, clock, believed, waits=waits)
        self.cameras = tuple(
            CameraFeed(
                number,
                camera.lens,
                physics,
                scene.light,
                clock,
                partial(_standing, believed, place),
                waits=waits,
            )
            for number, (camera, place) in enumerate(
                zip(scene.cameras, calibrated_places(scene), strict=True), start=1
            )
        )
        self._under_way: deque[tuple[CameraFeed, Shot]] = deque()
        self._pipe = _start(self)
        # a camera sees no fixtures
        labels, fronts = self._ask(setup), told_fronts(one for one in scene.furniture if one.kind != FIXTURE)
        for feed in self._feeds:
            feed.labels, feed.fronts = labels, fronts

    @property
    def _feeds(self) -> tuple[CameraFeed, ...]:
        return (self._own, *self.cameras)

    @property
    def labels(self) -> frozenset[str] | None:
        """The words that it can tell; None: any."""
        return self._own.labels

    @property
    def fronts(self) -> frozenset[str]:
        """The doors and drawers that the map tells apart by the piece that they are of."""
        return self._own.fronts

    @property
    def faults(self) -> CameraFaults:
        """Errors beyond the camera's own, injected by tests and evaluations."""
        return self._own.faults

    @property
    def looked_s(self) -> list[float]:
        """Processor time that the pictures took, beside drawing, each."""
        return self._own.looked_s

    def latest(self) -> PerceptionFrame | None:
        """The newest frame that has been delivered, or None before the first."""
        return self._own.latest()

    def tick(self) -> None:
        """Take the pictures that are due while somebody looks, deliver those whose latency has passed."""
        while self._under_way and self._pipe.poll(0):
            self._take_answer()
        for feed in self._feeds:
            for shot in feed.shots():
                self._pipe.send(shot)
                self._under_way.append((feed, shot))
                if self._waits:
                    self._take_answer()
            feed.deliver()

    def set_error(
        self, kind: str, offset_m: tuple[float, float, float], first_look_only: bool = True
    ) -> None:
        """Tell every object of a kind at a wrong place; see ``StubFaults.misplace``."""
        self._own.set_error(kind, offset_m, first_look_only)

    def _take_answer(self) -> None:
        answer = self._received()
        feed, shot = self._under_way.popleft()
        if not isinstance(answer, Answer):
            feed.take(None, shot)
            return
        if answer.silence and answer.silence not in self.silences:
            self.silences += (answer.silence,)
        feed.take(answer, shot)

    def _ask(self, question: object) -> Any:
        self._pipe.send(question)
        return self._received()

    def _received(self) -> Any:
        try:
            answer = self._pipe.recv()
        except (EOFError, OSError):
            raise RenderingUnavailableError(
                "the process that draws the camera's pictures has ended"
            ) from None
        if isinstance(answer, Exception):
            raise answer
        return answer


def _standing(believed: Callable[[], Believed], odom_T_camera: Transform) -> Believed:
    """What the robot knows, for a camera that does not move with it."""
    return Believed(odom_T_camera, believed().joints)


def picture_camera(robot: RobotData) -> DepthCamera:
    """The camera through which a robot sees.

    Raises:
        DescriptionError: It has none.
    """
    if not robot.hardware.cameras:
        name = robot.description.name
        raise DescriptionError(
            f"robot {name!r} has no camera for pictures: its data have no [[rgbd]]; perception is the stub's"
        )
    return robot.hardware.cameras[0]


def require_camera(robot: RobotData) -> None:
    """Find out, before anything moves, whether a robot can see with its camera on this machine.

    Raises:
        DescriptionError: It has none.
        RenderingUnavailableError: A library is missing; one line that names it.
    """
    picture_camera(robot)
    if importlib.util.find_spec("cv2") is None:
        raise RenderingUnavailableError(
            "seeing with the camera needs OpenCV; install it with: pip install 'humanoid-executive[camera]'"
        )
    require_opengl()


def _start(owner: object) -> Connection[Any, Any]:
    """Start the process; it ends with its owner."""
    ours, theirs = Pipe()
    process = subprocess.Popen(
        [sys.executable, "-m", _MODULE, str(theirs.fileno())],
        pass_fds=[theirs.fileno()],
        stdin=subprocess.DEVNULL,
        start_new_session=True,
    )
    theirs.close()
    weakref.finalize(owner, _end, process, ours)
    return ours


def _end(process: subprocess.Popen[bytes], pipe: Connection[Any, Any]) -> None:
    with contextlib.suppress(OSError):
        pipe.close()
    try:
        process.wait(_END_WITHIN_S)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
