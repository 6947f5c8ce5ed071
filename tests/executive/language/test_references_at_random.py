"""Clauses joined at random, and "it", "her" and "there" after them: what was meant, or a question."""

from __future__ import annotations

import itertools
import random
from dataclasses import dataclass, field

from executive.understanding.command_parser import parse

SENTENCES = 1500
SEED = 20261123
PEOPLE = {"Tom": "him", "Ben": "him", "Ana": "her", "Maria": "her", "Robin": "", "Kim": ""}
THINGS = ("cup", "bottle", "plate", "apple", "book")
PLACES = ("table", "shelf", "counter", "kitchen", "bedroom", "fridge")
SEPARATORS = (". ", ", ", " and ", ", then ", "; ")


@dataclass
class Clause:
    """A clause and what it names: who, which things, which places; ``leads`` is where it goes."""

    text: str
    people: dict[str, str] = field(default_factory=dict)
    things: tuple[str, ...] = ()
    places: tuple[str, ...] = ()
    leads: str | None = None


def clause(rng: random.Random) -> Clause:
    name = rng.choice(sorted(PEOPLE))
    who = {name: PEOPLE[name]}
    thing, place, room = rng.choice(THINGS), rng.choice(PLACES[:3]), rng.choice(PLACES[3:5])
    return rng.choice(
        [
            Clause(f"take the {thing} from the {place}", {}, (thing,), (place,)),
            Clause(f"pick up the {thing}", {}, (thing,)),
            Clause(f"put the {thing} on the {place}", {}, (thing,), (place,)),
            Clause(f"give the {thing} to {name}", who, (thing,)),
            Clause(f"wave to {name}", who),
            Clause(f"find {name}", who),
            Clause(f"go to {name}", who, leads=name),
            Clause(f"go to the {room}", {}, (), (room,), room),
            Clause("open the fridge", {}, (), ("fridge",)),
            Clause("wait for five seconds"),
            Clause(f"look at the {thing}", {}, (thing,)),
            Clause(f"count the plates on the {place}", {}, ("plates",), (place,)),
            Clause(f"tell {name} that I am in the {room}", who),
            Clause(f"{name} is in the {room}", who, (), (room,)),
            Clause(f"{name} is really cold", who),
            Clause(f"open the door for {name}", who, (), ("door",)),
            Clause(f"take {name}'s {thing}", who, (thing,)),
            Clause(f"point at the man in the {room}", {"man": "him"}, (), (room,)),
            Clause(f"say hello to the woman on the {place}", {"woman": "her"}, (), (place,)),
        ]
    )


def sentences(last: str):
    rng = random.Random(SEED + len(last))
    for _ in range(SENTENCES // 5):
        clauses = [clause(rng) for _ in range(rng.randint(1, 3))]
        separator = rng.choice(SEPARATORS)
        text = separator.join([*(one.text for one in clauses), last])
        tasks = parse(text).to_json()["tasks"]
        if tasks:
            yield text, clauses, tasks


def object_of(tasks):
    described = tasks[-1]["object"]
    while "ref" in described:
        described = tasks[described["ref"]]["object"]
    return described["kind"]


def test_her_and_him_are_the_only_one_of_those_named():
    for pronoun, pattern in itertools.product(("him", "her"), ("wave to {}", "bring {} a towel")):
        for text, clauses, tasks in sentences(pattern.format(pronoun)):
            people = {name: said for one in clauses for name, said in one.people.items()}
            fitting = [name for name, said in people.items() if said in ("", pronoun)]
            who = tasks[-1].get("person") or tasks[-1]["to"]

            assert fitting == [who["kind"] if isinstance(who, dict) else who], text


def test_it_is_one_thing_of_the_latest_clause_that_names_any():
    for text, clauses, tasks in sentences("put it in the bin"):
        (named,) = next(one.things for one in reversed(clauses) if one.things)

        assert object_of(tasks) == named, text


def test_it_that_is_brought_is_no_other_than_what_is_held():
    for text, _, tasks in sentences("bring it to me"):
        before = tasks[:-1]
        held = {object_of(tasks[: index + 1]) for index, one in enumerate(before) if one["action"] == "pick"}
        put_down = any(one["action"] in ("place", "hand_over") for one in before)

        assert not held or put_down or object_of(tasks) in held, text


def test_there_is_where_it_goes_or_the_only_place():
    for last in ("go there", "put a fork there"):
        for text, clauses, tasks in sentences(last):
            places = {place for one in clauses for place in one.places}
            meant = {clauses[-1].leads} if clauses[-1].leads else places
            place = tasks[-1].get("to") or tasks[-1]["on"]

            assert meant == {place}, text


KINDS = ("cup", "book")


def test_one_of_several_that_were_named_is_asked_about():
    for kind, action in itertools.product(KINDS, ("take", "look at", "give Ana")):
        for one in ("the first one", "the last one", "the other one"):
            named = f"{action} the red {kind} and the blue {kind}"

            assert parse(f"{named}, then give {one} to Tom").question is not None, one


def test_it_is_nothing_that_was_named_in_the_plural():
    for named in ("count the cups on the table", "pick up both cups", "find two cups", "look at the cups"):
        for last in ("put it in the bin", "put the book next to it", "bring it to me"):
            assert parse(f"{named}. {last}").to_json()["tasks"] == [], (named, last)


def test_what_is_in_the_hand_is_not_fetched_again():
    for one in ("the blue one", "the other one", "another one", "a red one"):
        assert parse(f"pick up both cups, then bring me {one}").question is not None


def test_the_same_is_not_given_away_twice():
    assert parse("give Tom the red cup, then give Ana the red one").question is not None


def test_a_thing_of_which_something_is_stated_is_no_door():
    assert parse("the bottle is dirty, close it").to_json()["tasks"] == []
