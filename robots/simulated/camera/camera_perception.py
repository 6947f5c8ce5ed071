"""A detector that looks at what the robot's own camera shows of a simulated world."""

from __future__ import annotations

import contextlib
import importlib.util
import subprocess
import sys
import weakref
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, replace
from multiprocessing.connection import Connection, Pipe
from typing import Any

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from robots.clock import Clock
from robots.errors import DescriptionError, RenderingUnavailableError
from robots.interface.depth_camera import DepthCamera
from robots.interface.hardware import RobotData
from robots.perception.detector import PerceptionFrame
from robots.perception.labels.labelling import BY_SHAPE, Labelling
from robots.perception.rgbd.furniture_map import furniture_map
from robots.perception.stub_faults import StubFaults
from robots.scenes.scene_description import SceneDescription
from robots.simulated.body.physics import Physics
from robots.simulated.camera.orders import Answer, LensFaults, Setup, Shot, WorldState
from robots.simulated.pictures.opengl import require_opengl

_TIME_TOLERANCE_S = 1e-9
_IDLE_S = 0.1
"""When nobody has asked for a frame for so long, none is taken: each costs as much as many periods."""
_STILL_S = 0.05
"""Who looks asks each tick; who has not asked for so long has seen enough."""
_MODULE = "robots.simulated.camera.process"
_END_WITHIN_S = 5.0


@dataclass(frozen=True, slots=True)
class Believed(Sealed):
    """What the robot knows of itself when a picture is taken.

    Attributes:
        odom_T_camera: Where the camera is, shape (4, 4).
        joints: Of its encoders, in the order of ``RobotDescription.actuated``.
    """

    odom_T_camera: Transform
    joints: Array


class CameraFaults(StubFaults):
    """Switches for a camera that is wrong in a known way, beside those of what is told.

    Attributes:
        lens: What is wrong with the pictures.
        frozen: Whether the same picture comes again and again.
        late_s: How much later than usual what was found is told.
        between: Called with the stamp of each frame: gives the faults of its picture; None: ``lens``.
    """

    def __init__(self) -> None:
        super().__init__()
        self.lens = LensFaults()
        self.frozen = False
        self.late_s = 0.0
        self.between: Callable[[float], LensFaults] | None = None


class CameraPerception:
    """A ``Detector`` over the robot's first camera.

    Whoever advances the world calls ``tick`` once each control period. Pictures are taken when somebody
    looks, drawn and looked at in a process of their own. Live, what is in them comes when it is done. In
    lockstep each is drawn when it is due to be told, and waited for, if somebody still looks then; nobody
    misses the others.

    Attributes:
        faults: Errors beyond the camera's own, injected by tests and evaluations.
        looked_s: Processor time that the pictures took, beside drawing, each.

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
    ) -> None:
        self.faults = CameraFaults()
        self.looked_s: list[float] = []
        self._camera = picture_camera(robot)
        self._physics, self._clock, self._believed, self._waits = physics, clock, believed, waits
        self._light = scene.light
        map_rng, seed_rng = rng.spawn(2)
        setup = Setup(
            robot.description.name,
            scene,
            furniture_map(scene, map_rng),
            int(seed_rng.integers(2**31)),
            labelling,
        )
        self._pipe = _start(self)
        self._labels: frozenset[str] | None = self._ask(setup)
        self._taken: deque[Shot] = deque()
        self._pending: deque[PerceptionFrame] = deque()
        self._asked: Shot | None = None
        self._latest: PerceptionFrame | None = None
        self._pictures = 0
        self._start_s = self._due_s = self._asked_s = clock.now_s()

    @property
    def labels(self) -> frozenset[str] | None:
        """The words that it can tell; None: any."""
        return self._labels

    def latest(self) -> PerceptionFrame | None:
        """The newest frame that has been delivered, or None before the first."""
        self._asked_s = self._clock.now_s()
        return self._latest

    def tick(self) -> None:
        """Take a picture when one is due and somebody looks, deliver those whose latency has passed."""
        now_s = self._clock.now_s() + _TIME_TOLERANCE_S
        if self._asked is not None and self._pipe.poll(0):
            self._take_answer()
        if now_s >= self._due_s:
            if now_s - self._asked_s <= _IDLE_S:
                self._take_picture()
            self._pictures += 1
            self._due_s = self._start_s + self._pictures / self._camera.rate_hz
        late_s = self._camera.latency_s + self.faults.late_s
        while self._taken and now_s >= self._taken[0].stamp_s + late_s:
            shot = self._taken.popleft()
            if now_s - self._asked_s <= _STILL_S:
                self._send(shot)
                self._take_answer()
        while self._pending and now_s >= self._pending[0].stamp_s + late_s:
            self._latest = self._pending.popleft()

    def _take_picture(self) -> None:
        if self._waits:
            self._taken.append(self._shot())
        elif self._asked is None:
            self._send(self._shot())

    def _send(self, shot: Shot) -> None:
        self._pipe.send(shot)
        self._asked = shot

    def set_error(
        self, kind: str, offset_m: tuple[float, float, float], first_look_only: bool = True
    ) -> None:
        """Tell every object of a kind at a wrong place; see ``StubFaults.misplace``."""
        self.faults.misplace(kind, offset_m, first_look_only)

    def _shot(self) -> Shot:
        data, believed = self._physics.data, self._believed()
        stamp_s = self._clock.now_s()
        self.faults.observe(stamp_s, believed.odom_T_camera)
        lens = self.faults.lens if self.faults.between is None else self.faults.between(stamp_s)
        if self.faults.blind:
            lens = replace(lens, covered=True)
        return Shot(
            stamp_s=stamp_s,
            sequence=self._pictures,
            state=WorldState(data.qpos, data.mocap_pos, data.mocap_quat),
            joints=believed.joints,
            odom_T_camera=believed.odom_T_camera,
            light=self._light.at(stamp_s),
            faults=lens,
            frozen=self.faults.frozen,
        )

    def _take_answer(self) -> None:
        answer, shot = self._received(), self._asked
        self._asked = None
        if isinstance(answer, Answer) and shot is not None:
            self.looked_s.append(answer.looked_s)
            self._pending.append(self._displaced(answer.frame, shot.odom_T_camera[:3, :3]))

    def _displaced(self, frame: PerceptionFrame, odom_R_camera: Array) -> PerceptionFrame:
        """The frame with the errors that were injected into what it tells."""
        told = []
        for seen in frame.detections:
            offset = self.faults.offset_m(seen.category, seen.kind, frame.stamp_s)
            color = self.faults.color_of(seen.category, seen.kind, seen.color)
            if offset.any() or color != seen.color:
                moved = poses.transform(np.eye(3), odom_R_camera.T @ offset) @ seen.camera_T_object
                seen = replace(seen, camera_T_object=moved, color=color)
            told.append(seen)
        return replace(frame, detections=tuple(told))

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
