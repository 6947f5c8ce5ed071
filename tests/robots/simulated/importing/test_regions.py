"""Parts that foreign files give a name to become named parts of fixtures, or are told not to be here."""

import tomllib

import pytest

from robots.scenes.scene_file import load_scene
from robots.simulated.importing.import_scene import import_scene

TABLE = '<body name="kitchen_table" pos=".9 0 0"><geom type="box" size=".35 .7 .02" pos="0 0 .82"/></body>'
STOVE = """
<body name="flat_stove_1_main" pos=".9 .2 .84" euler="0 0 {yaw}">
  <geom type="box" size=".12 .15 .02" pos="0 0 .02"/>
  <site name="flat_stove_1_cook_region" type="box" size=".06 .07 .005" pos=".03 -.05 .045"/>
  <site name="flat_stove_1_top_site" size=".006" pos="0 0 .06"/>
</body>"""
CADDY = """
<body name="desk_caddy_1" pos=".9 -.3 .84">
  <geom type="box" size=".1 .1 .005" pos="0 0 .005"/>
  <geom type="box" size=".1 .005 .04" pos="0 .095 .04"/>
  <geom type="box" size=".1 .005 .04" pos="0 -.095 .04"/>
  <geom type="box" size=".005 .1 .04" pos=".095 0 .04"/>
  <geom type="box" size=".005 .1 .04" pos="-.095 0 .04"/>
  <geom name="desk_caddy_1_reg_main" type="box" size=".1 .1 .04" pos="0 0 .04" {}/>
  <geom name="desk_caddy_1_reg_back" type="box" size=".08 .08 .03" pos="0 0 .045" {}/>
</body>""".format(*2 * ('contype="0" conaffinity="0"',))


def imported(tmp_path, world):
    file = tmp_path / "kitchen.xml"
    file.write_text(
        f'<mujoco><worldbody><geom type="plane" size="4 4 .1"/>{TABLE}{world}</worldbody></mujoco>'
    )
    written = import_scene(file)
    scene = load_scene(str(written.scene))
    return {piece.name: piece for piece in scene.furniture}, tomllib.loads(written.guesses.read_text())


@pytest.mark.parametrize("yaw", [0, 90])
def test_a_box_site_is_a_part_whose_floor_is_the_top_below_it(tmp_path, yaw):
    pieces, guesses = imported(tmp_path, STOVE.format(yaw=yaw))

    (burner,) = pieces["flat stove"].regions
    assert burner.name == "flat stove cook"
    assert burner.position_m[2] == pytest.approx(0.88, abs=1e-3)
    assert sorted(burner.size_m[:2]) == pytest.approx([0.12, 0.14], abs=1e-3)
    (told,) = guesses["region"]
    assert told == {
        "said": "flat_stove_1_cook_region",
        "of": "flat stove",
        "name": "flat stove cook",
        "is_here": True,
    }


def test_a_geom_that_is_called_a_region_is_one_and_the_whole_piece_is_none(tmp_path):
    pieces, _ = imported(tmp_path, CADDY)

    (back,) = pieces["desk caddy"].regions
    assert back.name == "desk caddy back"
    assert back.position_m == pytest.approx((0.0, 0.0, 0.85), abs=1e-3)
    assert back.size_m == pytest.approx((0.16, 0.16, 0.065), abs=1e-3)
