"""The page of the protocol names every field that crosses the sockets."""

from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import get_args

import pytest

from executive.live.desk_messages import DeskMessage
from robots.live.wire.messages import ControlMessage

PAGE = (Path(__file__).parents[3] / "docs" / "reference" / "live-protocol.md").read_text("utf-8")


@pytest.mark.parametrize("message", [*get_args(ControlMessage), *get_args(DeskMessage)])
def test_the_page_names_the_fields_of_a_message(message):
    assert is_dataclass(message)
    assert [field.name for field in fields(message) if f"`{field.name}`" not in PAGE] == []
