"""A camera without errors, but for those in its script."""

from __future__ import annotations

import operator

import numpy as np

from kinematics import poses
from kinematics.poses import Transform
from kinematics.robot_description import CameraDescription
from robots.clock import Clock
from robots.fake.scripted_world import ScriptedWorld
from robots.perception.detector import Detection, PerceptionFrame
from robots.perception.truth_view import TrueObject


class ScriptedDetector:
    """Sees whatever is in the field of view; satisfies ``Detector``.

    Attributes:
        blind: While true, frames come but show nothing.
        frozen: While true, no new frames come.
        offset_m: Names of things that are seen at a wrong place, and by how much, along the world's axes.
    """

    def __init__(
        self, world: ScriptedWorld, camera: CameraDescription, clock: Clock, rate_hz: float = 50.0
    ) -> None:
        """Look at a world."""
        self.blind = False
        self.frozen = False
        self.offset_m: dict[str, tuple[float, float, float]] = {}
        self._world, self._camera, self._clock = world, camera, clock
        self._period_s = 1.0 / rate_hz
        self._latest: PerceptionFrame | None = None
        self._view: object = None
        self._solids: tuple[TrueObject, ...] = ()
        self._detections: tuple[Detection, ...] = ()

    def latest(self) -> PerceptionFrame | None:
        """The newest frame."""
        return self._latest

    def advance(self) -> None:
        """Take a picture when one is due."""
        now_s = self._clock.now_s()
        due = self._latest is None or now_s >= self._latest.stamp_s + self._period_s - 1e-9
        if due and not self.frozen:
            number = 1 if self._latest is None else self._latest.sequence + 1
            self._latest = PerceptionFrame(now_s, number, () if self.blind else self._seen())

    def _seen(self) -> tuple[Detection, ...]:
        """What is in view; kept, since a camera and a world at rest show the same again."""
        world_T_camera, solids = self._world.world_T_camera(), self._world.solids()
        view = world_T_camera.tobytes(), sorted(self._world.hidden), dict(self.offset_m)
        same_things = len(solids) == len(self._solids) and all(map(operator.is_, solids, self._solids))
        if view != self._view or not same_things:
            self._view, self._solids = view, solids
            self._detections = tuple(self._looked_at(world_T_camera, solids))
        return self._detections

    def _looked_at(self, world_T_camera: Transform, solids: tuple[TrueObject, ...]) -> list[Detection]:
        camera_T_world = poses.inverse(world_T_camera)
        seen = []
        for item in solids:
            camera_T_object = camera_T_world @ item.world_T_object
            x, y, z = camera_T_object[:3, 3]
            in_view = (
                z > 0.0
                and abs(np.arctan2(x, z)) <= 0.5 * self._camera.horizontal_fov_rad
                and abs(np.arctan2(y, z)) <= 0.5 * self._camera.vertical_fov_rad
            )
            # of furniture and people any corner is enough; the fake does not look for corners
            if item.name in self._world.hidden or not (in_view or item.category != "object"):
                continue
            offset = poses.translation(*self.offset_m.get(item.name, (0.0, 0.0, 0.0)))
            told = camera_T_world @ offset @ item.world_T_object
            name = item.name if item.category == "person" else None
            seen.append(Detection(item.category, item.kind, item.color, told, item.shape, 0.95, name))
        return seen
