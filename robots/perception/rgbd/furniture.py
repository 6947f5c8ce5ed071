"""Furniture: entries of a map, put where their edges are seen; or, without a map, tops that carry things."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from robots.perception.rgbd.cloud import Cloud
from robots.perception.rgbd.openings.find import SeenCabinet
from robots.perception.rgbd.piece import Piece, pieces_of
from robots.perception.rgbd.surfaces import Surface
from robots.perception.surface import surface_points
from robots.scenes import furniture
from robots.scenes.furniture import TABLE_TOP_M, board_tops_m
from robots.scenes.scene_description import Furniture

MAP_M = 0.06
MAP_RAD = 0.02
"""Standard deviations of where a piece is on the map, as seen from the robot."""
_EDGE_M = 0.004
_MATCH_M, _MATCH_RAD = 0.12, math.radians(25.0)
"""An edge that is seen belongs to a side of the map's piece within these."""
_HEIGHT_M = 0.05
_SEEN_SHARE = 0.35
_SEEN_M = 0.08
_STEPS = 6


def find_furniture(
    cloud: Cloud,
    surfaces: Sequence[Surface],
    known: Sequence[Furniture],
    cabinets: Sequence[SeenCabinet] = (),
) -> list[Piece]:
    """The furniture in view.

    Args:
        cloud: The points.
        surfaces: The level surfaces in it.
        known: What of the map does not open or is not seen well, in the odometry frame, with its error.
        cabinets: What opens and is in view.
    """
    found: list[Piece] = [solid for cabinet in cabinets for solid in cabinet.pieces()]
    explained: set[int] = {
        i for i, surface in enumerate(surfaces) if any(_is_of(cabinet, surface) for cabinet in cabinets)
    }
    for piece in known:
        matches = [
            i for i, surface in enumerate(surfaces) if i not in explained and _could_be(piece, surface)
        ]
        if matches:
            explained.update(matches)
            aligned, edges = _aligned(cloud, piece, [surfaces[i] for i in matches])
            found += pieces_of(
                aligned, 0.97 if edges else 0.85, frozenset() if edges else frozenset({"edges"})
            )
        elif piece.kind != "table" and _seen(cloud, piece):
            found += on_map(piece)
    for i, surface in enumerate(surfaces):
        if i not in explained:
            found.append(_alone(surface))
    return found


def _could_be(piece: Furniture, surface: Surface) -> bool:
    if min(abs(top - surface.height_m) for top in board_tops_m(piece)) > _HEIGHT_M:
        return False
    local = _local(piece, surface.hull.astype(np.float64).mean(axis=0)[None])[0]
    half = 0.5 * np.array(piece.size_m[:2]) + 0.10
    return bool((np.abs(local) < half).all())


def on_map(piece: Furniture) -> list[Piece]:
    """The solids of a piece where the map has it."""
    return pieces_of(piece, 0.85, frozenset({"place"}))


def _is_of(cabinet: SeenCabinet, surface: Surface) -> bool:
    """Whether a level surface is a board, a bottom or the top of a piece that opens."""
    off = min(abs(top - surface.height_m) for top in cabinet.levels_m())
    return off < _HEIGHT_M and cabinet.covers(surface.hull.astype(np.float64).mean(axis=0))


def _local(piece: Furniture, places: Array) -> Array:
    c, s = math.cos(piece.yaw_rad), math.sin(piece.yaw_rad)
    return np.asarray((places - np.array(piece.position_m)) @ np.array([[c, -s], [s, c]]))


