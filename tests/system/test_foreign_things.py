"""Things that nobody here made, picked up and put down by the names that they bear, judged by the truth."""

import numpy as np
import pytest

from executive.embedding.requests import Requests
from executive.session.assembly import assemble
from executive.understanding.spoken_in import spoken_in
from robots.scenes.importing.import_object import import_object
from robots.scenes.scene_file import load_scene
from tests import foreign_meshes as foreign

TABLE = """
[[furniture]]
name = "table"
kind = "table"
size_m = [0.6, 1.4, 0.85]
position_m = [0.65, 0.0]
"""


def scene_with(folder, rng, target, other, label):
    """Two things of meshes on a table, each where a hand reaches; the file."""
    lines = [TABLE]
    for side, mesh, name in ((-1.0, target, label), (1.0, other, "cereal")):
        file = foreign.written(mesh, folder, f"{name.replace(' ', '_')}.obj", str(rng.choice(["+z", "+y"])))
        import_object(file)
        x, y = rng.uniform(-0.18, -0.1), side * rng.uniform(0.15, 0.25)
        place = f"position_m = [{x:.3f}, {y:.3f}]\nyaw_rad = {rng.uniform(-3, 3):.3f}\nmass_kg = 0.3"
        lines.append(f'[[object]]\nmesh = "{file.name}"\nlabel = "{name}"\non = "table"\n{place}\n')
    file = folder / "scene.toml"
    file.write_text("\n".join(lines))
    return file


def done(scene_file, seed, sentence):
    assembly = assemble("talos", load_scene(str(scene_file)), seed)
    with spoken_in(str(scene_file)):
        (result,) = Requests(assembly.session).submit(sentence, on_question="first").result()
    return result, assembly.world.truth


@pytest.mark.slow
@pytest.mark.requirement("M2", "P4")
@pytest.mark.parametrize("seed", [0, 1])
def test_a_thing_of_a_mesh_is_picked_up_by_its_label_and_truly_held(tmp_path, seed):
    rng = np.random.default_rng(seed)
    mesh = foreign.bottle(rng.uniform(0.028, 0.036), rng.uniform(0.17, 0.23)) if seed else foreign.can()
    file = scene_with(tmp_path, rng, mesh, foreign.carton(), "tomato soup")

    result, truth = done(file, seed, "pick up the tomato soup")

    assert result.outcome == "done", result
    assert "tomato soup" in truth.contacts.in_pads_only()
    assert truth.lift_m("tomato soup") > 0.08
    assert not truth.fallen()


@pytest.mark.slow
@pytest.mark.requirement("M2", "P4")
def test_a_thing_of_a_mesh_is_put_beside_another_and_stands_there(tmp_path):
    rng = np.random.default_rng(5)
    file = scene_with(tmp_path, rng, foreign.bottle(), foreign.carton(), "ketchup")

    result, truth = done(file, 5, "put the ketchup next to the cereal")

    assert result.outcome == "done", result
    assert truth.tilt_rad("ketchup") < 0.1
    apart = truth.world_T_object("ketchup")[:2, 3] - truth.world_T_object("cereal")[:2, 3]
    assert np.linalg.norm(apart) < 0.3


@pytest.mark.slow
@pytest.mark.requirement("M2", "P4")
def test_what_no_hand_can_take_is_refused_with_the_reason_and_stays(tmp_path):
    rng = np.random.default_rng(7)
    file = scene_with(tmp_path, rng, foreign.plate(), foreign.carton(), "dinner plate")
    before = load_scene(str(file)).objects[0].world_T_object

    result, truth = done(file, 7, "pick up the dinner plate")

    assert result.outcome == "failed"
    assert "flatter than this hand's fingers are thick" in str(result)
    assert truth.world_T_object("dinner plate")[:3, 3] == pytest.approx(before[:3, 3], abs=0.005)
