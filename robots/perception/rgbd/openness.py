"""Whether what is round is open at the top: what rays through its top should show if it were, or were not."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from robots.perception.rgbd.cloud import Cloud
from robots.perception.rgbd.samples import Samples
from robots.perception.rgbd.solids import Fit

WALL_M, BOTTOM_M = 0.003, 0.006
"""Of an usual cup; others differ from it by less than depths are uncertain."""
_ASKED = np.array(
    [(r * np.cos(a), r * np.sin(a)) for r in (0.0, 0.3, 0.55, 0.8) for a in np.arange(12) * np.pi / 6.0]
)[11:]
"""Places over the top of a thing, in radii of its opening, at which it is looked into."""
_UNSURE_M = 0.003
"""Of where the top and the inside of the wall are, beside what depths are uncertain by."""
_MOST = 2.0
"""What one ray may say: neighbouring depths err alike, and some are of an edge."""
_TOGETHER = 0.5
_MOST_ODDS = 8.0
DEEP_M = 0.012
"""What ends so far below the top of a thing is inside it, or its depth is uncertain."""
_BY_WALLS = np.array([(a, b) for a in (-0.75, 0.0, 0.75) for b in (-0.75, 0.0, 0.75) if (a, b) != (0.0, 0.0)])
_BY_WALLS_SHARE = 0.35
"""Places along the walls of a box, in half edges, at which it is looked into."""
_RING = 0.8 * np.array([(np.cos(turn), np.sin(turn)) for turn in np.arange(12) * np.pi / 6.0])
"""The same of a bowl, in radii."""
_HOLDS_M = 0.05
"""Half the edge of what is wide enough to hold something."""


def odds_of_open(cloud: Cloud, samples: Samples, rounds: Fit) -> Array:
    """Logarithm of the odds that each thing is open at the top, if it is an upright cylinder.

    A ray through the top of what is closed ends there; through an opening it goes on, to the far side of the
    wall or to the bottom. Each ray that came back speaks for one or the other by how far from both it ended;
    0 is what nothing has told.

    Args:
        cloud: The points.
        samples: What was measured of the things.
        rounds: They, as cylinders.

    Returns:
        Shape (k,).
    """
    x, y, radius, height = rounds.parameters.T
    inside = np.maximum(radius - WALL_M, 0.5 * radius)
    top = np.zeros((len(x), len(_ASKED), 3))
    top[..., :2] = inside[:, None, None] * _ASKED
    ways = top + np.stack([x, y, height], axis=-1)[:, None] - samples.eye[:, None]
    drop = _drop(top[..., :2], ways, inside, np.maximum(height - BOTTOM_M, 0.0))
    u, v, within = _pixels(cloud, ways)
    there = within & cloud.there[v, u]
    below = samples.origin[:, 2, None] + height[:, None] - cloud.z[v, u]
    spread = np.square(cloud.sigma_m[v, u]) + _UNSURE_M**2
    speaks = 0.5 * (np.square(below) - np.square(below - drop)) / spread
    odds = _TOGETHER * (np.clip(speaks, -_MOST, _MOST) * there).sum(axis=1)
    return np.asarray(np.clip(odds, -_MOST_ODDS, _MOST_ODDS))


def _drop(places: Array, ways: Array, inside: Array, deepest: Array) -> Array:
    """How far below an opening rays end that go through it, shape (k, n).

    Args:
        places: Where, from the middle of the opening, shape (k, n, 2).
        ways: Of the rays, of any length, shape (k, n, 3).
        inside: Radius of the opening, shape (k,).
        deepest: How deep the bottom is, shape (k,).
    """
    across = np.maximum(np.linalg.norm(ways[..., :2], axis=-1), 1e-9)
    ahead = (places * ways[..., :2]).sum(axis=-1) / across
    left = np.maximum(np.square(inside)[:, None] - np.square(places).sum(axis=-1) + np.square(ahead), 0.0)
    along = np.sqrt(left) - ahead
    drop: Array = np.minimum(along * np.maximum(-ways[..., 2], 0.0) / across, deepest[:, None])
    return drop


def is_open_bowl(cloud: Cloud, samples: Samples, rounds: Fit) -> NDArray[np.bool_]:
    """Whether many rays near the wall of a wide round thing end below its top, whatever is in its middle.

    Args:
        cloud: The points.
        samples: What was measured of the things.
        rounds: They, as cylinders.

    Returns:
        Shape (k,).
    """
    x, y, radius, height = rounds.parameters.T
    top = np.zeros((len(x), len(_RING), 3))
    top[..., :2] = np.stack([x, y], axis=-1)[:, None] + radius[:, None, None] * _RING
    top[..., 2] = height[:, None]
    return np.asarray(_is_deep(cloud, samples, top) & (radius > _HOLDS_M))


def is_open_box(cloud: Cloud, samples: Samples, boxes: Fit) -> NDArray[np.bool_]:
    """Whether many rays along the walls of a wide box end below its top, whatever is in its middle.

    Args:
        cloud: The points.
        samples: What was measured of the things.
        boxes: They, as boxes.

    Returns:
        Shape (k,).
    """
    x, y, yaw, a, b, height = boxes.parameters.T
    along, across = a[:, None] * _BY_WALLS[:, 0], b[:, None] * _BY_WALLS[:, 1]
    c, s = np.cos(yaw)[:, None], np.sin(yaw)[:, None]
    top = np.stack(
        [
            x[:, None] + c * along - s * across,
            y[:, None] + s * along + c * across,
            np.broadcast_to(height[:, None], along.shape),
        ],
        axis=-1,
    )
    return np.asarray(_is_deep(cloud, samples, top) & (np.minimum(a, b) > _HOLDS_M))


def _is_deep(cloud: Cloud, samples: Samples, top: Array) -> NDArray[np.bool_]:
    """Whether rays go on at many of some places at the top of each thing, shape (k, n, 3)."""
    u, v, within = _pixels(cloud, top - samples.eye[:, None])
    there = within & (cloud.depth_m[v, u] > 0.0)
    below = samples.origin[:, 2, None] + top[..., 2] - cloud.z[v, u]
    deep = there & (below > np.maximum(DEEP_M, 4.0 * cloud.sigma_m[v, u]))
    share = deep.sum(axis=1) / np.maximum(there.sum(axis=1), 6)
    return np.asarray(share > _BY_WALLS_SHARE)


def _pixels(cloud: Cloud, ways: Array) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.bool_]]:
    """Column, row and whether they are in the picture, of rays from the eye, shape (k, n, 3)."""
    seen = ways @ cloud.odom_T_camera[:3, :3]
    pixels = np.round(cloud.picture.pixels_of(seen.reshape(-1, 3))).astype(np.int64)
    rows, columns = cloud.depth_m.shape
    within = (pixels >= 0).all(axis=1) & (pixels[:, 0] < columns) & (pixels[:, 1] < rows)
    u, v = np.clip(pixels[:, 0], 0, columns - 1), np.clip(pixels[:, 1], 0, rows - 1)
    shape = ways.shape[:2]
    return u.reshape(shape), v.reshape(shape), within.reshape(shape)
