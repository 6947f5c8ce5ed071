"""What shape each thing has: the solid that explains what is measured of it, and what is only assumed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from robots.perception.rgbd.cloud import Cloud
from robots.perception.rgbd.openness import DEEP_M, is_open_bowl, is_open_box, odds_of_open
from robots.perception.rgbd.samples import Samples
from robots.perception.rgbd.solids import (
    Fit,
    ball_distance,
    box_distance,
    cylinder_distance,
    fit,
    visible_side,
)

_ROOM_M, _WITHIN_SHARE = 0.005, 0.7
_FOOT_WIDTH, _BOTTOM_M, _LINING_SHARE = 0.55, 0.02, 0.5
"""A bowl's wall is beyond a cone from this share of its width, at the foot, to its rim; what is so low is its
bottom. Of a piece of the lining more than this share is there."""
_HOLDS_M = 0.05
Form = Literal["cylinder", "beaker", "box", "crate", "ball"]
"""A beaker is a cylinder that is open at the top, a crate a box that is."""
_WALL_M = 0.004
"""What is so deep in a bowl is of its inside."""
_BOWL_ODDS = 4.0
"""Logarithm of the odds that what is deep along its wall is open."""
_HOLLOW_SHARE = 0.10
"""A box of whose points more are deep inside it is open."""
_WIDEST_OF_VISIBLE = 1.25, 0.003
"""A cylinder is no wider than this share of what is seen of it, and so much more: else a box that is seen
face on becomes a huge one."""
CUT_SHARE = 0.06
"""What has more of its outline behind something, or at the picture's edge, goes on there."""
_WIDEST_OF_CUT = 2.5
"""What has more of its outline than this share out of sight may be so much wider than what is seen of it."""
_TOPLESS, _HEIGHT_UNSEEN_M = 0.5, 0.10
"""Where more of the upper ends than this share are out of sight, the height is told as far as it is seen, and
is uncertain by so much."""
_FALLS_SHORT_M = 0.015
"""A ball that is so much lower or higher than it is wide is none."""
_LOOSE_BELOW_M = 0.03
"""What begins higher above the ground than this may hang in the air."""
_FOOT = np.array([(side, up) for side in (-0.5, 0.0, 0.5) for up in (0.15, 0.4, 0.65)])
"""Where its foot would be looked for: across, in half widths, and up, in shares of where it begins."""
_BEHIND_M, _THROUGH_SHARE = 0.02, 0.6


@dataclass(frozen=True, slots=True)
class Solid(InFloat64):
    """The shape of one thing.

    Attributes:
        form: Which kind of solid it is.
        shape: With its size.
        place_m: Its middle in the odometry frame, shape (3,).
        yaw_rad: Heading of a box.
        sigma_m: Standard deviations of the middle's x, y, z and of the size's parts, from what was measured.
        score: How badly it fits; about 1 for what is as it seems.
        margin: By how much the next best form fits worse.
        hidden: Share of its outline that ends behind something nearer.
        border: Share of it that ends at the edge of the picture.
        measured: What of it is measured: "top", "sides", "foot"; the rest, its back, is assumed.
        lifted_m: How high above the ground it begins; 0 for what stands.
        open_odds: Of what is round: logarithm of the odds that it is open at the top.
    """

    form: Form
    shape: Shape
    place_m: Array
    yaw_rad: float
    sigma_m: tuple[float, ...]
    score: float
    margin: float
    hidden: float
    border: float
    measured: frozenset[str]
    lifted_m: float = 0.0
    open_odds: float = 0.0


