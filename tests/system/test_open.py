"""Whole tasks at doors and drawers, on the robot that balances on its own feet."""

import math
from dataclasses import replace

import numpy as np
import pytest

from executive.session.assembly import assemble
from robots.scenes.scene_file import load_scene
from trees.tasks import CloseTask, ObjectDescription, OpenTask

MOST_N = 95.0
SLIP_M = 0.002


class Watched:
    """A robot before a piece of furniture, with the truth beside it."""

    def __init__(self, name, **changes):
        scene = load_scene(name)
        (piece,) = scene.furniture
        self.piece = replace(piece, opens=replace(piece.opens, **changes))
        self.assembly = assemble("talos", replace(scene, furniture=(self.piece,)), 3)
        self.session, self.truth = self.assembly.session, self.assembly.world.truth
        self.soles = [sole.frame for sole in self.assembly.model.description.soles]
        self.stood = self._feet()
        self.peak_n, self.when = 0.0, []
        self.session.watch_periods(self._look)

    def open(self, noun):
        return self.session.run_task(OpenTask(f"open the {noun}", ObjectDescription(noun)))

    def close(self, noun):
        return self.session.run_task(CloseTask(f"close the {noun}", ObjectDescription(noun)))

    def once(self, condition, act):
        """Do something at the first period in which a condition holds."""
        self.when.append((condition, act))

    def require_well(self):
        assert not self.truth.fallen()
        assert self.peak_n <= MOST_N
        assert np.linalg.norm(self._feet() - self.stood, axis=1).max() <= SLIP_M

    @property
    def opening(self):
        return self.truth.opening(self.piece.name)

    def _feet(self):
        return np.array([self.truth.world_T_link(sole)[:2, 3] for sole in self.soles])

    def _look(self):
        force = self.truth.contacts.furniture_force_on_robot()
        self.peak_n = max(self.peak_n, float(np.linalg.norm(force)))
        for due in [due for due in self.when if due[0]()]:
            self.when.remove(due)
            due[1]()


@pytest.mark.requirement("M3")
def test_a_fridge_is_opened_and_the_claimed_angle_is_true():
    kitchen = Watched("fridge")

    result = kitchen.open("fridge")

    assert result.outcome == "done", result.failure
    assert math.degrees(kitchen.opening) >= 65.0
    assert result.evidence["opening_deg"] == pytest.approx(math.degrees(kitchen.opening), abs=3.0)
    kitchen.require_well()


@pytest.mark.requirement("M3")
def test_a_locked_drawer_is_told_to_be_stuck_and_the_robot_stands():
    study = Watched("drawers", locked=True)

    result = study.open("drawer")

    assert result.outcome == "failed"
    assert "is stuck" in str(result.failure)
    assert study.opening < 0.002
    study.require_well()


@pytest.mark.requirement("M3")
@pytest.mark.requirement("S7")
def test_a_drawer_is_closed_by_a_hand_that_a_cancel_left_at_its_handle():
    study = Watched("drawers")
    study.once(lambda: study.opening > 0.12, lambda: study.session.cancel("by the test"))

    cancelled = study.open("drawer")
    left_open = study.opening
    study.session.hold(0.5)

    assert cancelled.outcome == "cancelled"
    assert 0.12 < left_open < 0.20
    assert study.opening == pytest.approx(left_open, abs=0.002), "it moves on after the cancel"
    assert study.session.toolbox.grippers["left"].reading().holding

    closed = study.close("drawer")

    assert closed.outcome == "done", closed.failure
    assert abs(study.opening) <= 0.01
    study.require_well()


@pytest.mark.requirement("M3")
@pytest.mark.requirement("S7")
def test_an_open_door_is_pushed_shut_with_its_handle_out_of_sight_even_after_a_cancel():
    kitchen = Watched("fridge", opening=math.radians(64.0))
    kitchen.assembly.perception.faults.misplace("handle", (0.0, 0.0, 30.0), first_look_only=False)
    kitchen.once(lambda: kitchen.opening < 0.7, lambda: kitchen.session.cancel("by the test"))

    cancelled = kitchen.close("fridge")
    left_open = kitchen.opening
    kitchen.session.hold(0.5)

    assert cancelled.outcome == "cancelled"
    assert kitchen.opening == pytest.approx(left_open, abs=0.01), "it is pushed on after the cancel"
    kitchen.require_well()

    closed = kitchen.close("fridge")

    assert closed.outcome == "done", closed.failure
    assert abs(math.degrees(kitchen.opening)) <= 3.0
    assert closed.evidence["opening_deg"] == pytest.approx(math.degrees(kitchen.opening), abs=3.0)
    kitchen.require_well()
