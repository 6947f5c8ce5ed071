"""The scene of a flat: rooms with names, walls with a doorway."""

import dataclasses

import pytest

from kinematics.geometry.planar import PlanarPose
from kinematics.walking.route.path_planning import footprints, plan_path
from robots.errors import SceneError
from robots.scenes.scene_description import Region
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_solids import planning_scene
from robots.scenes.scene_writer import dump


def test_a_scene_with_places_is_read_back_as_it_was_written():
    flat = load_scene("flat")

    assert {region.name for region in flat.places} == {"living room", "kitchen"}
    assert read_scene(dump(flat), "flat.toml", "flat").places == flat.places


def test_the_way_to_the_kitchen_leads_through_the_doorway():
    flat = load_scene("flat")
    obstacles = footprints(planning_scene(flat))

    path = plan_path(PlanarPose(), PlanarPose(4.3, 0.0), obstacles, 0.62)

    assert path is not None
    furniture = [
        dataclasses.replace(piece, size_m=(0.1, 4.5, 1.6)) if piece.name == "wall beside the table" else piece
        for piece in flat.furniture
    ]
    closed = dataclasses.replace(flat, furniture=tuple(furniture))
    assert plan_path(PlanarPose(), PlanarPose(4.3, 0.0), footprints(planning_scene(closed)), 0.62) is None


@pytest.mark.parametrize(
    ("region", "said"),
    [
        (Region("kitchen", (0.0, 0.0), (0.5, 3.0)), "at least 1 m"),
        (Region("kitchen", (float("nan"), 0.0), (2.0, 3.0)), "finite"),
        (Region("table", (0.0, 0.0), (2.0, 3.0)), "'table' is also furniture"),
    ],
)
def test_an_impossible_place_is_refused(region, said):
    flat = load_scene("flat")

    with pytest.raises(SceneError, match=said):
        read_scene(dump(dataclasses.replace(flat, places=(region,))), "flat.toml", "flat")
