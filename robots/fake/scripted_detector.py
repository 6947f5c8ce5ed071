"""A camera without errors, but for those in its script."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.model.camera_description import CameraDescription
from kinematics.scene.known_part import KnownPart
from robots.clock import Clock
from robots.fake.scripted_world import ScriptedWorld
from robots.perception.detector import Detection, PerceptionFrame
from robots.perception.position_error import PositionError
from robots.perception.truth_view import TrueObject

_SURELY = 0.95
PICTURE = b"a picture"
"""Of what is seen otherwise than surely."""


@dataclass(frozen=True, slots=True)
class _View:
    """The world at one instant, and from where it is seen."""

    world_T_camera: Transform
    solids: tuple[TrueObject, ...]
    hidden: frozenset[str]
    offset_m: dict[str, tuple[float, float, float]]
    confidence: dict[str, float]


@dataclass(frozen=True, slots=True)
class _Picture:
    """What the camera took; without a view it shows nothing."""

    stamp_s: float
    number: int
    view: _View | None


class ScriptedDetector:
    """Sees whatever is in the field of view; satisfies ``Detector``.

    Attributes:
        blind: While true, frames come but show nothing.
        frozen: While true, no new frames come.
        offset_m: Names of things that are seen at a wrong place, and by how much, along the world's axes.
        tilt_rad: By how much what is level seems to lean.
        confidence: Names of things that are seen otherwise than surely, and how surely.
        error: That it declares of all it tells; None: none.
        labels: The words that it can tell; None: any.
        fronts: The doors and drawers that it tells apart by their piece.
    """

    labels: frozenset[str] | None = None
    fronts: frozenset[str] = frozenset()

    def __init__(
        self, world: ScriptedWorld, camera: CameraDescription, clock: Clock, rate_hz: float = 50.0
    ) -> None:
        """Look at a world."""
        self.blind = False
        self.frozen = False
        self.offset_m: dict[str, tuple[float, float, float]] = {}
        self.tilt_rad = 0.0
        self.confidence: dict[str, float] = {}
        self.error: PositionError | None = None
        self._world, self._camera, self._clock = world, camera, clock
        self._period_s = 1.0 / rate_hz
        self._picture: _Picture | None = None
        self._latest: PerceptionFrame | None = None

    def latest(self) -> PerceptionFrame | None:
        """The newest frame; what it shows is worked out when somebody asks for it."""
        picture = self._picture
        if picture is None:
            return None
        if self._latest is None or self._latest.sequence != picture.number:
            seen = () if picture.view is None else tuple(self._looked_at(picture.view))
            self._latest = PerceptionFrame(picture.stamp_s, picture.number, seen, tilt_rad=self.tilt_rad)
        return self._latest

    def advance(self) -> None:
        """Take a picture when one is due."""
        now_s, last = self._clock.now_s(), self._picture
        due = last is None or now_s >= last.stamp_s + self._period_s - 1e-9
        if due and not self.frozen:
            number = 1 if last is None else last.number + 1
            self._picture = _Picture(now_s, number, None if self.blind else self._view())

    def _view(self) -> _View:
        world = self._world
        return _View(
            world.world_T_camera(),
            world.solids(),
            frozenset(world.hidden),
            dict(self.offset_m),
            dict(self.confidence),
        )

    def _looked_at(self, view: _View) -> list[Detection]:
        camera_T_world = poses.inverse(view.world_T_camera)
        seen = []
        for item in view.solids:
            camera_T_object = camera_T_world @ item.world_T_object
            x, y, z = camera_T_object[:3, 3].tolist()
            in_view = (
                z > 0.0
                and abs(math.atan2(x, z)) <= 0.5 * self._camera.horizontal_fov_rad
                and abs(math.atan2(y, z)) <= 0.5 * self._camera.vertical_fov_rad
            )
            # of furniture and people any corner is enough; the fake does not look for corners
            if item.name in view.hidden or not (in_view or item.category != "object"):
                continue
            offset_m = view.offset_m.get(item.name)
            told = camera_T_object
            if offset_m is not None:
                told = camera_T_world @ poses.translation(*offset_m) @ item.world_T_object
            seen.append(
                Detection(
                    item.category,
                    item.kind,
                    item.color,
                    told,
                    item.shape,
                    view.confidence.get(item.name, _SURELY),
                    item.told_name,
                    item.names,
                    item.categories,
                    item.traits,
                    self.error,
                    picture=PICTURE if item.name in view.confidence else None,
                    moves=_seen_from(camera_T_world, item.moves),
                )
            )
        return seen


def _seen_from(camera_T_world: Transform, moves: KnownPart | None) -> KnownPart | None:
    """What is known of a part that moves, in the camera's frame."""
    return None if moves is None else replace(moves, shut=camera_T_world @ moves.shut)
