"""Faults in the skills that carry something: those of the pick, and the same on the way afterwards."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from tools.evaluate.faults import FAULTS, Arm, FaultBench, FaultState, slip_in, take_in

FAULTED_SUITES = frozenset({"place", "put_in", "put_in_fridge", "hand_over"})
# The leaf in which a skill carries what it holds.
CARRYING = ("transfer", "offer")


def _taken_on_the_way(bench: FaultBench, state: FaultState) -> None:
    """Somebody takes the object out of the hand that carries it."""
    take_in(bench, state, CARRYING, float(bench.rng.uniform(0.1, 1.5)))


def _slip_on_the_way(bench: FaultBench, state: FaultState) -> None:
    """The object turns slippery while it is carried."""
    slip_in(bench, state, CARRYING)


SKILL_FAULTS: Mapping[str, Arm] = MappingProxyType(
    {
        **{name: arm for name, arm in FAULTS.items() if name not in ("nothing_there", "too_close")},
        "taken_on_the_way": _taken_on_the_way,
        "slip_on_the_way": _slip_on_the_way,
    }
)
"""By name. What is wrong with the scene itself is left out: the skill's own scenes are used."""
