"""What the planner and the checker said no to, as failures."""

from __future__ import annotations

from types import MappingProxyType

from kinematics.motion.verdict import Unsafe
from kinematics.requests.step import NoPlan, WhyNoPlan
from trees.failures import Failure, FailureKind, Reason

_REASONS = MappingProxyType(
    {
        WhyNoPlan.NO_WAY: Reason.KIND_ONLY,
        WhyNoPlan.NO_GRASP: Reason.NO_GRASP,
        WhyNoPlan.TOO_WIDE: Reason.TOO_WIDE,
        WhyNoPlan.NO_SPOT_IS_REACHED: Reason.NO_WAY_TO_SPOT,
    }
)
"""What the planners tell apart, as failures name it."""


def no_plan_failure(answer: NoPlan) -> Failure:
    """The planner's honest no, with its figures and how many candidates failed for which reason.

    The reason of the only candidate is not counted when the message tells it.
    """
    reasons = answer.reasons
    if sum(reasons.values()) == 1:
        reasons = {reason: 1 for reason in reasons if reason not in answer.message}
    numbers = {**reasons, **answer.numbers}
    return Failure(FailureKind.INFEASIBLE, answer.message, numbers, reason=_REASONS[answer.why])


def unsafe_failure(name: str, unsafe: Unsafe) -> Failure:
    """The checker's refusal as a failure, with the numbers of its first finding."""
    first = unsafe.findings[0]
    return Failure.unsafe(
        f"{unsafe}",
        finding=first,
        step=name,
        subject=" and ".join(first.subject),
        t_s=first.t_s,
        value=first.value,
        limit=first.limit,
        findings=len(unsafe.findings),
    )


def why_stale(name: str, planned_for: int, now: int) -> Failure | None:
    """Why a plan is of no use any more: it was made for a scene that is no longer believed."""
    if now == planned_for:
        return None
    return Failure.execution(
        f"the plan of {name} is stale: the scene has changed since",
        planned_for=planned_for,
        scene_version=now,
    ).because(Reason.STALE_PLAN)