def find_solids(cloud: Cloud, samples: Samples) -> tuple[list[Solid], NDArray[np.bool_]]:
    """The best solid for each piece, and whether it is a thing of its own: the inside of a beaker is none."""
    view = _seen_from(samples)
    round_start = np.column_stack([view.middle, view.half_width, view.height])
    outside = samples.weight * visible_side(samples, view.middle, view.height)
    rounds = fit(replace(samples, weight=outside), round_start, cylinder_distance, slice(2, 4))
    open_odds = odds_of_open(cloud, samples, rounds)
    bowl = is_open_bowl(cloud, samples, rounds)
    open_odds = np.where(bowl, np.maximum(open_odds, _BOWL_ODDS), open_odds)
    beaker = open_odds > 0.0
    rounds = _without_inside(replace(samples, weight=outside), rounds, beaker)
    boxes = fit(samples, _box_starts(samples, view), box_distance, slice(3, 6), (3, 4))
    boxes, crate = _without_insides(cloud, samples, boxes, view)
    ball_start = np.column_stack([view.middle, 0.5 * view.height])
    balls = fit(samples, ball_start, ball_distance, slice(2, 3))
    scores = np.stack(
        [
            np.where(_too_wide(view, rounds, samples), np.inf, rounds.score),
            # what is open at the top is round: boxes that are so have a form of their own
            np.where(beaker & ~crate, boxes.score + 1.0, boxes.score),
            np.where(_no_ball(view, balls), np.inf, balls.score),
        ]
    )
    best = scores.argmin(axis=0)
    ordered = np.sort(scores, axis=0)
    margin = np.minimum(ordered[1] - ordered[0], 20.0)
    made = []
    hangs = _seen_through(cloud, samples, view)
    for k, kind in enumerate(best):
        which: tuple[Form, Fit] = (
            ("beaker" if beaker[k] else "cylinder", rounds),
            ("crate" if crate[k] else "box", boxes),
            ("ball", balls),
        )[int(kind)]
        lifted = float(view.low[k]) if hangs[k] else 0.0
        made.append(
            replace(
                _solid(which[0], which[1], k, samples, view, float(margin[k]), lifted),
                open_odds=float(open_odds[k]),
            )
        )
    return made, ~_within_another(samples, rounds, beaker & (best == 0))


def _without_insides(
    cloud: Cloud, samples: Samples, boxes: Fit, view: _View
) -> tuple[Fit, NDArray[np.bool_]]:
    """The boxes, with those that are open fitted to their outside alone, and which these are."""
    crate = np.zeros(len(samples.origin), np.bool_)
    for _ in range(2):
        on, _ = box_distance(samples.points, boxes.parameters, False)
        deep = on < -DEEP_M
        share = (deep * samples.weight).sum(axis=1) / np.maximum(samples.weight.sum(axis=1), 1.0)
        wide = boxes.parameters[:, 3:5].min(axis=1) > _HOLDS_M
        crate |= ((share > _HOLLOW_SHARE) & wide) | is_open_box(cloud, samples, boxes)
        if not crate.any():
            break
        some = samples.only(crate)
        outside = replace(some, weight=some.weight * ~deep[crate])
        again = fit(outside, boxes.parameters[crate], box_distance, slice(3, 6), (3, 4))
        boxes = boxes.with_some(crate, again)
    # a rim is too thin for a fit; the highest points are its own
    boxes.parameters[crate, 5] = view.height[crate]
    return boxes, crate


def _without_inside(samples: Samples, rounds: Fit, beaker: NDArray[np.bool_]) -> Fit:
    """The round things, with those that are open at the top fitted to their outside alone."""
    if not beaker.any():
        return rounds
    some, first = samples.only(beaker), rounds.parameters[beaker]
    on, _ = cylinder_distance(some.points, first, False)
    inside = on < -np.maximum(_WALL_M, 3.0 * some.sigma_m)
    again = fit(replace(some, weight=some.weight * ~inside), first, cylinder_distance, slice(2, 4))
    return rounds.with_some(beaker, again)


@dataclass(frozen=True, slots=True)
class _View:
    """What is seen of each thing at first sight.

    Attributes:
        middle: Where its middle would be if it were as deep as it is wide, shape (k, 2).
        half_width: Across the line of sight.
        height: Of its highest points.
        low: Of its lowest points.
    """

    middle: Array
    half_width: Array
    height: Array
    low: Array


def _seen_from(samples: Samples) -> _View:
    towards = -samples.eye[:, :2] / np.linalg.norm(samples.eye[:, :2], axis=1, keepdims=True)
    across = np.stack([-towards[:, 1], towards[:, 0]], axis=1)
    sideways = np.einsum("knd,kd->kn", samples.points[..., :2], across)
    ahead = np.einsum("knd,kd->kn", samples.points[..., :2], towards)
    left, right = _quantile(sideways, samples.weight, 0.02), _quantile(sideways, samples.weight, 0.98)
    near = _quantile(ahead, samples.weight, 0.03)
    height = np.maximum(_quantile(samples.points[..., 2], samples.weight, 0.96), 0.012)
    low = _quantile(samples.points[..., 2], samples.weight, 0.03)
    half = np.maximum(0.5 * (right - left), 0.010)
    middle = 0.5 * (left + right)[:, None] * across + (near + half)[:, None] * towards
    return _View(middle, half, height, low)


