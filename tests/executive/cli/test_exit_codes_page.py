"""The page of the exit codes has every code."""

from pathlib import Path

import pytest

from executive.exit_codes import ExitCode

PAGE = (Path(__file__).parents[3] / "docs" / "start" / "exit-codes.md").read_text("utf-8")


@pytest.mark.parametrize("code", ExitCode)
def test_the_page_has_the_code_with_its_name(code):
    assert f"| {code.value} | {code.name} | " in PAGE
