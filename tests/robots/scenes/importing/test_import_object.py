import sys

import numpy as np
import pytest

from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.errors import CannotImportError
from robots.scenes.importing.convex import middle_of
from robots.scenes.importing.import_object import import_object, label_of
from robots.scenes.importing.outline import fitted
from robots.scenes.importing.resting import rests_of
from robots.scenes.meshes.object_model import read_model
from robots.scenes.meshes.sidecar import Sidecar, read_sidecar
from robots.scenes.scene_file import load_scene
from tests import foreign_meshes as foreign


def inside_share(parts, points, normals):
    """Of some points, the share that lies in the parts when moved inwards a little."""
    from scipy.spatial import ConvexHull

    planes = [ConvexHull(hull).equations for hull in parts.hulls]
    moved = points - 0.001 * normals
    return np.mean(
        np.any([(moved @ plane[:, :3].T + plane[:, 3]).max(axis=1) <= 0.0 for plane in planes], axis=0)
    )


@pytest.mark.parametrize("ending", ["obj", "stl", "glb"])
@pytest.mark.parametrize("up", ["+z", "+y"])
@pytest.mark.parametrize("unit", [1.0, 0.001])
def test_a_can_is_a_standing_cylinder_whatever_axis_is_up_and_whatever_units_it_has(
    tmp_path, ending, up, unit
):
    rng = np.random.default_rng(3)
    radius, height = rng.uniform(0.028, 0.04), rng.uniform(0.09, 0.13)
    file = foreign.written(foreign.can(radius, height), tmp_path, f"soup_can_1.{ending}", up, unit)

    made = import_object(file)

    outline = made.model.outline
    assert isinstance(outline, Cylinder)
    assert (outline.radius_m, outline.height_m) == pytest.approx((radius, height), abs=5e-4)
    assert outline.parts.outline_error_m < 0.003
    assert made.guesses.values["label"] == "soup can"
    assert np.ptp(made.model.vertices, axis=0)[2] == pytest.approx(height, abs=1e-6)


@pytest.mark.parametrize("seed", range(4))
def test_a_carton_that_lies_askew_in_its_file_is_turned_straight(tmp_path, seed):
    rng = np.random.default_rng(seed)
    size = tuple(rng.uniform([0.04, 0.07, 0.15], [0.05, 0.1, 0.2]))
    mesh = foreign.carton(size)
    mesh.apply_transform(foreign.trimesh.transformations.rotation_matrix(rng.uniform(0.2, 1.3), (0, 0, 1)))

    outline = import_object(foreign.written(mesh, tmp_path, "milk.obj")).model.outline

    assert isinstance(outline, Box)
    assert sorted(outline.size_m) == pytest.approx(sorted(size), abs=1e-3)
    assert outline.parts.outline_error_m < 0.002


@pytest.mark.slow
@pytest.mark.parametrize("shape", ["bowl", "mug", "bottle"])
def test_what_is_hollow_or_has_a_neck_is_cut_into_parts_that_leave_its_hollows_free(tmp_path, shape):
    mesh = getattr(foreign, shape)()
    model = import_object(foreign.written(mesh, tmp_path, f"{shape}.obj")).model
    parts = model.parts

    hull = foreign.trimesh.convex.convex_hull(parts.corners)
    filled = sum(foreign.trimesh.convex.convex_hull(one).volume for one in parts.hulls)
    assert 1 < len(parts.ends) <= 16
    assert filled < 0.9 * hull.volume
    surface, faces = foreign.trimesh.sample.sample_surface(mesh, 500, seed=1)
    placed = surface - (mesh.bounds.mean(axis=0) * (0, 0, 1))
    if shape != "mug":  # which is turned by its handle
        assert inside_share(parts, placed, mesh.face_normals[faces]) > 0.8
    assert parts.outline_error_m > 0.006


def test_bodies_that_are_convex_are_the_parts_as_they_are(tmp_path):
    pole, flag = foreign.carton((0.04, 0.04, 0.2)), foreign.carton((0.09, 0.1, 0.03))
    flag.apply_translation((0.0, 0.05, 0.085))
    mesh = foreign.trimesh.util.concatenate([pole, flag])

    parts = import_object(foreign.written(mesh, tmp_path, "flag.obj")).model.parts

    volumes = [foreign.trimesh.convex.convex_hull(one).volume for one in parts.hulls]
    assert volumes == pytest.approx([pole.volume, flag.volume])


def test_points_of_its_surface_are_on_it_with_normals_outwards(tmp_path):
    parts = import_object(foreign.written(foreign.bottle(), tmp_path, "bottle.obj")).model.parts

    assert len(parts.surface) > 1000
    assert inside_share(parts, parts.surface, parts.normals) == 1.0
    assert inside_share(parts, parts.surface, -parts.normals) < 0.05


def test_what_a_person_mends_is_kept_and_what_is_deleted_is_guessed_anew(tmp_path):
    file = foreign.written(foreign.can(), tmp_path, "thing.obj")
    beside = import_object(file).sidecar
    text = beside.read_text()
    mended = text.replace('label = "thing"', 'label = "tomato soup"').replace('up = "+z"', 'up = "-z"')
    beside.write_text("\n".join(line for line in mended.splitlines() if not line.startswith("mass_kg")))

    again = import_object(file)

    assert read_sidecar(beside, Sidecar).label == "tomato soup"
    assert read_sidecar(beside, Sidecar).up == (0.0, 0.0, -1.0)
    assert {"mass_kg", "scale"} <= set(again.guesses.reasons)
    assert not {"label", "up"} & set(again.guesses.reasons)


