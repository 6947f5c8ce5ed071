"""One estimate of each thing from several cameras, and what they do not agree on."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from robots.perception.detector import Detector
from robots.perception.fusion.gaussian import Gaussian, Innovation, Measurement
from robots.perception.object_estimate import ObjectEstimate
from robots.perception.position_error import PositionError

HEAD = "head camera"
_SAME_M = {"object": 0.06, "furniture": 0.12, "person": 0.3}
"""What two cameras show of one kind nearer to each other than this is one thing."""


@dataclass(frozen=True, slots=True)
class PlacedCamera(Sealed):
    """A camera that does not move with the robot.

    Attributes:
        name: What people call it: "ceiling camera".
        detector: Its frames; poses in them are relative to it.
        odom_T_camera: Where it is, from its calibration, shape (4, 4); what that is wrong by is part of the
            error that the detector declares.
    """

    name: str
    detector: Detector
    odom_T_camera: Transform


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
    that comes first does. Of a detector that declares no error the first camera's word counts.

    Args:
        by_camera: What each shows, in the odometry frame; the one that is trusted most first.
    """
    merged: list[ObjectEstimate] = []
    differing: list[tuple[ObjectEstimate, Innovation]] = []
    for name, estimates in by_camera.items():
        before = len(merged)
        taken: set[int] = set()
        for estimate in estimates:
            k = _same(estimate, merged[:before], taken)
            if k is None:
                merged.append(estimate)
                continue
            taken.add(k)
            innovation, both = _fused(merged[k], estimate, name)
            if innovation is not None and innovation.disagrees:
                differing.append((merged[k], innovation))
            else:
                merged[k] = both
    shows = {name: bool(estimates) for name, estimates in by_camera.items()}
    blind = tuple(name for name, some in shows.items() if not some) if any(shows.values()) else ()
    return Seen(tuple(merged), tuple(differing), blind)


def _same(estimate: ObjectEstimate, others: Sequence[ObjectEstimate], taken: set[int]) -> int | None:
    """Which of the others is the same thing; the nearest, or None."""
    near = [
        (math.dist(other.odom_T_object[:3, 3], estimate.odom_T_object[:3, 3]), k)
        for k, other in enumerate(others)
        if k not in taken
        and (other.category, other.kind, other.name) == (estimate.category, estimate.kind, estimate.name)
        and type(other.shape) is type(estimate.shape)
        and (None in (other.color, estimate.color) or other.color == estimate.color)
    ]
    distance_m, k = min(near, default=(math.inf, -1))
    return k if distance_m < _SAME_M[estimate.category] else None


def _fused(
    first: ObjectEstimate, second: ObjectEstimate, source: str
) -> tuple[Innovation | None, ObjectEstimate]:
    if first.error is None or second.error is None:
        return None, first
    start = Gaussian(first.odom_T_object[:3, 3], first.error.covariance_m2)
    measured = Measurement(source, 0.0, second.odom_T_object[:3, 3], second.error.covariance_m2, np.eye(3))
    both = start.updated(measured)
    pose = first.odom_T_object.copy()
    pose[:3, 3] = both.mean
    size_share = min(first.error.size_share, second.error.size_share)
    # what is left does not average away over more frames
    error = PositionError(both.covariance, np.zeros((3, 3)), size_share)
    return start.innovation(measured), replace(
        first,
        odom_T_object=pose,
        error=error,
        color=first.color or second.color,
        frames_seen=first.frames_seen + second.frames_seen,
        confidence=max(first.confidence, second.confidence),
    )
