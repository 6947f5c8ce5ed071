"""What the checker found, in a sentence for somebody who has never seen a trajectory."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from kinematics.motion.verdict import Finding, FindingKind

_NEAR = frozenset(
    {FindingKind.SELF_COLLISION, FindingKind.SCENE_COLLISION, FindingKind.HELD_OBJECT_COLLISION}
)
_OF_A_JOINT: Mapping[FindingKind, tuple[str, str]] = MappingProxyType(
    {
        FindingKind.POSITION_LIMIT: ("would have to turn to", "rad"),
        FindingKind.VELOCITY_LIMIT: ("would have to move at", "rad/s"),
        FindingKind.ACCELERATION_LIMIT: ("would have to speed up at", "rad/s²"),
        FindingKind.JERK_LIMIT: ("would have to jerk at", "rad/s³"),
        FindingKind.BOUNDARY_VELOCITY: ("would not be at rest, but move at", "rad/s"),
        FindingKind.EFFORT_LIMIT: ("would have to push with", "Nm"),
    }
)
"""What a joint would have to do, and the unit of it, by the limit that it would not keep."""


def plain_finding(finding: Finding) -> str | None:
    """A finding of the checker in words; None where nothing plainer can be said."""
    kind, subject = finding.kind, " and ".join(finding.subject)
    value, limit = finding.value, finding.limit
    when = f"{finding.t_s:.2f} s after the motion would begin"
    if kind in _NEAR:
        one, _, other = subject.partition(" and ")
        reached = f"within {value * 1000.0:.0f} mm of" if value > 0.0 else "into"
        what = "what is held, " if kind is FindingKind.HELD_OBJECT_COLLISION else ""
        return f"{what}{one} would come {reached} {other}, {when}; {limit * 1000.0:.0f} mm must stay free"
    if kind is FindingKind.CONCESSION:
        one, _, other = subject.partition(" and ")
        return f"the plan asks for {one} and {other} to come nearer to each other than may be granted, {when}"
    if kind is FindingKind.BALANCE:
        return (
            f"the robot would lean until {value * 1000.0:.0f} mm are left before it tips over, {when}; "
            f"{limit * 1000.0:.0f} mm must be left"
        )
    if kind in _OF_A_JOINT:
        does, unit = _OF_A_JOINT[kind]
        return f"{subject} {does} {value:.3g} {unit}, {when}; {limit:.3g} {unit} is the most that it may"
    return None
