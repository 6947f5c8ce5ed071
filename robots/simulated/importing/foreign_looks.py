"""What is seen of a foreign geom: its triangles with their colours, and its picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np
from PIL import Image

from kinematics.arrays import Array, Indices, Sealed
from robots.scenes.importing.seen_color import Surface, on_picture, seen_surface, small_png
from robots.simulated.importing.bodies import Foreign


@dataclass(frozen=True, slots=True)
class Looks(Sealed):
    """What is seen of some geoms, in the world.

    Attributes:
        vertices: Shape (n, 3), m.
        faces: Triangles of them, shape (m, 3).
        surface: The triangles' colours.
        on_picture: Where each vertex is on the picture, shape (n, 2), from its lower left; None without one.
        picture: PNG; empty without one.
    """

    vertices: Array
    faces: Indices
    surface: Surface
    on_picture: Array | None = None
    picture: bytes = b""


def looks_of(foreign: Foreign, geoms: Sequence[int]) -> Looks | None:
    """What is seen of those geoms that are meshes; with their picture where it is one mesh that has one.

    None where none is a mesh.
    """
    seen = [looks for geom in geoms if (looks := _looks(foreign, geom)) is not None]
    if len(seen) < 2:
        return seen[0] if seen else None
    starts = np.cumsum([0, *(len(one.vertices) for one in seen)])
    return Looks(
        np.concatenate([one.vertices for one in seen]),
        np.concatenate([one.faces + start for one, start in zip(seen, starts, strict=False)]),
        Surface(
            np.concatenate([one.surface.colors for one in seen]),
            np.concatenate([one.surface.areas for one in seen]),
        ),
    )


def _looks(foreign: Foreign, geom: int) -> Looks | None:
    vertices, faces = foreign.triangles(geom)
    if not len(faces):
        return None
    color = np.array(foreign.color(geom))
    uv, picture = _corners_on_picture(foreign, geom), _picture(foreign, geom)
    if uv is None or not picture:
        return Looks(vertices, faces, seen_surface(vertices, faces, color))
    colors = on_picture(picture, uv.mean(axis=1)) * color
    # a corner of two triangles can be at two places of the picture
    apart = np.arange(3 * len(faces)).reshape(-1, 3)
    surface = seen_surface(vertices, faces, colors)
    return Looks(vertices[faces].reshape(-1, 3), apart, surface, uv.reshape(-1, 2), picture)


def _corners_on_picture(foreign: Foreign, geom: int) -> Array | None:
    """Where the corners of each triangle are on the picture, shape (m, 3, 2), from its lower left."""
    model, mesh = foreign.model, int(foreign.model.geom_dataid[geom])
    first = int(model.mesh_texcoordadr[mesh])
    if first < 0:
        return None
    start, count = int(model.mesh_faceadr[mesh]), int(model.mesh_facenum[mesh])
    places = model.mesh_texcoord[first : first + int(model.mesh_texcoordnum[mesh])]
    uv = np.asarray(places[model.mesh_facetexcoord[start : start + count]], np.float64)
    return np.stack([uv[..., 0], 1.0 - uv[..., 1]], axis=-1)


def _picture(foreign: Foreign, geom: int) -> bytes:
    """Of a geom's material, PNG; empty without one."""
    model, material = foreign.model, int(foreign.model.geom_matid[geom])
    texture = -1 if material < 0 else int(model.mat_texid[material, int(mujoco.mjtTextureRole.mjTEXROLE_RGB)])
    if texture < 0 or int(model.tex_type[texture]) != int(mujoco.mjtTexture.mjTEXTURE_2D):
        return b""
    width, height = int(model.tex_width[texture]), int(model.tex_height[texture])
    channels, first = int(model.tex_nchannel[texture]), int(model.tex_adr[texture])
    pixels = np.asarray(model.tex_data[first : first + width * height * channels], np.uint8)
    return small_png(Image.fromarray(pixels.reshape(height, width, channels)[..., :3].copy()))
