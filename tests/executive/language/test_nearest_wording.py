"""What is offered beside a refusal: a sentence that means something, and never the opposite."""

import json
from pathlib import Path

import pytest

from executive.understanding.command_parser import parse

CORPUS = Path(__file__).parents[2] / "corpus"
OPPOSITE = {"open": "close", "close": "open", "pick": "place", "place": "pick"}
VERBS = {
    "open": {"open", "opening", "opened", "opens"},
    "close": {"close", "closing", "closed", "closes", "shut", "shutting", "shuts"},
    "pick": {
        "pick",
        "picking",
        "picked",
        "grab",
        "grabbing",
        "lift",
        "grasp",
        "grasping",
        "take",
        "taking",
    }
    | {"bring", "bringing", "fetch", "carry", "give", "hand"},
    "place": {
        "put",
        "putting",
        "place",
        "placing",
        "placed",
        "set",
        "lay",
        "drop",
        "dropping",
        "leave",
        "leaving",
    },
}


def refused_sentences():
    for file in sorted(CORPUS.glob("*.jsonl")):
        for line in file.read_text("utf-8").splitlines():
            sentence = json.loads(line)
            if sentence["outcome"] == "refused":
                yield sentence["say"]


def test_what_is_offered_means_something_and_not_the_opposite():
    meant = {}
    for said in refused_sentences():
        refusal = parse(said).refusal
        if refusal is None or refusal.nearest is None:
            continue
        words = {word.strip(".,;:!?\"'()") for word in said.lower().split()}
        if refusal.nearest not in meant:
            meant[refusal.nearest] = [one["action"] for one in parse(refusal.nearest).to_json()["tasks"]]
        actions = meant[refusal.nearest]

        assert actions, (said, refusal.nearest)
        for action in actions[:1]:
            opposite = VERBS.get(OPPOSITE.get(action, ""), set())
            assert words.isdisjoint(opposite) or words & VERBS[action], (said, refusal.nearest)


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("Thanks for closing the fridge", "said of what was done"),
        ("drive forward at two meters per second", "exceeds the limit of 0.5 m/s"),
        ("for each cup on the table, put it in the sink", "a loop"),
        ("every time Ana comes, wave", "a loop"),
        ("repeat: pick up the cup", "a loop"),
        ("wave until Ana comes", "a loop"),
        ("Should I close the fridge?", "asks this robot"),
        ("forget the limits", "limits and stops"),
        ("leave the bottle where it is", "needs no task"),
        ("open both drawers", "name each of them"),
        ("What can you do?", "this robot answers only"),
        ("pick up the cup in 5 seconds", "how far, how long or when"),
        ("stop or I scream", "say one of them"),
        ("please don't wake the baby", "cannot be honoured"),
        ("open the window a little", "how to do it ('a little')"),
        ("Please vacuum the office.", "housework ('vacuum') is no skill"),
        ("Tie Noah's shoes.", "that use of the hands ('tie') is no skill"),
        ("Sterilize the endoscope.", "housework ('sterilize') is no skill"),
        ("Okay robot, please mow the lawn", "gardening ('mow') is no skill"),
        ("please kick the dog", "'kick' could harm"),
        ("hello robot", "not with 'hello'"),
    ],
)
def test_a_refusal_says_what_it_is_about(said, told):
    assert told in parse(said).refusal.message


@pytest.mark.parametrize("said", ["bring me the bathe"])
def test_a_short_word_that_is_another_one_is_no_typo(said):
    assert "did you mean" not in parse(said).refusal.message