def test_what_was_kept_is_what_was_made(tmp_path):
    made = import_object(foreign.written(foreign.pebble(np.random.default_rng(1)), tmp_path, "stone.stl"))

    kept = read_model(made.file)

    assert kept.outline == made.model.outline
    assert kept.parts == made.model.parts
    np.testing.assert_array_equal(kept.parts.surface, made.model.parts.surface)


@pytest.mark.parametrize(
    ("content", "reason"), [(b"no mesh", "cannot be read as a mesh|has no surface"), (b"v 0 0 0\n", "")]
)
def test_a_file_that_is_no_mesh_is_refused_by_name(tmp_path, content, reason):
    file = tmp_path / "broken.obj"
    file.write_bytes(content)

    with pytest.raises(CannotImportError, match=f"broken.obj: .*({reason})"):
        import_object(file)


@pytest.fixture
def without_the_extra(monkeypatch):
    for name in ("trimesh", "coacd", "scipy", "scipy.spatial"):
        monkeypatch.setitem(sys.modules, name, None)


def test_without_the_extra_one_line_says_what_to_install(tmp_path, without_the_extra):
    file = tmp_path / "can.obj"
    file.write_text("v 0 0 0")

    with pytest.raises(CannotImportError, match=r"pip install 'humanoid-executive\[import\]'"):
        import_object(file)


@pytest.mark.parametrize(
    ("stem", "label"), [("soup_can_01", "soup can"), ("AlphabetSoup", "alphabet soup"), ("mug.2", "mug")]
)
def test_a_file_s_name_is_what_people_call_it(stem, label):
    assert label_of(stem) == label


def test_a_scene_is_read_without_the_importing_libraries(tmp_path, request):
    import_object(foreign.written(foreign.can(), tmp_path, "can.obj"))
    scene = tmp_path / "scene.toml"
    scene.write_text('[[object]]\nmesh = "can.obj"\nposition_m = [0.5, 0.0, 0.0505]\n')

    request.getfixturevalue("without_the_extra")

    assert load_scene(str(scene)).objects[0].name == "can"


@pytest.mark.parametrize("up", ["+z", "+y"])
@pytest.mark.parametrize("seed", range(3))
def test_what_is_slim_stands_on_its_end_though_it_lies_as_safely(tmp_path, up, seed):
    rng = np.random.default_rng(seed)
    size = tuple(rng.uniform([0.045, 0.05, 0.13], [0.05, 0.055, 0.2]))

    made = import_object(foreign.written(foreign.carton(size), tmp_path, "milk.obj", up))

    assert np.ptp(made.model.vertices[:, 2]) == pytest.approx(size[2], abs=1e-6)
    assert "up" in made.guesses.reasons


def test_the_outline_of_what_is_no_ball_stands_on_its_foot():
    """A stone fits a ball best of the three, badly, and that would reach far below it."""
    stone = np.asarray(foreign.pebble(np.random.default_rng(2), 0.05).vertices)

    outline = fitted(stone).outline

    assert not isinstance(outline, Ball)
    assert outline.height_m == pytest.approx(np.ptp(stone[:, 2]), abs=1e-6)


def test_a_material_without_a_picture_has_the_colour_of_the_light_that_comes_back(tmp_path):
    mesh = foreign.carton()
    material = foreign.trimesh.visual.material.PBRMaterial(baseColorFactor=[0.16, 0.004, 0.24, 1.0])
    mesh.visual = foreign.trimesh.visual.TextureVisuals(material=material)
    mesh.export(tmp_path / "block.glb")

    assert import_object(tmp_path / "block.glb").guesses.values["color"] == "purple"


def test_several_open_surfaces_in_one_mesh_are_cut_too(tmp_path):
    sheets = [foreign.trimesh.creation.box((0.05, 0.05, 0.05)) for _ in range(3)]
    for number, sheet in enumerate(sheets):
        sheet.update_faces(np.arange(len(sheet.faces)) > 0)
        sheet.apply_translation((0.0, 0.0, 0.049 * number))
    foreign.trimesh.util.concatenate(sheets).export(tmp_path / "tower.glb")

    model = import_object(tmp_path / "tower.glb").model

    assert np.ptp(model.parts.corners, axis=0) == pytest.approx([0.05, 0.05, 0.148], abs=4e-3)


def test_what_has_a_small_foot_at_each_end_of_its_length_lies(tmp_path):
    peg = foreign.lathe([(0, 0), (0.0045, 0), (0.01, 0.006), (0.01, 0.084), (0.0045, 0.09), (0, 0.09)])

    model = import_object(foreign.written(peg, tmp_path, "peg.obj")).model

    assert np.ptp(model.parts.corners, axis=0)[2] == pytest.approx(0.02, abs=1e-3)


def test_what_rests_safely_on_no_side_rests_on_its_safest():
    corners = np.asarray(foreign.trimesh.creation.icosphere(subdivisions=3, radius=0.006).vertices)

    rests = rests_of(corners, np.zeros(3))

    assert len(rests.up) == 1
    assert 0.0 < rests.margin_m[0] < 0.004


def test_the_middle_of_parts_is_that_of_their_mass_and_not_of_their_corners():
    slab, cone = foreign.carton((0.1, 0.1, 0.02)), foreign.trimesh.creation.cone(radius=0.04, height=0.12)
    mass = [slab.volume, cone.volume]

    middle = middle_of([np.asarray(slab.vertices), np.asarray(cone.vertices)])

    assert middle == pytest.approx(np.average([[0, 0, 0], [0, 0, 0.03]], axis=0, weights=mass), abs=1e-6)
