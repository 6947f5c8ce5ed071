"""Scene files: what they say, and how they are refused."""

from contextlib import suppress
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.errors import SceneError
from robots.outside import known_scenes
from robots.scenes.scene_description import (
    PerceptionModel,
    Person,
    RobotStart,
    SceneDescription,
    SceneItem,
    spoken_words,
)
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_rules import validate
from robots.scenes.scene_writer import dump

TABLE = """
[[furniture]]
name = "table"
kind = "table"
size_m = [0.6, 1.2, 0.9]
position_m = [0.65, 0.0]
"""

CUP = """
[[object]]
name = "red cup"
kind = "cup"
color = "red"
radius_m = 0.03
height_m = 0.11
mass_kg = 0.2
friction = 0.6
on = "table"
position_m = [-0.15, -0.2]
"""


def read(text):
    return read_scene(text, "kitchen.toml", "kitchen")


def refused(text):
    with pytest.raises(SceneError) as caught:
        read(text)
    assert caught.value.source == "kitchen.toml"
    assert "\n" not in str(caught.value)
    return caught.value


def changed(line, instead):
    assert line in TABLE + CUP
    return (TABLE + CUP).replace(line, instead)


def test_the_default_scene_is_a_red_cup_on_a_table_with_a_blue_box_well_away():
    scene = load_scene("tabletop")
    cup, box = scene.objects

    assert (cup.kind, cup.color, cup.shape) == ("cup", "red", Cylinder(0.03, 0.11))
    assert (box.kind, box.color) == ("box", "blue")
    assert scene.furniture[0].size_m == (0.6, 1.2, 0.9)
    assert np.linalg.norm(cup.world_T_object[:3, 3] - box.world_T_object[:3, 3]) > 0.3


def test_the_clutter_has_its_red_cup_between_others():
    scene = load_scene("clutter")
    assert 6 <= len(scene.objects) <= 8
    assert [item.kind for item in scene.objects if item.color == "red"] == ["cup"]


@pytest.mark.parametrize("name", known_scenes())
def test_every_scene_that_comes_along_survives_writing_and_reading(name):
    scene = load_scene(name)
    again = read_scene(dump(scene), "again.toml", name)

    assert dump(again) == dump(scene)
    assert again.furniture == scene.furniture
    for one, other in zip(scene.objects, again.objects, strict=True):
        assert one.world_T_object == pytest.approx(other.world_T_object, abs=1e-15)


def test_a_position_on_a_table_is_in_the_frame_of_its_tops_centre():
    turned = changed("position_m = [0.65, 0.0]", "position_m = [1.0, 0.5]\nyaw_rad = 1.5707963267948966")
    pose = read(turned).objects[0].world_T_object

    assert pose[:3, 3] == pytest.approx((1.0 + 0.2, 0.5 - 0.15, 0.9 + 0.055))
    assert poses.yaw_of(pose[:3, :3]) == pytest.approx(np.pi / 2.0)


def test_a_free_position_is_that_of_the_centre():
    free = changed('on = "table"\nposition_m = [-0.15, -0.2]', "position_m = [1.5, 1.0, 0.055]")
    assert read(free).objects[0].world_T_object[:3, 3] == pytest.approx((1.5, 1.0, 0.055))


@pytest.mark.parametrize(
    ("kind", "keys", "shape"),
    [
        ("ball", "radius_m = 0.04", Ball(0.04)),
        ("box", "size_m = [0.1, 0.08, 0.06]", Box((0.1, 0.08, 0.06))),
        ("bottle", "radius_m = 0.03\nheight_m = 0.2", Cylinder(0.03, 0.2)),
        ("bowl", "radius_m = 0.07\nheight_m = 0.05", Cylinder(0.07, 0.05)),
        ("can", "radius_m = 0.03\nheight_m = 0.12", Cylinder(0.03, 0.12)),
    ],
)
def test_each_kind_has_its_shape(kind, keys, shape):
    text = changed('kind = "cup"', f'kind = "{kind}"').replace("radius_m = 0.03\nheight_m = 0.11", keys)
    assert read(text).objects[0].shape == shape