def _quantile(values: Array, weight: Array, share: float) -> Array:
    """Of each row, of those that count."""
    ordered = np.sort(np.where(weight > 0.0, values, np.inf), axis=1)
    count = weight.sum(axis=1)
    at = np.clip((share * (count - 1)).round(), 0, values.shape[1] - 1).astype(np.int64)
    found = ordered[np.arange(len(values)), at]
    return np.where(np.isfinite(found), found, 0.0)


def _box_starts(samples: Samples, view: _View) -> Array:
    starts = np.zeros((len(samples.origin), 6))
    for k, points in enumerate(samples.points):
        flat = points[samples.weight[k] > 0.0][:, :2].astype(np.float32)
        if len(flat) < 3:
            starts[k] = (*view.middle[k], 0.0, view.half_width[k], view.half_width[k], view.height[k])
            continue
        (x, y), (a, b), degrees = cv2.minAreaRect(flat)
        starts[k] = (x, y, np.deg2rad(degrees), max(0.5 * a, 0.010), max(0.5 * b, 0.010), view.height[k])
    return starts


def _too_wide(view: _View, rounds: Fit, samples: Samples) -> NDArray[np.bool_]:
    share, more = _WIDEST_OF_VISIBLE
    widest = np.where(samples.border + samples.cut > CUT_SHARE, _WIDEST_OF_CUT, share)
    return np.asarray(rounds.parameters[:, 2] > widest * view.half_width + more)


def _no_ball(view: _View, balls: Fit) -> NDArray[np.bool_]:
    return np.asarray(np.abs(2.0 * balls.parameters[:, 2] - view.height) > _FALLS_SHORT_M)


def _ground_of(solid: Solid, place: Array, room_m: float) -> bool:
    """Whether a place, x and y, is on the ground that a thing covers, or so near to it."""
    dx, dy = place[:2] - solid.place_m[:2]
    if isinstance(solid.shape, Box):
        c, s = np.cos(solid.yaw_rad), np.sin(solid.yaw_rad)
        a, b = solid.shape.size_m[:2]
        return bool(abs(c * dx + s * dy) < 0.5 * a + room_m and abs(c * dy - s * dx) < 0.5 * b + room_m)
    return bool(np.hypot(dx, dy) < solid.shape.radius_m + room_m)


def apart(solids: Sequence[Solid], sure: Array) -> NDArray[np.bool_]:
    """Which things are not where another one is that is surer: two solids are never at one place.

    What is in a bowl or in an open box is.
    """
    kept = np.ones(len(solids), np.bool_)
    order = np.argsort(-sure, kind="stable")
    for i, a in enumerate(order):
        for b in order[i + 1 :]:
            first, second = solids[a], solids[b]
            if not kept[a] or not kept[b] or _could_hold(first, second) or _could_hold(second, first):
                continue
            if _ground_of(first, second.place_m, _ROOM_M) or _ground_of(second, first.place_m, 0.0):
                kept[b] = False
    return kept


def _could_hold(solid: Solid, other: Solid) -> bool:
    """Whether one may be in the other."""
    return solid.form in ("beaker", "crate") and _radius(solid) > max(_HOLDS_M, _radius(other))


def _radius(solid: Solid) -> float:
    return 0.5 * min(solid.shape.size_m[:2]) if isinstance(solid.shape, Box) else solid.shape.radius_m


