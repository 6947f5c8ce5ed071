"""Why a posture is not free, in words for people."""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType

REASONS = ("free", "reach", "limits", "balance", "contact", "unproven")


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why something is not free.

    Attributes:
        reason: "reach" (a foot cannot be kept), "limits", "balance", "contact", or "unproven": so near
            to a bound that it could not be proven to keep it.
        at: Where: the row of a point, or the row of an edge's beginning plus the parameter in [0, 1] on it.
        pair: Names of the two solids, when it is a contact.
    """

    reason: str
    at: float
    pair: tuple[str, str] | None


_WHY_NOT = MappingProxyType(
    {
        "reach": "the feet could not stay where they are",
        "limits": "a joint would come too near to its limit",
        "balance": "the robot would lean too far over its feet",
    }
)


@dataclass(frozen=True, slots=True)
class NotFree:
    """Why a point is not free: the judge's own finding.

    Attributes:
        reason: "reach" (a foot cannot be kept), "limits", "balance" or "contact".
        pair: Names of the two solids, when it is a contact.
    """

    reason: str
    pair: tuple[str, str] | None = None

    def __str__(self) -> str:
        return why_not_free(self.reason, self.pair)


def why_not_free(reason: str, pair: tuple[str, str] | None = None) -> str:
    """In words for people why a point is not free.

    Args:
        reason: "reach", "limits", "balance", or any other where something is too near to something.
        pair: What collides with what, when that is it.
    """
    if pair is not None:
        return f"{pair[0]} collides with {pair[1]}"
    return _WHY_NOT.get(reason, "something would come too near")
