"""Asked what is in a box that is open at the top, the robot tells what is in it, and nothing else."""

import pytest

from executive.embedding.requests import Requests
from executive.session.assembly import assemble
from robots.scenes.scene_file import read_scene

SCENE = """
[[furniture]]
name = "table"
kind = "table"
size_m = [0.6, 1.2, 0.9]
position_m = [0.65, 0.0]

[[object]]
name = "white box"
kind = "box"
color = "white"
size_m = [0.2, 0.3, 0.08]
wall_m = 0.01
mass_kg = 0.3
friction = 0.6
on = "table"
position_m = [-0.1, 0.2]

[[object]]
name = "green ball"
kind = "ball"
color = "green"
radius_m = 0.03
mass_kg = 0.1
friction = 0.6
position_m = [0.55, 0.25, 0.94]

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


@pytest.mark.requirement("M2")
@pytest.mark.parametrize(
    ("question", "said"),
    [
        ("what is in the box?", "in or on the box I see one green ball"),
        ("how many balls are in the box?", "there is one ball"),
        ("how many cups are in the box?", "there are no cups"),
    ],
)
def test_what_is_in_the_box_is_told_as_it_is(question, said):
    assembly = assemble("talos", read_scene(SCENE, "hollow.toml", "hollow"), 1)

    (result,) = Requests(assembly.session).submit(question).result()

    assert result.outcome == "done"
    assert result.evidence["said"] == said
