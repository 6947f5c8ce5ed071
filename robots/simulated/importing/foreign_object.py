"""An object of a foreign model, made of the solids that its maker gave it."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.formats.solid_document import MAX_PARTS
from kinematics.geometry import poses
from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.poses import Transform
from robots.scenes.importing.convex import convex_parts, middle_of, of_few_corners, surface_of, volume
from robots.scenes.importing.extra import library
from robots.scenes.importing.outline import fitted, turn_of
from robots.scenes.importing.resting import rests_of
from robots.scenes.importing.seen_color import said_color, seen_surface
from robots.scenes.meshes.object_model import GREY, ObjectModel
from robots.simulated.importing.bodies import Foreign
from robots.simulated.importing.foreign_looks import Looks, looks_of

_FLAT_M = 3e-4


@dataclass(frozen=True, slots=True)
class ForeignObject(Sealed):
    """An object.

    Attributes:
        model: What is made of it.
        world_T_object: Where it is, upright, shape (4, 4).
        color: What colour people say that it has, and of what share of it; None where they would not.
        left_out: How many solids were too many or too flat.
    """

    model: ObjectModel
    world_T_object: Transform
    color: tuple[str, float] | None
    left_out: int


def foreign_object(
    foreign: Foreign, bodies: Sequence[int], upright: Array | None = None, key: str | None = None
) -> ForeignObject:
    """Make an object of some bodies as they are placed: what is up there is its top.

    Args:
        foreign: The model.
        bodies: All bodies of the object.
        upright: How it is turned first, shape (3, 3), where its top is elsewhere.
        key: Of its parts; a digest of them when left out.
    """
    stands = np.eye(3) if upright is None else upright
    geoms = foreign.solid_geoms(bodies)
    found = [solids_of(foreign, geom, stands) for geom in geoms]
    solid = [hull for hulls in found for hull in hulls]
    flat = sum(not hulls for hulls in found)
    if not solid:
        every = np.concatenate([foreign.corners(geom) @ stands.T for geom in geoms])
        solid, flat = [_box_about(every)], len(geoms) - 1
    hulls = sorted(solid, key=lambda hull: -volume(hull))[:MAX_PARTS]
    turn = turn_of(np.concatenate(hulls))
    about = poses.rotation_z(turn)
    to_own = about @ stands
    seen = _seen(foreign, bodies, [hull @ stands for hull in hulls])
    hulls = [hull @ about.T for hull in hulls]
    fit = fitted(np.concatenate(hulls))
    hulls = [hull - fit.centre for hull in hulls]
    vertices = seen.vertices @ to_own.T - fit.centre
    corners = np.concatenate(hulls)
    surface, normals = surface_of(hulls)
    parts = ConvexParts(
        key=key or hashlib.sha256(corners.tobytes() + vertices.tobytes()).hexdigest()[:24],
        corners=corners,
        ends=tuple(np.cumsum([len(hull) for hull in hulls]).tolist()),
        surface=surface,
        normals=normals,
        rests=rests_of(corners, middle_of(hulls)).up,
        outline_error_m=fit.error_m,
    )
    model = ObjectModel(
        replace(fit.outline, parts=parts),
        vertices,
        seen.faces.astype(np.int32),
        seen.on_picture,
        seen.picture,
        seen.surface.mean if seen.surface.areas.any() else GREY,
    )
    says = seen.picture or any(foreign.says_color(geom) for geom in foreign.geoms(bodies, False) or geoms)
    color = said_color(seen.surface) if says else None
    place = poses.transform(to_own.T, to_own.T @ fit.centre)
    return ForeignObject(model, place, color, flat + len(solid) - len(hulls))


def solids_of(foreign: Foreign, geom: int, stands: Array) -> list[Array]:
    """Corners of a geom's convex parts in the world, each shape (k, 3), m; none where it is flat.

    Args:
        foreign: The model.
        geom: MuJoCo's index.
        stands: How it is turned first, shape (3, 3).
    """
    cloud = foreign.corners(geom) @ stands.T
    if not _is_solid(cloud):
        return []
    vertices, faces = foreign.triangles(geom)
    if not foreign.are_drawn or not len(faces):
        return [of_few_corners(cloud)]
    if geom not in foreign.cut:
        foreign.cut[geom] = convex_parts(vertices, faces.astype(np.int32))
    return [hull @ stands.T for hull in foreign.cut[geom]]


def _box_about(corners: Array) -> Array:
    """Corners of a thin box about what is flat."""
    low, high = corners.min(axis=0) - _FLAT_M, corners.max(axis=0) + _FLAT_M
    signs = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    return np.asarray(low + signs * (high - low))


def _is_solid(cloud: Array) -> bool:
    if len(cloud) < 4:
        return False
    off = cloud - cloud.mean(axis=0)
    return bool(np.ptp(off @ np.linalg.svd(off, full_matrices=False)[2][2]) > _FLAT_M)


def _seen(foreign: Foreign, bodies: Sequence[int], hulls: Sequence[Array]) -> Looks:
    """What is seen of it, in the world; its parts as they are given, where nothing else is."""
    looks = looks_of(foreign, foreign.geoms(bodies, colliding=False))
    if looks is not None:
        return looks
    meshes = [library("trimesh").convex.convex_hull(hull) for hull in hulls]
    starts = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])
    vertices = np.concatenate([np.asarray(mesh.vertices) for mesh in meshes])
    faces = np.concatenate(
        [np.asarray(mesh.faces, np.int64) + start for mesh, start in zip(meshes, starts, strict=False)]
    )
    color = np.array(foreign.color(foreign.solid_geoms(bodies)[0]))
    return Looks(vertices, faces, seen_surface(vertices, faces, color))
