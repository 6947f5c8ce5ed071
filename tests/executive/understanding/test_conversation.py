"""One sentence after the other: what only the ones before make clear, and what nothing makes clear."""

import pytest

from executive.references import PREVIOUS
from executive.scripts.task_script import load_script
from executive.understanding.conversation import Conversation
from robots.fake.fake_world import cup
from trees.tasks import WHERE_IT_WAS, CloseTask, HandOverTask, ObjectDescription, PickTask, PlaceTask

RED_CUP = ObjectDescription("cup", "red")


def heard(*sentences):
    """What the last one was understood as."""
    conversation = Conversation()
    return [conversation.understand(sentence) for sentence in sentences][-1].parsed


@pytest.mark.requirement("L2")
@pytest.mark.parametrize(
    "said",
    [
        ["take the red cup", "put it on the table"],
        ["take the red cup", "wave to Ana", "put it on the table"],
        ["take the red cup", "hold on", "put it on the table"],
        ["take the red cup and wave to Ana", "put it on the table"],
    ],
)
def test_it_is_what_was_spoken_of_before(said):
    (place,) = heard(*said).commands

    assert isinstance(place, PlaceTask)
    assert (place.object, place.on) == (RED_CUP, "table")
    assert place.text == "put it on the table"


@pytest.mark.requirement("L2")
@pytest.mark.parametrize(
    ("said", "meant"),
    [
        (["take the red cup", "put it back"], RED_CUP),
        (["take the red cup", "wave to Ana", "put it back where it was"], RED_CUP),
        (["take the red cup", "put the cup back where you found it"], RED_CUP),
        (["take the can", "put it back", "take the red cup", "put it back in its place"], RED_CUP),
    ],
)
def test_back_is_where_it_was_taken_from_wherever_that_was(said, meant):
    (place,) = heard(*said).commands

    assert (place.object, place.on, place.to) == (meant, None, WHERE_IT_WAS)


def test_back_is_a_place_that_was_named_where_one_was():
    (place,) = heard("take the red cup from the counter", "put it back").commands

    assert (place.on, place.to) == ("counter", None)


@pytest.mark.parametrize("said", ["put it back", "put the cup back where it was", "take it and put it back"])
def test_back_alone_is_asked(said):
    assert heard(said).question is not None


def test_what_leans_on_a_sentence_may_be_leant_on():
    (hand_over,) = heard("take the red cup", "put it on the table", "give it to Ana").commands

    assert isinstance(hand_over, HandOverTask)
    assert (hand_over.object, hand_over.to) == (RED_CUP, "Ana")


def test_references_inside_a_leaning_sentence_still_count_from_its_first_command():
    pick, _, place = heard("look at the red cup", "take it, wave to Ana and put it on the table").commands

    assert isinstance(pick, PickTask)
    assert pick.object == place.object == RED_CUP


@pytest.mark.requirement("L2")
def test_what_was_the_left_one_is_meant_though_it_is_the_left_one_no_more():
    (place,) = heard("take the left cup", "wave to Ana", "put it on the table").commands

    assert place.object == PREVIOUS


@pytest.mark.requirement("L3")
@pytest.mark.parametrize(
    "said",
    [
        ["look at the left cup", "put it on the table"],
        ["take the left cup", "put the red cup next to it"],
        ["put it on the table"],
        ["wave to Ana", "put it on the table"],
        ["take both cups", "put it on the table"],
        ["do a backflip", "put it on the table"],
        ['[{"say": "take the red cup", "confidence": 1.0}]', "put it on the table"],
        ["take the red cup", "wave", "wave to Ana", "go home", "wave to Ben", "put it on the table"],
    ],
)
def test_what_nothing_makes_clear_stays_a_question(said):
    assert heard(*said).question.text == "what does 'it' stand for?"


@pytest.mark.requirement("L3")
def test_nothing_is_put_onto_what_is_in_the_hand():
    assert heard("pick up the cup", "put the can on the left one").question is not None
    assert heard("find the box", "put the can on the left one").commands


@pytest.mark.requirement("L2")
def test_the_thing_that_was_moved_last_is_the_one_that_is_moved_again(fake_stage):
    requests = fake_stage(cup("a", "red", (0.45, 0.2)), cup("b", "blue", (0.45, -0.2))).requests

    taken = requests.submit("take the left cup").result()
    put = requests.submit("put it on the table").result()

    assert taken[-1].acted_on == put[-1].evidence["object"] == "red cup"
    assert put[-1].outcome == "done"


@pytest.mark.requirement("L2")
@pytest.mark.parametrize(
    "said",
    [
        ["open the top drawer", "close it"],
        ["pick up the left cup", "open the top drawer", "close it again"],
        ["open the top drawer", "put the can in it", "close it"],
    ],
)
def test_a_drawer_that_was_opened_stays_the_top_one(said):
    (close,) = heard(*said).commands

    assert isinstance(close, CloseTask)
    assert close.object == ObjectDescription("drawer", ordinal="top")


@pytest.mark.requirement("L2")
@pytest.mark.parametrize(
    ("said", "meant"),
    [
        (["how many cups are there?", "pick up the left one"], ObjectDescription("cup", ordinal="leftmost")),
        (
            ["take the red cup", "put it down", "take the other one"],
            ObjectDescription("cup", ordinal="other"),
        ),
        (["take the red cup", "take one bottle"], ObjectDescription("bottle")),
        (["wave to Ana", "pick up the left one"], ObjectDescription(ordinal="leftmost")),
        (["what is on the table?", "pick up the red one"], ObjectDescription(color="red")),
    ],
)
def test_one_is_of_the_kind_that_was_spoken_of_before(said, meant):
    (pick,) = heard(*said).commands

    assert isinstance(pick, PickTask)
    assert pick.object == meant


@pytest.mark.parametrize(
    "said",
    [
        "the blue one",
        "don't touch the blue one",
        "if there is a blue one take it",
        "throw the blue one at Ana",
    ],
)
def test_what_is_refused_by_itself_stays_refused(said):
    assert heard("take the red cup", said).refusal is not None


def test_what_stands_for_itself_is_read_by_itself():
    (pick,) = heard("take the red cup", "take the blue cup").commands

    assert pick.object == ObjectDescription("cup", "blue")


@pytest.mark.requirement("U1")
def test_a_script_goes_on_about_the_same_thing(tmp_path):
    script = tmp_path / "script.toml"
    script.write_text(
        '[[task]]\nsay = "take the red cup"\n[[task]]\nsay = "put it on the table"\n'
        '[[task]]\nsay = "put it down"\nexpect = "question"\n'
    )

    _, put, asked = load_script(script).statements

    assert put.parsed.commands[0].object == RED_CUP
    assert asked.parsed.question is not None


@pytest.mark.requirement("L2")
@pytest.mark.parametrize(
    "then", ["bring it to me", "bring them to me", "pick up the first one", "put it down"]
)
def test_of_several_that_were_found_none_is_chosen(then):
    parsed = heard("find the cups", then)

    assert parsed.commands == ()
    assert parsed.question is not None


def test_of_several_that_were_found_one_may_be_told_by_its_colour():
    (pick,) = heard("find the cups", "pick up the red one").commands

    assert pick.object == RED_CUP