def _aligned(cloud: Cloud, piece: Furniture, surfaces: Sequence[Surface]) -> tuple[Furniture, bool]:
    """The piece where its edges are seen, and whether any are; its height as measured."""
    top = max(surfaces, key=lambda surface: surface.area_m2)
    raised = min((top.height_m - board for board in board_tops_m(piece)), key=abs)
    depth, width, height = piece.size_m
    piece = replace(piece, size_m=(depth, width, height + raised))
    edges = np.concatenate([_edges(cloud, surface) for surface in surfaces])
    half = 0.5 * np.array([depth, width])
    used = 0
    offset, turn = np.zeros(2), 0.0
    for _ in range(_STEPS):
        here = replace(
            piece,
            position_m=(piece.position_m[0] + float(offset[0]), piece.position_m[1] + float(offset[1])),
            yaw_rad=piece.yaw_rad + turn,
        )
        local = _local(here, edges)
        # each edge point to the nearest of the four sides
        sides = np.stack(
            [local[:, 0] - half[0], -local[:, 0] - half[0], local[:, 1] - half[1], -local[:, 1] - half[1]],
            axis=1,
        )
        side = np.abs(sides).argmin(axis=1)
        off = sides[np.arange(len(sides)), side]
        along = np.where(side < 2, np.abs(local[:, 1]) - half[1], np.abs(local[:, 0]) - half[0])
        good = (np.abs(off) < _MATCH_M) & (along < 0.03)
        used = int(good.sum())
        if used < 15:
            break
        c, s = math.cos(here.yaw_rad), math.sin(here.yaw_rad)
        normals = np.array([[c, s], [-c, -s], [-s, c], [s, -c]])[side[good]]
        arm = edges[good] - np.array(here.position_m)
        # moving the piece by d and turning it changes a point's distance from a side by -n d and so on
        jacobian = np.column_stack([-normals, -(normals[:, 1] * arm[:, 0] - normals[:, 0] * arm[:, 1])])
        weight = 1.0 / (1.0 + (off[good] / (3.0 * _EDGE_M)) ** 2) ** 2 / _EDGE_M**2
        # neighbours err together: a side counts as some dozens of measurements
        weight *= 40.0 / max(used, 40)
        prior = np.diag([1.0 / MAP_M**2, 1.0 / MAP_M**2, 1.0 / MAP_RAD**2])
        normal = (jacobian * weight[:, None]).T @ jacobian + prior
        right = -(jacobian * weight[:, None]).T @ off[good] - prior @ np.array([*offset, turn])
        step = np.linalg.solve(normal, right)
        offset, turn = offset + step[:2], turn + float(step[2])
    if used < 15:
        return piece, False
    place = float(piece.position_m[0] + offset[0]), float(piece.position_m[1] + offset[1])
    return replace(piece, position_m=place, yaw_rad=piece.yaw_rad + turn), True


def _edges(cloud: Cloud, surface: Surface) -> Array:
    """Places on a surface's rim beyond which the picture goes on farther away, shape (n, 2)."""
    mask = cv2.morphologyEx(surface.pixels.astype(np.uint8), cv2.MORPH_CLOSE, np.ones((5, 5), np.uint8)) > 0
    depth = cloud.depth_m[::2, ::2]
    there = cloud.there[::2, ::2]
    x, y = cloud.x[::2, ::2], cloud.y[::2, ::2]
    rows, columns = mask.shape
    found = []
    whole = cv2.erode(mask.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    v, u = np.nonzero(surface.pixels & ~whole)
    for dy, dx in ((0, 1), (0, -1), (1, 0), (-1, 0)):
        nv, nu = v + dy, u + dx
        fv, fu = v + 4 * dy, u + 4 * dx
        within = (fv >= 0) & (fv < rows) & (fu >= 0) & (fu < columns)
        nv, nu = np.clip(nv, 0, rows - 1), np.clip(nu, 0, columns - 1)
        fv, fu = np.clip(fv, 0, rows - 1), np.clip(fu, 0, columns - 1)
        ends = within & ~mask[nv, nu] & ~mask[fv, fu] & there[fv, fu]
        ends &= depth[fv, fu] > depth[v, u] + np.float32(0.05)
        found.append(np.column_stack([x[v[ends], u[ends]], y[v[ends], u[ends]]]))
    return np.asarray(np.concatenate(found), dtype=np.float64)


def _seen(cloud: Cloud, piece: Furniture) -> bool:
    """Whether the picture shows something where the piece should be, on most of what should be in sight."""
    eye, camera_R = cloud.odom_T_camera[:3, 3], cloud.odom_T_camera[:3, :3].T
    agree = total = 0
    rows, columns = cloud.depth_m.shape
    for solid in furniture.solids(piece):
        points, normals = surface_points(solid.shape)
        world = points @ solid.world_T_solid[:3, :3].T + solid.world_T_solid[:3, 3]
        facing = ((eye - world) * (normals @ solid.world_T_solid[:3, :3].T)).sum(axis=1) > 0.0
        seen = (world[facing] - eye) @ camera_R.T
        seen = seen[seen[:, 2] > 0.3]
        pixels = np.round(cloud.picture.pixels_of(seen)).astype(np.int64)
        within = (pixels >= 0).all(axis=1) & (pixels[:, 0] < columns) & (pixels[:, 1] < rows)
        u, v, z = pixels[within, 0], pixels[within, 1], seen[within, 2]
        shown = cloud.depth_m[v, u]
        there = shown > 0.0
        total += int((there & (shown > z - 2.0 * _SEEN_M)).sum())
        agree += int((there & (np.abs(shown - z) < _SEEN_M)).sum())
    return total >= 6 and agree > _SEEN_SHARE * total


def _alone(surface: Surface) -> Piece:
    """A top that no map knows: as far as it is seen; legs are not told."""
    (x, y), (a, b), degrees = cv2.minAreaRect(surface.hull)
    pose = poses.transform(
        poses.rotation_z(math.radians(degrees)), (x, y, surface.height_m - 0.5 * TABLE_TOP_M)
    )
    shape = Box((max(float(a), 0.05), max(float(b), 0.05), TABLE_TOP_M))
    return Piece("table", None, shape, pose, 0.7, frozenset({"edges", "legs"}))
