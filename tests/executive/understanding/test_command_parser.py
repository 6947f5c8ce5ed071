"""Sentences become one meaning, a question, or a refusal that helps."""

import json
import string

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from executive.meaning import wording
from executive.understanding.command_parser import examples, parse
from executive.vocabulary import load_vocabulary
from executive.vocabulary.inflection import forms

RED_CUP = {"action": "pick", "object": {"kind": "cup", "color": "red"}}
FROM_TABLE = {**RED_CUP, "from": "table"}
LEFT_HAND = {**RED_CUP, "hand": "left"}
CUP = {"action": "pick", "object": {"kind": "cup"}}
HOME = {"action": "go_home"}
STOP = {"action": "stop"}


def picks(kind=None, color=None, **slots):
    described = {"kind": kind, "color": color}
    return {"action": "pick", "object": {key: value for key, value in described.items() if value}, **slots}


UNDERSTOOD = [
    ("pick up the red cup on the table", [FROM_TABLE]),
    ("Pick up the red cup on the table.", [FROM_TABLE]),
    ("pick up red cup", [RED_CUP]),
    ("grab the red mug", [RED_CUP]),
    ("pick the red cup up", [RED_CUP]),
    ("pick the red cup up from the table", [FROM_TABLE]),
    ("pick the red cup from the table up", [FROM_TABLE]),
    ("take the red cup from the table", [FROM_TABLE]),
    ("take the red cup off the table", [FROM_TABLE]),
    ("get the red cup from the tabletop", [FROM_TABLE]),
    ("lift the red cup off of the table", [FROM_TABLE]),
    ("lift up the red cup", [RED_CUP]),
    ("fetch the red cup", [RED_CUP]),
    ("grasp the red cup", [RED_CUP]),
    ("grab hold of the red cup", [RED_CUP]),
    ("take hold of that red teacup", [RED_CUP]),
    ("collect the red coffee mug from the table", [FROM_TABLE]),
    ("from the table pick up the red cup", [FROM_TABLE]),
    ("pick up the red cup that is on the table", [FROM_TABLE]),
    ("pick up the red cup which is standing on the table", [FROM_TABLE]),
    ("pick up the red cup standing on the table", [FROM_TABLE]),
    ("pick up the cup that is red", [RED_CUP]),
    ("pick up the cup that's red from the table", [FROM_TABLE]),
    ("pick up the red coloured cup", [RED_CUP]),
    ("pick up the red-colored cup", [RED_CUP]),
    ("please pick up the red cup", [RED_CUP]),
    ("Could you please pick up the red cup for me?", [RED_CUP]),
    ("would you mind picking up the red cup", [RED_CUP]),
    ("I want you to pick up the red cup", [RED_CUP]),
    ("I'd like you to grab the red cup, please", [RED_CUP]),
    ("I\u2019d like you to grab the red cup", [RED_CUP]),
    ("Robot, pick up the red cup!", [RED_CUP]),
    ("hey robot, could you grab the red mug now?", [RED_CUP]),
    ("OK, now pick up the red cup, thanks", [RED_CUP]),
    ("PICK UP THE RED CUP", [RED_CUP]),
    ("  pick   up\tthe red\ncup ", [RED_CUP]),
    ("pick up the scarlet mug", [RED_CUP]),
    ("pick up the red cup with your left hand", [LEFT_HAND]),
    ("pick up the red cup using the left arm", [LEFT_HAND]),
    ("use your left hand to pick up the red cup", [LEFT_HAND]),
    ("use the left hand and pick up the red cup", [LEFT_HAND]),
    ("take the red cup from the table with the left hand", [{**FROM_TABLE, "hand": "left"}]),
    ("take the red cup with the left hand from the table", [{**FROM_TABLE, "hand": "left"}]),
    ("pick up the cup", [CUP]),
    ("pick up a cup", [CUP]),
    ("can you pick up the can", [picks("can")]),
    ("pick up the soda", [picks("can")]),
    ("pick up the orange ball", [picks("ball", "orange")]),
    ("pick up the grey block", [picks("box", "gray")]),
    ("get the green bottle", [picks("bottle", "green")]),
    ("take the white bowl from the table", [picks("bowl", "white", **{"from": "table"})]),
    ("pick up the red thing", [picks(None, "red")]),
    ("pick up the red one", [picks(None, "red")]),
    ("go home", [HOME]),
    ("please go back home", [HOME]),
    ("return to your home position", [HOME]),
    ("move to the home posture", [HOME]),
    ("stop", [STOP]),
    ("Stop!", [STOP]),
    ("halt", [STOP]),
    ("stop right now", [STOP]),
    ("don't move", [STOP]),
    ("pick up the red cup and go home", [RED_CUP, HOME]),
    ("pick up the red cup, then go home.", [RED_CUP, HOME]),
    ("Pick up the red cup. Go home.", [RED_CUP, HOME]),
]

REFUSED = [
    # sentence, the offending word
    ("pick up the zorbl", "zorbl"),
    ("zorbl the red cup", "zorbl"),
    ("pikc up the red cup", "pikc"),
    ("pick up the red cpu", "cpu"),
    ("hebe die rote tasse auf", "hebe"),
    ("rm -rf /", "rm"),
    ("pick up the red", "red"),
    ("pick up the red blue cup", "blue"),
    ("pick up the red cup with the left hand with the right hand", "right"),
    ("pick up the person", "person"),
    ("pick up the table", "table"),
    ("don't pick up the red cup", "don't"),
    ("pick up the red cup without touching it", "without"),
    ("if the cup is red pick it up", "if"),
    ("pick up the red cup slowly", "slowly"),
    ("move forward at 0.6 m/s", "0.6 m/s"),
    ("kill the cat", "kill"),
]

