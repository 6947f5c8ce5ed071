"""How a scene is lit: what a camera's picture depends on, and nothing else does."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, get_args

LightKind = Literal["bright", "dim", "warm", "side"]
LIGHT_KINDS: tuple[LightKind, ...] = get_args(LightKind)
"""Usual light; a tenth of it; that of a filament lamp; and all of it from one side."""


@dataclass(frozen=True, slots=True)
class LightChange:
    """From a simulated time on, the light is of another kind."""

    at_s: float
    kind: LightKind


@dataclass(frozen=True, slots=True)
class Light:
    """The light of a scene.

    Attributes:
        kind: At first.
        changes: What it becomes later on, in order of time.
    """

    kind: LightKind = "bright"
    changes: tuple[LightChange, ...] = ()

    def at(self, time_s: float) -> LightKind:
        """The kind of light at a simulated time."""
        kind = self.kind
        for change in self.changes:
            if change.at_s <= time_s:
                kind = change.kind
        return kind


def defect(light: Light) -> tuple[str, str] | None:
    """The key and the reason of the first rule that a light breaks, or None."""
    last_s = 0.0
    for i, change in enumerate(light.changes):
        if not (math.isfinite(change.at_s) and change.at_s >= last_s):
            return f"change[{i}].at_s", f"must be {last_s:g} or later, not {change.at_s:g}"
        last_s = change.at_s
    return None
