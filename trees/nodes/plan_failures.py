"""What the planner and the checker said no to, as failures."""

from __future__ import annotations

from kinematics.motion.verdict import Unsafe
from kinematics.requests.step import NoPlan
from trees.failures import Failure, FailureKind


def no_plan_failure(answer: NoPlan) -> Failure:
    """The planner's honest no, with its figures and how many candidates failed for which reason.

    The reason of the only candidate is not counted when the message tells it.
    """
    reasons = answer.reasons
    if sum(reasons.values()) == 1:
        reasons = {reason: 1 for reason in reasons if reason not in answer.message}
    return Failure(FailureKind.INFEASIBLE, answer.message, {**reasons, **answer.numbers})


def unsafe_failure(name: str, unsafe: Unsafe) -> Failure:
    """The checker's refusal as a failure, with the numbers of its first finding."""
    first = unsafe.findings[0]
    return Failure.unsafe(
        f"{unsafe}",
        step=name,
        finding=first.kind.value,
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
    )