def test_what_is_left_out_has_its_declared_default():
    scene = read(TABLE + CUP)
    assert scene.robot_start == RobotStart()
    assert scene.perception == PerceptionModel()
    assert scene.furniture[0].friction == 0.7


def test_perception_and_start_are_read():
    head = "robot_start = { x_m = 0.02, yaw_rad = -0.05 }\n[perception]\nbias_m = 0.01\nlatency_s = 0.1\n"
    scene = read(head + TABLE + CUP)
    assert scene.robot_start == RobotStart(0.02, 0.0, -0.05)
    assert scene.perception == replace(PerceptionModel(), bias_m=0.01, latency_s=0.1)


@pytest.mark.parametrize(
    ("line", "instead", "key", "says"),
    [
        ("mass_kg = 0.2", "mass_kg = 0", "object[0].mass_kg", "not 0"),
        ("mass_kg = 0.2", "mass_kg = -1.0", "object[0].mass_kg", "not -1"),
        ("mass_kg = 0.2", 'mass_kg = "heavy"', "object[0].mass_kg", "must be a number, not 'heavy'"),
        ("mass_kg = 0.2", "mass_kg = nan", "object[0].mass_kg", "finite"),
        ("mass_kg = 0.2", "mass_kg = true", "object[0].mass_kg", "must be a number"),
        ("radius_m = 0.03", "", "object[0].radius_m", "is missing"),
        ("radius_m = 0.03", "radus_m = 0.03", "object[0].radus_m", "nearest is 'radius_m'"),
        ("radius_m = 0.03", "radus_m = 0.03\nfrom = 1", "object[0].radus_m", "nearest is 'radius_m'"),
        ('kind = "cup"', "kind = 3", "object[0].kind", "must be a text in quotes, not 3"),
        ('kind = "cup"', "", "object[0].kind", "is missing"),
        ("mass_kg = 0.2", "mas_kg = 0.2", "object[0].mas_kg", "'mass_kg'"),
        ("radius_m = 0.03", "radius_m = 0", "object[0].radius_m", "not 0"),
        ("height_m = 0.11", "height_m = -0.1", "object[0].height_m", "not -0.1"),
        ("friction = 0.6", "friction = 0", "object[0].friction", "above 0"),
        ("friction = 0.6", "friction = -0.6", "object[0].friction", "above 0"),
        ('kind = "cup"', 'kind = "cupp"', "object[0].kind", "nearest is 'cup'"),
        ('kind = "cup"', 'kind = "box"', "object[0].size_m", "is missing"),
        ('color = "red"', 'color = "rad"', "object[0].color", "nearest is 'red'"),
        ('on = "table"', 'on = "tabel"', "object[0].on", "nearest is 'table'"),
        ("[-0.15, -0.2]", "[-0.295, -0.2]", "object[0].position_m", "would tip off the edge of 'table'"),
        ("[-0.15, -0.2]", "[-0.15, 2.0]", "object[0].position_m", "would tip off the edge of 'table'"),
        ("[-0.15, -0.2]", "[-0.15]", "object[0].position_m", "list of 2 numbers"),
        ("[-0.15, -0.2]", "[-0.15, inf]", "object[0].position_m[1]", "finite"),
        ('name = "red cup"', 'name = ""', "object[0].name", "text in quotes"),
        ('name = "red cup"', 'name = "table"', "object[0].name", "also furniture[0].name"),
        ('kind = "table"', 'kind = "tabel"', "furniture[0].kind", "nearest is 'table'"),
        ("size_m = [0.6, 1.2, 0.9]", "size_m = [0.6, 1.2, 0]", "furniture[0].size_m", "height"),
        ("size_m = [0.6, 1.2, 0.9]", "size_m = 0.6", "furniture[0].size_m", "list of 3 numbers"),
        ("[0.65, 0.0]", "[0.45, 0.0]", "robot_start", "stands inside furniture 'table'"),
        ("[[object]]", "[[objekt]]", "objekt", "nearest is 'object'"),
        ("[[object]]", "[object]", "object", "[[object]]"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused_with_key_and_reason(line, instead, key, says):
    error = refused(changed(line, instead))
    assert error.key == key
    assert says in error.reason


@pytest.mark.parametrize(
    ("position", "says"),
    [
        ("[1.5, 1.0, 0.5]", "hangs 0.4450 m in the air"),
        ("[0.5, -0.2, 1.0]", "hangs 0.0450 m in the air"),
        ("[1.5, 1.0, 0.02]", "deep in the floor"),
        ("[0.5, -0.2, 0.9]", "overlaps furniture 'table'"),
        ("[0.37, 0.59, 0.5]", "overlaps furniture 'table'"),  # a leg
        ("[0.65, 0.0, 0.5]", "hangs"),  # between the legs
        ("[0.05, 0.1, 0.055]", "overlaps the robot's start"),
    ],
)
def test_free_objects_must_stand_somewhere_and_inside_nothing(position, says):
    error = refused(changed('on = "table"\nposition_m = [-0.15, -0.2]', f"position_m = {position}"))
    assert error.key == "object[0].position_m"
    assert says in error.reason


def second_cup(gap_m):
    other = CUP.replace('"red cup"', '"other cup"')
    return TABLE + CUP + other.replace("[-0.15, -0.2]", f"[-0.15, {-0.2 + 0.06 + gap_m!r}]")


def test_two_cups_may_stand_a_millimetre_apart():
    assert len(read(second_cup(0.001)).objects) == 2


def test_two_cups_inside_one_another_are_refused():
    error = refused(second_cup(-0.002))
    assert error.key == "object[1].position_m"
    assert "object 'other cup' overlaps object 'red cup'" in error.reason


def test_an_object_may_stand_on_another():
    base = CUP.replace('kind = "cup"', 'kind = "box"').replace(
        "radius_m = 0.03\nheight_m = 0.11", "size_m = [0.1, 0.1, 0.05]"
    )
    cup = CUP.replace('"red cup"', '"upper cup"').replace(
        'on = "table"\nposition_m = [-0.15, -0.2]', "position_m = [0.5, -0.2, 1.005]"
    )
    assert len(read(TABLE + base + cup).objects) == 2


def test_two_tables_in_one_place_are_refused():
    error = refused(
        TABLE + TABLE.replace('name = "table"', 'name = "desk"').replace("[0.65, 0.0]", "[0.9, 0.3]")
    )
    assert error.key == "furniture[1].position_m"


def test_furniture_has_names_and_sorts_and_keeps_them_when_it_is_written():
    scene = read(TABLE + 'names = ["sideboard", "credenza"]\ncategories = ["antiques"]\n')
    (piece,) = scene.furniture

    assert (piece.names, piece.categories) == (("sideboard", "credenza"), ("antiques",))
    assert read(dump(scene)).furniture == (piece,)
    assert {"sideboard", "credenza", "antiques"} <= spoken_words(scene)


@pytest.mark.parametrize("key", ["names", "categories"])
def test_a_name_of_furniture_that_nobody_says_is_refused(key):
    error = refused(TABLE + f'{key} = ["desk", "{"x" * 200}"]\n')

    assert error.key == f"furniture[0].{key}"
    assert "200" in error.reason


@pytest.mark.parametrize(("name", "told"), [("fridge", "fridge"), ("top shelf", "shelf")])
def test_a_table_that_is_named_as_another_kind_is_refused(name, told):
    error = refused(TABLE.replace('name = "table"', f'name = "{name}"'))

    assert error.key == "furniture[0].name"
    assert error.reason == f"{name!r} is a name for the kind {told!r}, but the kind is 'table'"


def test_a_person_in_the_table_is_refused():
    error = refused(TABLE + '[[person]]\nname = "Ana"\nposition_m = [0.7, 0.2]\n')
    assert error.key == "person[0].position_m"


@pytest.mark.parametrize(
    ("line", "key"),
    [
        ("dropout = 1.5", "perception.dropout"),
        ("bias_m = -0.1", "perception.bias_m"),
        ("rate_hz = 0", "perception.rate_hz"),
        ('kind = "stubb"', "perception.kind"),
        ("blur = 1", "perception.blur"),
    ],
)
def test_impossible_perception_is_refused(line, key):
    assert refused(f"[perception]\n{line}\n" + TABLE).key == key


def test_what_is_no_toml_is_refused():
    assert "is no TOML" in refused("table = [").reason


def test_a_missing_file_names_the_scene_that_was_meant():
    with pytest.raises(SceneError, match=r"there is no such file; did you mean the scene 'tabletop'\?"):
        load_scene("tabeltop.toml")


def test_an_unknown_name_is_answered_with_the_nearest():
    with pytest.raises(SceneError, match="the nearest is 'clutter'"):
        load_scene("cluter")


def test_a_folder_and_a_binary_file_are_refused(tmp_path):
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe\x00")
    (tmp_path / "folder.toml").mkdir()
    for name in ("binary.toml", "folder.toml"):
        with pytest.raises(SceneError, match="cannot be read"):
            load_scene(str(tmp_path / name))


def test_a_file_is_read_by_its_path(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(TABLE + CUP)
    assert load_scene(str(path)).name == "mine"


def test_a_scene_made_by_a_program_is_judged_the_same():
    cup = SceneItem("cup", "cup", "red", Cylinder(0.03, 0.1), 0.2, 0.6, poses.translation(1.5, 1.0, 0.3))
    with pytest.raises(SceneError, match="hangs"):
        validate(SceneDescription("made", objects=(cup,)), "made")
    validate(SceneDescription("made", people=(Person("Ana", (1.5, 0.8), 0.0),)), "made")


def test_a_lying_cup_may_be_in_a_scene_but_not_in_a_file():
    lying = poses.transform(poses.rotation_x(np.pi / 2.0), (1.5, 1.0, 0.03))
    scene = SceneDescription(
        "made", objects=(SceneItem("cup", "cup", "red", Cylinder(0.03, 0.1), 0.2, 0.6, lying),)
    )
    validate(scene, "made")
    with pytest.raises(ValueError, match="tilted"):
        dump(scene)


@given(st.text(max_size=300))
def test_any_text_is_a_scene_or_a_scene_error(text):
    with suppress(SceneError):
        read(text)


values = st.one_of(
    st.integers(), st.floats(), st.booleans(), st.text(max_size=8), st.lists(st.floats(), max_size=4)
)


@given(st.sampled_from(["mass_kg", "radius_m", "position_m", "on", "kind", "friction", "yaw_rad"]), values)
def test_any_value_of_a_key_is_a_scene_or_a_scene_error(key, value):
    def toml(item):
        if isinstance(item, bool):
            return str(item).lower()
        if isinstance(item, str):
            return "'" + "".join(c for c in item if c.isalnum()) + "'"
        return str(item)

    lines = [line for line in CUP.splitlines() if not line.startswith(f"{key} ")]
    with suppress(SceneError):
        read(TABLE + "\n".join([*lines, f"{key} = {toml(value)}"]))


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
def test_a_file_with_a_byte_order_mark_is_the_same_scene(tmp_path, ending):
    file = tmp_path / "kitchen.toml"
    file.write_bytes(b"\xef\xbb\xbf" + (TABLE + CUP).replace("\n", ending).encode())

    assert dump(load_scene(str(file))) == dump(read(TABLE + CUP))


def test_an_object_that_is_nowhere_is_refused_with_what_to_write():
    text = TABLE + CUP.replace('on = "table"\n', "").replace("position_m = [-0.15, -0.2]\n", "")

    assert 'position_m: is missing: say where its centre is, [x, y, z], or on = "table"' in str(refused(text))


def test_a_scene_of_very_many_things_is_refused_before_they_are_held_against_each_other():
    ball = '[[object]]\nname = "b{0}"\nkind = "ball"\nradius_m = 0.03\nposition_m = [{0}, 3.0, 0.03]\n'

    error = refused("".join(ball.format(k) for k in range(501)))

    assert "has 501 things; a scene holds at most 500" in str(error)
