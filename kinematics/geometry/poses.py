"""Rigid transforms as 4x4 homogeneous matrices.

``world_T_tool`` maps tool coordinates into the world: ``p_world = world_T_tool @ p_tool``.
Lengths are metres, angles radians.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

Transform = NDArray[np.float64]
"""A homogeneous transform, shape (4, 4)."""


def transform(rotation: ArrayLike, translation: ArrayLike) -> Transform:
    """Put a rotation, shape (3, 3), and a translation, shape (3,), into one transform."""
    a_T_b = np.zeros((4, 4))
    a_T_b[:3, :3] = rotation
    a_T_b[:3, 3] = translation
    a_T_b[3, 3] = 1.0
    return a_T_b


def translation(x: float, y: float, z: float) -> Transform:
    """Return the transform that only moves."""
    return transform(np.eye(3), (x, y, z))


def inverse(a_T_b: Transform) -> Transform:
    """Return ``b_T_a``, using that the rotation's inverse is its transpose."""
    rotation = a_T_b[:3, :3].T
    return transform(rotation, -rotation @ a_T_b[:3, 3])


def rotation_x(angle_rad: float) -> NDArray[np.float64]:
    """Rotation about x, shape (3, 3)."""
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    return np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])


def rotation_y(angle_rad: float) -> NDArray[np.float64]:
    """Rotation about y, shape (3, 3)."""
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    return np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])


def rotation_z(angle_rad: float) -> NDArray[np.float64]:
    """Rotation about z, shape (3, 3)."""
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def rotations_y(angles_rad: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rotations about y by each angle, shape (n,) to (n, 3, 3)."""
    c, s = np.cos(angles_rad), np.sin(angles_rad)
    found = np.zeros((len(angles_rad), 3, 3))
    found[:, 0, 0], found[:, 0, 2], found[:, 1, 1] = c, s, 1.0
    found[:, 2, 0], found[:, 2, 2] = -s, c
    return found


def rotations_z(angles_rad: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rotations about z by each angle, shape (n,) to (n, 3, 3)."""
    c, s = np.cos(angles_rad), np.sin(angles_rad)
    found = np.zeros((len(angles_rad), 3, 3))
    found[:, 0, 0], found[:, 0, 1] = c, -s
    found[:, 1, 0], found[:, 1, 1], found[:, 2, 2] = s, c, 1.0
    return found


def rotation_from_vector(vector_rad: ArrayLike) -> NDArray[np.float64]:
    """Rotation of a rotation vector (axis times angle), by Rodrigues' formula."""
    w = np.asarray(vector_rad, dtype=np.float64)
    angle = float(np.linalg.norm(w))
    skew = np.array([[0.0, -w[2], w[1]], [w[2], 0.0, -w[0]], [-w[1], w[0], 0.0]])
    if angle < 1e-9:
        return np.asarray(np.eye(3) + skew)
    a, b = math.sin(angle) / angle, (1.0 - math.cos(angle)) / angle**2
    return np.asarray(np.eye(3) + a * skew + b * (skew @ skew))


def vector_from_rotation(rotation: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rotation vector, shape (3,), of a rotation matrix; its length is in [0, pi]."""
    x, y, z, w = quaternion_from_rotation(rotation)
    v = np.array([x, y, z])
    if w < 0.0:
        v, w = -v, -w
    norm = float(np.linalg.norm(v))
    if norm < 1e-12:
        return 2.0 * v
    return v * (2.0 * math.atan2(norm, w) / norm)


def quaternion_from_rotation(rotation: NDArray[np.float64]) -> NDArray[np.float64]:
    """Unit quaternion (x, y, z, w) of a rotation matrix, by Shepperd's method."""
    # Plain numbers: calls on arrays of three would take five times as long.
    (a, b, c), (d, e, f), (g, h, i) = rotation.tolist()
    trace = a + e + i
    largest = max(a, e, i, trace)
    if a == largest:
        q = (1.0 + a - e - i, b + d, c + g, h - f)
    elif e == largest:
        q = (b + d, 1.0 + e - i - a, f + h, c - g)
    elif i == largest:
        q = (c + g, f + h, 1.0 + i - a - e, d - b)
    else:
        q = (h - f, c - g, d - b, 1.0 + trace)
    x, y, z, w = q
    return np.array(q) / math.sqrt(x * x + y * y + z * z + w * w)


def quaternions_from_rotations(rotations: NDArray[np.float64]) -> NDArray[np.float64]:
    """Unit quaternions (x, y, z, w) of rotation matrices, shape (n, 3, 3) to (n, 4), by Shepperd's method."""
    (a, b, c), (d, e, f), (g, h, i) = np.moveaxis(rotations, 0, 2)
    # four times the outer product of each quaternion with itself: the largest row is well conditioned
    outer = np.array(
        [
            [1.0 + a - e - i, b + d, c + g, h - f],
            [b + d, 1.0 - a + e - i, f + h, c - g],
            [c + g, f + h, 1.0 - a - e + i, d - b],
            [h - f, c - g, d - b, 1.0 + a + e + i],
        ]
    )
    largest = np.argmax(np.einsum("kkn->kn", outer), axis=0)
    rows = outer[largest, :, np.arange(len(rotations))]
    return np.asarray(rows / np.linalg.norm(rows, axis=1, keepdims=True), dtype=np.float64)


def rotation_from_quaternion(xyzw: ArrayLike) -> NDArray[np.float64]:
    """Rotation matrix of a quaternion (x, y, z, w), normalised first."""
    q = np.asarray(xyzw, dtype=np.float64)
    x, y, z, w = q / np.linalg.norm(q)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def angle_between(rotation_a: NDArray[np.float64], rotation_b: NDArray[np.float64]) -> float:
    """Angle in radians of the rotation that takes one into the other."""
    return float(np.linalg.norm(vector_from_rotation(rotation_a.T @ rotation_b)))


def interpolate(a: Transform, b: Transform, fraction: float) -> Transform:
    """Straight line in position, constant-axis rotation, at ``fraction`` in [0, 1]."""
    place = (1.0 - fraction) * a[:3, 3] + fraction * b[:3, 3]
    if np.array_equal(a[:3, :3], b[:3, :3]):
        return transform(a[:3, :3], place)
    turn = vector_from_rotation(a[:3, :3].T @ b[:3, :3])
    rotation = a[:3, :3] @ rotation_from_vector(fraction * turn)
    return transform(rotation, place)


def line(a: Transform, b: Transform, points: int) -> NDArray[np.float64]:
    """``interpolate`` at evenly spaced fractions, both ends included, shape (points, 4, 4)."""
    if not np.array_equal(a[:3, :3], b[:3, :3]):
        return np.array([interpolate(a, b, k / (points - 1)) for k in range(points)])
    found = np.empty((points, 4, 4))
    found[:] = a
    fraction = np.arange(points)[:, None] / (points - 1)
    found[:, :3, 3] = (1.0 - fraction) * a[:3, 3] + fraction * b[:3, 3]
    return found


def yaw_of(rotation: NDArray[np.float64]) -> float:
    """Heading in radians: the angle of the x axis in the horizontal plane."""
    return math.atan2(float(rotation[1, 0]), float(rotation[0, 0]))
