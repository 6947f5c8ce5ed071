"""What takes back, orders or qualifies a command is honoured, asked about or refused: never passed over."""

import pytest

from executive.understanding.command_parser import parse

pytestmark = pytest.mark.requirement("L2", "L5")


@pytest.mark.parametrize(
    ("sentence", "word"),
    [
        ("pick up the cup, never mind", "never mind"),
        ("pick up the cup, abort", "abort"),
        ("open the drawer, actually close it", "actually"),
        ("pick up the cup, er, the bottle", "er"),
        ("walk to the table, hmm, to the counter", "hmm"),
        ("pick up the red cup, sorry, put down the blue cup", "sorry"),
        ("run to the kitchen", "run"),
        ("whisper hello to Ana", "whisper"),
        ("walk to the table real quick", "real quick"),
        ("throw the ball into the box", "throw"),
        ("throw the cup at Ana", "throw"),
        ("wave to Ana on the table", "Ana"),
        ("go under the table", "under"),
        ("walk into the table", "into"),
        ("fetch me his jacket", "his"),
        ("bring me the two cups on the left", "leftmost"),
        ("hand the knife to the child", "knife"),
        ("move_forwards", "move_forwards"),
    ],
)
def test_words_that_cannot_be_honoured_are_named_in_the_refusal(sentence, word):
    parsed = parse(sentence)

    assert parsed.commands == ()
    assert word in parsed.refusal.word


@pytest.mark.parametrize(
    "sentence",
    [
        "pick up the red cup, the blue one",
        "put the cup in the box and put it on the shelf",
        "say pick up the cup and open the fridge",
        "go back",
    ],
)
def test_what_can_be_meant_in_two_ways_is_asked(sentence):
    assert parse(sentence).question is not None


@pytest.mark.parametrize(
    "sentence",
    [
        "pick up the cup, first open the fridge",
        "pick up the cup and hold it up",
        "look under the table for the ball twice",
        "pick up the cup by yourself",
        "can you reach the cup",
        "give Ben her cup",
    ],
)
def test_no_task_comes_of_a_sentence_with_a_word_to_spare(sentence):
    assert parse(sentence).commands == ()


@pytest.mark.parametrize(
    ("sentence", "plain"),
    [
        ("actually, pick up the cup", "pick up the cup"),
        ("umm, pick up the, uh, red cup", "pick up the red cup"),
        ("first pick up the cup, then wave", "pick up the cup, then wave"),
        ("the red cup, pick it up", "pick up the red cup"),
        ("gimme the cup", "give me the cup"),
        ("never mind", "stop"),
        ("say 'pick up the cup'", 'say "pick up the cup"'),
        ("take the can with your left hand and the cup with your right", None),
    ],
)
def test_what_changes_nothing_is_passed_over(sentence, plain):
    tasks = parse(sentence).to_json()["tasks"]

    assert tasks
    if plain is not None:
        assert tasks == parse(plain).to_json()["tasks"]


def test_there_is_the_place_that_was_named():
    tasks = parse("walk to the table and pick up the cup there").to_json()["tasks"]

    assert tasks[1] == {"action": "pick", "object": {"kind": "cup"}, "from": "table"}


@pytest.mark.parametrize(
    "sentence",
    [
        "say hello before going home",
        "say hello in the kitchen",
        "say thank you to Ana for the cup",
        "say hi and jump",
        "tell Ana that dinner is ready and open the door quickly",
        "speak louder",
        "say the magic word",
        "greet Ana and say her name",
        "say thanks to Ana: hello",
    ],
)
def test_free_words_to_say_hold_nothing_that_may_be_meant_otherwise(sentence):
    assert parse(sentence).commands == ()


@pytest.mark.parametrize(
    ("sentence", "words"),
    [
        ("say hello", "hello"),
        ("say thank you to Ana", "thank you"),
        ("say happy birthday, Ana", "happy birthday, Ana"),
        ("tell Ana the cup is on the table", "the cup is on the table"),
        ('say "hello before going home"', "hello before going home"),
    ],
)
def test_greetings_statements_and_quotations_are_said(sentence, words):
    (command,) = parse(sentence).commands

    assert command.words == words


@pytest.mark.parametrize(
    "sentence",
    [
        "pick up the wooden robot",
        "pick up the cup on my left",
        "find the tables",
        "describe the boxes",
        "bring me the red cup and bottle",
        "bring the cup next to Ana",
        "go to the kitchen and tell me how many cups are there",
        "I need to go to the bathroom",
        "before I go home, open the door",
        "go ahead",
        "go back to where you were",
        "pick up the biggest cups",
        "put the fork to the left and the knife to the right of the plate",
        "bring me the cup and put it on the table",
        "how many different cups are on the table",
    ],
)
def test_number_side_speaker_and_place_are_never_passed_over(sentence):
    assert parse(sentence).commands == ()


def test_a_place_beside_a_person_is_no_hand_over():
    tasks = parse("take the cup and bring it to behind Ana").to_json()["tasks"]

    assert [task["action"] for task in tasks] == ["pick", "place"]


@pytest.mark.parametrize(
    ("sentence", "manners"),
    [
        ("gently put the cup on the table", ("gently",)),
        ("very carefully, pick up the cup", ("very carefully",)),
        ("pick up the cup carefully and put it gently on the table", ("carefully", "gently")),
        ("pick up the cup", ()),
        ('say "drive carefully"', ()),
    ],
)
def test_manners_that_change_nothing_are_noted_to_be_told(sentence, manners):
    parsed = parse(sentence)

    assert parsed.commands
    assert parsed.manners == manners


@pytest.mark.parametrize(
    "sentence", ["wave to the man in the jacket", "find the person in the hat", "go to bed"]
)
def test_what_is_no_place_is_none(sentence):
    assert parse(sentence).commands == ()


def test_the_same_thing_is_picked_up_twice_only_when_it_is_asked_about():
    assert parse("pick up the cup. pick up the cup.").outcome == "question"
    twice = parse("pick up the cup and take the cup to Ana").to_json()
    assert twice["tasks"] == parse("take the cup to Ana").to_json()["tasks"]


@pytest.mark.parametrize(
    ("sentence", "told"),
    [
        ("put the cup on", "after 'on' something is missing"),
        ("go to Olivia and pick her up", "a person is nothing"),
    ],
)
def test_a_refusal_tells_what_is_missing_from_what_does_not_go_together(sentence, told):
    assert told in str(parse(sentence).refusal)
