"""Things of several convex parts: an arch, whose hull fills what it leaves free, and random ones."""

import numpy as np

from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.shapes import Box

CORNERS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])


def of_hulls(key, hulls):
    ends = tuple(np.cumsum([len(hull) for hull in hulls]).tolist())
    return ConvexParts(key, np.concatenate(hulls), ends)


def moved(corners, x=0.0, y=0.0, z=0.0):
    return corners + np.array([x, y, z])


def outlined(parts):
    """A box about the origin that holds them."""
    return Box(tuple((2.0 * np.abs(parts.corners).max(axis=0)).tolist()), parts)


def arch(apart_m=0.4, thick_m=0.03, long_m=0.3):
    """Two plates of which one is ``apart_m`` to the left of the other."""
    plate = CORNERS * (long_m, thick_m, long_m)
    return outlined(of_hulls(f"arch {apart_m}", [moved(plate, y=side * apart_m / 2) for side in (-1, 1)]))


def random_parts(rng, key):
    hulls = [
        rng.uniform(0.02, 0.12) * rng.normal(size=(int(rng.integers(4, 30)), 3)) + 0.08 * rng.normal(size=3)
        for _ in range(int(rng.integers(1, 6)))
    ]
    return outlined(of_hulls(key, hulls))
