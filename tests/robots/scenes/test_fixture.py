"""What is fixed where it stands: boxes, knobs and buttons of a scene file."""

import numpy as np
import pytest

from robots.errors import SceneError
from robots.scenes.furniture import solids
from robots.scenes.scene_file import read_scene
from robots.scenes.scene_writer import dump

STOVE = """
[[furniture]]
name = "table"
kind = "table"
size_m = [0.6, 1.2, 0.8]
position_m = [1.0, 0.0]

[[furniture]]
name = "stove"
kind = "fixture"
size_m = [0.3, 0.4, 1.0]
position_m = [1.0, 0.0]
foot_m = 0.8
[[furniture.control]]
name = "knob"
kind = "knob"
position_m = [-0.15, 0.1, 0.9]
"""


def test_a_fixture_stands_on_a_table_and_is_read_back_as_it_was_written():
    scene = read_scene(STOVE, "stove.toml", "stove")

    again = read_scene(dump(scene), "stove.toml", "stove")

    assert again == scene
    (box,) = solids(scene.furniture[1])
    assert box.world_T_solid[:3, 3] == pytest.approx([1.0, 0.0, 0.9])
    assert box.shape.size_m == pytest.approx((0.3, 0.4, 0.2))


def test_the_box_that_carries_things_is_the_largest_at_the_top():
    boxes = "".join(
        f"[[furniture.box]]\nsize_m = {size}\nposition_m = {at}\n"
        for size, at in (
            ([0.3, 0.02, 0.2], [0.0, 0.19, 0.9]),
            ([0.3, 0.4, 0.02], [0.0, 0.0, 0.99]),
        )
    )
    scene = read_scene(STOVE.replace("foot_m = 0.8\n", f"foot_m = 0.8\n{boxes}"), "stove.toml", "stove")

    first, _ = solids(scene.furniture[1])

    assert first.name == "stove/top"
    assert first.shape.size_m == pytest.approx((0.3, 0.4, 0.02))


@pytest.mark.parametrize(
    ("old", "new", "key"),
    [
        ("foot_m = 0.8", "foot_m = 1.2", "foot_m"),
        ('name = "knob"', 'name = "knob"\ntravel = 9.0', "travel"),
        ('kind = "knob"', 'kind = "lever"', "kind"),
    ],
)
def test_a_fixture_that_cannot_be_is_refused_with_its_key(old, new, key):
    with pytest.raises(SceneError, match=key):
        read_scene(STOVE.replace(old, new), "stove.toml", "stove")


def test_objects_stand_on_a_fixture():
    can = '[[object]]\nname = "can"\nkind = "can"\nradius_m = 0.03\nheight_m = 0.1\non = "stove"\n'

    scene = read_scene(STOVE + can, "stove.toml", "stove")

    assert scene.objects[0].world_T_object[2, 3] == pytest.approx(1.05)
    assert np.allclose(scene.objects[0].world_T_object[:2, 3], [1.0, 0.0])
