"""What several frames together tell about the things in view."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from statistics import fmean, median

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from kinematics.scene.known_part import KnownPart
from kinematics.scene.label import Label
from robots.perception.detector import Category, Detection, PerceptionFrame
from robots.perception.position_error import PositionError
from robots.perception.seen_label import SeenLabel
from robots.scenes.fixture import CONTROL_KINDS

# Nearer than the centres of two of the slimmest cups that touch, farther than any frame noise.
_OBJECT_GATE_M = 0.03
_FURNITURE_GATE_M = 0.06
# Two estimates of objects so near are one thing that was named in two ways.
_SAME_PLACE_M = 0.02
# Unless one is so much wider than the other: then that is a box or bowl with the other inside.
_HOLDS_FACTOR = 1.6
# So much wider is enough where both are told in the same pictures: what is named in two ways is of one size.
_HOLDS_TOGETHER_FACTOR = 1.15
# Something that leans less stands, and the rest is noise; more, and it lies.
_STANDING_TILT_RAD = 0.5
# Detections farther from the median than this, and than three times the usual distance, do not count.
_OUTLIER_M = 0.008
# A name that more than so many of the frames tell is the thing's.
_SURE_SHARE = 0.5


@dataclass(frozen=True, slots=True)
class ObjectEstimate(Sealed):
    """One thing, estimated from several frames.

    Attributes:
        category: "object", "furniture" or "person".
        kind, color: As most detections say.
        odom_T_object: Pose in the odometry frame, shape (4, 4); vertical for what stands.
        shape: Mean solid.
        confidence: In [0, 1]; mean of the detections', lowered by frames that missed it or disagree.
        frames_seen: In how many frames.
        spread_m: Root mean square distance of all its detections from the estimate. White noise gives
            about 1.7 times its deviation; more says that something moved, or was merged with a neighbour.
        name: Of a person who was recognised, or of furniture that has one of its own; None else.
        names, categories: As in ``Detection``.
        traits: Of a person: those that at least half of the frames tell.
        error: Of place and size, in the odometry frame; None when the detector declares none.
        alike: What else an object may be called, as far as at least half of the frames tell.
        picture: The newest that a frame tells of what is unsure, as in ``Detection``; None else.
        cut: Whether no frame shows all of it: it is at least so large.
        moves: As in ``Detection``, in the odometry frame.
    """

    category: Category
    kind: str
    color: str | None
    odom_T_object: Transform
    shape: Shape
    confidence: float
    frames_seen: int
    spread_m: float
    name: str | None = None
    names: tuple[str, ...] = ()
    categories: tuple[str, ...] = ()
    traits: tuple[str, ...] = ()
    error: PositionError | None = None
    alike: tuple[str, ...] = ()
    picture: bytes | None = None
    cut: bool = False
    moves: KnownPart | None = None

    @property
    def label(self) -> Label:
        """What it is called, and what it may be called as well."""
        if self.alike:
            return SeenLabel(self.kind, self.color, self.names, self.categories, self.traits, self.alike)
        return Label(self.kind, self.color, self.names, self.categories, self.traits)

    def may_be(self, kind: str, color: str | None) -> bool:
        """Whether it can be an object that was known before, by its kind and its colour.

        Args:
            kind: What that one is.
            color: Its colour; what was seen without one can have any.
        """
        return (
            self.category == "object"
            and (self.kind == kind or kind in self.alike)
            and self.color in (color, None)
        )

    @property
    def tilt_rad(self) -> float:
        """Angle of its own z axis to the vertical, in [0, pi]."""
        return math.acos(min(max(float(self.odom_T_object[2, 2]), -1.0), 1.0))

    @property
    def lying(self) -> bool:
        """Whether it is tipped over; a ball never is."""
        return not isinstance(self.shape, Ball) and self.tilt_rad > _STANDING_TILT_RAD


def _names(seen: Sequence[Detection]) -> tuple[str, ...]:
    """What most of some detections call a thing; a name that is not sure in some frames is not sure."""
    first = seen[0].names
    if all(detection.names == first for detection in seen):
        return first
    told = Counter(detection.names for detection in seen)
    most, count = max(told.items(), key=lambda item: (item[1], item[0]))
    return most if count > _SURE_SHARE * len(seen) else ()


def _alike(seen: Sequence[Detection], names: tuple[str, ...]) -> tuple[str, ...]:
    """What at least half of some detections say that a thing may be, or is."""
    if not any(detection.alike for detection in seen):
        return ()
    told = Counter(word for detection in seen for word in {*detection.alike, *detection.names})
    often = [word for word, count in told.items() if 2 * count >= len(seen) and word not in names]
    return tuple(sorted(often, key=lambda word: (-told[word], word)))


@dataclass(slots=True)
class _Cluster:
    """Detections of what is taken for one thing, at most one a frame.

    Places are plain numbers: there are few of them, and of few numpy's sums take ten times as long.
    """

    first: Detection
    positions: list[list[float]] = field(default_factory=list)
    rotations: list[Array] = field(default_factory=list)
    detections: list[Detection] = field(default_factory=list)
    camera: Transform = field(default_factory=lambda: np.eye(4))

    def add(self, detection: Detection, odom_T_object: Transform) -> None:
        self.detections.append(detection)
        self.positions.append(odom_T_object[:3, 3].tolist())
        self.rotations.append(odom_T_object[:3, :3])

    @property
    def centre(self) -> list[float]:
        return [_median(column) for column in zip(*self.positions, strict=True)]

    def _may_be_called(self, detection: Detection) -> bool:
        """Whether the names agree: of what may be something else, a frame may tell none."""
        if detection.names == self.first.names:
            return True
        unsure = bool(detection.alike or self.first.alike)
        return unsure and not (detection.names and self.first.names)

    def accepts(self, detection: Detection) -> bool:
        colors = {d.color for d in self.detections} - {None}
        return (
            detection.category == self.first.category
            and detection.kind == self.first.kind
            and detection.name == self.first.name
            and self._may_be_called(detection)
            and _is_part_of(detection, self.first)
            and type(detection.shape) is type(self.first.shape)
            and (detection.color is None or not colors or detection.color in colors)
        )


def _is_part_of(detection: Detection, first: Detection) -> bool:
    """Whether two detections may be of one door or drawer, as far as models tell that."""
    if detection.moves is None or first.moves is None:
        return detection.moves is first.moves
    return detection.moves.is_of(first.moves)


def fuse_frames(
    views: Sequence[tuple[Transform, PerceptionFrame]], min_frames: int = 3
) -> tuple[ObjectEstimate, ...]:
    """Estimate what is there from several frames.

    Detections of one kind (and no other colour) that are near each other are one thing; what fewer than
    ``min_frames`` frames show (all of them, when there are fewer) is not there. Position and size are
    the mean of those near the median, so that a detection that was merged with a neighbour does
    not pull; ``spread_m`` still tells of it. What stands is made vertical.

    Args:
        views: ``odom_T_camera`` at each frame's stamp, shape (4, 4), with the frame. A frame whose
            sequence number was there before is left out.
        min_frames: In how many frames a thing must have been seen.

    Returns:
        In order of category, kind, colour and place: the same views give the same order.
    """
    unique = {frame.sequence: (odom_T_camera, frame) for odom_T_camera, frame in reversed(views)}
    clusters: list[_Cluster] = []
    for sequence in sorted(unique):
        _assign(*unique[sequence], clusters)
    needed = min(min_frames, len(unique))
    kept = [cluster for cluster in clusters if len(cluster.detections) >= needed]
    estimates = [_estimate(cluster, len(unique)) for cluster in kept]
    return tuple(sorted(_one_name_each(estimates, len(unique)), key=_order))


def _assign(odom_T_camera: Transform, frame: PerceptionFrame, clusters: list[_Cluster]) -> None:
    """Give each detection of a frame to the nearest cluster within the gate, or a new one."""
    placed = [(detection, odom_T_camera @ detection.camera_T_object) for detection in frame.detections]
    centres = [cluster.centre for cluster in clusters]
    pairs = []
    for i, (detection, odom_T_object) in enumerate(placed):
        place = odom_T_object[:3, 3].tolist()
        gate = _OBJECT_GATE_M if detection.category == "object" else _FURNITURE_GATE_M
        for k, cluster in enumerate(clusters):
            distance = math.dist(place, centres[k])
            if distance < gate and cluster.accepts(detection):
                pairs.append((distance, i, k))
    used_detections: set[int] = set()
    used_clusters: set[int] = set()
    for _, i, k in sorted(pairs):
        if i not in used_detections and k not in used_clusters:
            clusters[k].add(*placed[i])
            clusters[k].camera = odom_T_camera
            used_detections.add(i)
            used_clusters.add(k)
    for i, (detection, odom_T_object) in enumerate(placed):
        if i not in used_detections:
            cluster = _Cluster(detection, camera=odom_T_camera)
            cluster.add(detection, odom_T_object)
            clusters.append(cluster)


def _estimate(cluster: _Cluster, frames: int) -> ObjectEstimate:
    centre = cluster.centre
    from_median = [math.dist(place, centre) for place in cluster.positions]
    near_m = max(_OUTLIER_M, 3.0 * _median(from_median))
    near = [i for i, away_m in enumerate(from_median) if away_m <= near_m]
    position = [fmean(column) for column in zip(*(cluster.positions[i] for i in near), strict=True)]
    off = [math.dist(place, position) for place in cluster.positions]
    inliers = [cluster.detections[i] for i in near]
    first = cluster.rotations[near[0]]
    turned = [_turned_like(first, cluster.rotations[i], cluster.detections[i].shape) for i in near]
    rotation = _mean_rotation([one for one, _ in turned])
    shape = _mean_shape([one for _, one in turned])
    colors = Counter(detection.color for detection in inliers if detection.color is not None)
    seen = len(cluster.detections)
    confidence = fmean(detection.confidence for detection in inliers)
    names = _names(inliers)
    return ObjectEstimate(
        category=cluster.first.category,
        kind=cluster.first.kind,
        color=min(colors, key=lambda c: (-colors[c], c)) if colors else None,
        odom_T_object=poses.transform(_upright(rotation, shape, cluster.first), position),
        shape=shape,
        confidence=confidence * (len(inliers) / frames) ** 0.5,
        frames_seen=seen,
        spread_m=math.hypot(*off) / math.sqrt(len(off)),
        name=cluster.first.name,
        names=names,
        categories=cluster.first.categories,
        traits=_traits(inliers),
        error=_error(cluster, inliers),
        alike=_alike(inliers, names),
        picture=inliers[-1].picture,
        cut=all(detection.cut for detection in inliers),
        moves=_moves(cluster, near),
    )


def _error(cluster: _Cluster, inliers: Sequence[Detection]) -> PositionError | None:
    """Of the mean of some detections, as the worst of them is; the camera hardly turns during a look."""
    told = [detection.error for detection in inliers if detection.error is not None]
    if len(told) < len(inliers) or not told:
        return None
    worst = told[0]
    for error in told[1:]:
        if error is not worst and np.trace(error.covariance_m2) > np.trace(worst.covariance_m2):
            worst = error
    return worst.averaged(len(told)).turned(cluster.camera[:3, :3])


def _moves(cluster: _Cluster, near: Sequence[int]) -> KnownPart | None:
    """Where a solid would be if its door or drawer were shut: the mean of what the frames tell."""
    told, shut = None, []
    for i in near:
        seen = cluster.detections[i]
        if seen.moves is None:
            return None
        told = seen.moves
        odom_T_solid = poses.transform(cluster.rotations[i], cluster.positions[i])
        shut.append(odom_T_solid @ poses.inverse(seen.camera_T_object) @ told.shut)
    if told is None:
        return None
    rotation = _mean_rotation([pose[:3, :3] for pose in shut])
    return replace(told, shut=poses.transform(rotation, np.mean([pose[:3, 3] for pose in shut], axis=0)))


def _traits(seen: Sequence[Detection]) -> tuple[str, ...]:
    """What at least half of some detections tell."""
    told = Counter(trait for detection in seen for trait in detection.traits)
    return tuple(sorted(trait for trait, count in told.items() if 2 * count >= len(seen)))


def _median(values: Iterable[float]) -> float:
    """A look has few frames, and of few numbers numpy's median takes thirty times as long."""
    return float(median(values))


