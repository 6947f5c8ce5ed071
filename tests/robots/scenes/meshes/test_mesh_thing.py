import pytest

from robots.errors import SceneError
from robots.scenes.importing.import_object import import_object
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_writer import dump
from tests import foreign_meshes as foreign

TABLE = """
[[furniture]]
name = "table"
kind = "table"
size_m = [0.6, 1.2, 0.8]
position_m = [0.7, 0.0]
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("things")
    import_object(foreign.written(foreign.can(0.03, 0.1), folder, "tomato_soup.obj"))
    return folder


def with_object(folder, keys):
    file = folder / "scene.toml"
    file.write_text(f'{TABLE}\n[[object]]\nmesh = "tomato_soup.obj"\n{keys}\n')
    return load_scene(str(file))


def test_it_is_called_by_its_label_its_names_and_its_categories(folder):
    keys = 'on = "table"\nlabel = "alphabet soup"\nnames = ["the red tin"]\ncategories = ["food"]'

    item = with_object(folder, keys).objects[0]

    assert item.name == "alphabet soup"
    assert item.kind == "soup"
    assert item.names == ("alphabet soup", "the red tin")
    assert item.categories == ("food",)


def test_what_a_scene_does_not_say_is_as_its_sidecar_says(folder):
    item = with_object(folder, 'on = "table"').objects[0]

    assert item.name == "tomato soup"
    assert item.mass_kg == pytest.approx(0.17, abs=0.01)
    assert item.world_T_object[2, 3] == pytest.approx(0.8 + 0.05, abs=1e-6)


def test_it_may_be_of_another_size(folder):
    item = with_object(folder, 'on = "table"\nscale = 1.5').objects[0]

    assert item.shape.height_m == pytest.approx(0.15, abs=1e-6)
    assert item.shape.parts.corners[:, 2].max() == pytest.approx(0.075, abs=1e-6)
    assert item.model.vertices[:, 2].max() == pytest.approx(0.075, abs=1e-6)


def test_a_scene_with_it_is_read_back_as_it_was_written(folder):
    scene = with_object(folder, 'on = "table"\nmass_kg = 0.4\nyaw_rad = 0.3')

    again = read_scene(dump(scene), "again.toml", "scene")

    assert again.objects[0].shape == scene.objects[0].shape
    assert again.objects[0].mass_kg == 0.4
    assert again.objects[0].names == scene.objects[0].names


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        ('on = "table"\nup = "+y"', r"object\[0\].up: .*imported with up = '\+z'.*import object"),
        ('on = "table"\nscale = -1.0', r"object\[0\].scale: must be above 0"),
        ('on = "table"\nup = "north"', r"object\[0\].up: must be one of \+z"),
        ('on = "table"\nmas_kg = 1.0', r"mas_kg"),
    ],
)
def test_what_cannot_be_is_refused_with_key_and_reason(folder, keys, said):
    with pytest.raises(SceneError, match=said):
        with_object(folder, keys)


def test_a_mesh_that_is_not_there_or_was_not_imported_or_has_changed_is_told(folder, tmp_path):
    scene = tmp_path / "scene.toml"
    scene.write_text(f'{TABLE}\n[[object]]\nmesh = "cup.obj"\non = "table"\n')
    with pytest.raises(SceneError, match=r"object\[0\].mesh: there is no file"):
        load_scene(str(scene))

    foreign.written(foreign.can(), tmp_path, "cup.obj")
    with pytest.raises(SceneError, match=r"was not imported yet: say `executive import object cup.obj`"):
        load_scene(str(scene))

    import_object(tmp_path / "cup.obj")
    assert load_scene(str(scene)).objects[0].name == "cup"

    foreign.written(foreign.can(0.04), tmp_path, "cup.obj")
    with pytest.raises(SceneError, match="has changed since the import"):
        load_scene(str(scene))
