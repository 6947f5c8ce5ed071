"""Furniture of the map that opens, as a picture shows it: its body, front, handle, and what is behind."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from robots.perception.rgbd.cloud import Cloud
from robots.perception.rgbd.openings.bar import Bar, completed, find_bar
from robots.perception.rgbd.openings.cabinet import OPENING, YAW, Cabinet, X, Y, Z, surface_m
from robots.perception.rgbd.openings.fit import ON_MAP, ON_SIGHT, Fit, Prior, fit
from robots.perception.rgbd.openings.view import Thinned, View, thinned, view_of
from robots.perception.rgbd.piece import Piece, pieces_of
from robots.perception.surface import surface_points
from robots.scenes.articulated import DRAWER_BOTTOM, HANDLE, MovingSolid
from robots.scenes.scene_description import Furniture

_WORST = 0.6
"""A fit that costs more is none."""
_THERE_SHARE = 0.75
_SURE_POINTS, _SURE_SHARE, _SURE_M = 150, 0.35, 0.01
_SEEN_SHARE = 0.35
_LEAST_PLACES = 4
_AGREES_M = 0.04
_AJAR = {True: 0.2, False: 0.05}
"""What is behind a front shows from so far open on, rad or m."""
_EXPLAINED_M = 0.012
_SIGMAS = 3.0


@dataclass(frozen=True, slots=True)
class SeenCabinet(InFloat64):
    """A piece that opens, as it is seen.

    Attributes:
        cabinet: Its boxes.
        fit: Where it stands and how far it is open.
        front_seen: Whether the front is in view; else only the body is.
        bar: Its handle, or None when that is not seen.
        inside_seen: Whether what goes with the front is seen behind it.
    """

    cabinet: Cabinet
    fit: Fit
    front_seen: bool
    bar: Bar | None
    inside_seen: bool

    @property
    def placed(self) -> Furniture:
        """The piece of the map where it is seen, and as high as it is."""
        config, piece = self.fit.config, self.cabinet.piece
        x, y = piece.position_m
        depth, width, height = piece.size_m
        return replace(
            piece,
            position_m=(x + float(config[X]), y + float(config[Y])),
            yaw_rad=piece.yaw_rad + float(config[YAW]),
            size_m=(depth, width, height + float(config[Z])),
        )

    def pieces(self) -> list[Piece]:
        """Its solids, as far as they are seen or follow from what is."""
        piece, config = self.cabinet.piece, self.fit.config
        standing = replace(self.placed, size_m=piece.size_m)
        found = pieces_of(standing, 0.95, raised_m=float(config[Z]))
        if self.front_seen:
            part = self.cabinet.odom_T_piece(config) @ self.cabinet.piece_T_part(float(config[OPENING]))
            for k, solid in enumerate(self.cabinet.moving):
                if k == 0 or (self.inside_seen and solid.kind):
                    found.append(Piece(solid.kind, None, solid.shape, part @ solid.part_T_solid, 0.95))
        if self.bar is not None:
            found.append(Piece(HANDLE, None, self.bar.shape, self.bar.frame_T_bar, 0.95))
        return found

    def explains(self, points: Array, sigma_m: Array) -> NDArray[np.bool_]:
        """Which points are on its surface, and so are no things; shape (n,).

        Args:
            points: In the odometry frame, shape (n, 3).
            sigma_m: How uncertain each is, shape (n,).
        """
        cabinet, config = self.cabinet, self.fit.config
        local_T_odom = poses.inverse(cabinet.odom_T_piece(config))
        local = points @ local_T_odom[:3, :3].T + local_T_odom[:3, 3]
        part_T_piece = poses.inverse(cabinet.piece_T_part(float(config[OPENING])))
        moved = local @ part_T_piece[:3, :3].T + part_T_piece[:3, 3]
        away = np.minimum(surface_m(local, *cabinet.fixed), surface_m(moved, *cabinet.moving_boxes))
        on = away < _EXPLAINED_M + _SIGMAS * sigma_m
        if self.bar is not None:
            bar = points - self.bar.frame_T_bar[:3, 3]
            along = bar @ self.bar.frame_T_bar[:3, 2]
            beside = np.linalg.norm(bar - along[:, None] * self.bar.frame_T_bar[:3, 2], axis=1)
            on |= (beside < self.bar.shape.radius_m + 0.06) & (
                np.abs(along) < 0.5 * self.bar.shape.height_m + 0.03
            )
        return np.asarray(on)

    def levels_m(self) -> list[float]:
        """Heights of everything level on it that could carry a thing."""
        cabinet, config = self.cabinet, self.fit.config
        middles, halves = cabinet.fixed
        tops = (middles[:, 2] + halves[:, 2]).tolist()
        part = cabinet.piece_T_part(float(config[OPENING]))
        middles, halves = cabinet.moving_boxes
        tops += (part[2, 3] + middles[:, 2] + halves[:, 2]).tolist()
        return [float(top) + float(config[Z]) for top in tops]

    def covers(self, place: Array) -> bool:
        """Whether a place, x and y, is over the piece or over what stands out of it."""
        local = poses.inverse(self.cabinet.odom_T_piece(self.fit.config)) @ [*place[:2], 0.0, 1.0]
        depth, width, _ = self.cabinet.piece.size_m
        out = 0.0 if self.cabinet.is_door else float(self.fit.config[OPENING])
        return bool(
            -0.5 * depth - out - 0.05 < local[0] < 0.5 * depth + 0.05 and abs(local[1]) < 0.5 * width + 0.05
        )


class Cabinets:
    """Finds what opens, picture by picture, and remembers where it was seen.

    Args:
        known: The map, in the odometry frame.
    """

    def __init__(self, known: Sequence[Furniture]) -> None:
        self._on_map = tuple(piece for piece in known if piece.opens is not None)
        self._on_sight: dict[int, Furniture] = {}
        self._by_front: dict[int, Bar] = {}
        self._now: set[int] = set()

    def look(self, cloud: Cloud) -> list[SeenCabinet]:
        """What of it is in view."""
        if not self._on_map:
            return []
        whole = thinned(cloud)
        found: list[SeenCabinet] = []
        self._now = set()
        for k, on_map in enumerate(self._on_map):
            seen = None
            if k in self._on_sight:
                seen = _find(cloud, whole, self._on_sight[k], ON_SIGHT)
            if seen is None:
                seen = _find(cloud, whole, on_map, ON_MAP)
            if seen is None:
                continue
            self._on_sight[k] = replace(seen.placed, size_m=on_map.size_m)
            self._now.add(k)
            found.append(self._with_whole_bar(k, seen))
        return found

    def _with_whole_bar(self, k: int, seen: SeenCabinet) -> SeenCabinet:
        """With a handle as long as it was ever seen: an arm or the picture's edge hides a part of it."""
        if seen.bar is None:
            return seen
        odom_T_front = seen.cabinet.odom_T_front(seen.fit.config)
        bar = replace(seen.bar, frame_T_bar=poses.inverse(odom_T_front) @ seen.bar.frame_T_bar)
        if k in self._by_front:
            bar = completed(bar, self._by_front[k])
        self._by_front[k] = bar
        return replace(seen, bar=replace(bar, frame_T_bar=odom_T_front @ bar.frame_T_bar))

    @property
    def unseen(self) -> list[Furniture]:
        """Where pieces are believed to be that the last picture does not show well."""
        return [self._on_sight.get(k, piece) for k, piece in enumerate(self._on_map) if k not in self._now]


