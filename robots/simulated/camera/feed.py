"""The pictures of one camera of a simulated world: when they are due, what is wrong, what they tell."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from robots.clock import Clock
from robots.interface.depth_camera import DepthCamera
from robots.perception.detector import PerceptionFrame
from robots.perception.stub_faults import StubFaults
from robots.scenes.light import Light
from robots.simulated.body.physics import Physics
from robots.simulated.camera.orders import Answer, LensFaults, Shot, WorldState

_TIME_TOLERANCE_S = 1e-9
_IDLE_S = 0.1
"""When nobody has asked for a frame for so long, none is taken: each costs as much as many periods."""
_STILL_S = 0.05
"""Who looks asks each tick; who has not asked for so long has seen enough."""


@dataclass(frozen=True, slots=True)
class Believed(Sealed):
    """What the robot knows when a picture is taken.

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


class CameraFeed:
    """A ``Detector`` over one camera.

    Whoever asks the process that draws for pictures calls ``shots``, ``take`` and ``deliver``.

    Attributes:
        labels: The words that it can tell; None: any.
        fronts: The doors and drawers that it tells apart by the piece that they are of.
        faults: Errors beyond the camera's own, injected by tests and evaluations.
        looked_s: Processor time that the pictures took, beside drawing, each.
    """

    def __init__(
        self,
        number: int,
        camera: DepthCamera,
        physics: Physics,
        light: Light,
        clock: Clock,
        believed: Callable[[], Believed],
        *,
        waits: bool,
    ) -> None:
        """Begin without a picture.

        Args:
            number: Of the camera, as in ``Shot``.
            camera: What it is like.
            physics: The world.
            light: Of the scene.
            clock: Simulated time.
            believed: Tells what the robot knows now.
            waits: Whether each picture is drawn when it is due to be told, and waited for, as lockstep needs.
        """
        self.labels: frozenset[str] | None = None
        self.fronts: frozenset[str] = frozenset()
        self.faults = CameraFaults()
        self.looked_s: list[float] = []
        self._number, self._camera, self._physics, self._light = number, camera, physics, light
        self._clock, self._believed = clock, believed
        self._pending: deque[PerceptionFrame] = deque()
        self._waits, self._taken = waits, deque[Shot]()
        self._under_way = False
        self._latest: PerceptionFrame | None = None
        self._pictures = 0
        self._start_s = self._due_s = self._asked_s = clock.now_s()

    def latest(self) -> PerceptionFrame | None:
        """The newest frame that has been delivered, or None before the first."""
        self._asked_s = self._clock.now_s()
        return self._latest

    def set_error(
        self, kind: str, offset_m: tuple[float, float, float], first_look_only: bool = True
    ) -> None:
        """Tell every object of a kind at a wrong place; see ``StubFaults.misplace``."""
        self.faults.misplace(kind, offset_m, first_look_only)

    def shots(self) -> list[Shot]:
        """The pictures that have to be drawn now: ``take`` is told what came of each."""
        now_s = self._clock.now_s() + _TIME_TOLERANCE_S
        if now_s >= self._due_s:
            if now_s - self._asked_s <= _IDLE_S and (self._waits or not (self._taken or self._under_way)):
                self._taken.append(self._shot())
            self._pictures += 1
            self._due_s = self._start_s + self._pictures / self._camera.rate_hz
        wanted = []
        while self._taken and (not self._waits or now_s >= self._taken[0].stamp_s + self._late_s):
            shot = self._taken.popleft()
            if not self._waits or now_s - self._asked_s <= _STILL_S:
                wanted.append(shot)
                self._under_way = True
        return wanted

    def take(self, answer: Answer | None, shot: Shot) -> None:
        """Take what came of a picture; None when nothing did."""
        self._under_way = False
        if answer is not None:
            self.looked_s.append(answer.looked_s)
            self._pending.append(self._displaced(answer.frame, shot.odom_T_camera[:3, :3]))

    @property
    def _late_s(self) -> float:
        return self._camera.latency_s + self.faults.late_s

    def deliver(self) -> None:
        """Tell the frames whose latency has passed."""
        now_s = self._clock.now_s() + _TIME_TOLERANCE_S
        while self._pending and now_s >= self._pending[0].stamp_s + self._late_s:
            self._latest = self._pending.popleft()

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
            camera=self._number,
        )

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
