"""Parts of furniture with a name of their own, in a scene file."""

import numpy as np
import pytest

from robots.errors import SceneError
from robots.scenes.furniture import region_plates
from robots.scenes.scene_description import spoken_words
from robots.scenes.scene_file import read_scene
from robots.scenes.scene_writer import dump

STOVE = """
[[furniture]]
name = "table"
kind = "table"
size_m = [0.6, 1.2, 0.8]
position_m = [1.0, 0.2]
yaw_rad = 1.2
[[furniture.region]]
name = "left burner"
size_m = [0.15, 0.12, 0.01]
position_m = [0.1, -0.2, 0.8]
[[furniture.region]]
name = "right burner"
size_m = [0.15, 0.12, 0.01]
position_m = [0.1, 0.2, 0.8]
"""


def test_a_region_is_read_back_as_it_was_written_and_its_floor_is_where_things_stand():
    scene = read_scene(STOVE, "stove.toml", "stove")

    assert read_scene(dump(scene), "stove.toml", "stove") == scene
    left, right = region_plates(scene.furniture[0])
    c, s = np.cos(1.2), np.sin(1.2)
    assert (left.name, right.name) == ("table/left burner", "table/right burner")
    assert left.world_T_solid[:2, 3] == pytest.approx([1.0 + c * 0.1 + s * 0.2, 0.2 + s * 0.1 - c * 0.2])
    assert left.world_T_solid[2, 3] + 0.5 * left.shape.height_m == pytest.approx(0.8)
    assert {"left burner", "right burner"} <= spoken_words(scene)


@pytest.mark.parametrize(
    ("old", "new", "key"),
    [
        ("0.15, 0.12", "0.15, 0.0", "region[0].size_m"),
        ("0.1, -0.2, 0.8", "0.1, nan, 0.8", "region[0].position_m"),
        ("0.1, -0.2, 0.8", "0.1, -0.2, -0.8", "region[0].position_m"),
        ('"right burner"', '"left burner"', "region[1].name"),
        ('"left burner"', '"left/burner"', "region[0].name"),
    ],
)
def test_what_is_wrong_with_a_region_is_told_by_its_key(old, new, key):
    with pytest.raises(SceneError) as refused:
        read_scene(STOVE.replace(old, new, 1), "stove.toml", "stove")

    assert key in str(refused.value)
