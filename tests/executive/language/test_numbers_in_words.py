"""Numbers and measures as they are spoken."""

import pytest

from executive.understanding.command_parser import parse


def tasks_of(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.parametrize(
    ("said", "seconds"),
    [
        ("a hundred and ten", 110.0),
        ("one hundred twenty-five", 125.0),
        ("two hundred and five", 205.0),
        ("about ninety", 90.0),
        ("2,5", 2.5),
    ],
)
def test_a_number_is_understood_as_it_is_spoken(said, seconds):
    assert tasks_of(f"wait {said} seconds") == [{"action": "wait", "duration_s": seconds}]


@pytest.mark.parametrize("said", ["1,500", "1,2,3", "a hundred then ten", "twenty hundred and five"])
def test_digits_that_may_mean_something_else_are_not_a_number(said):
    assert tasks_of(f"wait {said} seconds") == []


def test_three_quarters_of_a_meter_are_75_cm():
    assert tasks_of("walk forward three quarters of a meter")[0]["distance_m"] == 0.75


def test_a_distance_may_stand_before_its_direction():
    assert tasks_of("walk 2 m forward") == tasks_of("walk forward 2 m") != []


def test_the_smaller_unit_of_a_length_is_added():
    assert tasks_of("walk forward 1 m 20 cm")[0]["distance_m"] == 1.2
    assert tasks_of("walk forward 20 cm 1 m") == []


def test_a_turn_is_made_by_its_degrees():
    assert tasks_of("make a 90-degree turn to the right") == tasks_of("turn right 90 degrees") != []
