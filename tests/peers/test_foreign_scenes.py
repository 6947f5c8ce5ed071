"""Whole scenes of other benchmarks: what their makers say is in them is found, and nothing is dropped.

The scenes are built by the benchmarks themselves, in an environment of their own; how many objects, drawers
and doors there are is what the benchmark's task files and joints say.
"""

import dataclasses
import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from robots.scenes.scene_file import load_scene
from robots.simulated.importing.bodies import label_of_body, read_foreign
from robots.simulated.importing.import_scene import import_scene
from robots.simulated.importing.inventory import inventory_of
from tools.benchmark.peers.environments import PeerEnvironment, default_cache
from tools.documents.imported_pictures import PICTURES, SHOWN, draw, picture_of

EXPORT = Path(__file__).parent / "programs" / "export_scenes.py"
ASSETS = Path("lib/python3.11/site-packages")
KITCHEN = "gymnasium_robotics/envs/assets/kitchen_franka/kitchen_assets/kitchen_env_model.xml"
METAWORLD = "metaworld/assets/sawyer_xyz/sawyer_{}.xml"
MOST_ASKED = 0.05
LEAST_HANDLES = 0.95
OPENS = ("drawer", "door", "sliding door")


@pytest.fixture(scope="module")
def environment():
    environment = PeerEnvironment("foreign_scenes", default_cache())
    if not environment.is_ready:
        name = environment.name
        pytest.skip(f"{name} is not installed: python -m tools.benchmark.peers {name}")
    return environment


@pytest.fixture(scope="module")
def folder(environment, tmp_path_factory):
    """Where the benchmarks have written their scenes."""
    folder = tmp_path_factory.mktemp("scenes")
    done = subprocess.run([environment.python, EXPORT, folder], capture_output=True, text=True, timeout=500)
    assert done.returncode == 0, done.stderr[-2000:]
    return folder


@pytest.fixture(scope="module")
def exported(folder):
    """Scenes that the benchmarks have built, with their makers' answers."""
    return {
        file.stem: (_looked_through(file.with_suffix(".xml")), json.loads(file.read_text()))
        for file in sorted(folder.glob("*.json"))
    }


@dataclasses.dataclass(frozen=True)
class NamesOf:
    """What is left of a compiled model, which takes half a gigabyte with its pictures."""

    file: Path
    names: tuple[str, ...]

    def name(self, body):
        return self.names[body]


def _looked_through(file):
    found = inventory_of(read_foreign(file))
    names = tuple(found.foreign.name(body) for body in range(found.foreign.model.nbody))
    return dataclasses.replace(found, foreign=NamesOf(file, names))


def shipped(environment, path):
    return environment.python.parent.parent / ASSETS / path


def test_every_object_is_an_object_by_its_name(exported):
    wrong = {}
    for name, (found, answer) in exported.items():
        labels = sorted(thing.label for thing in found.objects)
        wanted = sorted(label_of_body(each["name"]) for each in answer["objects"])
        if labels != wanted:
            wrong[name] = (labels, wanted)

    assert len(exported) >= 24
    assert not wrong


def test_every_piece_of_furniture_is_one(exported):
    wrong = {}
    for name, (found, answer) in exported.items():
        missing = [
            each["name"]
            for each in answer["furniture"]
            if not any(_is_it(piece.label, each["name"]) for piece in found.pieces)
            and each["kind"] != "floor"
        ]
        if missing:
            wrong[name] = missing

    assert not wrong


def _is_it(label: str, name: str) -> bool:
    """Whether a label is a name's: the arenas call their tables otherwise than the task files do."""
    wanted = label_of_body(name)
    return label == wanted or wanted.split()[-1].rstrip("0123456789") == label.split()[-1]