def _turned_like(first: Array, rotation: Array, shape: Shape) -> tuple[Array, Shape]:
    """A plain box with its axes named as in another sighting of it: which side is x, each frame chooses."""
    if not isinstance(shape, Box) or shape.parts is not None:
        return rotation, shape
    quarters = round(poses.yaw_of(first.T @ rotation) / (0.5 * math.pi)) % 4
    if quarters == 0:
        return rotation, shape
    x, y, z = shape.size_m
    back = rotation @ poses.rotation_z(-0.5 * math.pi * quarters)
    return back, Box((y, x, z)) if quarters % 2 else shape


def _mean_rotation(rotations: Sequence[Array]) -> Array:
    """Chordal mean: the rotation nearest to the arithmetic mean (Markley et al. 2007)."""
    first, *others = [rotation.tolist() for rotation in rotations]
    if all(other == first for other in others):  # a detector that tracks what stands still tells the same
        return rotations[0]
    u, _, vt = np.linalg.svd(np.mean(rotations, axis=0))
    flip = np.diag([1.0, 1.0, float(np.sign(np.linalg.det(u @ vt)))])
    return np.asarray(u @ flip @ vt, dtype=np.float64)


def _upright(rotation: Array, shape: Shape, first: Detection) -> Array:
    """Vertical when it stands (heading kept, but for round things); else as it lies, or a knob is turned."""
    if first.kind in CONTROL_KINDS:
        return rotation
    if isinstance(shape, Ball) and shape.parts is None:
        return np.eye(3)
    if math.acos(min(max(float(rotation[2, 2]), -1.0), 1.0)) > _STANDING_TILT_RAD:
        return rotation
    faceless = isinstance(shape, Cylinder) and shape.parts is None and first.category != "person"
    return np.eye(3) if faceless else poses.rotation_z(poses.yaw_of(rotation))


