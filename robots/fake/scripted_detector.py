"""A camera without errors, but for those in its script."""

from __future__ import annotations

import numpy as np

from kinematics import poses
from kinematics.robot_description import CameraDescription
from robots.clock import Clock
from robots.fake.scripted_world import ScriptedWorld
from robots.perception.detector import Detection, PerceptionFrame


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

    def latest(self) -> PerceptionFrame | None:
        """The newest frame."""
        return self._latest

    def advance(self) -> None:
        """Take a picture when one is due."""
        now_s = self._clock.now_s()
        due = self._latest is None or now_s >= self._latest.stamp_s + self._period_s - 1e-9
        if due and not self.frozen:
            number = 1 if self._latest is None else self._latest.sequence + 1
            self._latest = PerceptionFrame(now_s, number, () if self.blind else tuple(self._seen()))

    def _seen(self) -> list[Detection]:
        camera_T_world = poses.inverse(self._world.world_T_camera())
        seen = []
        for item in self._world.solids():
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
