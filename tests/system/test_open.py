"""Whole tasks at doors and drawers, on the robot that balances on its own feet."""

import math
from dataclasses import replace

import numpy as np
import pytest

from executive.assembly import assemble
from robots.scene_file import load_scene
from trees.tasks import ObjectDescription, OpenTask


class Watched:
    """A robot before a piece of furniture, with the truth beside it."""

    def __init__(self, name, **changes):
        scene = load_scene(name)
        (piece,) = scene.furniture
        self.piece = replace(piece, opens=replace(piece.opens, **changes))
        self.assembly = assemble("talos", replace(scene, furniture=(self.piece,)), 3)
        self.truth = self.assembly.world.truth
        self.peak_n = 0.0
        self.assembly.session.watch_periods(self._look)

    def _look(self):
        force = self.truth.furniture_force_on_robot()
        self.peak_n = max(self.peak_n, float(np.linalg.norm(force)))

    def open(self, noun):
        return self.assembly.session.run_task(OpenTask(f"open the {noun}", ObjectDescription(noun)))

    @property
    def opening(self):
        return self.truth.opening(self.piece.name)


@pytest.mark.requirement("M3")
def test_a_fridge_is_opened_and_the_claimed_angle_is_true():
    kitchen = Watched("fridge")

    result = kitchen.open("fridge")

    assert result.outcome == "done", result.failure
    assert math.degrees(kitchen.opening) >= 65.0
    assert result.evidence["opening_deg"] == pytest.approx(math.degrees(kitchen.opening), abs=3.0)
    assert kitchen.peak_n <= 95.0
    assert not kitchen.truth.fallen()


@pytest.mark.requirement("M3")
def test_a_locked_drawer_is_told_to_be_stuck_and_the_robot_stands():
    study = Watched("drawers", locked=True)

    result = study.open("drawer")

    assert result.outcome == "failed"
    assert "is stuck" in str(result.failure)
    assert study.opening < 0.002
    assert study.peak_n <= 95.0
    assert not study.truth.fallen()
