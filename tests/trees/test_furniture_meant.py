"""Which board or table is meant: by its height, by its place, or by what it stands near."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from trees.beliefs.grounding.grounding import Ambiguous, Found, Missing, ground, ground_furniture
from trees.beliefs.scene.believed_thing import surroundings
from trees.tasks import ObjectDescription, Relation

HEIGHTS_M = {"shelf": 1.2, "shelf 2": 0.4, "shelf 3": 0.8}
SIDE = SceneObject("shelf 4", Box((0.3, 0.02, 1.25)), poses.translation(0.6, 0.5, 0.62), movable=False)
BOARDS = [
    SceneObject(name, Box((0.3, 1.0, 0.02)), poses.translation(0.6, 0.0, height), movable=False)
    for name, height in HEIGHTS_M.items()
]
TABLES = [
    SceneObject(name, Box((0.6, 0.8, 0.04)), poses.translation(1.0, y, 0.8), movable=False)
    for name, y in (("table", -1.5), ("table 2", 1.5))
]
ANA = SceneObject("Ana", Cylinder(0.24, 1.75), poses.translation(1.2, 2.6, 0.875), movable=False)


def around(*more):
    return surroundings(
        PlanningScene().with_objects([*BOARDS, SIDE, *TABLES, ANA, *more]), np.eye(4), support_gap_m=0.05
    )


@pytest.mark.requirement("L3")
@pytest.mark.parametrize(
    ("wanted", "name"),
    [
        (ObjectDescription("shelf", ordinal="top"), "shelf"),
        (ObjectDescription("shelf", ordinal="bottom"), "shelf 2"),
        (ObjectDescription("shelf"), "shelf"),
        (ObjectDescription("table", ordinal="leftmost"), "table 2"),
        (ObjectDescription("table", relation=Relation("next_to", "Ana")), "table 2"),
        (ObjectDescription("table", name="table 2"), "table 2"),
    ],
)
def test_a_board_is_meant_by_its_height_and_a_table_by_its_place(wanted, name):
    assert ground_furniture(wanted, around()) == Found((name,))


def test_a_board_that_cannot_be_told_is_asked_about():
    asked = ground_furniture(ObjectDescription("shelf", ordinal="second"), around())

    assert isinstance(asked, Ambiguous)
    assert {choice.name for choice in asked.choices} == set(HEIGHTS_M)


def test_furniture_that_was_not_seen_is_missing():
    assert ground_furniture(ObjectDescription("desk", ordinal="top"), around()) == Missing("no top desk seen")


@pytest.mark.parametrize(("ordinal", "name"), [("top", "red cup"), ("bottom", "blue cup")])
def test_what_stands_on_a_board_is_told_from_what_stands_on_another(ordinal, name):
    cups = [
        SceneObject(cup, Cylinder(0.03, 0.1), poses.translation(0.6, 0.1, height + 0.06))
        for cup, height in (("red cup", 1.2), ("blue cup", 0.4))
    ]

    found = ground(ObjectDescription("cup"), around(*cups), ObjectDescription("shelf", ordinal=ordinal))

    assert found == Found((name,))
