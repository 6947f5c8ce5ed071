"""One estimate of each thing from several cameras, and what they do not agree on."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Cylinder
from robots.perception.detector import Detector
from robots.perception.fusion.gaussian import Gaussian, Innovation, Measurement
from robots.perception.fusion.registration import registrations
from robots.perception.object_estimate import ObjectEstimate, could_hold
from robots.perception.position_error import PositionError
from robots.scenes.fixed_camera import HEAD_CAMERA
from robots.scenes.scene_description import SceneDescription

HEAD = HEAD_CAMERA
_SAME_M = {"object": 0.06, "furniture": 0.12, "person": 0.3}
"""What two cameras show of one kind nearer to each other than this is one thing."""
_ONE_PLACE_M = 0.03
"""And so is what they show of two kinds, or colours: no two things have their middles so near to each other,
unless one of them holds the other."""
_LEVEL_M = 0.01
"""What two cameras show to begin, and to end, within this of each other is as high."""
_WELL_WITHIN = 0.8
"""Of half the field of view: what is nearer to a picture's edge may be cut."""


@dataclass(frozen=True, slots=True)
class PlacedCamera(Sealed):
    """A camera that does not move with the robot.

    Attributes:
        name: What people call it: "ceiling camera".
        detector: Its frames; poses in them are relative to it.
        odom_T_camera: Where it is, from its calibration, shape (4, 4); what that is wrong by is part of the
            error that the detector declares.
        field_of_view_rad: Across and down.
        range_m: Nearest and farthest that it shows.
    """

    name: str
    detector: Detector
    odom_T_camera: Transform
    field_of_view_rad: tuple[float, float] = (1.1, 0.85)
    range_m: tuple[float, float] = (0.3, 8.0)

    def should_show(self, place_m: Array) -> bool:
        """Whether a place, shape (3,), is well within its pictures."""
        x, y, z = (self.odom_T_camera[:3, :3].T @ (place_m - self.odom_T_camera[:3, 3])).tolist()
        across, down = self.field_of_view_rad
        within = abs(math.atan2(x, z)) <= 0.5 * _WELL_WITHIN * across
        within &= abs(math.atan2(y, z)) <= 0.5 * _WELL_WITHIN * down
        return within and self.range_m[0] <= z <= self.range_m[1]


def calibrated_places(scene: SceneDescription) -> tuple[Transform, ...]:
    """``odom_T_camera`` of each camera that stands in a scene, shape (4, 4), as its calibration has it.

    The odometry frame is where the robot stands at first: that is where it was calibrated to them.
    """
    start = scene.robot_start
    world_T_odom = poses.transform(poses.rotation_z(start.yaw_rad), (start.x_m, start.y_m, 0.0))
    return tuple(poses.inverse(world_T_odom) @ camera.world_T_camera for camera in scene.cameras)


@dataclass(frozen=True, slots=True)
class Seen:
    """What several cameras show together.

    Attributes:
        estimates: Each thing once.
        differing: Things that two cameras show at different places, with by how much.
        blind: Cameras that show nothing at all while another one shows something.
    """

    estimates: tuple[ObjectEstimate, ...]
    differing: tuple[tuple[ObjectEstimate, Innovation], ...]
    blind: tuple[str, ...]


def seen_by_all(by_camera: Mapping[str, Sequence[ObjectEstimate]]) -> Seen:
    """Fuse what several cameras show.

    Where two cameras agree on a place, both count by their declared errors; where they do not, the camera
    that comes first does. What all things that both show are apart by tells what their calibrations are wrong
    by, and moves what only one of them shows as well. Of a detector that declares no error the first camera's
    word counts. What one of them takes for another kind or colour is what the surer one takes it for.

    Args:
        by_camera: What each shows, in the odometry frame; the one that is trusted most first.
    """
    merged: list[ObjectEstimate] = []
    differing: list[tuple[ObjectEstimate, Innovation]] = []
    for name, estimates in by_camera.items():
        seen, pairs = list(estimates), _pairs(merged, estimates)
        apart = {k: _apart(merged[i], seen[k], name) for k, i in pairs.items()}
        differing += [(merged[pairs[k]], far) for k, far in apart.items() if far is not None]
        agreed = {k: i for k, i in pairs.items() if apart[k] is None}
        if (moves := registrations([(merged[i], seen[k]) for k, i in agreed.items()])) is not None:
            merged, seen = list(map(moves[0].moved, merged)), list(map(moves[1].moved, seen))
        for k, estimate in enumerate(seen):
            if k in agreed:
                merged[agreed[k]] = _fused(merged[agreed[k]], estimate, name)
            elif k not in pairs:
                merged.append(estimate)
    shows = {name: bool(estimates) for name, estimates in by_camera.items()}
    blind = tuple(name for name, some in shows.items() if not some) if any(shows.values()) else ()
    return Seen(tuple(merged), tuple(differing), blind)


