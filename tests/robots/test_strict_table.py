"""Tables of files as models: what is read, and in which words it is refused."""

from dataclasses import dataclass
from typing import Annotated, Literal

import pytest
from pydantic import Field, FiniteFloat

from robots.strict_table import AsTable, Pair, StrictTable, Text, read_table


@dataclass(frozen=True, slots=True)
class Spot:
    name: str
    at_m: tuple[float, float]
    yaw_rad: float


@dataclass(frozen=True, slots=True)
class Speed:
    most_m_s: float = 1.0


class Ball(StrictTable):
    kind: Literal["ball"]
    radius_m: FiniteFloat


class Box(StrictTable):
    kind: Literal["box"]
    size_m: Pair


class File(StrictTable):
    title: Text
    spot: Annotated[Spot, AsTable(yaw_rad=0.0)]
    both: Annotated[tuple[Spot, Speed], AsTable()] | None = None
    thing: list[Annotated[Ball | Box, Field(discriminator="kind")]] = Field(default_factory=list)


SPOT = {"name": "door", "at_m": [1, 2.5]}


def read(**changes):
    return read_table(
        File, {"title": "a", "spot": SPOT, **changes}, lambda key, reason: ValueError(key, reason)
    )


def test_a_table_is_read_into_the_dataclass_that_it_stands_for():
    assert read().spot == Spot("door", (1.0, 2.5), 0.0)


def test_one_table_holds_the_fields_of_several_dataclasses():
    both = read(both={**SPOT, "yaw_rad": 0.5, "most_m_s": 2}).both

    assert both == (Spot("door", (1.0, 2.5), 0.5), Speed(2.0))


@pytest.mark.parametrize(
    ("changes", "key", "reason"),
    [
        ({"tittle": "a"}, "tittle", "unknown key; the nearest is 'title', all: title, spot, both, thing"),
        ({"spot": {**SPOT, "at_m": [1]}}, "spot.at_m", "must be a list of 2 numbers, not [1]"),
        ({"spot": {**SPOT, "at_m": [1, True]}}, "spot.at_m[1]", "must be a number, not True"),
        ({"spot": {**SPOT, "name": " "}}, "spot.name", "must be a text in quotes, not ' '"),
        ({"spot": {**SPOT, "yaw": 1.0}}, "spot.yaw",
         "unknown key; the nearest is 'yaw_rad', all: name, at_m, yaw_rad"),
        ({"spot": 3}, "spot", "must be a table"),
        ({"thing": {}}, "thing", "must be a list of tables: write [[thing]]"),
        ({"thing": [{"kind": "ball"}]}, "thing[0].radius_m", "is missing"),
        ({"thing": [{"kind": "bal"}]}, "thing[0].kind",
         "unknown kind 'bal'; the nearest is 'ball', all: ball, box"),
        ({"thing": [{"radius_m": 1.0}]}, "thing[0].kind", "is missing"),
        ({"thing": [{"kind": "ball", "radius_m": float("inf")}]}, "thing[0].radius_m",
         "must be finite, not inf"),
    ],
)  # fmt: skip
def test_the_first_thing_that_is_wrong_is_told_with_its_key_and_what_was_expected(changes, key, reason):
    with pytest.raises(ValueError) as refused:
        read(**changes)

    assert refused.value.args == (key, reason)


def test_a_misspelled_key_is_told_before_the_one_that_it_stands_for_is_missing():
    with pytest.raises(ValueError) as refused:
        read(spot={"nam": "door", "at_m": [1, 2]})

    assert refused.value.args[0] == "spot.nam"
