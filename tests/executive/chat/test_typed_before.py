"""Lines that were typed before are kept for their user alone."""

import stat

import pytest

from executive.chat.typed_before import TypedBefore


def test_lines_come_back_in_their_order(tmp_path):
    TypedBefore(tmp_path / "chat" / "history").remember(["wave", "pick up the cup"])

    assert TypedBefore(tmp_path / "chat" / "history").lines() == ["wave", "pick up the cup"]


@pytest.mark.requirement("U1")
def test_nobody_else_may_read_them(tmp_path):
    TypedBefore(tmp_path / "history").remember(["wave"])

    assert stat.S_IMODE((tmp_path / "history").stat().st_mode) == 0o600


def test_a_place_that_cannot_be_written_forgets_them(tmp_path):
    (tmp_path / "file").write_text("")
    TypedBefore(tmp_path / "file" / "history").remember(["wave"])

    assert TypedBefore(tmp_path / "file" / "history").lines() == []


def test_what_moves_a_cursor_is_not_read_back(tmp_path):
    (tmp_path / "history").write_bytes(b"wave\n\x1b[2J\n\xff\xfe\nstop\n")

    assert TypedBefore(tmp_path / "history").lines()[0] == "wave"
    assert not any("\x1b" in line for line in TypedBefore(tmp_path / "history").lines())


def test_only_the_newest_are_kept(tmp_path):
    TypedBefore(tmp_path / "history").remember([f"line {number}" for number in range(2000)])

    assert len(TypedBefore(tmp_path / "history").lines()) == 500
    assert TypedBefore(tmp_path / "history").lines()[-1] == "line 1999"
