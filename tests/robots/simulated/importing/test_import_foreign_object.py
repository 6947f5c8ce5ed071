"""Objects of files that other programs read: URDFs of one link, MJCF written to be put into a body."""

import pytest

from robots.errors import CannotImportError
from robots.scenes.importing.convex import volume
from robots.simulated.importing.import_foreign_object import import_foreign_object
from tests import foreign_meshes as foreign

LINK = """<robot name="thing"><link name="base_link">
<inertial><mass value="{mass}"/><inertia ixx="{xx}" iyy="1" izz="{zz}" ixy="0" ixz="0" iyz="0"/></inertial>
<visual><geometry><mesh filename="{mesh}"/></geometry>{material}</visual>
<collision><geometry><mesh filename="{mesh}" scale="{scale} {scale} {scale}"/></geometry></collision>
</link></robot>"""
RED = '<material name="red"><color rgba="0.9 0.05 0.05 1"/></material>'


def urdf(folder, mesh, *, mass=0.2, xx=1.0, zz=1.0, material="", scale=1.0):
    file = folder / "wooden_stand.urdf"
    file.write_text(LINK.format(mesh=mesh, mass=mass, xx=xx, zz=zz, material=material, scale=scale))
    return file


def two_blocks(folder, name="solids.obj"):
    """An OBJ of two boxes, one on the other, each an object of its own."""
    lines, count = [], 0
    for number, (size, height) in enumerate((((0.1, 0.1, 0.02), 0.01), ((0.02, 0.02, 0.08), 0.06))):
        box = foreign.carton(size)
        box.apply_translation([0.0, 0.0, height - box.bounds.mean(axis=0)[2]])
        lines.append(f"o part_{number}")
        lines += [f"v {x} {y} {z}" for x, y, z in box.vertices]
        lines += ["f " + " ".join(str(count + k + 1) for k in face) for face in box.faces]
        count += len(box.vertices)
    (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text("\n".join(lines) + "\n")


def test_a_urdf_of_one_link_is_an_object_of_all_solids_of_its_mesh(tmp_path):
    two_blocks(tmp_path)

    made = import_foreign_object(urdf(tmp_path, "solids.obj", material=RED, scale=1.0))

    assert made.guesses.measured["size_m"] == pytest.approx([0.1, 0.1, 0.1], abs=1e-3)
    assert made.guesses.measured["parts"] == 2
    assert made.guesses.values["mass_kg"] == pytest.approx(0.2)
    assert made.guesses.values["color"] == "red"
    assert made.guesses.values["label"] == "wooden stand"


def test_a_solid_of_a_urdf_is_what_its_mesh_shows_and_not_its_hull(tmp_path):
    foreign.written(foreign.bowl(), tmp_path, "bowl.obj")

    parts = import_foreign_object(urdf(tmp_path, "bowl.obj")).model.parts

    assert sum(volume(hull) for hull in parts.hulls) < 0.7 * volume(parts.corners)


@pytest.mark.parametrize("named", ["package://things/meshes/solids.obj", "package://elsewhere/solids.obj"])
def test_a_package_is_looked_for_around_the_file(tmp_path, named):
    folder = tmp_path / "things" / "urdf"
    folder.mkdir(parents=True)
    two_blocks(tmp_path / "things", "meshes/solids.obj")
    two_blocks(folder)

    assert import_foreign_object(urdf(folder, named)).guesses.measured["parts"] == 2


@pytest.mark.parametrize(("xx", "zz"), [(0.0, 0.0), (1.0, 0.0), (-1.0, 1.0)])
def test_an_inertia_that_no_body_has_is_mended_and_told(tmp_path, xx, zz):
    two_blocks(tmp_path)

    made = import_foreign_object(urdf(tmp_path, "solids.obj", xx=xx, zz=zz))

    assert made.guesses.values["mass_kg"] == pytest.approx(0.2)
    assert made.guesses.measured["mended"] == ["the inertia of 'base_link' was none"]


def test_what_says_that_it_weighs_nothing_is_guessed_by_its_size(tmp_path):
    two_blocks(tmp_path)

    made = import_foreign_object(urdf(tmp_path, "solids.obj", mass=0))

    assert made.guesses.values["mass_kg"] == pytest.approx(
        600 * (0.1 * 0.1 * 0.02 + 0.02 * 0.02 * 0.08), abs=2e-3
    )
    assert "says nothing" in made.guesses.reasons["mass_kg"]


def test_what_says_no_colour_is_not_called_grey(tmp_path):
    two_blocks(tmp_path)

    assert "color" not in import_foreign_object(urdf(tmp_path, "solids.obj")).guesses.values


def test_what_is_seen_has_the_colour_of_its_mesh_where_the_urdf_says_none(tmp_path):
    box = foreign.carton((0.05, 0.05, 0.1))
    box.visual.face_colors = [20, 40, 200, 255]
    box.export(tmp_path / "blue.ply")

    assert import_foreign_object(urdf(tmp_path, "blue.ply")).guesses.values["color"] == "blue"


def test_a_solid_that_nobody_knows_is_left_out_and_told(tmp_path):
    file = tmp_path / "crate.urdf"
    file.write_text(
        """<robot name="crate"><link name="crate"><collision><geometry><box size=".1 .1 .1"/></geometry>
</collision><collision><geometry><cdf filename="crate.cdf"/></geometry></collision>
<visual><geometry><mesh filename="not_there.dae"/></geometry></visual></link></robot>"""
    )

    made = import_foreign_object(file)

    assert made.guesses.measured["size_m"] == pytest.approx([0.1, 0.1, 0.1], abs=1e-3)
    shape, seen = made.guesses.measured["mended"]
    assert "not_there.dae" in shape + seen
    assert "a collision of 'crate' of a shape that nobody knows was left out" in (shape, seen)


def test_a_solid_s_mesh_that_is_not_there_is_named(tmp_path):
    file = tmp_path / "crate.urdf"
    file.write_text(
        """<robot name="crate"><link name="crate"><collision><geometry>
<mesh filename="package://crates/crate.stl"/></geometry></collision></link></robot>"""
    )

    with pytest.raises(CannotImportError, match=r"crates/crate\.stl' is not there"):
        import_foreign_object(file)


def test_a_model_that_is_written_to_be_put_into_a_body_is_an_object(tmp_path):
    file = tmp_path / "toy_brick.xml"
    file.write_text(
        """<mujoco><worldbody><geom type="box" size=".02 .03 .01"/>
<geom type="cylinder" pos="0 0 .013" size=".005 .003"/></worldbody></mujoco>"""
    )

    made = import_foreign_object(file)

    assert made.guesses.measured["size_m"] == pytest.approx([0.04, 0.06, 0.026], abs=1e-3)
    assert made.guesses.values["label"] == "toy brick"
    assert made.guesses.values["mass_kg"] == pytest.approx(600 * 0.04 * 0.06 * 0.02, abs=3e-3)


def test_what_is_seen_may_be_a_sheet(tmp_path):
    sheet = "v 0 0 .06\nv .05 0 .06\nv 0 .05 .06\nv .05 .05 .06\nf 1 2 3\nf 2 4 3\n"
    (tmp_path / "label.obj").write_text(sheet)
    file = tmp_path / "crate.urdf"
    file.write_text(
        """<robot name="crate"><link name="crate"><collision><geometry><box size=".1 .1 .1"/></geometry>
</collision><visual><geometry><mesh filename="label.obj"/></geometry></visual></link></robot>"""
    )

    assert import_foreign_object(file).guesses.measured["parts"] == 1
