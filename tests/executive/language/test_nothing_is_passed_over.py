"""What another reading could make of a sentence is asked about or refused: no word is passed over."""

import pytest

from executive.understanding.command_parser import parse

NO_TASK = (
    # said of oneself
    "let me open the fridge",
    "I'll pick up the cup",
    "I am going to close the drawer",
    # nothing is to be moved
    "leave the cup on the table",
    "find the cup and leave it on the table",
    # one thing said twice
    "bring me the blue thing, the cup",
    "bring me the cup, the bottle",
    "pick up the toy, the ball and the cup",
    "wave to the nurse, Ana",
    # a clause that describes, where nothing separates it
    "bring me the cup what is on the table",
    "pick up the cup where is the bottle",
    # the same thing in two places, or given twice
    "put the cup in the cup",
    "put my cup next to your cup",
    "point at this cup and then at that cup",
    "give me the cup and Ana the cup",
    # quantities
    "grasp every other cup",
    "grasp every second cup",
    "pick up a third of the cups",
    "hand the 5 cup to Ana",
    "pick up the cup you see first",
    # a mere heading, or a stop, beside another task
    "go home, in reverse",
    "walk to Ana, straight, and wave",
    "backwards look at the cup",
    "stop pick up both cups",
    "pick up the cup, stop",
    "go drawer home",
    # people
    "hand the cup for Ana to Ben",
    "bring the cup to Ben for Ana",
    "give Ben the cup and her the bottle",
    "wave to the man and give her the cup",
    "walk to Ana and give him the cup",
    # places
    "pick up the cup at the back of the table",
    "bring me the juice in a glass",
    "walk to the kitchen. The shelf.",
    "bring the cup from the table to the sink and the plate from the counter",
    # a statement that says something else than the task takes up
    "the fridge is open. Open it.",
    "the fridge should be closed. Open it.",
    "the drawer is open, close the fridge",
    "look at the shelf. Is there a cup?",
    "take the plate to the sink and take the bowl there too",
    "look at the shelf. Take the cup there.",
    "open the bottom drawer and put the blue box in that one",
    # "one" of what
    "pick up the cup on the left table and the bottle on the right one",
    "pick up the red cup and the blue bottle and put the red one in the box",
    "put the bottle next to the red cup and the can next to the blue one",
    "put the red cup on the table and the blue box on the green one",
    "walk to the red table, then to the blue one",
    "pick up the red cup and the blue cup and put the other one in the box",
    # "it" of what
    "find the red cup and put the bottle next to it and the can behind it",
    "find the red cup and the blue cup and put them in it",
    "open the drawer, put the cup in it and the bottle next to it",
    # marks
    "!walk to the kitchen",
)


@pytest.mark.requirement("L5")
@pytest.mark.parametrize("sentence", NO_TASK)
def test_what_may_mean_something_else_makes_no_task(sentence):
    parsed = parse(sentence)

    assert parsed.commands == ()
    assert parsed.question is not None or parsed.refusal is not None


@pytest.mark.parametrize(
    ("sentence", "actions"),
    [
        ("take the cup to the shelf and leave it there", ["pick", "place"]),
        ("pick up the cup and leave it on the table", ["pick", "place"]),
        ("let me have the cup", ["hand_over"]),
        ("bring me the cup, the bottle and the box", ["pick", "hand_over"] * 3),
        ("bring me the bottle. How many cups are on the table?", ["pick", "hand_over", "count"]),
        ("put the cup next to the other cup", ["place"]),
        ("grasp all the other cups", ["pick"]),
        ("walk to the kitchen and stop", ["walk_to", "stop"]),
        ("forward 2 m, left 90 degrees", ["move", "move"]),
        ("go to the table, then home", ["walk_to", "go_home"]),
        ("bring the cup to Ana for me", ["pick", "hand_over"]),
        ("walk to Ana and give her the cup", ["walk_to", "hand_over"]),
        ("look at the boy and bring him the ball", ["look_at", "pick", "hand_over"]),
        ("bring me the apple in the bowl", ["pick", "hand_over"]),
        ("the fridge is open, close it", ["close"]),
        ("give Ana the smaller cup and Ben the bigger one", ["hand_over", "hand_over"]),
        ("put the red ball in the box and the blue one on the shelf", ["put_in", "place"]),
        ("pick up both the cup and the bottle", ["pick", "pick"]),
    ],
)
def test_what_can_mean_one_thing_only_is_still_done(sentence, actions):
    assert [command.action for command in parse(sentence).commands] == actions


def test_a_second_thing_is_for_the_person_who_was_named_before_it():
    parsed = parse("hand Maria the red pen and the blue one, and Tom the black one")

    assert [(one.object.color, one.to) for one in parsed.commands] == [
        ("red", "Maria"),
        ("blue", "Maria"),
        ("black", "Tom"),
    ]
