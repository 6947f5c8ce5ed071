"""Kinds of joints: what a description says of many joints at once."""

from __future__ import annotations

import re
from collections.abc import Mapping

from robots.errors import DescriptionError


def kind_of(joint: str, members: Mapping[str, str]) -> str:
    """The kind that a joint belongs to.

    Args:
        joint: Its name.
        members: Regular expressions of names by kind, ``[gains.members]``; the first that fits counts.

    Raises:
        DescriptionError: It belongs to none.
    """
    for kind, pattern in members.items():
        if re.fullmatch(pattern, joint):
            return kind
    raise DescriptionError(f"joint {joint!r} belongs to no kind of [gains.members]")
