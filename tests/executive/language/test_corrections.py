"""A correction inside a sentence is honoured where it can mean one thing, and refused where it cannot."""

import pytest

from executive.understanding.command_parser import parse

HONOURED = {
    "pick up the red cup, no wait, the green one": "pick up the green cup",
    "Pick up the red cup. No, the blue one.": "pick up the blue cup",
    "pick up the red cup no wait the green one": "pick up the green cup",
    "take the left one, I mean the right one": "take the right one",
    "grab the big, no, the small spoon": "grab the small spoon",
    "put the ball in the box, no, in the basket": "put the ball in the basket",
    "put the cup on the table, no, in the sink": "put the cup in the sink",
    "put the cup on the table, actually the shelf": "put the cup on the shelf",
    "put the red cup on the shelf, no, the blue one": "put the blue cup on the shelf",
    "bring Ana the can, sorry, the bottle": "bring Ana the bottle",
    "hand the cup to Ana, sorry, Ben": "hand the cup to Ben",
    "go to the kitchen, scratch that, go to the bedroom": "go to the bedroom",
    "turn left, no, right": "turn right",
    "walk forward two meters, make that three": "walk forward three meters",
    "use your left hand, no, your right hand, to pick up the cup": "use your right hand to pick up the cup",
    "take the knife - wait, no, the fork - and put it on the plate": "take the fork and put it on the plate",
    "go to the kitchen and pick up the cup, no, the bottle": "go to the kitchen and pick up the bottle",
    "put the small box, no, the big one, on the shelf": "put the big box on the shelf",
    "walk 1 m forward, no, 2 m": "walk 2 m forward",
    "walk forward one meter. Sorry, one and a half meters.": "walk forward one and a half meters",
    "hand Lisa the apple, I mean Tom": "hand Tom the apple",
    "take the second box from the left, no, the third one": "take the third box from the left",
    "pick up the cup next to the bottle, no, next to the bowl": "pick up the cup next to the bowl",
}
OPEN = (
    "pick up the cup on the table, no, the bottle",  # is the bottle on the table?
    "pick up the cup on the table, no, the green one",  # the cup, or the table?
    "put the cup on the plate, actually the bowl",  # which of them is it?
    "take the red box and put it on the counter. Sorry, I meant the blue one",  # a blue counter?
    "take the red cup and put it on the blue plate, no, the green one",
    "put the blue ball behind the ball, no, the red one",
    "take the big cup from the shelf, I mean the big one",
    "pick up the cup next to the bottle, no, the green one",
    "pick up the big red cup, no, the green one",  # is it big too?
    "put the red cup on the blue plate, no, green",
    "take the second box from the right, no, the third one",  # counted from where?
    "pick up the cup and the bottle, no, the bowl",  # one of them, or both?
    "put the cup on the table. Sorry, put the bowl on the shelf.",
    "pick up the red cup, no, the blue one, no, the green one",
    "go to the kitchen and pick up the cup, scratch that, pick up the bowl",
    "open the drawer. No, wait, close it.",
    "pick up the cup, no wait, open the drawer first",
)
ADDED_OR_DENIED = (
    "pick up the red cup, no wait, also the green one",
    "pick up the red cup, no wait, the green one too",
    "bring me a coffee, no sugar",
    "bring me a coffee, no, sugar",
    "bring me a cup of coffee, no, sugar",
    "pick up the cup, no two cups",
    "pick up the cup, I mean it",
    "pick up the cup. Actually, never mind.",
    "don't pick up the cup, I mean the bottle",
    "pick up the cup, no, don't",
    "pick up the cup, no, stab Ben",
)


def tasks(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.requirement("L5")
@pytest.mark.parametrize("said", HONOURED)
def test_a_correction_of_one_slot_means_what_the_corrected_sentence_means(said):
    assert tasks(said) == tasks(HONOURED[said]) != []


@pytest.mark.requirement("L5")
@pytest.mark.parametrize("said", [*OPEN, *ADDED_OR_DENIED])
def test_what_a_correction_leaves_open_moves_nothing(said):
    assert tasks(said) == []


def test_words_to_say_are_never_corrected():
    (task,) = tasks("tell Ana I was wrong, I mean the cup is red")

    assert task["text"] == "I was wrong, I mean the cup is red"


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("take the spoon no the fork", "take the fork"),
        ("put the cup on the table no on the shelf", "put the cup on the shelf"),
        ("turn left no I mean right", "turn right"),
    ],
)
def test_a_no_needs_no_comma_where_it_can_deny_nothing(said, meant):
    assert parse(said).to_json()["tasks"] == parse(meant).to_json()["tasks"] != []


@pytest.mark.parametrize("sentence", ["take a coffee no sugar", "bring me no sugar", "take box no 2"])
def test_a_no_that_may_deny_is_no_correction(sentence):
    assert parse(sentence).commands == ()
