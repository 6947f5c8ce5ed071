"""Things of meshes, cut into convex parts; a mug that several tests take, for it is cut in seven seconds."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.shapes import Box, Cylinder
from robots.scenes.importing.convex import convex_parts, surface_of
from robots.scenes.importing.outline import fitted
from tests import foreign_meshes as foreign


def thing(mesh, key):
    """Parts of a mesh, with points of their surface, centred."""
    hulls = convex_parts(mesh.vertices, mesh.faces)
    fit = fitted(np.concatenate(hulls))
    hulls = [hull - fit.centre for hull in hulls]
    parts = ConvexParts(
        key,
        np.concatenate(hulls),
        tuple(np.cumsum([len(hull) for hull in hulls]).tolist()),
        *surface_of(hulls),
        outline_error_m=fit.error_m,
    )
    outline = fit.outline
    if isinstance(outline, Box):
        return Box(outline.size_m, parts)
    return Cylinder(outline.radius_m, outline.height_m, parts)


def as_wide_as(parts, share, key):
    """The same thing, so much slimmer across."""
    across = np.array([share, share, 1.0])
    return replace(parts, key=key, corners=parts.corners * across, surface=parts.surface * across)


@pytest.fixture(scope="session")
def wide_mug():
    """Of 110 mm across and 90 mm high."""
    return thing(foreign.mug(0.055, 0.09), "a wide mug")