def _pairs(known: Sequence[ObjectEstimate], seen: Sequence[ObjectEstimate]) -> dict[int, int]:
    """Which of the known things each seen one is, by their indices; the nearest pairs first, each once."""
    near = sorted(
        (math.dist(one.odom_T_object[:3, 3], other.odom_T_object[:3, 3]), k, i)
        for k, one in enumerate(seen)
        for i, other in enumerate(known)
        if _may_be_one(one, other)
    )
    pairs: dict[int, int] = {}
    for _, k, i in near:
        if k not in pairs and i not in pairs.values():
            pairs[k] = i
    return pairs


def _may_be_one(one: ObjectEstimate, other: ObjectEstimate) -> bool:
    if one.category != other.category:
        return False
    apart_m = math.dist(one.odom_T_object[:3, 3], other.odom_T_object[:3, 3])
    alike = (
        (one.kind, one.name) == (other.kind, other.name)
        and type(one.shape) is type(other.shape)
        and (None in (one.color, other.color) or one.color == other.color)
    )
    if alike:
        return apart_m < _SAME_M[one.category]
    if one.category != "object" or apart_m >= _ONE_PLACE_M:
        return False
    return _as_high(one, other) or not could_hold(one.shape, other.shape)


def _as_high(one: ObjectEstimate, other: ObjectEstimate) -> bool:
    """Whether two things begin and end at one height; what is in another stands on its bottom."""
    halves = [
        (float(each.odom_T_object[2, 3]), 0.5 * each.shape.height_m)
        for each in (one, other)
        if isinstance(each.shape, Box | Cylinder)
    ]
    if len(halves) < 2:
        return False
    (z, half), (other_z, other_half) = halves
    apart_m = abs(z - half - other_z + other_half), abs(z + half - other_z - other_half)
    return max(apart_m) < _LEVEL_M


def _apart(first: ObjectEstimate, second: ObjectEstimate, source: str) -> Innovation | None:
    """By how much two cameras show a thing at different places, where both may not be wrong by so much."""
    if first.error is None or second.error is None:
        return None
    start = Gaussian(first.odom_T_object[:3, 3], first.error.covariance_m2)
    place = second.odom_T_object[:3, 3]
    found = start.innovation(Measurement(source, 0.0, place, second.error.covariance_m2, np.eye(3)))
    return found if found.disagrees else None


def _fused(first: ObjectEstimate, second: ObjectEstimate, source: str) -> ObjectEstimate:
    """One estimate of what two cameras agree on, whose calibrations have been compared."""
    if first.error is None or second.error is None:
        return first
    start = Gaussian(first.odom_T_object[:3, 3], first.error.own_m2)
    place = second.odom_T_object[:3, 3]
    both = start.updated(Measurement(source, 0.0, place, second.error.own_m2, np.eye(3)))
    shared = first.error.shared_m2
    # sizes, and where the edges are, are those of who measures them better
    better = second.error.size_share < first.error.size_share
    measures, size_share = (second, second.error.size_share) if better else (first, first.error.size_share)
    words = second if second.confidence > first.confidence and not _same_words(first, second) else first
    pose = measures.odom_T_object.copy()
    pose[:3, 3] = both.mean
    # what is left does not average away over more frames
    error = PositionError(both.covariance + shared, np.zeros((3, 3)), size_share, shared)
    return replace(
        words,
        odom_T_object=pose,
        shape=measures.shape,
        error=error,
        color=words.color or first.color or second.color,
        frames_seen=first.frames_seen + second.frames_seen,
        confidence=max(first.confidence, second.confidence),
    )


def _same_words(one: ObjectEstimate, other: ObjectEstimate) -> bool:
    return (one.kind, one.color, one.names) == (other.kind, other.color, other.names)
