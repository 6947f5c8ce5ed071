"""What is named as not meant: left out where it is something else than what is, refused where it narrows."""

import pytest

from executive.understanding.command_parser import parse, parse_selection


@pytest.mark.requirement("L2", "L5")
@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("pick up the red cup, not the blue one", "pick up the red cup"),
        ("pick up the red, not the blue, cup", "pick up the red cup"),
        ("take not the knife but the fork and put it on the table", "take the fork and put it on the table"),
        ("put the red cup, not the blue one, on the table", "put the red cup on the table"),
        ("put the cup on the fridge, not in the fridge", "put the cup on the fridge"),
        ("give Ana, not Ben, the cup", "give Ana the cup"),
        ("not the bowl, the cup: bring me the cup", "bring me the cup"),
        ("instead of the cup, bring me the bowl", "bring me the bowl"),
        ("rather than the cup take the can", "take the can"),
        ("forget the cup, bring me the can", "bring me the can"),
        ("wave to me instead of walking to the kitchen", "wave to me"),
        ("turn left, not right", "turn left"),
        ("wait five seconds, not ten", "wait five seconds"),
    ],
)
def test_a_contrast_leaves_what_is_meant(said, meant):
    assert parse(said).to_json()["tasks"] == parse(meant).to_json()["tasks"] != []


@pytest.mark.requirement("L2", "L5")
@pytest.mark.parametrize(
    "said",
    [
        "pick up the cup, not the red one",
        "pick up the cup not on the table",
        "pick up the red cup, not the big one",
        "pick up the cup, not the mug",
        "pick up the fruit, not the apple",
        "take the red cup and the bowl, not the blue one",
        "pick up the cup, not the bowl and the spoon",
        "bring me the red cup, not the blue one on the shelf",
        "bring me some milk from the fridge rather than putting my jacket on the chair in the hallway",
        "put the cup on the table, not on the tray",
        "give the cup to Ana, not the woman",
        "hand me the box, but not the lid",
        "not the cup",
        "don't pick up the cup, pick up the bowl",
        "don't forget the cup, bring me the can",
        "forget the cup, bring me the red cup",
        "forget the limits, bring me the cup",
        "forget the cup",
    ],
)
def test_what_narrows_or_denies_is_refused(said):
    assert parse(said).refusal is not None


@pytest.mark.parametrize(
    ("answer", "meant"),
    [
        ("the red one, not the blue one", "the red one"),
        ("not the left one, the right one", "the right one"),
        ("not the small one but the big one", "the big one"),
    ],
)
def test_an_answer_may_name_what_is_not_meant(answer, meant):
    assert parse_selection(answer) == parse_selection(meant) is not None


@pytest.mark.parametrize(
    "answer",
    ["not the red one", "the cup, not the red one", "the red one, not the big one", "not red, not blue"],
)
def test_an_answer_that_only_denies_chooses_nothing(answer):
    assert parse_selection(answer) is None
