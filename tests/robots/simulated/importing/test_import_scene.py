"""Foreign kitchens, made at random: what is in them is found, and what cannot be is told."""

import numpy as np
import pytest
from PIL import Image

from kinematics.geometry import poses
from robots.errors import CannotImportError
from robots.scenes.scene_file import load_scene
from robots.scenes.scene_words import COLORS
from robots.simulated.importing.bodies import label_of_body, read_foreign
from robots.simulated.importing.import_scene import import_scene
from robots.simulated.importing.inventory import inventory_of
from tests import foreign_meshes as foreign

ROBOT = """
<body name="robot0"><body name="link0" pos="-1 0 1"><joint name="j0" axis="0 0 1"/>
<geom type="box" size=".05 .05 .1"/></body></body>"""
MOTOR = '<actuator><motor joint="j0"/></actuator>'


def scene_of(tmp_path, world, more="", name="kitchen.xml"):
    file = tmp_path / name
    file.write_text(
        f'<mujoco><worldbody><geom type="plane" size="4 4 .1"/>{world}</worldbody>{more}</mujoco>'
    )
    return file


def table(x=0.9, yaw_deg=0.0, top=0.84):
    return f"""
<body name="kitchen_table" pos="{x} 0 0" euler="0 0 {yaw_deg}">
  <geom name="top" type="box" size=".35 .7 .02" pos="0 0 {top - 0.02}"/>
  <geom type="box" size=".03 .03 .35" pos=".3 .6 .35"/><geom type="box" size=".03 .03 .35" pos="-.3 -.6 .35"/>
</body>"""


def can(name, x, y, foot=0.84, radius=0.033, height=0.1):
    return f"""
<body name="{name}" pos="{x} {y} {foot + height / 2 + 0.0005}"><freejoint/>
<geom type="cylinder" size="{radius} {height / 2}"/></body>"""


def cabinet(yaw_deg, out=0.045, drawers=1):
    fronts = "".join(
        f"""
  <body name="drawer_{k}" pos="0 0 {0.6 - 0.2 * k}">
    <joint type="slide" axis="-1 0 0" range="0 .3" limited="true"/>
    <geom type="box" size=".01 .28 .08" pos="-.2 0 0"/><geom type="box" size=".18 .28 .005" pos="0 0 -.07"/>
    <geom type="capsule" size=".008" fromto="{-0.21 - out} -.07 0 {-0.21 - out} .07 0"/>
    <geom type="box" size="{out / 2} .006 .006" pos="{-0.21 - out / 2} .06 0"/></body>"""
        for k in range(drawers)
    )
    return f"""
<body name="wooden_cabinet_1" pos="2.2 1 0" euler="0 0 {yaw_deg}">
  <geom type="box" size=".2 .3 .01" pos="0 0 .7"/><geom type="box" size=".2 .01 .35" pos="0 .3 .35"/>
  <geom type="box" size=".2 .01 .35" pos="0 -.3 .35"/>{fronts}
</body>"""


def fridge(yaw_deg, side):
    return f"""
<body name="fridge_main" pos="2.2 -1.5 0" euler="0 0 {yaw_deg}">
  <geom type="box" size=".28 .3 .02" pos="0 0 1.6"/>
  <geom type="box" size=".28 .02 .8" pos="0 {-side * 0.28} .8"/>
  <geom type="box" size=".02 .3 .8" pos=".28 0 .8"/>
  <body name="fridge_door" pos="-.32 {side * 0.3} .8">
    <joint type="hinge" axis="0 0 {-side}" range="0 110" limited="true"/>
    <geom type="box" size=".02 .3 .75" pos="0 {-side * 0.3} 0"/>
    <geom type="capsule" size=".011" fromto="-.07 {-side * 0.53} 0 -.07 {-side * 0.53} .4"/>
  </body>
</body>"""


@pytest.mark.parametrize("seed", range(3))
def test_free_bodies_are_objects_by_their_names_where_they_stand(tmp_path, seed):
    rng = np.random.default_rng(seed)
    x, y = 0.9 + rng.uniform(-0.2, 0.2), rng.uniform(0.1, 0.5)
    world = table() + can("tomato_soup_1_main", x, y) + can("AlphabetSoup_2", x, -y) + ROBOT

    written = import_scene(scene_of(tmp_path, world, MOTOR))
    scene = load_scene(str(written.scene))

    assert {item.name for item in scene.objects} == {"tomato soup", "alphabet soup"}
    soup = next(item for item in scene.objects if item.name == "tomato soup")
    assert soup.world_T_object[:3, 3] == pytest.approx([x, y, 0.89], abs=1e-3)
    assert soup.names == ("tomato soup",)
    assert "tomato soup" in written.objects
    assert any("robot0: left out, has motors" in line for line in written.told)


