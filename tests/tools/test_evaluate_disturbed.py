"""Suites of pushes and of walks with something wrong: what is counted, and what is drawn."""

import numpy as np
import pytest

from tools.evaluate.disturbed.bare_walk import BareWalk
from tools.evaluate.disturbed.pushes import PushSummary, run_push_episode
from tools.evaluate.disturbed.rough import RoughSummary
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import EpisodeRecord
from tools.pictures.draw_pushes import curves, picture


def push(seed, stood=True, gait="standing", side="sideways", at="pelvis", share=1.0, force_n=250.0):
    numbers = {"gait": gait, "side": side, "at": at, "share": share, "force_n": force_n}
    return EpisodeRecord(seed, "done" if stood else "failed", truth=stood, fell=not stood, numbers=numbers)


def bars(*records):
    return {bar.name: bar for bar in PushSummary("push", 0, None, 0.02, records).bars()}


def test_only_pushes_at_the_pelvis_with_the_force_that_is_demanded_count():
    found = bars(push(0), push(1, stood=False, at="torso"), push(2, stood=False, share=1.5))

    assert found["standing, 250 N"].value == "1 of 1"
    assert found["standing, 250 N"].met


def test_a_demand_without_a_push_is_not_met():
    assert not bars(push(0))["walking, sideways, 120 N"].met


def test_one_fall_of_ten_misses_the_demand():
    walks = [push(k, stood=k > 0, gait="walking", force_n=120.0) for k in range(10)]

    assert not bars(*walks)["walking, sideways, 120 N"].met


def test_a_small_robot_is_pushed_at_its_own_links_with_its_own_demand():
    records = [run_push_episode(EpisodeOrder(seed, robot="g1")) for seed in (1, 10)]

    assert {record.outcome for record in records} <= {"done", "failed"}
    assert {record.numbers["at"] for record in records} == {"pelvis", "torso"}
    assert all(record.numbers["force_n"] <= 120.0 for record in records)


def test_what_is_wrong_is_counted_by_itself():
    records = [
        EpisodeRecord(k, "done", truth=k != 1, numbers={"wrong": wrong})
        for k, wrong in enumerate(("delay", "uneven", "delay"))
    ]

    found = {bar.name: bar.value for bar in RoughSummary("rough", 0, None, 0.02, records).bars()}

    assert found["sensors 10 ms late"] == "2 of 2"
    assert found["plates of up to 1 cm on the floor"] == "0 of 1"


def test_a_curve_counts_the_pushes_of_each_force():
    records = [push(k, stood=k < 2, force_n=260.0).to_json() for k in range(3)]

    assert curves(records)["standing"] == [(275.0, 2, 3)]
    assert picture(records).count("<circle") == 1


def test_delayed_readings_are_those_of_some_periods_ago():
    body = BareWalk("talos", 0, delay_periods=5)

    stamps = []
    for _ in range(10):
        body.loop.step()
        stamps.append(body.loop.sensing.state().readings.stamp_s)

    assert np.diff(stamps[5:]) == pytest.approx(0.002)
    assert body.world.truth.time_s - stamps[-1] == pytest.approx(5 * 0.002)


def test_a_hard_push_makes_the_standing_robot_fall_and_a_light_one_does_not():
    light, hard = BareWalk("talos", 0), BareWalk("talos", 0)

    assert light.go_on(0.2)
    assert light.push(100.0, 0.0, "base_link")
    assert light.go_on(0.8)
    assert hard.go_on(0.2)
    assert not (hard.push(1500.0, 0.0, "base_link") and hard.go_on(1.5))
    assert np.isfinite(light.world.truth.com()).all()
