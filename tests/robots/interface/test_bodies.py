"""Bodies that are attached by an entry point."""

import sys
from importlib.metadata import EntryPoint

import pytest

from robots.clock import WallClock
from robots.interface import bodies
from robots.interface.bodies import BodyError, body_named
from robots.models.description import load_robot
from robots.unitree.body import attach


@pytest.fixture
def points(monkeypatch):
    found = [
        EntryPoint("unitree", "robots.unitree.body:attach", "humanoid_executive.bodies"),
        EntryPoint("broken", "no_such_package.body:attach", "humanoid_executive.bodies"),
    ]
    monkeypatch.setattr(bodies.importlib.metadata, "entry_points", lambda group: found)


def test_a_body_is_found_by_its_entry_point(points):
    assert body_named("unitree") is attach


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("unitre", "no body 'unitre'; the nearest is 'unitree'"),
        ("broken", "body 'broken': ModuleNotFoundError"),
    ],
)
def test_a_body_that_is_not_there_or_broken_is_named(points, name, says):
    with pytest.raises(BodyError, match=says):
        body_named(name)


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"interfce": "eth0"}, "unknown option 'interfce' of the body; the nearest is 'interface'"),
        ({"arms": "both"}, "arms: expected yes or no, not 'both'"),
        ({"domain": "300"}, "domain: expected a number from 0 to 232, not '300'"),
    ],
)
def test_an_option_that_is_wrong_is_named_before_anything_is_sent(options, says):
    with pytest.raises(BodyError, match=says):
        attach(load_robot("g1"), WallClock(), options)


def test_without_the_library_one_line_tells_what_to_install(monkeypatch):
    for name in [name for name in sys.modules if name.startswith(("cyclonedds", "robots.unitree.dds"))]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.delitem(sys.modules, "robots.unitree.messages", raising=False)
    monkeypatch.setitem(sys.modules, "cyclonedds", None)

    with pytest.raises(BodyError, match=r"takes cyclonedds: pip install 'humanoid-executive\[ros\]'$"):
        attach(load_robot("g1"), WallClock(), {})