NO_SKILL = [
    ("watch me", "following"),
    ("clean the table", "housework"),
    ("jump", "whole body"),
    ("tell me a joke", "conversation"),
]

MALFORMED = [
    ("", "empty"),
    ("   \t ", "empty"),
    ("?!", "nothing to do"),
    ("pick up the red cup\x00", "U+0000"),
    ("pick up the \x1b[31mred\x1b[0m cup", "U+001B"),
    ("pick up the \u202ered cup", "U+202E"),
    ("pick up the r\u200bed cup", "U+200B"),
    ("pick up the \udce9 cup", "U+DCE9"),
    ("pick up the red cup " * 60_000, "at most"),
    ("a " * 200, "at most"),
    ('{"command": "pick up the red cup"}', "{"),
    ("pick up the <b>red</b> cup", "<"),
    ("../../etc/passwd", "not"),
]


@pytest.mark.requirement("L1")
@pytest.mark.parametrize(("text", "tasks"), UNDERSTOOD)
def test_everyday_phrasings_mean_the_same_task(text, tasks):
    answer = parse(text).to_json()

    assert answer["refusal"] is None
    assert answer["tasks"] == tasks


@pytest.mark.requirement("L5")
@pytest.mark.parametrize(("text", "word"), REFUSED)
def test_what_cannot_be_honoured_is_refused_with_the_word_that_caused_it(text, word):
    parsed = parse(text)

    assert parsed.commands == ()
    assert parsed.refusal is not None
    assert parsed.refusal.word == word
    assert word in parsed.refusal.message


@pytest.mark.requirement("L5")
@pytest.mark.parametrize(("text", "activity"), NO_SKILL)
def test_what_is_understood_but_no_skill_is_said_so(text, activity):
    refusal = parse(text).refusal

    assert refusal is not None
    assert "no skill of this robot yet" in refusal.message
    assert activity in refusal.message


@pytest.mark.requirement("L5")
@pytest.mark.parametrize(("text", "reason"), MALFORMED)
def test_what_is_no_sentence_is_refused_with_the_reason(text, reason):
    parsed = parse(text)

    assert parsed.outcome == "refused"
    assert reason in parsed.refusal.message


@pytest.mark.requirement("L5")
@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("pikc up the red cup", "pick"),
        ("pick up the red cup on the tabel", "table"),
    ],
)
def test_a_typing_error_gets_the_word_that_was_meant_and_no_task(text, meant):
    parsed = parse(text)

    assert parsed.commands == ()
    assert f"did you mean {meant!r}?" in parsed.refusal.message


@pytest.mark.parametrize("text", ["pick up something", "grab the thing", "take that one"])
def test_an_unnamed_object_is_asked_for(text):
    parsed = parse(text)

    assert parsed.outcome == "question"
    assert parsed.commands == ()


@pytest.mark.parametrize("text", examples())
def test_the_wordings_that_are_offered_are_valid(text):
    assert parse(text).outcome == "tasks"


@pytest.mark.parametrize("text", [text for text, _ in UNDERSTOOD])
def test_the_plain_wording_of_a_command_means_the_command(text):
    for command in parse(text).commands:
        again = parse(wording(command)).commands
        assert [wording(one) for one in again] == [wording(command)]


def test_each_task_carries_the_words_it_came_from():
    first, second = parse("Pick up the red cup, then go home").commands

    assert (first.text, second.text) == ("Pick up the red cup", "go home")


def test_the_answer_is_plain_json_whatever_was_said():
    for text in ("pick up the \udce9 cup", "x" * 1_000_000, "pick up the red cup"):
        document = json.dumps(parse(text).to_json())
        assert len(document) < 3000


WORDS = sorted(load_vocabulary().single_words)


@pytest.mark.requirement("L5", "F2")
@given(st.text(max_size=600))
def test_no_text_raises(text):
    assert parse(text).outcome in ("tasks", "question", "refused")


@given(st.lists(st.sampled_from([*WORDS, ",", ".", "-", "'", "7", "zorbl"]), max_size=12).map(" ".join))
def test_no_salad_of_known_words_raises_and_none_is_half_understood(text):
    parsed = parse(text)

    assert parsed.outcome in ("tasks", "question", "refused")
    assert (parsed.outcome == "tasks") == bool(parsed.commands)


@given(
    st.text(alphabet=string.ascii_lowercase, min_size=1, max_size=8).filter(lambda word: word not in WORDS)
)
@example("theres")
def test_a_word_that_is_in_no_list_is_never_passed_over(word):
    parsed = parse(f"pick up the {word} red cup")

    assert parsed.outcome == "refused"
    assert parsed.refusal.word == forms("typed").get(word, word)


@given(st.integers(0, 40), st.sampled_from(string.printable))
def test_a_changed_character_gives_the_same_task_or_a_refusal_or_another_valid_sentence(position, character):
    text = "pick up the red cup on the table"
    position %= len(text)

    parsed = parse(text[:position] + character + text[position + 1 :])

    for command in parsed.commands:
        assert parse(wording(command)).outcome in ("tasks", "question")
