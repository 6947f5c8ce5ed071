"""Pairs of links that are not judged: found by sampling, and held against fresh samples."""

import dataclasses
import importlib.resources
import tomllib

import pytest

from kinematics.model.robot_model import RobotModel
from robots.models.description import DISABLED_COLLISIONS, load_description
from tools.robot_data.disabled_collisions import find, pairs_text


def undisabled(name):
    return RobotModel(dataclasses.replace(load_description(name), disabled_collisions=frozenset()))


@pytest.fixture(scope="module")
def g1_anew():
    return find(undisabled("g1"), samples=200, seed=77)


@pytest.fixture(scope="module")
def g1_stored():
    file = importlib.resources.files("robots.models") / "g1" / DISABLED_COLLISIONS
    return {key: {tuple(pair) for pair in pairs} for key, pairs in tomllib.loads(file.read_text()).items()}


def test_no_pair_is_stored_as_far_apart_that_fresh_samples_find_near(g1_anew, g1_stored):
    assert len(g1_stored["never"]) > 50
    assert g1_stored["never"] <= set(g1_anew.never)


def test_neighbours_and_what_is_built_together_are_those_stored(g1_anew, g1_stored):
    assert set(g1_anew.adjacent) == g1_stored["adjacent"]
    assert set(g1_anew.by_design) == g1_stored["by_design"]


def test_hands_and_what_they_can_hit_stay_judged(g1_stored):
    disabled = set().union(*g1_stored.values())

    for pair in (
        ("left_rubber_hand", "right_rubber_hand"),
        ("left_rubber_hand", "torso_link"),
        ("head_link", "right_rubber_hand"),
        ("left_knee_link", "right_knee_link"),
    ):
        assert pair not in disabled


def test_what_is_printed_can_be_read_back(g1_anew):
    read = tomllib.loads(pairs_text(g1_anew, "g1", 200, 77))

    assert [tuple(pair) for pair in read["never"]] == list(g1_anew.never)
    assert set(read) == {"adjacent", "by_design", "never"}
