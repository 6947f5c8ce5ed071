"""A camera that hangs is noticed, and one that works is let alone."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball
from robots.perception.detector import Detection, PerceptionFrame
from robots.perception.fusion.frame_watch import Fault, FrameWatch
from robots.perception.position_error import alike_in_all_directions

TICK_S = 0.02


def frame(stamp_s, number, x=0.0, noise_m=0.002):
    error = alike_in_all_directions(0.005, noise_m, 0.01)
    seen = Detection("object", "ball", "red", poses.translation(x, 0.0, 1.0), Ball(0.03), 0.9, error=error)
    return PerceptionFrame(stamp_s, number, (seen,))


def faults(frames, ticks=60):
    """What is told when, at each tick the newest frame of some (delivery time, frame)."""
    watch, told = FrameWatch(0.0), []
    for k in range(ticks):
        now_s = k * TICK_S
        newest = [one for at_s, one in frames if at_s <= now_s + 1e-9]
        told.append((now_s, watch.take(newest[-1] if newest else None, now_s)))
    return told


def steady(rate_hz=15.0, until_s=1.2, age_s=0.1, same=False):
    rng = np.random.default_rng(0)
    stamps = np.arange(0.0, until_s, 1.0 / rate_hz).tolist()
    return [(t + age_s, frame(t, k, 0.0 if same else rng.normal())) for k, t in enumerate(stamps)]


@pytest.mark.requirement("P3")
def test_a_camera_that_works_is_let_alone():
    assert {fault for _, fault in faults(steady())} == {None}


@pytest.mark.requirement("F3")
def test_one_frame_again_and_again_is_noticed_within_half_a_second():
    stops = [(at_s, one) for at_s, one in steady() if at_s < 0.5]
    noticed = [at_s for at_s, fault in faults(stops) if fault is Fault.FROZEN]

    assert noticed[0] - stops[-1][0] <= 0.5


@pytest.mark.requirement("F3")
def test_a_frozen_picture_with_new_stamps_is_noticed_within_half_a_second():
    noticed = [at_s for at_s, fault in faults(steady(same=True)) if fault is Fault.FROZEN]

    assert noticed[0] <= 0.5


def test_a_detector_without_noise_may_tell_the_same_twice():
    still = [(t, frame(t, k, noise_m=0.0)) for k, t in enumerate(np.arange(0.0, 1.2, 0.05).tolist())]

    assert {fault for _, fault in faults(still)} == {None}


@pytest.mark.requirement("F3")
def test_frames_that_come_far_too_late_are_stale():
    late = faults([(t, frame(t - 0.8, k, x)) for k, (t, x) in enumerate((0.1 * k, k) for k in range(12))])

    assert Fault.STALE in {fault for _, fault in late}


def test_what_was_taken_before_anybody_looked_is_no_fault_of_the_camera():
    left_over = [(0.0, frame(-4.1, 1)), (0.04, frame(-4.0, 2, 1.0)), (0.08, frame(-3.9, 3, 2.0))]
    after = [(0.1 + 0.1 * k, frame(0.1 * k, 4 + k, 3.0 + k)) for k in range(11)]

    assert {fault for _, fault in faults([*left_over, *after], ticks=50)} == {None}


@pytest.mark.requirement("F3")
def test_frames_that_go_back_in_time_are_stale():
    mixed = [(0.0, frame(0.0, 1)), (0.1, frame(0.1, 2, 1.0)), (0.2, frame(0.05, 3, 2.0))]

    assert faults(mixed, ticks=12)[-1][1] is Fault.STALE


def test_a_pause_of_who_looks_is_no_silence_of_the_camera():
    watch = FrameWatch(0.0)
    watch.take(frame(0.0, 1), 0.02)

    assert watch.take(frame(0.0, 1), 3.0) is None