def _find(cloud: Cloud, whole: Thinned, piece: Furniture, prior: Prior) -> SeenCabinet | None:
    view, cabinet = view_of(cloud, whole, piece), Cabinet(piece)
    fitted = fit(cabinet, view, prior)
    if fitted is None or not _is_sure(fitted, len(view.points)):
        return None
    seen = _seen(cabinet, fitted, view)
    return seen if _is_there(seen, view) else None


def _is_sure(fitted: Fit, points: int) -> bool:
    """Whether a picture, with so many points around it, shows well where a piece stands."""
    spread = np.sqrt(np.diag(fitted.covariance)[[X, Y]])
    return bool(
        fitted.cost < _WORST
        and fitted.points >= max(_SURE_POINTS, _SURE_SHARE * points)
        and spread.max() < _SURE_M
    )


def _is_there(seen: SeenCabinet, view: View) -> bool:
    """Whether most of what of it should be in sight is."""
    agree = past = 0
    for solid in seen.pieces():
        if solid.kind == HANDLE:
            continue
        points, normals = surface_points(solid.shape)
        world = points @ solid.odom_T_solid[:3, :3].T + solid.odom_T_solid[:3, 3]
        facing = ((view.eye - world) * (normals @ solid.odom_T_solid[:3, :3].T)).sum(axis=1) > 0.0
        shown, z = view.depth_at(world[facing])
        agree += int(((shown > 0.0) & (np.abs(shown - z) < _AGREES_M)).sum())
        past += int((shown > z + _AGREES_M).sum())
    return agree + past < _LEAST_PLACES or agree > _THERE_SHARE * (agree + past)


def _seen(cabinet: Cabinet, fitted: Fit, view: View) -> SeenCabinet:
    front_seen = fitted.front_places >= _LEAST_PLACES and fitted.front_seen > _SEEN_SHARE
    bar = None
    shape = cabinet.moving[0].shape
    if front_seen and isinstance(shape, Box):
        bar = find_bar(view.cloud, cabinet.odom_T_front(fitted.config), shape)
    inside = front_seen and float(fitted.config[OPENING]) > _AJAR[cabinet.is_door]
    if inside and not cabinet.is_door:
        bottom = next(solid for solid in cabinet.moving if solid.kind == DRAWER_BOTTOM)
        inside = _is_seen(cabinet, fitted, bottom, view)
    return SeenCabinet(cabinet, fitted, front_seen, bar, inside)


def _is_seen(cabinet: Cabinet, fitted: Fit, solid: MovingSolid, view: View) -> bool:
    """Whether the picture shows a solid where it should be."""
    config = fitted.config
    pose = cabinet.odom_T_piece(config) @ cabinet.piece_T_part(float(config[OPENING])) @ solid.part_T_solid
    points, normals = surface_points(solid.shape)
    up = normals[:, 2] > 0.5
    shown, z = view.depth_at(points[up] @ pose[:3, :3].T + pose[:3, 3])
    agree = (shown > 0.0) & (np.abs(shown - z) < _AGREES_M)
    return int(agree.sum()) >= _LEAST_PLACES
