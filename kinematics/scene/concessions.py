"""What a planner asks the judge to overlook in one step: a pair of names, by how much, and why.

A planner never changes the scene that its motions are judged in. Where a step cannot keep the scene's
margins (it starts too near to something, it takes hold of something), it says so in concessions, which the
judge bounds by rules of its own.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from enum import Enum

from kinematics.scene.planning_scene import Pair, PlanningScene


class ConcessionReason(Enum):
    """Why a pair may be nearer than the scene says."""

    STARTS_NEAR = "starts near"
    STARTS_IN_CONTACT = "starts in contact"
    AT_REST = "at rest"
    GRASPED_OBJECT = "grasped object"
    HANDLE_IN_HAND = "handle in hand"
    SUPPORT_OF_HELD_OBJECT = "support of held object"


@dataclass(frozen=True, slots=True)
class Concession:
    """One pair that a step brings, or leaves, nearer together than the scene allows.

    Attributes:
        pair: A link or held object, and an object of the scene, in no order.
        reason: Why.
        step: During which step: "reach", "approach", "retreat", ...
        distance_m: What the pair keeps instead of the scene's margin; None where it may touch.
    """

    pair: Pair
    reason: ConcessionReason
    step: str
    distance_m: float | None = None

    @property
    def names(self) -> tuple[str, ...]:
        """The pair, sorted."""
        return tuple(sorted(self.pair))


def touching(
    first: Iterable[str], second: Iterable[str], reason: ConcessionReason, step: str
) -> tuple[Concession, ...]:
    """Every one of some names may touch every one of others."""
    others = tuple(second)
    return tuple(Concession(frozenset((one, other)), reason, step) for one in first for other in others)


def in_step(concessions: Iterable[Concession], step: str) -> tuple[Concession, ...]:
    """The same concessions for another step."""
    return tuple(replace(one, step=step) for one in concessions)


def with_touching(scene: PlanningScene, concessions: Sequence[Concession]) -> PlanningScene:
    """The scene for planning, in which conceded pairs may touch; distances are not in it."""
    pairs = [one.names for one in concessions if one.distance_m is None and len(one.pair) == 2]
    return scene.allowing((first, second) for first, second in pairs) if pairs else scene
