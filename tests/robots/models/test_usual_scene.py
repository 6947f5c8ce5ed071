"""A robot is before furniture of its own size when nobody says where."""

import pytest

from robots.models.usual_scene import USUAL_SCENE, usual_scene


@pytest.mark.parametrize(
    ("robot", "scene"), [("talos", USUAL_SCENE), ("g1", "low_tabletop"), ("panda", "bench")]
)
def test_a_robot_is_where_its_description_says(robot, scene):
    assert usual_scene(robot) == scene


@pytest.mark.parametrize("text", ["", "[body]\nbase_link = 'b'\n", "body = 3\n", "[body\n"])
def test_a_description_that_names_none_leaves_the_usual_one(tmp_path, text):
    (tmp_path / "description.toml").write_text(text, "utf-8")
    assert usual_scene(str(tmp_path)) == USUAL_SCENE


def test_a_scene_file_is_looked_for_beside_the_description(tmp_path):
    (tmp_path / "description.toml").write_text("[body]\nscene = 'kitchen.toml'\n", "utf-8")
    assert usual_scene(str(tmp_path)) == str(tmp_path / "kitchen.toml")


def test_of_a_robot_that_nobody_knows_the_usual_one_is_told():
    assert usual_scene("nobody") == USUAL_SCENE
