"""Everybody in a picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Cylinder
from robots.perception.rgbd.cloud import Cloud
from robots.perception.rgbd.colors import Light, light_of
from robots.perception.rgbd.people.body import (
    Body,
    gesture_of,
    in_line,
    limbs_near,
    lying_body,
    may_lie,
    may_stand,
    posture_of,
    trunk_axis,
)
from robots.perception.rgbd.people.clothes import clothes_of
from robots.perception.rgbd.people.heads import HEAD_M, Head, facing, find_head
from robots.perception.rgbd.people.pieces import EVERY, Piece, Pieces, pieces_of
from robots.scenes.person_solid import (
    LYING_HALF_WIDTH_M,
    LYING_HEIGHT_M,
    PERSON_REACH_M,
    SITTING_REACH_M,
)

FLOOR_RGB = (0.46, 0.50, 0.54)
"""Of the floor, in daylight: where no furniture tells the light, it does."""
_SITS_AHEAD_M = 0.17
_LEAST_FLOOR = 400
_LIKE_A_FACE, _BULGES_M = 0.4, 0.005
_NECK_M, _FEW = 0.12, 12
"""What is nearer than this to the line up through a head is above it, if it is as many points."""
_LARGEST_M2 = 0.75
"""Nobody shows more of himself."""


@dataclass(frozen=True, slots=True)
class SeenPerson(Sealed):
    """Somebody in a picture.

    Attributes:
        odom_T_person: x where the person faces, or from the feet to the head of who lies; the middle of
            ``shape``.
        shape: Around the whole person, as scenes have it; the height is measured.
        traits: Posture, gesture and clothes, as far as they can be told.
        confidence: In [0, 1].
        faces: Whether x was seen; it is towards the robot else.
    """

    odom_T_person: Transform
    shape: Box | Cylinder
    traits: tuple[str, ...]
    confidence: float
    faces: bool


def find_people(cloud: Cloud, light: Light) -> list[SeenPerson]:
    """Everybody whose head is in a picture, the nearest first.

    Args:
        cloud: The points.
        light: As furniture tells it.
    """
    pieces = pieces_of(cloud)
    if not light.known:
        light = _light_by_floor(cloud, light)
    found: list[tuple[float, SeenPerson, Array]] = []
    for piece in pieces.all:
        body = _body(cloud, piece, pieces)
        if body is None or any(np.linalg.norm(body.axis - other) < 0.35 for _, _, other in found):
            continue
        found.append((piece.depth_m, _told(cloud, body, light), body.axis))
    return [person for _, person, _ in sorted(found, key=lambda one: one[0])]


def _body(cloud: Cloud, piece: Piece, pieces: Pieces) -> Body | None:
    focal = cloud.picture.camera.focal_px / EVERY
    if piece.area_m2 < _LARGEST_M2 and may_stand(piece):
        head = find_head(cloud, piece)
        if head is None or not _ends_above(head, piece) or not _is_round(head, piece, cloud):
            return None
        axis = trunk_axis(head, piece.points, cloud.odom_T_camera[:3, 3])
        if not _has_trunk(head, piece):
            return None
        limbs = limbs_near(head, axis, piece, pieces.all)
        points, pixels = _together([piece, *limbs])
        area = (float(np.linalg.norm(head.middle - cloud.odom_T_camera[:3, 3])) / focal) ** 2
        return Body(head, axis, posture_of(head, points, axis), points, pixels, None, area)
    if may_lie(piece):
        points, pixels = _together([piece, *in_line(piece, pieces.all)])
        lying = lying_body(points)
        if lying is None:
            return None
        middle, along, length = lying
        crown = middle + (0.5 * length - HEAD_M) * along
        head = Head(np.array([*crown, HEAD_M]), 0.0, 0.0, 0.0, 1.0)
        return Body(head, middle, "lying", points, pixels, along, (piece.depth_m / focal) ** 2)
    return None


def _ends_above(head: Head, piece: Piece) -> bool:
    """Whether nothing goes on above a head to where the picture ends: what does is a trunk with its neck."""
    if piece.rows.min() > 0:
        return True
    beside = np.linalg.norm(piece.points[:, :2] - head.middle[:2], axis=1)
    above = piece.points[:, 2] > head.middle[2] + HEAD_M
    return int((above & (beside < _NECK_M)).sum()) < _FEW


def _has_trunk(head: Head, piece: Piece) -> bool:
    """Whether something as wide as shoulders is below a head."""
    below = head.middle[2] - piece.points[:, 2]
    near = np.linalg.norm(piece.points[:, :2] - head.middle[:2], axis=1) < 0.35
    chest = piece.points[(below > 0.20) & (below < 0.50) & near]
    if len(chest) < 20 or int((near & (below > 0.33) & (below < 0.50)).sum()) < 12:
        return False
    wide = chest[:, :2] - chest[:, :2].mean(axis=0)
    spread = np.linalg.svd(wide, compute_uv=False) / len(wide) ** 0.5
    return bool(0.05 < spread[0] < 0.35)


def _is_round(head: Head, piece: Piece, cloud: Cloud) -> bool:
    """Whether what is below a head is no board: it bulges, or hair and a face are above it."""
    if facing(cloud, head, 255.0)[1] > _LIKE_A_FACE:
        return True
    below = head.middle[2] - piece.points[:, 2]
    near = np.linalg.norm(piece.points[:, :2] - head.middle[:2], axis=1) < 0.20
    chest = piece.points[(below > 0.25) & (below < 0.60) & near][:, :2]
    if len(chest) < 30:
        return False
    thick = float(np.linalg.svd(chest - chest.mean(axis=0), compute_uv=False)[1]) / len(chest) ** 0.5
    return bool(thick > _BULGES_M + cloud.picture.camera.errors.depth_sigma_m(piece.depth_m))


def _together(pieces: list[Piece]) -> tuple[Array, NDArray[np.int64]]:
    points = np.concatenate([piece.points for piece in pieces])
    pixels = np.concatenate([np.column_stack([piece.rows, piece.columns]) for piece in pieces])
    return points, pixels * EVERY


def _told(cloud: Cloud, body: Body, light: Light) -> SeenPerson:
    eye = cloud.odom_T_camera[:3, 3]
    clothes = clothes_of(body, cloud.picture.color, light)
    if body.along is not None:
        yaw = float(np.arctan2(body.along[1], body.along[0]))
        box = Box((1.75, 2.0 * LYING_HALF_WIDTH_M, LYING_HEIGHT_M))
        pose = poses.transform(poses.rotation_z(yaw), (*body.axis, 0.5 * LYING_HEIGHT_M))
        return SeenPerson(pose, box, ("lying", *clothes), 0.9, True)
    seen, _ = facing(cloud, body.head, light.level)
    yaw = float(np.arctan2(*(eye[:2] - body.axis)[::-1])) if seen is None else seen
    gesture = gesture_of(body, seen)
    posture = () if body.posture is None else (body.posture,)
    height = float(body.head.middle[2]) + HEAD_M
    sits = body.posture == "sitting"
    ahead = _SITS_AHEAD_M if sits else 0.0
    place = body.axis + ahead * np.array([np.cos(yaw), np.sin(yaw)])
    shape = Cylinder(SITTING_REACH_M if sits else PERSON_REACH_M, height)
    pose = poses.transform(poses.rotation_z(yaw), (*place, 0.5 * height))
    traits = (*posture, *(() if gesture is None else (gesture,)), *clothes)
    return SeenPerson(pose, shape, traits, 0.95 if posture else 0.7, seen is not None)


def _light_by_floor(cloud: Cloud, light: Light) -> Light:
    """The light as the floor shows it, if enough of that is in view."""
    part = (slice(None, None, 2), slice(None, None, 2))
    floor = cloud.there[part] & (np.abs(cloud.z[part]) < np.float32(0.04))
    return light_of(cloud.picture.color, floor, FLOOR_RGB) if int(floor.sum()) > _LEAST_FLOOR else light
