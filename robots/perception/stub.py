"""A perception stub: reads the simulator's truth and spoils it by a declared, seeded error model.

Every error is a number of ``PerceptionModel``:

- *calibration*, along the world's axes, drawn once an episode, which everything has in common;
- *bias*, along the world's axes, and *size error*, drawn once for each object or piece of furniture
  and episode: another look does not average them away;
  Beyond 4 m it grows with the square of the distance, as the noise of positions does;
- *noise* of position and orientation, *dropout*, *false* and *merged* detections, drawn anew for each
  frame;
- *latency*: a frame is delivered that long after its picture was taken;
- *sight*: field of view and range of the camera, and line of sight to sampled surface points, the robot
  itself being an obstacle too. Of a piece of furniture that is recognised by any of its solids all solids
  are told, because its kind tells where the legs are.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import groupby

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from kinematics.model.camera_description import CameraDescription
from kinematics.scene.known_part import KnownPart
from robots.clock import Clock
from robots.perception.detector import Detection, PerceptionFrame
from robots.perception.position_error import alike_in_all_directions
from robots.perception.sight import Sight
from robots.perception.stub_faults import StubFaults
from robots.perception.told_labels import told_labels
from robots.perception.truth_view import TrueObject, TruthView
from robots.scenes.articulated import PART_KINDS
from robots.scenes.fixture import CONTROL_KINDS
from robots.scenes.scene_description import PerceptionModel

# A plane is recognised from a small part of it; an object needs the declared share.
_FURNITURE_MIN_VISIBLE = 0.04
# Rounding of sums of control periods must not move a picture by a whole period.
_TIME_TOLERANCE_S = 1e-9
_FALSE_KINDS: tuple[tuple[str, Shape], ...] = (
    ("cup", Cylinder(0.03, 0.11)),
    ("box", Box((0.06, 0.06, 0.1))),
    ("ball", Ball(0.035)),
    ("can", Cylinder(0.033, 0.12)),
)
# Depth by triangulation: its error grows with the square of the distance, and shows from here on.
_SHARP_M = 4.0
# When nobody has asked for a frame for so long, none is taken: a fifth of a run's time is saved.
_IDLE_S = 0.5
_FALSE_COLORS = ("red", "blue", "green", "yellow", "white")


@dataclass(frozen=True, slots=True)
class _Episode:
    """What is drawn once: the error of one object or piece of furniture."""

    bias_m: Array
    scale: tuple[float, float, float]


class PerceptionStub:
    """A ``Detector`` over a ``TruthView``.

    Whoever advances the world calls ``tick`` once each control period. Two stubs with equal truth, model
    and generator tell the same.

    Attributes:
        fronts: The doors and drawers that it tells apart by the piece that they are of.
        faults: Further errors, to be injected by tests and evaluations.
        cameras: Others, which stand in the room; they go on with this one.
        silences: None: nobody else is asked what things are called.
    """

    def __init__(
        self,
        truth: TruthView,
        camera: CameraDescription,
        model: PerceptionModel,
        clock: Clock,
        rng: np.random.Generator,
        fronts: frozenset[str] = frozenset(),
    ) -> None:
        self.fronts = fronts
        self.faults = StubFaults()
        self.cameras: tuple[PerceptionStub, ...] = ()
        self.silences: tuple[str, ...] = ()
        self._truth = truth
        self._camera = camera
        self._model = model
        self._clock = clock
        self._episode_rng, self._frame_rng, self._false_rng, self._traits_rng = rng.spawn(4)
        calibration = self._episode_rng.spawn(1)[0].normal(0.0, model.calibration_m, 3)
        self._calibration_m = calibration if model.calibration_m > 0.0 else np.zeros(3)
        self._sight = Sight(truth, camera)
        self._episodes: dict[str, _Episode] = {}
        self._labels = told_labels(_called(truth), model.labels)
        for solid in truth.solids():
            self._episode(solid)
        self._pending: deque[PerceptionFrame] = deque()
        self._latest: PerceptionFrame | None = None
        self._pictures = 0
        self._start_s = clock.now_s()
        self._due_s = self._start_s
        self._asked_s = self._start_s

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
        if now_s >= self._due_s:
            if now_s - self._asked_s <= _IDLE_S:
                self._pending.append(self._picture(self._clock.now_s()))
            self._pictures += 1
            self._due_s = self._start_s + self._pictures / self._model.rate_hz
        while self._pending and now_s >= self._pending[0].stamp_s + self._model.latency_s:
            self._latest = self._pending.popleft()
        for other in self.cameras:
            other.tick()

    def set_error(
        self, kind: str, offset_m: tuple[float, float, float], first_look_only: bool = True
    ) -> None:
        """Tell every object of a kind at a wrong place; see ``StubFaults.misplace``."""
        self.faults.misplace(kind, offset_m, first_look_only)

    def _picture(self, stamp_s: float) -> PerceptionFrame:
        """A new one; of a frozen camera what the last one showed."""
        last = self._pending[-1] if self._pending else self._latest
        if self.faults.frozen and last is not None:
            return PerceptionFrame(stamp_s, self._pictures, last.detections)
        return self._look(stamp_s)

    def _look(self, stamp_s: float) -> PerceptionFrame:
        world_T_camera = self._truth.world_T_camera()
        self.faults.observe(stamp_s, world_T_camera)
        detections: list[Detection] = []
        if not self.faults.blind:
            seen = self._merge(list(self._seen(world_T_camera)))
            detections = self._detect(seen, stamp_s, world_T_camera)
            detections += self._false_detections(world_T_camera)
        return PerceptionFrame(stamp_s, self._pictures, tuple(detections))

    def _seen(self, world_T_camera: Transform) -> Iterable[tuple[TrueObject, float]]:
        """Solids that the camera sees in this frame, with the share of each that is in sight."""
        pieces = [list(members) for _, members in groupby(self._truth.solids(), key=_piece)]
        # of furniture the largest face first: mostly that one question is enough
        first = [max(solids, key=_area) for solids in pieces]
        for solids, tried, share in zip(
            pieces, first, self._sight.shares(first, world_T_camera), strict=True
        ):
            needed = self._model.min_visible if tried.category == "object" else _FURNITURE_MIN_VISIBLE
            if share < needed and len(solids) > 1:
                rest = [solid for solid in solids if solid is not tried]
                share = max(self._sight.shares(rest, world_T_camera))
            if share < needed or share == 0.0:
                continue
            if self._frame_rng.random() >= self._model.dropout:
                for solid in solids:
                    yield solid, share

    def _merge(self, seen: list[tuple[TrueObject, float]]) -> list[tuple[TrueObject, float]]:
        """Replace pairs of nearly touching objects by one that covers both, by chance."""
        if self._model.merge_chance <= 0.0:
            return seen
        objects = [item for item in seen if item[0].category == "object"]
        for i, (a, share_a) in enumerate(objects):
            for b, share_b in objects[i + 1 :]:
                near = _horizontal_gap(a, b) < self._model.merge_distance_m
                if near and self._frame_rng.random() < self._model.merge_chance:
                    rest = [item for item in seen if item[0] is not a and item[0] is not b]
                    return [*rest, (_cover(a, b), max(share_a, share_b))]
        return seen

    def _detect(
        self, seen: list[tuple[TrueObject, float]], stamp_s: float, world_T_camera: Transform
    ) -> list[Detection]:
        """Spoil what is seen; all of a frame together, because it is done thirty times a second."""
        if not seen:
            return []
        model, solids = self._model, [solid for solid, _ in seen]
        # a row for each detection: position, orientation, confidence
        noise = self._frame_rng.standard_normal((len(seen), 7))
        world_T_object = np.array([solid.world_T_object for solid in solids])
        away_m = np.linalg.norm(world_T_object[:, :3, 3] - world_T_camera[:3, 3], axis=1)
        worse = np.maximum(1.0, (away_m / _SHARP_M) ** 2)
        world_T_object[:, :3, 3] += model.noise_m * worse[:, None] * noise[:, :3]
        world_T_object[:, :3, 3] += self._calibration_m + [
            grown * self._episode(solid).bias_m + self.faults.offset_m(solid.category, solid.kind, stamp_s)
            for solid, grown in zip(solids, worse, strict=True)
        ]
        world_T_object[:, :3, :3] @= _turns(model.orientation_noise_rad * noise[:, 3:6])
        camera_T_world = poses.inverse(world_T_camera)
        camera_T_object = self.faults.turned(camera_T_world @ world_T_object)
        return [
            Detection(
                category=solid.category,
                kind=solid.kind,
                color=self.faults.color_of(solid.category, solid.kind, solid.color),
                camera_T_object=pose,
                shape=self._shape(solid),
                confidence=self._confidence(pose, share, float(row[6])),
                name=solid.told_name,
                names=solid.names,
                categories=solid.categories,
                traits=self._traits(solid),
                moves=self._moves(solid, camera_T_world),
                error=alike_in_all_directions(
                    _declared(grown * model.bias_m),
                    _declared(grown * model.noise_m),
                    model.size_noise,
                    model.calibration_m,
                ),
            )
            for (solid, share), pose, row, grown in zip(
                seen, camera_T_object, noise, worse.tolist(), strict=True
            )
        ]

    def _shape(self, solid: TrueObject) -> Shape:
        """Its solid, with the errors of size."""
        shape, wrong = (
            _resized(solid.shape, self._episode(solid).scale),
            self.faults.scale_of(solid.category, solid.kind),
        )
        return shape if wrong is None else _resized(shape, wrong)

    def _traits(self, solid: TrueObject) -> tuple[str, ...]:
        """What of a person can be told in this frame."""
        if not solid.traits:
            return ()
        told = self._traits_rng.random(len(solid.traits)) >= self._model.trait_dropout
        return tuple(trait for trait, kept in zip(solid.traits, told, strict=True) if kept)

    def _moves(self, solid: TrueObject, camera_T_world: Transform) -> KnownPart | None:
        """Of what is recognised by its model: where that has it shut, as far off as its piece is."""
        if solid.moves is None:
            return None
        shut = solid.moves.shut.copy()
        shut[:3, 3] += self._calibration_m + self._bias_m(solid.name.partition("/")[0])
        return replace(solid.moves, shut=camera_T_world @ shut)

    def _confidence(self, camera_T_object: Transform, share: float, noise: float) -> float:
        """Falls with distance, with what hides the object, and towards the edge of the view."""
        x, y, z = (float(value) for value in camera_T_object[:3, 3])
        distance = math.hypot(x, y, z)
        depth = max(z, 1e-6)
        off_axis = max(abs(x) / (self._sight.tan[0] * depth), abs(y) / (self._sight.tan[1] * depth))
        value: float = 0.98 * (1.0 - 0.05 * max(0.0, distance - 1.0)) * (0.6 + 0.4 * share)
        value *= 1.0 - 0.1 * min(max(off_axis - 0.7, 0.0) / 0.3, 1.0)
        return min(max(value + 0.01 * noise, 0.0), 1.0)

    def _false_detections(self, world_T_camera: Transform) -> list[Detection]:
        """Things that are not there: upright, anywhere in view, of middling confidence."""
        rng = self._false_rng
        detections = []
        for _ in range(int(rng.poisson(self._model.false_rate))):
            depth = rng.uniform(max(0.5, self._camera.range_m[0]), min(2.0, self._camera.range_m[1]))
            across = rng.uniform(-0.9, 0.9, 2) * self._sight.tan * np.array([depth, depth])
            kind, shape = _FALSE_KINDS[int(rng.integers(len(_FALSE_KINDS)))]
            upright = world_T_camera[:3, :3].T @ poses.rotation_z(rng.uniform(-math.pi, math.pi))
            detections.append(
                Detection(
                    category="object",
                    kind=kind,
                    color=_FALSE_COLORS[int(rng.integers(len(_FALSE_COLORS)))],
                    camera_T_object=poses.transform(upright, (across[0], across[1], depth)),
                    shape=shape,
                    confidence=float(rng.uniform(0.3, 0.7)),
                )
            )
        return detections

    def _bias_m(self, piece: str) -> Array:
        """The error of the place of a piece of furniture, none of what has no solid of its own."""
        drawn = self._episodes.get(piece)
        return np.zeros(3) if drawn is None else drawn.bias_m

    def _episode(self, solid: TrueObject) -> _Episode:
        name = _piece(solid)
        if name not in self._episodes:
            bias_m = self._episode_rng.normal(0.0, self._model.bias_m, 3)
            x, y, z = (1.0 + self._episode_rng.normal(0.0, self._model.size_noise, 3)).tolist()
            self._episodes[name] = _Episode(bias_m, (x, y, z))
        return self._episodes[name]


def _called(truth: TruthView) -> Iterable[str]:
    """What the things of a world are called."""
    for solid in truth.solids():
        yield from (solid.kind, *solid.names, *solid.categories)
        if solid.category == "furniture" and solid.told_name is not None:
            yield solid.told_name


def _declared(error_m: float) -> float:
    """An error to the tenth of a millimetre; nobody declares it better."""
    return round(error_m, 4)


def _piece(solid: TrueObject) -> str:
    """An object's or a person's own name, or that of the piece of furniture that a solid belongs to.

    Doors, drawers and handles are seen, and misjudged, each on its own.
    """
    alone = solid.category != "furniture" or solid.kind in (*PART_KINDS, *CONTROL_KINDS)
    return solid.name if alone else solid.name.rpartition("/")[0]


def _area(solid: TrueObject) -> float:
    """Horizontal area, to ask the most telling solid of a piece first."""
    shape = solid.shape
    if isinstance(shape, Box):
        return shape.size_m[0] * shape.size_m[1]
    return math.pi * shape.radius_m**2


def _horizontal_radius(shape: Shape) -> float:
    if isinstance(shape, Box):
        return 0.5 * math.hypot(shape.size_m[0], shape.size_m[1])
    return shape.radius_m


def _horizontal_gap(a: TrueObject, b: TrueObject) -> float:
    """Distance of two upright objects' surfaces, boxes taken by their circumscribed circle."""
    between = a.world_T_object[:2, 3] - b.world_T_object[:2, 3]
    return float(np.linalg.norm(between)) - _horizontal_radius(a.shape) - _horizontal_radius(b.shape)


