"""Whether what is round is open at the top: what rays through its top should show if it were, or were not."""

from __future__ import annotations

import numpy as np

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
    seen = ways @ cloud.odom_T_camera[:3, :3]
    pixels = np.round(cloud.picture.pixels_of(seen.reshape(-1, 3))).astype(np.int64)
    rows, columns = cloud.depth_m.shape
    within = (pixels >= 0).all(axis=1) & (pixels[:, 0] < columns) & (pixels[:, 1] < rows)
    u, v = np.clip(pixels[:, 0], 0, columns - 1), np.clip(pixels[:, 1], 0, rows - 1)
    there = (within & cloud.there[v, u]).reshape(drop.shape)
    below = samples.origin[:, 2, None] + height[:, None] - cloud.z[v, u].reshape(drop.shape)
    spread = np.square(cloud.sigma_m[v, u].reshape(drop.shape)) + _UNSURE_M**2
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
