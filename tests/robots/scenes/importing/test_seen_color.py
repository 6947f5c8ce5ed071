"""What colour an imported thing is said to have: the one that most of it shows, or none."""

import io

import numpy as np
import pytest
from PIL import Image

from robots.scenes.importing.import_object import import_object
from robots.scenes.importing.seen_color import Surface, on_picture, said_color
from robots.scenes.meshes.sidecar import Sidecar, read_sidecar, sidecar_file
from robots.scenes.scene_file import load_scene
from robots.scenes.scene_words import COLORS
from tests import foreign_meshes as foreign

ON_THE_TABLE = """
[[furniture]]
name = "table"
kind = "table"
size_m = [0.6, 1.2, 0.86]
position_m = [0.7, 0.0]

[[object]]
mesh = "can.glb"
on = "table"
"""


def painted(tmp_path, top, below, name="can.glb"):
    """A can of one colour above half its height, and of another below."""
    mesh = foreign.can(0.03, 0.1)
    high = mesh.triangles_center[:, 2] > np.median(mesh.vertices[:, 2])
    colors = np.where(high[:, None], COLORS[top], COLORS[below])
    mesh.visual = foreign.trimesh.visual.ColorVisuals(
        mesh, face_colors=np.column_stack([255 * colors, np.full(len(colors), 255)]).astype(np.uint8)
    )
    return foreign.written(mesh, tmp_path, name)


@pytest.mark.parametrize("word", sorted(COLORS))
@pytest.mark.parametrize("seed", range(3))
def test_shades_of_a_colour_are_that_colour(word, seed):
    rng = np.random.default_rng(seed)
    shades = np.clip(np.array(COLORS[word]) + rng.normal(0.0, 0.02, (50, 3)), 0.0, 1.0)

    color, share = said_color(Surface(shades, rng.uniform(0.1, 1.0, 50)))

    assert color == word
    assert share > 0.9


def test_what_is_half_of_one_colour_and_half_of_another_has_none():
    halves = np.array([COLORS["black"], COLORS["white"]])

    assert said_color(Surface(halves, np.array([1.0, 1.0]))) is None
    assert said_color(Surface(halves, np.array([1.0, 3.0])))[0] == "white"


def test_a_place_of_a_picture_is_told_from_its_lower_left():
    image = Image.new("RGB", (4, 4), (255, 0, 0))
    image.putpixel((3, 0), (0, 0, 255))
    file = io.BytesIO()
    image.save(file, "PNG")

    colors = on_picture(file.getvalue(), np.array([[0.9, 0.9], [0.9, 0.1], [1.9, -0.1]]))

    assert colors.tolist() == [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]


def test_the_colour_of_a_mesh_is_guessed_mended_by_a_person_and_told_of_the_thing(tmp_path):
    file = painted(tmp_path, "green", "green")
    import_object(file)
    scene = tmp_path / "scene.toml"
    scene.write_text(ON_THE_TABLE)

    assert "of what is seen" in sidecar_file(file).read_text()
    assert load_scene(str(scene)).objects[0].color == "green"

    said = sidecar_file(file).read_text().replace('color = "green"', 'color = "blue"')
    sidecar_file(file).write_text(said)
    import_object(file)
    assert load_scene(str(scene)).objects[0].color == "blue"


def test_a_thing_of_two_colours_and_one_without_any_have_none(tmp_path):
    for file in (
        painted(tmp_path, "red", "white"),
        foreign.written(foreign.can(0.03, 0.1), tmp_path, "x.stl"),
    ):
        import_object(file)

        assert read_sidecar(sidecar_file(file), Sidecar).color is None
