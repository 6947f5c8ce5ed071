import pytest

from robots.errors import SceneError
from robots.scenes.light import Light, LightChange
from robots.scenes.scene_file import read_scene
from robots.scenes.scene_writer import dump

DIM_THEN_WARM = """
[light]
kind = "dim"
[[light.change]]
at_s = 2.5
kind = "warm"
"""


def test_a_scene_says_how_it_is_lit_and_how_that_changes():
    light = read_scene(DIM_THEN_WARM, "scene.toml", "scene").light

    assert light == Light("dim", (LightChange(2.5, "warm"),))
    assert (light.at(2.4), light.at(2.5)) == ("dim", "warm")


def test_light_is_bright_where_a_scene_says_nothing():
    assert read_scene("", "scene.toml", "scene").light.at(100.0) == "bright"


def test_light_that_is_written_is_read_back():
    scene = read_scene(DIM_THEN_WARM, "scene.toml", "scene")

    assert read_scene(dump(scene), "scene.toml", "scene").light == scene.light


@pytest.mark.parametrize(
    ("text", "key"),
    [
        ('[light]\nkind = "pink"\n', "light.kind"),
        (
            '[[light.change]]\nat_s = 2.0\nkind = "dim"\n[[light.change]]\nat_s = 1.0\nkind = "dim"\n',
            "light.change[1].at_s",
        ),
    ],
)
def test_light_that_cannot_be_is_refused_with_its_key(text, key):
    with pytest.raises(SceneError) as refused:
        read_scene(text, "scene.toml", "scene")

    assert refused.value.key == key


def test_a_scene_says_that_the_robot_sees_with_its_camera():
    scene = read_scene('[perception]\nkind = "rgbd"\n', "scene.toml", "scene")

    assert scene.perception.kind == "rgbd"


def test_a_perception_that_there_is_not_is_refused_with_the_nearest():
    with pytest.raises(SceneError, match="rgbd"):
        read_scene('[perception]\nkind = "rgb"\n', "scene.toml", "scene")
