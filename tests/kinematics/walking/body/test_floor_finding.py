"""Soles that stop on what they touch, and go down to what they do not feel."""

import numpy as np
import pytest

from kinematics.geometry.planar import PlanarPose
from kinematics.walking.body.floor_finding import FloorFinding
from kinematics.walking.pattern.com_motion import ComSample
from kinematics.walking.pattern.pattern_sample import PatternSample, Phase

PERIOD_S = 0.002
SWING_S, LIFT_M = 0.5, 0.05
STILL = ComSample((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (0.0, 0.0))
FEET = {"left": PlanarPose(0.0, 0.1, 0.0), "right": PlanarPose(0.0, -0.1, 0.0)}


class Steps:
    """Steps on the spot over a floor that is not where the plan has it."""

    def __init__(self, heights_m=None):
        self.floor = FloorFinding(heights_m or {"left": 0.0, "right": 0.0}, PERIOD_S)
        self.heights = {"left": [], "right": []}

    def instant(self, phase, carrying, lift_m, loads_n):
        found = self.floor.under(PatternSample(STILL, FEET, lift_m, carrying, phase), loads_n)
        for side, height_m in found.lift_m.items():
            self.heights[side].append(height_m)

    def swing_left(self, felt_below_m):
        """The left foot swings; it feels the floor while it is lower than this."""
        for k in range(1, round(SWING_S / PERIOD_S) + 1):
            share = k * PERIOD_S / SWING_S
            planned_m = LIFT_M * (4.0 * share * (1.0 - share)) ** 3
            touched = share > 0.5 and self.heights["left"][-1] < felt_below_m
            self.instant(
                Phase.SWING,
                ("right",),
                {"left": planned_m, "right": 0.0},
                {"left": 200.0 if touched else 0.0, "right": 900.0},
            )

    def both(self, seconds, felt_below_m, phase=Phase.LAND):
        """Both feet are to stand; the left one feels the floor while it is lower than this."""
        for _ in range(round(seconds / PERIOD_S)):
            felt = not self.heights["left"] or self.heights["left"][-1] < felt_below_m
            loads_n = {"left": 400.0 if felt else 0.0, "right": 500.0}
            self.instant(phase, ("left", "right"), {"left": 0.0, "right": 0.0}, loads_n)


@pytest.mark.requirement("M6")
def test_a_sole_stays_on_the_plate_that_it_touches():
    steps = Steps()
    steps.both(0.1, felt_below_m=1.0)

    steps.swing_left(felt_below_m=0.009)
    steps.both(0.1, felt_below_m=0.009)

    assert 0.004 < steps.heights["left"][-1] < 0.009
    assert steps.heights["left"][-50] - steps.heights["left"][-1] < 0.0005


@pytest.mark.requirement("M6")
def test_a_sole_that_feels_nothing_goes_down_until_it_does():
    steps = Steps()
    steps.both(0.1, felt_below_m=1.0)

    steps.swing_left(felt_below_m=-0.006)
    steps.both(0.3, felt_below_m=-0.006)

    assert -0.010 < steps.heights["left"][-1] < -0.006
    assert steps.heights["right"][-1] > -0.001


def test_a_hole_is_not_followed_down():
    steps = Steps()
    steps.both(0.1, felt_below_m=1.0)

    steps.swing_left(felt_below_m=-1.0)
    steps.both(1.0, felt_below_m=-1.0)

    assert -0.025 < steps.heights["left"][-1] < -0.015


def test_a_level_floor_changes_nothing():
    steps = Steps()
    steps.both(0.1, felt_below_m=1.0)

    steps.swing_left(felt_below_m=0.0025)
    planned = [LIFT_M * (4.0 * s * (1.0 - s)) ** 3 for s in np.arange(1, 251) * PERIOD_S / SWING_S]
    steps.both(0.5, felt_below_m=1.0)

    assert steps.heights["left"][50:300] == pytest.approx(planned, abs=0.0)
    assert set(steps.heights["left"][300:]) == {0.0}
    assert set(steps.heights["right"]) == {0.0}


def test_the_next_step_heads_for_the_plans_floor_again():
    steps = Steps({"left": 0.008, "right": 0.0})
    steps.both(0.1, felt_below_m=1.0)

    steps.swing_left(felt_below_m=-0.1)

    assert steps.heights["left"][-1] == pytest.approx(0.0, abs=0.003)


def test_floors_that_are_all_high_are_the_plans_floor_in_the_end():
    steps = Steps({"left": 0.010, "right": 0.008})

    steps.both(10.0, felt_below_m=1.0)

    left, right = steps.heights["left"][-1], steps.heights["right"][-1]
    assert abs(left + right) < 0.001
    assert left - right == pytest.approx(0.002)


def test_at_the_end_of_a_walk_nothing_moves():
    steps = Steps({"left": 0.010, "right": 0.008})
    steps.both(1.0, felt_below_m=1.0)

    steps.both(0.3, felt_below_m=1.0, phase=Phase.SETTLE)
    before = steps.heights["left"][-1]
    steps.both(0.1, felt_below_m=1.0, phase=Phase.REST)

    assert steps.heights["left"][-1] == before


@pytest.mark.parametrize("felt_below_m", [0.012, 0.006, -0.004, -0.012])
def test_no_sole_is_moved_by_jerks(felt_below_m):
    steps = Steps()
    steps.both(0.1, felt_below_m=1.0)
    steps.swing_left(felt_below_m)
    steps.both(0.4, felt_below_m)

    heights = np.array(steps.heights["left"])
    acceleration = np.diff(heights, 2) / PERIOD_S**2
    planned = LIFT_M * (4.0 * 0.5 * 0.5) ** 3 * 24.0 / SWING_S**2
    assert np.abs(acceleration).max() < planned + 10.0