def test_every_drawer_and_door_is_one_with_its_handle_oriented(exported, environment):
    handles, parts, wrong = 0, 0, []
    for name, (found, answer) in exported.items():
        openings = {found.foreign.name(one.body): one for piece in found.pieces for one in piece.openings}
        for moving in (each for piece in answer["furniture"] for each in piece["moving"]):
            one = openings.get(moving["body"])
            drawer = moving["type"] == "slide"
            if one is None or drawer != (one.kind == "drawer"):
                wrong.append((name, moving["body"], one and one.kind))
                continue
            if one.kind in OPENS:
                parts += 1
                handles += _is_oriented(one, upright=not drawer and name != "robosuite_door")

    assert not wrong
    assert parts > 20
    assert handles >= LEAST_HANDLES * parts


def _is_oriented(one, upright: bool) -> bool:
    """Whether a handle lies across the way of opening: a drawer's level, a door's upright."""
    if one.handle is None:
        return False
    along = abs(one.handle.along[2])
    return abs(one.handle.along @ one.outwards) < 0.1 and (along > 0.95 if upright else along < 0.1)


@pytest.mark.parametrize(
    ("path", "kinds"),
    [
        (KITCHEN, {"sliding door": 1, "door": 3, "knob": 5}),
        (METAWORLD.format("drawer"), {"drawer": 1}),
        (METAWORLD.format("door_pull"), {"door": 1}),
        (METAWORLD.format("door_lock"), {"knob": 1}),
    ],
)
def test_what_opens_and_turns_is_found_in_what_others_ship(environment, path, kinds):
    found = inventory_of(read_foreign(shipped(environment, path)))

    openings = [one for piece in found.pieces for one in piece.openings]
    assert {kind: sum(one.kind == kind for one in openings) for kind in kinds} == kinds
    assert len(openings) == sum(kinds.values())
    assert all(one.handle is not None for one in openings if one.kind in OPENS)


def test_handles_are_where_the_kitchen_s_maker_marked_them(environment):
    foreign = read_foreign(shipped(environment, KITCHEN))
    openings = [one for piece in inventory_of(foreign).pieces for one in piece.openings]
    marks = {
        int(foreign.model.site_bodyid[k]): foreign.data.site_xpos[k]
        for k in range(foreign.model.nsite)
        if foreign.model.site(k).name != "kettle_site"
    }

    for one in openings:
        if one.handle is not None:
            away = marks[one.body] - one.handle.middle
            along = np.clip(away @ one.handle.along, *(0.5 * one.handle.length_m * np.array([-1, 1])))
            assert np.linalg.norm(away - along * one.handle.along) < 0.05


def test_each_makes_a_scene_that_can_be_a_world_and_tells_all_that_is_not_in_it(
    exported, environment, tmp_path
):
    files = [found.foreign.file for found, _ in exported.values()]
    files += [shipped(environment, path) for path in (KITCHEN, METAWORLD.format("drawer"))]
    asked = bodies = 0
    for file in files:
        written = import_scene(file, tmp_path / file.stem / f"{file.stem}.toml")
        scene = load_scene(str(written.scene))
        found = inventory_of(read_foreign(file))
        here = {one.name for one in (*scene.objects, *scene.furniture)}
        told = "\n".join(written.told)
        assert len(here) + told.count(": left out, ") + told.count("stands on nothing") >= (
            len(found.objects) + len(found.pieces) + len(found.left_out)
        ), file
        asked += len(written.asked)
        bodies += len(found.objects) + len(found.pieces) + sum(len(p.openings) for p in found.pieces)

    assert asked <= MOST_ASKED * bodies, (asked, bodies)


@pytest.mark.opengl
def test_the_pictures_in_the_documentation_can_be_drawn_again(folder, tmp_path):
    assert draw(folder, tmp_path) == []

    names = sorted(picture_of(scene) for scene in SHOWN)
    page = (PICTURES.parent / "guides" / "scenes.md").read_text()
    assert sorted(file.name for file in PICTURES.glob("imported_*")) == names
    for name in names:
        drawn, kept = Image.open(tmp_path / name), Image.open(PICTURES / name)
        assert drawn.size == kept.size
        assert np.asarray(drawn.convert("L"), float).std() > 25.0  # of 255: it shows more than a sky
        assert f"../pictures/{name}" in page
