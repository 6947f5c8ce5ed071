"""What was seen, in words for people."""

import numpy as np
import pytest

from kinematics.geometry.shapes import Cylinder
from kinematics.scene.label import Label
from trees.beliefs.grounding.report_words import direction, kinds_in, whereabouts
from trees.beliefs.scene.believed_thing import BelievedThing


@pytest.mark.parametrize(
    ("place", "words"),
    [
        ((0.45, -0.2), "0.45 m ahead, 0.20 m to the right"),
        ((0.45, 0.02), "0.45 m ahead"),
        ((-1.2, 1.3), "1.20 m behind me, 1.30 m to the left"),
    ],
)
def test_a_direction_is_never_a_negative_length(place, words):
    assert direction(*place) == words


def test_what_a_thing_stands_on_is_called_without_its_number():
    cup = BelievedThing(
        "red cup",
        Label("cup", "red"),
        Cylinder(0.03, 0.11),
        np.array([0.45, 0.0, 0.95]),
        0.055,
        True,
        "table 2",
    )

    assert whereabouts(cup) == "on the table, 0.45 m ahead"


def test_the_legs_of_a_table_are_not_told_as_more_tables():
    assert kinds_in(["table 3", "red cup", "table", "table 2"]) == "red cup, table"
    assert kinds_in([]) == "nothing"
