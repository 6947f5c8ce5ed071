"""Random scenes before an arm that is bolted down are within its reach, and fit into its fingers."""

import math

import numpy as np
import pytest

from kinematics.geometry.shapes import Box
from robots.models.description import load_description
from tools.evaluate.__main__ import own_scene
from tools.evaluate.scenes import episode_scene, read_episode_scene
from tools.evaluate.skills.episode import trial_of
from tools.evaluate.skills.rooms import BENCH
from tools.evaluate.stopping.courses import BENCH_CYCLE, COURSES, LOW_CYCLE
from tools.evaluate.stopping.stop_episode import stop_orders

SEEDS = range(30)


def held_things():
    for seed in SEEDS:
        yield read_episode_scene(episode_scene(seed, scene="bench"), seed).objects[0]
        for suite in ("place", "put_in"):
            trial = trial_of(suite, seed, "bench")
            yield next(item for item in trial.scene.objects if item.name == trial.aim)


def test_what_is_to_be_held_fits_between_the_fingers():
    opening_m = load_description("panda").grippers["right"].max_opening_m

    for item in held_things():
        shape = item.shape
        width_m = min(shape.size_m[:2]) if isinstance(shape, Box) else 2.0 * shape.radius_m
        assert width_m < opening_m - 0.012


def test_what_is_to_be_held_is_within_reach():
    places = np.array([item.world_T_object[:2, 3] for item in held_things()])

    assert np.hypot(*places.T).max() <= BENCH.farthest_m


def test_nobody_stands_about():
    assert not any(trial_of("point_at", seed, "bench").scene.people for seed in SEEDS)


def test_a_suite_without_a_bench_says_so():
    with pytest.raises(ValueError, match="hand_over has no episodes in the scene 'bench'"):
        trial_of("hand_over", 0, "bench")


def test_the_rooms_of_a_humanoid_are_as_before():
    start = trial_of("place", 3124).scene.robot_start

    assert math.isclose(start.x_m, 0.025534452877446705)


def test_stops_of_a_bench_come_to_every_phase_of_its_courses():
    orders = stop_orders("stop", 18, 0, "panda", scene="bench")

    assert sum(len(order.wanted) for order in orders) == 18
    assert {COURSES[order.course] for order in orders} == set(BENCH_CYCLE)


def test_stops_before_a_low_table_are_of_what_a_small_body_does_there():
    orders = stop_orders("stop", 31, 0, "g1", scene="low_tabletop")

    assert sum(len(order.wanted) for order in orders) == 31
    assert {COURSES[order.course] for order in orders} == set(LOW_CYCLE)
    for order in orders[:5]:
        scene = COURSES[order.course].script(order.seed).scene
        assert all(piece.size_m[2] < 0.8 for piece in scene.furniture)


@pytest.mark.parametrize(
    ("suite", "robot", "scene"),
    [
        ("pick", "talos", None),
        ("pick", "g1", "low_tabletop"),
        ("place", "panda", "bench"),
        ("open", "panda", "bench_drawers"),
        ("open", "g1", "low_kitchen"),
        ("hand_over", "panda", None),
        ("things", "g1", None),
    ],
)
def test_a_suite_is_drawn_before_furniture_of_the_robots_own_size(suite, robot, scene):
    assert own_scene(suite, robot) == scene