def _mean_shape(shapes: Sequence[Shape]) -> Shape:
    """Mean size; by the median, so that merged detections do not widen it."""
    first = shapes[0]
    if first.parts is not None and all(shape == first for shape in shapes):
        return first
    if isinstance(first, Box):
        x, y, z = zip(*(shape.size_m for shape in shapes if isinstance(shape, Box)), strict=True)
        return Box((_median(x), _median(y), _median(z)))
    if isinstance(first, Cylinder):
        return Cylinder(
            _median(shape.radius_m for shape in shapes if isinstance(shape, Cylinder)),
            _median(shape.height_m for shape in shapes),
        )
    return Ball(_median(shape.radius_m for shape in shapes if isinstance(shape, Ball)))


def _one_name_each(estimates: Sequence[ObjectEstimate], frames: int) -> list[ObjectEstimate]:
    """Of objects of like size at the same place (a flickering kind or colour) keep the one seen most."""
    kept: list[ObjectEstimate] = []
    for estimate in sorted(estimates, key=lambda e: (-e.frames_seen, -e.confidence, *_order(e))):
        taken = estimate.category == "object" and any(
            other.category == "object"
            and math.dist(other.odom_T_object[:3, 3], estimate.odom_T_object[:3, 3]) < _SAME_PLACE_M
            and not _are_two(other, estimate, frames)
            for other in kept
        )
        if not taken:
            kept.append(estimate)
    return kept


def _are_two(one: ObjectEstimate, other: ObjectEstimate, frames: int) -> bool:
    """Whether two at one place are a thing, and what it is in."""
    together = one.frames_seen + other.frames_seen > frames
    return could_hold(one.shape, other.shape, _HOLDS_TOGETHER_FACTOR if together else _HOLDS_FACTOR)


def could_hold(a: Shape, b: Shape, factor: float = _HOLDS_FACTOR) -> bool:
    """Whether one of two solids is so much wider than the other is long that the other may be in it."""
    (a_width_m, a_length_m), (b_width_m, b_length_m) = _ground_m(a), _ground_m(b)
    return a_width_m > factor * b_length_m or b_width_m > factor * a_length_m


def _ground_m(shape: Shape) -> tuple[float, float]:
    """How wide and how long a solid is that stands."""
    if isinstance(shape, Box):
        return min(shape.size_m[:2]), max(shape.size_m[:2])
    return 2.0 * shape.radius_m, 2.0 * shape.radius_m


def _order(estimate: ObjectEstimate) -> tuple[str, str, str, float, float, float]:
    x, y, z = (float(value) for value in estimate.odom_T_object[:3, 3])
    return estimate.category, estimate.kind, estimate.color or "", x, y, z
