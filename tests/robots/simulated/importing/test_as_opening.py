"""Doors and drawers of foreign furniture open in the scene that is made of it."""

import math

import numpy as np
import pytest

from robots.scenes.scene_file import load_scene
from robots.simulated.importing.import_scene import import_scene

TABLE = """
<body name="table" pos="0 0 0"><geom type="box" size=".6 .6 .02" pos="0 0 .8"/>
<geom type="box" size=".03 .03 .39" pos=".5 .5 .39"/>
<geom type="box" size=".03 .03 .39" pos="-.5 -.5 .39"/></body>"""


def drawers(yaw_deg, count, rng):
    """A cabinet on the table with some drawers, and their measures."""
    deep, wide, high = rng.uniform(0.08, 0.12), rng.uniform(0.1, 0.16), rng.uniform(0.03, 0.05)
    out, travel = rng.uniform(0.02, 0.05), rng.uniform(0.1, 0.2)
    rows = "".join(
        f"""
  <body name="chest_drawer_{k}" pos="0 0 {high + 0.02 + 2.05 * high * k}">
    <joint type="slide" axis="-1 0 0" range="0 {travel}" limited="true"/>
    <geom type="box" size=".005 {wide} {high}" pos="{-deep} 0 0"/>
    <geom type="box" size="{0.8 * deep} {0.9 * wide} .003" pos="0 0 {-0.8 * high}"/>
    <geom type="box" size="{0.8 * deep} .003 {0.6 * high}" pos="0 {0.9 * wide} 0"/>
    <geom type="box" size=".006 .04 .006" pos="{-deep - 0.005 - out} 0 0"/>
    <geom type="box" size="{out / 2} .004 .004" pos="{-deep - 0.005 - out / 2} .03 0"/></body>"""
        for k in range(count)
    )
    body = f"""
<body name="small_chest_1" pos=".1 .2 .82" euler="0 0 {yaw_deg}">
  <geom type="box" size="{deep} {wide + 0.01} .005" pos=".01 0 .005"/>
  <geom type="box" size="{deep} .004 {count * high}" pos=".01 {wide + 0.006} {count * high + 0.02}"/>
  <geom type="box" size="{deep} .004 {count * high}" pos=".01 {-wide - 0.006} {count * high + 0.02}"/>{rows}
</body>"""
    return body, (deep, wide, high, out, travel)


def oven(yaw_deg, side):
    return f"""
<body name="mini_oven_main" pos="-.1 -.2 .82" euler="0 0 {yaw_deg}">
  <geom type="box" size=".12 .17 .01" pos="0 0 .2"/><geom type="box" size=".12 .17 .01" pos="0 0 .01"/>
  <geom type="box" size=".01 .17 .1" pos=".11 0 .1"/>
  <body name="oven_door" pos="-.125 {side * 0.17} .1">
    <joint type="hinge" axis="0 0 {-side}" range="0 100" limited="true"/>
    <geom type="box" size=".005 .17 .095" pos="0 {-side * 0.17} 0"/>
    <geom type="capsule" size=".007" fromto="-.05 {-side * 0.3} -.05 -.05 {-side * 0.3} .05"/>
  </body>
</body>"""


def imported(tmp_path, world):
    file = tmp_path / "kitchen.xml"
    file.write_text(
        f'<mujoco><worldbody><geom type="plane" size="4 4 .1"/>{TABLE}{world}</worldbody></mujoco>'
    )
    written = import_scene(file)
    return load_scene(str(written.scene)), written


@pytest.mark.parametrize("yaw_deg", [0, 90, -140])
@pytest.mark.parametrize("count", [1, 2, 3])
def test_every_drawer_of_a_chest_opens_by_its_own_bar(tmp_path, yaw_deg, count):
    rng = np.random.default_rng(count)
    world, (_, wide, high, out, travel) = drawers(yaw_deg, count, rng)
    scene, written = imported(tmp_path, world)
    piece = next(one for one in scene.furniture if one.openings)

    names = [one.name for one in sorted(piece.openings, key=lambda one: -one.boxes[0].position_m[2])]
    expected = {1: ["drawer"], 2: ["top drawer", "bottom drawer"]}
    assert names == expected.get(count, ["top drawer", "middle drawer", "bottom drawer"])
    for one in piece.openings:
        front, bar = one.boxes[0], one.bar
        assert one.travel == pytest.approx(travel, abs=1e-3)
        assert front.size_m == pytest.approx((0.01, 2 * wide, 2 * high), abs=2e-3)
        assert len(one.boxes) == 3
        face = front.position_m[0] - 0.5 * front.size_m[0]
        assert face - bar.position_m[0] == pytest.approx(out, abs=2e-3)
        assert (bar.length_m, bar.radius_m) == pytest.approx((0.08, 0.006), abs=1e-3)
        assert not bar.upright
    assert piece.yaw_rad == pytest.approx(math.radians(yaw_deg), abs=1e-3)
    assert len(piece.boxes) == 3
    assert not any("does not move" in told for told in written.told)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("yaw_deg", [0, 60])
def test_a_door_hangs_where_its_joint_is(tmp_path, yaw_deg, side):
    scene, _ = imported(tmp_path, oven(yaw_deg, side))
    piece = next(one for one in scene.furniture if one.openings)
    (door,) = piece.openings
    front = door.boxes[0]

    assert (door.name, door.kind) == ("door", "door")
    assert door.hinge == ("left" if side > 0 else "right")
    assert door.hinge_m[1] - front.position_m[1] == pytest.approx(side * 0.17, abs=2e-3)
    assert door.bar.position_m[1] - front.position_m[1] == pytest.approx(-side * 0.13, abs=2e-3)
    assert door.bar.upright
    assert door.travel == pytest.approx(math.radians(100.0), abs=1e-3)


def test_what_opens_to_another_side_stays_shut_and_is_told(tmp_path):
    aside = """
  <body name="side_door" pos=".05 -.18 .1"><joint type="hinge" axis="0 0 1" range="0 90" limited="true"/>
    <geom type="box" size=".05 .005 .09" pos=".05 0 0"/></body>
</body>"""
    world = oven(0, 1).rstrip().removesuffix("</body>") + aside
    scene, written = imported(tmp_path, world)
    piece = next(one for one in scene.furniture if one.openings)

    assert [one.name for one in piece.openings] == ["door"]
    assert any("side_door does not move here: it opens to another side" in told for told in written.told)
