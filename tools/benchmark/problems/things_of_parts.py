"""Household things of convex parts, made at random: mugs, bowls, bottles, plates, as imported meshes are."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.shapes import Box

AROUND = 12
"""Pieces that a round wall is cut into."""
_SIDES = 20
_WALL_M = 0.004


def prism(radius_m: float, low_m: float, high_m: float, top_radius_m: float | None = None) -> Array:
    """Corners of a round piece, shape (2 * sides, 3)."""
    angles = 2.0 * math.pi * np.arange(_SIDES) / _SIDES
    ring = np.column_stack([np.cos(angles), np.sin(angles)])
    top = radius_m if top_radius_m is None else top_radius_m
    low = np.column_stack([radius_m * ring, np.full(_SIDES, low_m)])
    return np.concatenate([low, np.column_stack([top * ring, np.full(_SIDES, high_m)])])


def _wall(radius_m: float, low_m: float, high_m: float, top_radius_m: float) -> list[Array]:
    """A round wall, open inside: each piece has eight corners."""
    pieces = []
    for k in range(AROUND):
        ends = 2.0 * math.pi * np.array([k, k + 1]) / AROUND
        ring = np.column_stack([np.cos(ends), np.sin(ends)])
        levels = ((low_m, radius_m), (high_m, top_radius_m))
        piece = [
            np.column_stack([(outer - inside) * ring, np.full(2, z)])
            for z, outer in levels
            for inside in (0.0, _WALL_M)
        ]
        pieces.append(np.concatenate(piece))
    return pieces


def _mug(rng: np.random.Generator) -> list[Array]:
    radius, high = float(rng.uniform(0.035, 0.045)), float(rng.uniform(0.08, 0.11))
    bars = np.array([[x, y, z] for x in (0.0, 0.01) for y in (-0.005, 0.005) for z in (0.0, 0.01)])
    out = radius + 0.025
    handle = [
        bars * (2.5, 1.0, 1.0) + (radius, 0.0, 0.2 * high),
        bars * (2.5, 1.0, 1.0) + (radius, 0.0, 0.7 * high),
        bars * (1.0, 1.0, 0.05 * high / 0.001) + (out - 0.01, 0.0, 0.2 * high),
    ]
    return [prism(radius, 0.0, _WALL_M), *_wall(radius, _WALL_M, high, radius), *handle]


def _bowl(rng: np.random.Generator) -> list[Array]:
    foot, rim = float(rng.uniform(0.03, 0.04)), float(rng.uniform(0.05, 0.055))
    return [prism(foot, 0.0, _WALL_M), *_wall(foot, _WALL_M, float(rng.uniform(0.05, 0.07)), rim)]


def _bottle(rng: np.random.Generator) -> list[Array]:
    radius, high = float(rng.uniform(0.03, 0.038)), float(rng.uniform(0.18, 0.24))
    neck = 0.4 * radius
    return [
        prism(radius, 0.0, 0.6 * high),
        prism(radius, 0.6 * high, 0.75 * high, neck),
        prism(neck, 0.75 * high, high),
    ]


def _plate(rng: np.random.Generator) -> list[Array]:
    foot = float(rng.uniform(0.03, 0.035))
    return [prism(foot, 0.0, 0.005), *_wall(foot, 0.005, float(rng.uniform(0.02, 0.03)), 0.055)]


KINDS: tuple[Callable[[np.random.Generator], list[Array]], ...] = (_mug, _bowl, _bottle, _plate)


def thing(rng: np.random.Generator) -> Box:
    """One of them in the box that holds it."""
    return boxed(KINDS[int(rng.integers(len(KINDS)))](rng))


def boxed(hulls: list[Array]) -> Box:
    """Convex pieces as one thing, in the box that holds it."""
    corners, ends = parts_of(hulls)
    low, high = corners.min(axis=0), corners.max(axis=0)
    x, y, z = (high - low).tolist()
    return Box((x, y, z), made_of(corners - 0.5 * (low + high), ends))


def parts_of(hulls: list[Array]) -> tuple[Array, tuple[int, ...]]:
    """All corners, shape (n, 3), and the row behind the last one of each piece."""
    return np.concatenate(hulls), tuple(int(end) for end in np.cumsum([len(hull) for hull in hulls]))


def made_of(corners: Array, ends: tuple[int, ...]) -> ConvexParts:
    """Parts whose key tells their corners."""
    return ConvexParts(hashlib.sha256(corners.tobytes()).hexdigest(), corners, ends)
