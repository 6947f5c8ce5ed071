"""What a detector tells of an object besides its kind."""

import pytest

from robots.errors import SceneError
from robots.perception.told_labels import told_labels
from robots.scenes.scene_description import told_names
from robots.scenes.scene_file import read_scene
from robots.scenes.scene_writer import dump

TABLE = '[[furniture]]\nname = "table"\nkind = "table"\nsize_m = [0.6, 1.2, 0.9]\nposition_m = [0.65, 0.0]\n'
CAN = """
[[object]]
name = "tomato soup"
kind = "can"
names = ["soup"]
categories = ["food"]
radius_m = 0.03
height_m = 0.1
position_m = [0.5, 0.0, 0.05]
"""


@pytest.mark.parametrize(
    ("name", "kind", "names", "told"),
    [
        ("red can 2", "can", (), ()),
        ("can", "can", (), ()),
        ("orange", "ball", (), ("orange",)),
        ("tomato soup", "can", (), ("tomato soup",)),
        ("tomato soup 2", "can", (), ("tomato soup",)),
        ("red cup", "cup", ("my favourite",), ("my favourite",)),
        ("Tomato soup", "can", ("tomato soup",), ("tomato soup",)),
    ],
)
def test_a_name_counts_when_it_says_more_than_colour_kind_and_number(name, kind, names, told):
    assert told_names(name, kind, names) == told


def test_names_and_categories_of_a_scene_file_are_read_and_written():
    scene = read_scene(CAN, "one.toml", "one")

    assert (scene.objects[0].names, scene.objects[0].categories) == (("soup",), ("food",))
    again = read_scene(dump(scene), "two.toml", "one").objects[0]
    assert (again.names, again.categories) == (("soup",), ("food",))


@pytest.mark.parametrize(
    ("keys", "shape"),
    [
        ('kind = "teapot"\nradius_m = 0.05\nheight_m = 0.1', "Cylinder"),
        ('kind = "sponge"\nsize_m = [0.05, 0.05, 0.03]', "Box"),
        ('kind = "orange"\nradius_m = 0.04', "Ball"),
        ('kind = "cupp"\nshape = "cylinder"\nradius_m = 0.04\nheight_m = 0.1', "Cylinder"),
        ('kind = "nest"\nshape = "bowl"\nradius_m = 0.04\nheight_m = 0.1\nwall_m = 0.006', "Cylinder"),
    ],
)
def test_any_kind_has_the_shape_that_is_said_or_that_its_sizes_tell(keys, shape):
    scene = read_scene(f'{TABLE}[[object]]\nname = "it"\n{keys}\non = "table"', "a.toml", "a")

    assert type(scene.objects[0].shape).__name__ == shape


@pytest.mark.parametrize(
    ("keys", "reason"),
    [
        ('kind = "cupp"\nradius_m = 0.04\nheight_m = 0.1', "the nearest is 'cup'"),
        ('kind = "teapot"', "say size_m"),
        ('kind = "can"\nradius_m = 0.03\nheight_m = 0.1\nnames = [""]', "names"),
    ],
)
def test_what_is_no_kind_says_what_would_be(keys, reason):
    with pytest.raises(SceneError, match=reason):
        read_scene(f'[[object]]\nname = "it"\n{keys}\nposition_m = [0.5, 0.0, 0.2]', "a.toml", "a")


def test_a_scene_that_declares_any_word_has_open_perception():
    assert told_labels((), ("any",)) is None
    assert {"cup", "table", "door", "rubik's cube"} <= told_labels((), ("Rubik's cube",))
