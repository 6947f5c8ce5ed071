"""What a terminal sends is read as keys."""

import pytest

from executive.screens.key_names import key_names


@pytest.mark.parametrize(
    ("sent", "names"),
    [
        ("a", ("a",)),
        ("\x1b[A\x1b[B\x1b[C\x1b[D", ("up", "down", "right", "left")),
        ("\x1bOA", ("up",)),
        ("\r", ("enter",)),
        ("w\x1b[A.", ("w", "up", ".")),
        ("\x1b[1;5C", ("right",)),
        ("\x1b[15~x", ("x",)),
        ("\x1b", ()),
        ("", ()),
    ],
)
def test_keys_have_names(sent, names):
    assert key_names(sent) == names
