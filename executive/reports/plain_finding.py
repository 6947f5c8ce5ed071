"""What the checker found, in a sentence for somebody who has never seen a trajectory."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from trees.failures import Number

_NEAR = frozenset({"self-collision", "scene collision", "held object collision"})
_OF_A_JOINT: Mapping[str, tuple[str, str]] = MappingProxyType(
    {
        "position limit": ("would have to turn to", "rad"),
        "velocity limit": ("would have to move at", "rad/s"),
        "acceleration limit": ("would have to speed up at", "rad/s²"),
        "jerk limit": ("would have to jerk at", "rad/s³"),
        "boundary velocity": ("would not be at rest, but move at", "rad/s"),
        "effort limit": ("would have to push with", "Nm"),
    }
)
"""What a joint would have to do, and the unit of it, by what the checker calls its limit."""


def plain_finding(numbers: Mapping[str, Number]) -> str | None:
    """A finding of the checker in words; None where nothing plainer can be said.

    Args:
        numbers: Those of the failure: ``finding`` (its kind), ``subject``, ``value``, ``limit``, ``t_s``.
    """
    kind, subject = str(numbers.get("finding", "")), str(numbers.get("subject", ""))
    value, limit, t_s = (numbers.get(name) for name in ("value", "limit", "t_s"))
    if not isinstance(value, float) or not isinstance(limit, float) or not isinstance(t_s, float):
        return None
    when = f"{t_s:.2f} s after the motion would begin"
    if kind in _NEAR:
        one, _, other = subject.partition(" and ")
        reached = f"within {value * 1000.0:.0f} mm of" if value > 0.0 else "into"
        what = "what is held, " if kind == "held object collision" else ""
        return f"{what}{one} would come {reached} {other}, {when}; {limit * 1000.0:.0f} mm must stay free"
    if kind == "concession":
        one, _, other = subject.partition(" and ")
        return f"the plan asks for {one} and {other} to come nearer to each other than may be granted, {when}"
    if kind == "balance":
        return (
            f"the robot would lean until {value * 1000.0:.0f} mm are left before it tips over, {when}; "
            f"{limit * 1000.0:.0f} mm must be left"
        )
    if kind in _OF_A_JOINT:
        does, unit = _OF_A_JOINT[kind]
        return f"{subject} {does} {value:.3g} {unit}, {when}; {limit:.3g} {unit} is the most that it may"
    return None
