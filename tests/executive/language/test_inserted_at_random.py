"""Words put at random places into known sentences: none that says something is passed over."""

import random

import pytest

from executive.meaning import command_json
from executive.understanding.command_parser import parse

SENTENCES = (
    "pick up the red cup on the table",
    "pick up the blue box with the left hand",
    "put the red cup on the shelf",
    "put the ball in the box",
    "bring me the bottle",
    "bring Ana the blue can from the counter",
    "hand the cup to Ana",
    "open the fridge, then close the drawer",
    "walk to Ana and wave",
    "point at the bottle",
    "look at the cup",
    "find the red cup",
    "count the cups on the table",
    "what is on the table",
    "wait 5 seconds",
    "go home",
    "take the cup and put it on the shelf",
    "pick up both cups",
    "give me the leftmost bottle",
    "take all the cups from the shelf",
    "move forward 1 meter",
)
_WORDS = """
not never no nobody nothing nowhere except without unless hardly almost barely instead otherwise else if
when whenever while until because since although whether before after once twice thrice later
tomorrow yesterday tonight soon always usually sometimes often ever yet slowly quickly quietly halfway
sideways upside together apart aside around diagonally backwards forward straight maybe perhaps probably
possibly might could should would may was were did had been has having myself yourself himself everyone
most some several few half other different same next last previous second third fourth bigger
smaller biggest heavy heaviest light full empty clean dirty hot cold old broken her his their mine yours
Ana's dark bright striped wooden plastic green tall two three ten twenty dozen percent between above
through past along against under behind or nor but versus minus per rather besides like unlike
than more less who whom whose which why how what where pretend imagine suppose refuse avoid forget stop
cancel throw drop pour push wash kick break simulate undo repeat bottle hand head robot's cat dog
door window
"""
MEANINGFUL = tuple(_WORDS.split())
HOW_MANY = 1200


@pytest.mark.requirement("L5")
@pytest.mark.parametrize("seed", [1, 2])
def test_a_word_that_says_something_changes_the_tasks_or_stops_them(seed):
    drawn = random.Random(seed)
    meant = {sentence: parse(sentence).commands for sentence in SENTENCES}
    passed_over = []

    for _ in range(HOW_MANY // 2):
        sentence, word = drawn.choice(SENTENCES), drawn.choice(MEANINGFUL)
        pieces = sentence.split()
        inserted = drawn.choice([word, word, f", {word}, ", f"{word},"])
        pieces.insert(drawn.randrange(len(pieces) + 1), inserted)
        said = " ".join(pieces).replace(" ,", ",").lstrip(", ")
        if _done(parse(said).commands) == _done(meant[sentence]):
            passed_over.append(said)

    assert [said for said in passed_over if not _changes_nothing(said)] == []


def _done(commands):
    """What is done, without how it was said."""
    return [command_json(command) for command in commands]


def _changes_nothing(said):
    """Words of order between two commands or before one, a side said twice, "straight to", "what else"."""
    before = (
        "next",
        "second",
        "third",
        "fourth",
        "leftmost left",
        "straight",
        "take along all",
        "through to",
        "what else",
        "at once",
    )
    return any(one in said for one in before)
