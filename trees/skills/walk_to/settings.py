"""Numbers of walking to something; each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class WalkToSettings:
    """Numbers of walking to something.

    Attributes:
        walk_attempts: How often it walks, corrections included.
    """

    walk_attempts: int = 4
