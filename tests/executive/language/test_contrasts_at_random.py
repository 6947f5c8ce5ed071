"""Contrasts drawn at random: what is meant is done where what is not meant is another thing, else nothing."""

import random

import pytest

from executive.understanding.command_parser import parse

KINDS = ("cup", "bowl", "ball", "bottle", "book")
COLORS = (None, None, "red", "blue", "green")
SIZES = (None, None, None, "small", "big")
VERBS = ("pick up", "bring me", "look at", "find", "hand me", "point at")
TEMPLATES = (
    *("{v} {w}, not {e}", "{v} {w} and not {e}", "{v} {w} but not {e}", "{v} {w} instead of {e}"),
    *("{v} {w} rather than {e}", "instead of {e}, {v} {w}", "not {e}, {v} {w}", "rather than {e} {v} {w}"),
    *("forget {e}, {v} {w}", "please {v} {w}, not {e}, thanks"),
)


def drawn(rng, kinds):
    return rng.choice(SIZES), rng.choice(COLORS), rng.choice(kinds)


def wording(thing):
    return " ".join(("the", *(word for word in thing if word)))


def are_apart(meant, not_meant):
    """Whether both say something that cannot hold of one thing."""
    kinds = meant[2], not_meant[2]
    if "one" not in kinds and kinds[0] != kinds[1]:
        return True
    return any(one and other and one != other for one, other in zip(meant[:2], not_meant[:2], strict=True))


@pytest.mark.requirement("L2", "L5")
def test_a_contrast_is_what_is_meant_or_nothing():
    rng = random.Random(20261125)
    done = expected = 0

    for _ in range(600):
        meant, not_meant = drawn(rng, KINDS), drawn(rng, (*KINDS, "one"))
        template, verb = rng.choice(TEMPLATES), rng.choice(VERBS)
        said = template.format(v=verb, w=wording(meant), e=wording(not_meant))
        tasks = parse(said).to_json()["tasks"]
        alone = parse(f"{verb} {wording(meant)}").to_json()["tasks"]

        apart = are_apart(meant, not_meant)
        assert tasks in ([], alone), said
        assert apart or tasks == [], said
        done += bool(tasks)
        expected += apart

    assert done > 0.95 * expected


@pytest.mark.requirement("L2", "L5")
def test_what_is_shared_out_is_another_one_for_each():
    rng = random.Random(20261126)
    for _ in range(200):
        first, second = rng.sample(("Ana", "Ben", "Maria", "me"), 2)
        kind = rng.choice(KINDS)
        said = rng.choice(
            (
                f"give {first} and {second} a {kind} each",
                f"bring {first} and {second} a {kind} each",
                f"get two {kind}s, one for {first} and one for {second}",
                f"bring a {kind} to {first} and another to {second}",
                f"give a {kind} to {first} and one to {second}",
                f"bring {first} a {kind} and {second} another",
            )
        )
        tasks = parse(said).to_json()["tasks"]
        got = [one["to"] for one in tasks if one["action"] == "hand_over"]
        things = [one["object"] for one in tasks if "ref" not in one["object"]]

        assert got == [first, second], said
        assert things == [{"kind": kind}, {"kind": kind, "ordinal": "other"}], said