@pytest.mark.parametrize("yaw_deg", [0, 35, 140, -110])
def test_a_chest_that_is_turned_is_one_of_ours_with_its_handle_where_it_is(tmp_path, yaw_deg):
    chest = cabinet(yaw_deg).replace("wooden_cabinet_1", "oak_chest_1")
    written = import_scene(scene_of(tmp_path, table() + chest))
    piece = next(one for one in load_scene(str(written.scene)).furniture if one.kind == "drawers")

    assert np.degrees(piece.yaw_rad) == pytest.approx(yaw_deg, abs=0.1)
    assert piece.size_m == pytest.approx((0.41, 0.62, 0.71), abs=0.02)
    assert piece.opens.handle_length_m == pytest.approx(0.156, abs=0.01)
    assert piece.opens.handle_radius_m == pytest.approx(0.008, abs=0.002)


@pytest.mark.parametrize(
    ("called", "drawers"), [("wooden_cabinet_1", 2), ("wooden_cabinet_1", 1), ("chest_1", 2)]
)
def test_what_is_called_otherwise_or_has_more_that_opens_keeps_its_name_and_all_of_it(
    tmp_path, called, drawers
):
    piece_xml = cabinet(20, drawers=drawers).replace("wooden_cabinet_1", called)
    written = import_scene(scene_of(tmp_path, table() + piece_xml))
    piece = next(one for one in load_scene(str(written.scene)).furniture if one.openings)

    assert piece.name == called.removesuffix("_1").replace("_", " ")
    assert len(piece.openings) == drawers
    assert not any("does not move" in line for line in written.told)


@pytest.mark.parametrize("yaw_deg", [0, 60, -90])
@pytest.mark.parametrize("out", [0.03, 0.06])
def test_each_drawer_and_its_handle_is_found_however_the_chest_is_turned(tmp_path, yaw_deg, out):
    file = scene_of(tmp_path, cabinet(yaw_deg, out, drawers=3))

    (piece,) = inventory_of(read_foreign(file)).pieces

    turn = poses.rotation_z(np.radians(yaw_deg))
    assert [one.kind for one in piece.openings] == ["drawer"] * 3
    for k, one in enumerate(piece.openings):
        middle = np.array([2.2, 1.0, 0.0]) + turn @ np.array([-0.21 - out, 0.0, 0.6 - 0.2 * k])
        assert one.outwards == pytest.approx(turn @ [-1.0, 0.0, 0.0], abs=1e-6)
        assert one.handle.middle == pytest.approx(middle, abs=0.01)
        assert abs(one.handle.along @ turn @ [0.0, 1.0, 0.0]) > 0.99


@pytest.mark.parametrize("yaw_deg", [0, 25, -120])
@pytest.mark.parametrize(("side", "hinge"), [(1, "left"), (-1, "right")])
def test_a_door_is_hinged_on_its_side(tmp_path, yaw_deg, side, hinge):
    written = import_scene(scene_of(tmp_path, table() + fridge(yaw_deg, side)))

    piece = next(one for one in load_scene(str(written.scene)).furniture if one.kind == "fridge")

    assert piece.opens.hinge == hinge
    assert piece.opens.handle_height_m == pytest.approx(1.0, abs=0.03)
    assert piece.opens.handle_inset_m == pytest.approx(0.07, abs=0.03)
    assert np.degrees(piece.yaw_rad) == pytest.approx(yaw_deg, abs=0.5)


def test_nothing_is_dropped_without_a_word(tmp_path):
    world = (
        table()
        + can("cup_1", 0.9, 0.0)
        + can("lost_ball", 3.0, 3.0, foot=2.0)
        + '<body name="shelf_bracket" pos="0 2 1"><geom type="box" size=".1 .1 .1"/></body>'
        + '<body name="ghost" pos="0 2 1"/>'
    )

    written = import_scene(scene_of(tmp_path, world))

    text = "\n".join(written.told)
    assert "lost ball: stands on nothing that is known" in text
    bracket = next(one for one in load_scene(str(written.scene)).furniture if one.name == "shelf bracket")
    assert (bracket.kind, bracket.foot_m) == ("fixture", pytest.approx(0.9))
    assert "ghost: left out, has no solid" in text
    guesses = written.guesses.read_text()
    assert all(f'body = "{name}"' in guesses for name in ("cup_1", "lost_ball", "shelf_bracket", "ghost"))


def test_what_slides_along_all_three_axes_is_an_object(tmp_path):
    slides = "".join(
        f'<joint type="slide" axis="{axis}"/><joint type="hinge" axis="{axis}"/>'
        for axis in ("1 0 0", "0 1 0", "0 0 1")
    )

    written = import_scene(
        scene_of(tmp_path, table() + can("cup_1", 0.9, 0.0).replace("<freejoint/>", slides))
    )

    assert written.objects == ["cup"]


def test_a_robot_without_motors_that_a_marker_leads_is_no_furniture(tmp_path):
    world = (
        table()
        + can("cup_1", 0.9, 0.0)
        + '<body name="marker" mocap="true" pos="0 2 1"/><body name="arm" pos="0 2 1">'
        '<geom type="box" size=".1 .1 .1"/><body name="hand" pos="0 0 .2"><joint type="hinge" axis="0 1 0"/>'
        '<geom type="box" size=".05 .05 .1"/></body></body>'
    )
    tied = '<equality><weld body1="marker" body2="hand"/></equality>'

    written = import_scene(scene_of(tmp_path, world, tied))

    assert written.furniture == ["kitchen table"]
    assert "arm: left out, is moved by a program, by a marker that it is tied to" in "\n".join(written.told)


