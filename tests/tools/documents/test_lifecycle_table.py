"""The documentation of the state machine is the state machine's table."""

from pathlib import Path

import pytest

from tools.documents.lifecycle_table import main, markdown, rendered

SAFETY = Path(__file__).parents[3] / "docs" / "understand" / "safety.md"


@pytest.mark.requirement("S5")
def test_the_document_shows_the_table_that_the_code_has():
    document = SAFETY.read_text("utf-8")

    assert rendered(document) == document, "run python -m tools.documents.lifecycle_table"


def test_the_tool_puts_the_table_between_the_marks(tmp_path):
    path = tmp_path / "page.md"
    path.write_text("a\n<!-- state machine: begin -->\nold\n<!-- state machine: end -->\nb\n")

    assert main([str(path)]) == 0

    assert markdown() in path.read_text()
    assert "old" not in path.read_text()
    assert path.read_text().startswith("a\n")
    assert path.read_text().endswith("\nb\n")


def test_a_document_without_marks_is_refused():
    with pytest.raises(ValueError, match="no <!-- state machine"):
        rendered("nothing")
