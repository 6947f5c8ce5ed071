"""Things picked up, put down and given away at random: nothing is done with what the hand cannot have."""

from __future__ import annotations

import itertools
import random

import pytest

from executive.understanding.command_parser import parse

SEED = 20261124
SENTENCES = 400
THINGS = ("the cup", "the cup and the bowl", "both cups", "the cups", "all the fruit", "a pen", "two forks")
PRONOUNS = ("it", "them", "both", "the cup", "the bowl", "the red one", "the other one")
DOING = (
    *("pick up {}", "take {} from the shelf", "get {}", "bring {}", "bring me {}", "take {} to Ana"),
    *("give {} to Tom", "hand {} to me", "put {} on the table", "put {} in the box", "put {} down"),
    *("throw {} away", "return {} to Ana", "move {} to the shelf", "carry {} to the kitchen"),
)
BETWEEN = ("wave to Ana", "go to the kitchen", "open the fridge", "wait five seconds", "look at the shelf")
PUTS_DOWN = ("place", "put_in", "hand_over")


def sentences():
    rng = random.Random(SEED)
    for _ in range(SENTENCES):
        clauses = [rng.choice(DOING).format(rng.choice(THINGS))]
        for _ in range(rng.randint(1, 3)):
            clauses += [rng.choice(BETWEEN)] if rng.random() < 0.2 else []
            clauses.append(rng.choice(DOING).format(rng.choice(PRONOUNS)))
        yield rng.choice((". ", ", ", ", then ", " and ")).join(clauses)


@pytest.fixture(scope="module")
def what_the_hands_do():
    """For each sentence that makes tasks: what is done, in order, to each thing."""
    return list(done_to_each())


def done_to_each():
    for text in sentences():
        tasks = parse(text).to_json()["tasks"]
        done: dict[int, list[str]] = {}
        for index, task in enumerate(tasks):
            if "object" in task:
                root = index
                while "ref" in tasks[root]["object"]:
                    root = tasks[root]["object"]["ref"]
                done.setdefault(root, []).append(task["action"])
        if tasks:
            yield text, done


def test_what_was_given_away_is_not_put_down_or_given_again(what_the_hands_do):
    for text, done in what_the_hands_do:
        for actions in done.values():
            for before, after in itertools.pairwise(actions):
                assert before != "hand_over" or after not in PUTS_DOWN, text


def test_what_is_in_the_hand_is_not_picked_up(what_the_hands_do):
    for text, done in what_the_hands_do:
        for actions in done.values():
            assert ("pick", "pick") not in itertools.pairwise(actions), text


def test_many_of_them_are_done(what_the_hands_do):
    assert len(what_the_hands_do) > SENTENCES / 8