def _cover(a: TrueObject, b: TrueObject) -> TrueObject:
    """One object in the place of two: named after the larger one, as wide as both together."""
    large, small = (a, b) if _horizontal_radius(a.shape) >= _horizontal_radius(b.shape) else (b, a)
    centres = large.world_T_object[:3, 3], small.world_T_object[:3, 3]
    apart = float(np.linalg.norm(centres[0][:2] - centres[1][:2]))
    radius = 0.5 * (apart + _horizontal_radius(a.shape) + _horizontal_radius(b.shape))
    height = max(a.shape.height_m, b.shape.height_m)
    middle = large.world_T_object.copy()
    middle[:3, 3] = 0.5 * (centres[0] + centres[1])
    shape: Shape = Cylinder(radius, height)
    if isinstance(large.shape, Box):
        shape = Box((2.0 * radius, large.shape.size_m[1], height))
    return replace(large, shape=shape, world_T_object=middle)


def _turns(vectors_rad: Array) -> Array:
    """Rotations of small rotation vectors, shape (n, 3), as matrices, shape (n, 3, 3), by Rodrigues."""
    angle = np.linalg.norm(vectors_rad, axis=1)[:, None, None]
    x, y, z = vectors_rad.T
    skew = np.zeros((len(vectors_rad), 3, 3))
    skew[:, 0, 1], skew[:, 0, 2], skew[:, 1, 2] = -z, y, -x
    skew[:, 1, 0], skew[:, 2, 0], skew[:, 2, 1] = z, -y, x
    half = np.sinc(angle / (2.0 * np.pi))
    turns: Array = np.eye(3) + np.sinc(angle / np.pi) * skew + 0.5 * half * half * (skew @ skew)
    return turns


@lru_cache(maxsize=256)
def _resized(shape: Shape, scale: tuple[float, float, float]) -> Shape:
    """With errors of its size; of what is recognised by its model, whose size that tells, as it is."""
    if shape.parts is not None:
        return shape
    if isinstance(shape, Box):
        x, y, z = (a * b for a, b in zip(shape.size_m, scale, strict=True))
        return Box((x, y, z))
    if isinstance(shape, Cylinder):
        return Cylinder(shape.radius_m * scale[0], shape.height_m * scale[2])
    return Ball(shape.radius_m * scale[0])