def _within_another(samples: Samples, rounds: Fit, beaker: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Which pieces are of the lining of a beaker that another piece is the outside of.

    What stands in it is within it as well, but most of that is away from its wall and its bottom.
    """
    x, y, radius, height = rounds.parameters.T
    world = samples.points + samples.origin[:, None]
    within, total = np.zeros(len(world), np.bool_), samples.weight.sum(axis=1)
    for k in np.flatnonzero(beaker):
        away = np.hypot(
            world[..., 0] - samples.origin[k, 0] - x[k], world[..., 1] - samples.origin[k, 1] - y[k]
        )
        up = world[..., 2] - samples.origin[k, 2]
        room = (away < radius[k] + _ROOM_M) & (up < height[k] + _ROOM_M)
        lining = (away > radius[k] * (_FOOT_WIDTH + (1.0 - _FOOT_WIDTH) * up / height[k])) | (up < _BOTTOM_M)
        in_room, of_lining = ((some & (samples.weight > 0.0)).sum(axis=1) for some in (room, room & lining))
        inside = (in_room > _WITHIN_SHARE * total) & (of_lining > _LINING_SHARE * total)
        inside[k] = False
        within |= inside & ~within[k]
    return within


def _solid(
    form: Form, found: Fit, k: int, samples: Samples, view: _View, margin: float, lifted: float
) -> Solid:
    p, sigma = found.parameters[k], np.sqrt(np.maximum(np.diag(found.covariance[k]), 1e-10))
    x, y = samples.origin[k, :2] + p[:2]
    ground = float(samples.origin[k, 2])
    yaw, shape, spread = 0.0, _shape(form, p), tuple(float(value) for value in sigma[2:])
    if form in ("box", "crate"):
        yaw, spread = _turned(p), (2.0 * float(sigma[3]), 2.0 * float(sigma[4]), float(sigma[5]))
    if lifted > 0.0 and form != "ball":
        shape = _without_foot(shape, lifted)
    place = np.array([x, y, ground + lifted + 0.5 * shape.height_m])
    low = float(view.low[k])
    measured = {"sides"} if low < 0.6 * shape.height_m else set()
    if samples.topless[k] > _TOPLESS:
        spread = (*spread[:-1], max(spread[-1], _HEIGHT_UNSEEN_M))
    else:
        measured.add("top")
    if low < _LOOSE_BELOW_M:
        measured.add("foot")
    return Solid(
        form=form,
        shape=shape,
        place_m=place,
        yaw_rad=yaw,
        sigma_m=(float(sigma[0]), float(sigma[1]), *spread),
        score=float(found.score[k]),
        margin=margin,
        hidden=float(samples.cut[k]),
        border=float(samples.border[k]),
        measured=frozenset(measured),
        lifted_m=lifted,
    )


def _without_foot(shape: Shape, lifted: float) -> Shape:
    """The shape of what begins above the ground, of one that was fitted down to it."""
    height = max(shape.height_m - lifted, 0.01)
    if isinstance(shape, Box):
        return Box((shape.size_m[0], shape.size_m[1], height))
    return Cylinder(shape.radius_m, height)


def _seen_through(cloud: Cloud, samples: Samples, view: _View) -> NDArray[np.bool_]:
    """Which pieces hang in the air: where their foot would be, the picture shows what is behind it."""
    towards = samples.eye[:, :2] - view.middle
    towards /= np.linalg.norm(towards, axis=1, keepdims=True)
    across = np.stack([-towards[:, 1], towards[:, 0]], axis=1)
    foot = np.zeros((len(samples.origin), len(_FOOT), 3))
    foot[..., :2] = (view.middle + view.half_width[:, None] * towards)[:, None]
    foot[..., :2] += _FOOT[:, 0, None] * (view.half_width[:, None] * across)[:, None]
    foot[..., 2] = _FOOT[:, 1] * view.low[:, None]
    seen = (foot - samples.eye[:, None]).reshape(-1, 3) @ cloud.odom_T_camera[:3, :3]
    pixels = np.round(cloud.picture.pixels_of(seen)).astype(np.int64)
    rows, columns = cloud.depth_m.shape
    within = (pixels >= 0).all(axis=1) & (pixels[:, 0] < columns) & (pixels[:, 1] < rows)
    u, v = np.clip(pixels[:, 0], 0, columns - 1), np.clip(pixels[:, 1], 0, rows - 1)
    shown = within & cloud.there[v, u]
    behind = shown & (cloud.depth_m[v, u] > seen[:, 2] + _BEHIND_M)
    told, through = (mask.reshape(len(foot), -1).sum(axis=1) for mask in (shown, behind))
    return np.asarray((view.low > _LOOSE_BELOW_M) & (told >= 3) & (through > _THROUGH_SHARE * told))


def _shape(form: Form, p: Array) -> Shape:
    if form in ("box", "crate"):
        return Box((2.0 * float(p[3]), 2.0 * float(p[4]), float(p[5])))
    if form == "ball":
        return Ball(float(p[2]))
    return Cylinder(float(p[2]), float(p[3]))


def _turned(p: Array) -> float:
    """Heading of a box, which looks the same after a quarter turn with its edges exchanged."""
    return float((p[2] + 0.5 * np.pi) % np.pi - 0.5 * np.pi)
