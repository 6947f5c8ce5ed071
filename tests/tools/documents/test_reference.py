"""Pages that are made from the code are what the code makes."""

import re
from dataclasses import dataclass
from pathlib import Path

import pytest

import trees.skills
from tools.documents.decisions_page import decisions_page
from tools.documents.markdown import attributes, summary, table
from tools.documents.reference import DOCS, PAGES
from tools.documents.rooms import FLOORS, layers, packages, says


@pytest.mark.parametrize("name", PAGES)
def test_the_page_is_what_its_program_makes(name):
    assert (DOCS / name).read_text("utf-8") == PAGES[name](), "run python -m tools.documents.reference"


def test_every_command_has_its_part():
    from executive.cli.app import app

    text = PAGES["reference/cli.md"]()

    assert all(f"\n## {command.name}\n" in text for command in app.registered_commands)


def test_every_event_has_its_fields():
    text = PAGES["reference/events.md"]()

    assert "### SetpointRefused" in text
    assert "| `value` | str | The answer's words, the reason of a cancel, what a person" in text


def test_every_number_of_the_policy_has_a_meaning():
    empty = [line for line in PAGES["reference/policy.md"]().splitlines() if line.endswith("|  |")]

    assert empty == []


def test_every_skill_with_settings_has_its_numbers_on_the_policy_s_page():
    text = PAGES["reference/policy.md"]()

    folders = sorted(file.parent.name for file in Path(trees.skills.__file__).parent.glob("*/settings.py"))
    assert re.findall(r"^### `trees/skills/(\w+)/settings.py`", text, re.MULTILINE) == folders
    assert "### `trees/skills/pick/settings.py`: `PickSettings`\n\nNumbers of picking up.\n" in text
    assert "| `hold_s` | 2 | How long the object must stay held after the lift before it counts. |" in text
    assert "**`inventory_gazes`**: The looks that together see everything" in text


def test_a_leaf_tells_its_promises_and_its_deadline():
    text = PAGES["reference/node-kinds.md"]()

    part = text.split("### CloseGripper\n")[1].split("### ")[0]
    assert "Before: " in part
    assert "After: " in part
    assert "Moves: gripper. Ends within 4 s." in part


def test_a_report_s_keys_have_their_place_and_what_they_hold():
    text = PAGES["reference/report.md"]()

    assert "| `safety` | Safety |" in text
    assert "| `checked_trajectories` | integer |" in text
    assert "| `left_out` | *optional*; array of LeftOut |" in text
    assert "| `failure` | Failure or null |" in text
    assert "| `outcome` | done, failed, refused, question, cancelled |" in text


@pytest.mark.parametrize("floor", FLOORS)
def test_every_room_says_what_it_is(floor):
    assert [name for name in packages(floor) if not says(f"{floor}.{name}")] == []


def test_rooms_are_in_the_order_of_their_contract():
    text = PAGES["understand/rooms.md"]()

    assert text.index("`trees.btcpp`") < text.index("`trees.leaves`") < text.index("`trees.beliefs`")
    assert layers("kinematics")[-1][0] == "errors"


@dataclass
class Thing:
    """What it is,
    in two lines.

    Attributes:
        one: The first,
            which goes on.
        two, three: Both.
    """

    one: int
    two: int
    three: int


def test_a_docstring_gives_its_summary_and_what_it_says_of_each_field():
    assert summary(Thing) == "What it is, in two lines."
    assert attributes(Thing) == {"one": "The first, which goes on.", "two": "Both.", "three": "Both."}


def test_a_bar_in_a_cell_does_not_end_it():
    assert table(("a",), [("x | y",)]) == "| a |\n| --- |\n| x \\| y |\n"


def test_decisions_come_with_number_title_and_status(tmp_path):
    (tmp_path / "0004-rules.md").write_text("# 4. Rules are tests\n\n## Status\nAccepted.\n")
    (tmp_path / "0013-chart.md").write_text("# ADR 0013: A chart\n\n**Status:** accepted\n\n## Context\n")

    text = decisions_page(tmp_path)

    assert "| 4 | [Rules are tests](0004-rules.md) | Accepted. |" in text
    assert "| 13 | [A chart](0013-chart.md) | Accepted |" in text


def test_a_decision_without_a_status_is_named(tmp_path):
    (tmp_path / "0004-rules.md").write_text("# 4. Rules are tests\n")

    with pytest.raises(ValueError, match=r"0004-rules\.md"):
        decisions_page(tmp_path)
