"""In the flat: to another room, through a doorway that nobody told of."""

import numpy as np
import pytest

from executive.embedding.requests import Requests
from executive.session.assembly import assemble
from robots.scenes.scene_file import load_scene


@pytest.mark.requirement("M6")
def test_the_robot_walks_to_the_kitchen_and_touches_nothing():
    scene = load_scene("flat")
    assembly = assemble("talos", scene, 1)
    truth, touched = assembly.world.truth, []
    assembly.session.watch_periods(lambda: touched.extend(truth.contacts.robot_with_furniture()))

    (result,) = Requests(assembly.session).submit("walk to the kitchen").result()

    kitchen = next(region for region in scene.places if region.name == "kitchen")
    off = np.abs(truth.world_T_base()[:2, 3] - kitchen.position_m)
    assert result.outcome == "done"
    assert not touched
    assert not truth.fallen()
    assert np.all(off < 0.5 * np.array(kitchen.size_m) - 0.3)
