"""Random scenes cover exactly what the evaluation promises, and can be worlds."""

import math

import numpy as np
import pytest

from robots.scenes.scene_file import load_scene
from robots.scenes.scene_writer import dump
from tools.evaluate.scenes import TARGET, episode_scene, pick_scene, read_episode_scene

SCENES = [read_episode_scene(pick_scene(seed), seed) for seed in range(100)]
CUPS = [next(item for item in scene.objects if item.name == TARGET) for scene in SCENES]


def spread(values, low, high):
    """Inside the range, and using nearly all of it."""
    values = np.array(values)
    assert values.min() >= low - 1e-9
    assert values.max() <= high + 1e-9
    assert values.min() < low + 0.05 * (high - low)
    assert values.max() > high - 0.05 * (high - low)


def test_the_cup_is_drawn_from_the_whole_range():
    spread([cup.world_T_object[0, 3] for cup in CUPS], 0.35, 0.65)
    spread([cup.world_T_object[1, 3] for cup in CUPS], -0.45, 0.45)
    spread([cup.shape.radius_m for cup in CUPS], 0.020, 0.038)
    spread([cup.shape.height_m for cup in CUPS], 0.080, 0.160)
    spread([cup.mass_kg for cup in CUPS], 0.1, 0.6)
    spread([cup.friction for cup in CUPS], 0.4, 1.0)


def test_table_and_start_are_drawn_from_the_whole_range():
    spread([scene.furniture[0].size_m[2] for scene in SCENES], 0.75, 1.0)
    spread([scene.robot_start.x_m for scene in SCENES], -0.03, 0.03)
    spread([scene.robot_start.y_m for scene in SCENES], -0.03, 0.03)
    spread([scene.robot_start.yaw_rad for scene in SCENES], -math.radians(5), math.radians(5))
    assert {(s.perception.bias_m, s.perception.noise_m) for s in SCENES} == {(0.005, 0.002)}


def test_every_cup_stands_whole_on_the_table():
    for scene, cup in zip(SCENES, CUPS, strict=True):
        (table,) = scene.furniture
        inside = 0.5 * np.array(table.size_m[:2]) - cup.shape.radius_m
        assert np.all(np.abs(cup.world_T_object[:2, 3] - table.position_m) <= inside)
        assert cup.world_T_object[2, 3] == pytest.approx(table.size_m[2] + 0.5 * cup.shape.height_m)


def test_the_standing_robot_does_not_touch_the_table():
    hands_and_thighs = np.array([(0.203, 0.525), (0.203, -0.525), (0.208, 0.057), (0.208, -0.057)])
    for scene in SCENES:
        (table,), start = scene.furniture, scene.robot_start
        c, s = math.cos(start.yaw_rad), math.sin(start.yaw_rad)
        ahead = start.x_m + hands_and_thighs @ (c, -s)
        assert table.position_m[0] - 0.5 * table.size_m[0] - ahead.max() >= 0.01


def test_some_scenes_hold_other_things_and_none_of_them_is_a_second_red_cup():
    crowded = [scene for scene in SCENES if len(scene.objects) > 1]

    assert 0.3 < len(crowded) / len(SCENES) < 0.7
    for scene in crowded:
        assert [item.color for item in scene.objects].count("red") == 1


def test_a_seed_is_one_scene_to_the_last_byte():
    assert pick_scene(7) == pick_scene(7)
    assert pick_scene(7) != pick_scene(8)


def test_nothing_there_leaves_the_rest_of_the_scene_as_it_was():
    for seed in range(20):
        scene = read_episode_scene(pick_scene(seed, "nothing_there"), seed)
        assert [i.name for i in scene.objects] == [i.name for i in SCENES[seed].objects][1:]
        assert scene.furniture == SCENES[seed].furniture


def test_too_close_puts_a_cup_of_another_colour_a_few_millimetres_beside():
    for seed in range(20):
        scene = read_episode_scene(pick_scene(seed, "too_close"), seed)
        red, blue = scene.objects[:2]
        gap = np.linalg.norm((red.world_T_object - blue.world_T_object)[:2, 3]) - 2 * red.shape.radius_m
        assert (red.color, blue.color) == ("red", "blue")
        assert 0.001 <= gap <= 0.006


def test_a_scene_survives_being_written_again():
    again = read_episode_scene(dump(SCENES[3]), 3)

    assert again.furniture == SCENES[3].furniture


def test_the_sentence_names_the_furniture_that_the_cup_is_on():
    from robots.scenes.scene_file import load_scene
    from tools.evaluate.scenes import sentence_for

    assert sentence_for(load_scene("tabletop")) == "pick up the red cup on the table"
    assert sentence_for(load_scene("shelf")) == "pick up the red cup on the shelf"


def test_clutter_is_another_one_for_each_seed_and_full():
    scenes = [read_episode_scene(episode_scene(seed, scene="clutter"), seed) for seed in range(30)]

    counts = [len(scene.objects) - 1 for scene in scenes]
    assert len({tuple(item.world_T_object[0, 3] for item in scene.objects) for scene in scenes}) == 30
    assert min(counts) >= 2  # a small table has no room for more
    assert max(counts) >= 10
    for scene in scenes:
        places = [item.world_T_object[:2, 3] for item in scene.objects]
        gaps = [np.linalg.norm(a - b) for i, a in enumerate(places) for b in places[:i]]
        assert min(gaps) >= 0.03 + 2 * 0.020


@pytest.mark.parametrize("name", ["dinner", "shelf", "counter"])
def test_a_named_scene_is_a_little_different_for_each_seed(name):
    told = load_scene(name)
    scenes = [read_episode_scene(episode_scene(seed, scene=name), seed) for seed in range(5)]

    assert len({scene.robot_start for scene in scenes}) == 5
    assert {(scene.perception.bias_m, scene.perception.noise_m) for scene in scenes} == {(0.005, 0.002)}
    for scene in scenes:
        for item, was in zip(scene.objects, told.objects, strict=True):
            moved = np.abs(item.world_T_object[:3, 3] - was.world_T_object[:3, 3])
            assert np.all(moved <= (0.02 + 1e-9, 0.02 + 1e-9, 0.005))
    assert len({scene.objects[0].world_T_object[0, 3] for scene in scenes}) == 5
