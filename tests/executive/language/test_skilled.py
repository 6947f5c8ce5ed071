"""Skills of which the grammar knows only the words, from a file of a user or of a package."""

from dataclasses import dataclass

import pytest

from executive.meaning import command_json
from executive.understanding.command_parser import parse
from trees import registry
from trees.skill import Skill
from trees.skills import built_in
from trees.tasks import Destination

WORDS = """
[vocabulary.SKILL]
words.bow = ["bow", "take a bow"]
words.levitate = ["levitate"]
[vocabulary.SKILL_AT]
words.bow = ["bow to"]
words.usher = ["usher"]
"""


@dataclass(frozen=True, slots=True)
class BowTask:
    text: str
    person: Destination | None = None

    action = "bow"


@dataclass(frozen=True, slots=True)
class UsherTask:
    text: str
    person: Destination | None = None
    to: Destination | None = None

    action = "usher"


@pytest.fixture
def told(monkeypatch, tmp_path):
    """What a sentence means to a robot that can bow and usher."""
    (tmp_path / "words.toml").write_text(WORDS)
    more = {kind.action: Skill(task=kind, tree=None, example="bow") for kind in (BowTask, UsherTask)}
    known = {**built_in(), **more}
    monkeypatch.setattr(registry, "built_in", lambda: known)
    return lambda text: parse(text, tmp_path / "words.toml")


def tasks(parsed):
    return [command_json(command) for command in parsed.commands]


@pytest.mark.parametrize("text", ["bow", "take a bow", "please bow", "could you take a bow?"])
def test_a_skill_is_named_alone(told, text):
    assert tasks(told(text)) == [{"action": "bow"}]


def test_it_stands_among_other_commands(told):
    assert tasks(told("before bowing, go home")) == [{"action": "go_home"}, {"action": "bow"}]


def test_whom_it_is_said_of_is_its_person(told):
    assert tasks(told("bow to me")) == [{"action": "bow", "person": "me"}]
    assert tasks(told("find Ana and bow to her"))[1] == {"action": "bow", "person": "Ana"}


def test_where_to_is_its_place(told):
    assert tasks(told("usher Ana to the kitchen")) == [{"action": "usher", "person": "Ana", "to": "kitchen"}]


def test_what_its_task_has_no_slot_for_is_refused(told):
    assert told("bow to the table").refusal.message == "'bow to' is not done to 'table'"


def test_words_of_a_skill_that_is_not_there_are_refused(told):
    assert told("levitate").refusal.message == "'levitate': 'levitate' is no skill of this robot"
