"""Cutting a mesh into few convex parts of few corners, and points on their common surface."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, Indices
from robots.scenes.importing.extra import library

MOST_PARTS = 16
MOST_CORNERS = 40
TOLERANCE_M = 0.0007
"""Corners are left out of a part as long as none of them is farther from the rest."""
CONVEX_SHARE = 0.97
"""What fills so much of its hull is one part."""
_MOST_FACES = 2000
_CONCAVITY = 0.08
_RESOLUTION = 500
_PREPROCESSED = 30
_TRIED, _AT_ONCE, _AHEAD = 60, 10, 2
"""Of the search for a cut: four times as many find hardly better ones."""
_SAMPLES = 1600
_INSIDE_M = 0.0003
_THINNEST_M = 0.0004


def convex_parts(vertices: Array, faces: NDArray[np.int32], seed: int = 0) -> list[Array]:
    """Corners of the parts, each shape (k, 3), m; the largest first."""
    trimesh = library("trimesh")
    mesh = trimesh.Trimesh(vertices, faces, process=True)
    hull = mesh.convex_hull
    bodies = mesh.split(only_watertight=False, repair=False) if mesh.body_count <= MOST_PARTS else ()
    if len(bodies) and all(_is_convex(body) for body in bodies):
        hulls = [of_few_corners(np.asarray(body.vertices)) for body in bodies]
        return sorted(hulls, key=lambda one: -volume(one))
    simple = _simplified(trimesh, mesh)
    coacd = library("coacd")
    coacd.set_log_level("error")
    found = coacd.run_coacd(
        coacd.Mesh(np.asarray(simple.vertices), np.asarray(simple.faces)),
        threshold=_CONCAVITY,
        max_convex_hull=MOST_PARTS,
        # what is closed is cut as it is: made anew from voxels it has many times the triangles
        preprocess_mode="off" if simple.is_watertight else "on",
        preprocess_resolution=_PREPROCESSED,
        resolution=_RESOLUTION,
        mcts_iterations=_TRIED,
        mcts_nodes=_AT_ONCE,
        mcts_max_depth=_AHEAD,
        seed=seed,
    )
    hulls = [of_few_corners(np.asarray(corners, np.float64)) for corners, _ in found if _is_solid(corners)]
    return sorted(hulls or [of_few_corners(np.asarray(hull.vertices))], key=lambda one: -volume(one))


def _is_convex(mesh: Any) -> bool:
    return bool(mesh.is_watertight and mesh.volume >= CONVEX_SHARE * mesh.convex_hull.volume)


def _is_solid(corners: Any) -> bool:
    points = np.asarray(corners, np.float64)
    if len(points) < 4:
        return False
    off = points - points.mean(axis=0)
    thin = off @ np.linalg.svd(off, full_matrices=False)[2][2]
    return bool(np.ptp(thin) > _THINNEST_M)


def _simplified(trimesh: Any, mesh: Any) -> Any:
    """The same with fewer triangles: corners that are in one cell of a grid become one."""
    cells = 64
    while len(mesh.faces) > _MOST_FACES and cells > 8:
        step = float(np.ptp(mesh.vertices, axis=0).max()) / cells
        key = np.floor((mesh.vertices - mesh.vertices.min(axis=0)) / step).astype(np.int64)
        of = np.unique(key, axis=0, return_inverse=True)[1].ravel()
        count = np.bincount(of)
        points = np.stack([np.bincount(of, mesh.vertices[:, k]) / count for k in range(3)], axis=1)
        faces = of[mesh.faces]
        whole = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 0] != faces[:, 2])
        mesh = trimesh.Trimesh(points, np.unique(faces[whole], axis=0), process=True)
        cells = int(cells / 1.4)
    return mesh


def volume(corners: Array) -> float:
    """Of a part, m3."""
    return float(library("scipy.spatial").ConvexHull(corners).volume)


def middle_of(hulls: Sequence[Array]) -> Array:
    """Centre of mass of parts of even density, each shape (k, 3), as the simulator has it; shape (3,), m."""
    meshes = [library("trimesh").convex.convex_hull(hull) for hull in hulls]
    middles = [np.asarray(mesh.center_mass) for mesh in meshes]
    return np.asarray(np.average(middles, axis=0, weights=[float(mesh.volume) for mesh in meshes]))


def of_few_corners(corners: Array) -> Array:
    """Those corners of a hull, shape (n, 3), without which it would be another, shape (k, 3)."""
    spatial = library("scipy.spatial")
    corners = corners[spatial.ConvexHull(corners).vertices]
    directions = np.array(
        [(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1) if (x, y, z) != (0, 0, 0)]
    )
    chosen: list[int] = sorted({int(k) for k in np.argmax(corners @ directions.T, axis=0)})
    while len(chosen) < min(MOST_CORNERS, len(corners)):
        beyond = _beyond(spatial, corners, chosen)
        farthest = int(np.argmax(beyond))
        if beyond[farthest] <= TOLERANCE_M:
            break
        chosen.append(farthest)
    return np.asarray(corners[sorted(chosen)])


def _beyond(spatial: Any, corners: Array, chosen: Sequence[int]) -> Array:
    """How far each corner is outside of the hull of some."""
    try:
        planes = spatial.ConvexHull(corners[chosen]).equations
    except spatial.QhullError:  # those are in one plane
        off = np.linalg.norm(corners[:, None] - corners[chosen], axis=2).min(axis=1)
        return np.asarray(off + TOLERANCE_M * (off > 0.0))
    return np.asarray((corners @ planes[:, :3].T + planes[:, 3]).max(axis=1))


def surface_of(hulls: Sequence[Array], seed: int = 0) -> tuple[Array, Array]:
    """Points on the surface of all parts together, and outward normals there, shape (n, 3) each."""
    trimesh, spatial = library("trimesh"), library("scipy.spatial")
    rng = np.random.default_rng(seed)
    meshes = [trimesh.convex.convex_hull(hull) for hull in hulls]
    area = np.array([mesh.area for mesh in meshes])
    counts: Indices = np.maximum(12, _SAMPLES * area / area.sum()).astype(np.int64)
    points, normals = [], []
    for mesh, count in zip(meshes, counts, strict=True):
        found, faces = trimesh.sample.sample_surface(mesh, int(count), seed=rng)
        points.append(np.asarray(found))
        normals.append(np.asarray(mesh.face_normals)[faces])
    planes = [spatial.ConvexHull(hull).equations for hull in hulls]
    kept = []
    for own, some in enumerate(points):
        outside = np.ones(len(some), bool)
        for other, equations in enumerate(planes):
            if other != own:
                outside &= (some @ equations[:, :3].T + equations[:, 3]).max(axis=1) > -_INSIDE_M
        kept.append(outside)
    which = np.concatenate(kept)
    order = rng.permutation(int(which.sum()))
    return np.concatenate(points)[which][order], np.concatenate(normals)[which][order]