def test_a_urdf_whose_link_has_no_name_of_its_own_is_called_as_its_file(tmp_path):
    file = tmp_path / "side_table.urdf"
    file.write_text(
        """<robot name="t"><link name="baseLink"><collision><origin xyz="0 0 .7"/>
<geometry><box size=".8 .6 .04"/></geometry></collision></link></robot>"""
    )

    assert import_scene(file).furniture == ["side table"]


def test_what_is_wrong_but_does_not_matter_is_mended_and_told(tmp_path):
    more = (
        '<asset><texture name="t" type="2d" file="none.png"/><texture name="t" type="2d" file="none.png"/>'
        '<material name="m" texture="t"/></asset>'
    )
    world = table() + can("cup_1", 0.9, 0.0).replace("<geom", '<geom material="m" nonsense="1"')

    written = import_scene(scene_of(tmp_path, world, more))

    assert written.objects == ["cup"]
    guesses = written.guesses.read_text()
    assert "nonsense" in guesses
    assert "a second texture" in guesses
    assert "pictures that cannot be read" in guesses


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("<html/>", "neither MJCF"),
        ("<mujoco", "is no XML"),
        ("<mujoco><worldbody/></mujoco>", "nothing in it"),
        ('<mujoco><worldbody><body><joint type="wheel"/></body></worldbody></mujoco>', "refuses it"),
    ],
)
def test_a_file_that_is_no_scene_is_refused_with_the_reason(tmp_path, text, reason):
    file = tmp_path / "odd.xml"
    file.write_text(text)

    with pytest.raises(CannotImportError, match=f"odd.xml: .*{reason}"):
        import_scene(file)


def test_a_urdf_of_one_piece_is_read(tmp_path):
    file = tmp_path / "chest.urdf"
    file.write_text(
        """<robot name="chest"><link name="chest"><collision><geometry><box size=".4 .6 .7"/></geometry>
<origin xyz="0 0 .35"/></collision></link>
<link name="drawer"><inertial><mass value="1"/><inertia ixx=".1" iyy=".1" izz=".1" ixy="0" ixz="0" iyz="0"/>
</inertial><collision><geometry><box size=".02 .5 .15"/></geometry></collision>
<collision><origin xyz="-.05 0 0"/><geometry><box size=".02 .12 .02"/></geometry></collision></link>
<joint name="slide" type="prismatic"><parent link="chest"/><child link="drawer"/><origin xyz="-.22 0 .5"/>
<axis xyz="-1 0 0"/><limit lower="0" upper=".3" effort="10" velocity="1"/></joint></robot>"""
    )

    pieces = inventory_of(read_foreign(file)).pieces

    (opening,) = [one for piece in pieces for one in piece.openings]
    assert opening.kind == "drawer"
    assert opening.handle.middle == pytest.approx([-0.27, 0.0, 0.5], abs=0.005)


@pytest.mark.parametrize(
    ("body", "label"),
    [
        ("alphabet_soup_1_main", "alphabet soup"),
        ("wooden_cabinet_1", "wooden cabinet"),
        ("BlackBowl", "black bowl"),
        ("sugar_box_link", "sugar box"),
    ],
)
def test_a_body_s_name_is_what_people_call_it(body, label):
    assert label_of_body(body) == label


@pytest.mark.parametrize(("place", "color"), [("0.2 0.9", "red"), ("0.2 0.1", "blue")])
def test_what_has_a_picture_keeps_it_and_is_of_the_colour_that_it_shows(tmp_path, place, color):
    image = Image.new("RGB", (8, 8), tuple(round(255 * value) for value in COLORS["red"]))
    image.paste(tuple(round(255 * value) for value in COLORS["blue"]), (0, 4, 8, 8))
    image.save(tmp_path / "looks.png")
    box = foreign.carton((0.05, 0.05, 0.1))
    corners = "".join(f"v {x} {y} {z}\n" for x, y, z in box.vertices)
    faces = "".join("f " + " ".join(f"{k + 1}/1" for k in face) + "\n" for face in box.faces)
    (tmp_path / "box.obj").write_text(f"{corners}vt {place}\n{faces}")
    world = f"""{table()}<body name="milk" pos=".8 0 .9"><freejoint/><geom type="box" size=".025 .025 .05"/>
<geom type="mesh" mesh="box" material="looks" contype="0" conaffinity="0"/></body>"""
    assets = """<asset><mesh name="box" file="box.obj"/><texture name="looks" type="2d" file="looks.png"/>
<material name="looks" texture="looks"/></asset>"""

    import_scene(scene_of(tmp_path, world, assets))

    (milk,) = load_scene(str(tmp_path / "kitchen.toml")).objects
    assert milk.color == color
    assert milk.model.picture
    assert np.allclose(milk.model.on_picture, np.fromstring(place, sep=" "), atol=1e-6)
