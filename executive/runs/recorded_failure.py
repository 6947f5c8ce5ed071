"""A failure as a report holds it, read back; reports that name no reasons are read as well."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kinematics.motion.verdict import Finding, FindingKind
from trees.failures import CHOICES_JOINED_BY, Failure, FailureKind, OpenChoice, Reason

_FOR_PROGRAMS = frozenset(
    {"objects", "slot", "unseen", "one_will_do", "survey", "none_left", "lost", "finding"}
)
"""What reports without reasons have among a failure's numbers, though it is not for people."""


def failure_from(document: Mapping[str, Any]) -> Failure:
    """The failure that ``Failure.to_json`` wrote, with its causes.

    Where a report names no reason, the kind says it all. What there is to choose from, and what the checker
    found, are then taken from the numbers, which held them as text.

    Args:
        document: A failure of a report.

    Raises:
        KeyError: It has no kind or no message, or a reason that is not known.
        ValueError: Its kind, or the kind of the checker's finding, is not known.
    """
    cause, kind = document.get("cause"), FailureKind(document["kind"])
    told = dict(document.get("numbers", {}))
    return Failure(
        kind,
        str(document["message"]),
        {key: value for key, value in told.items() if key not in _FOR_PROGRAMS},
        str(document.get("where", "")),
        None if cause is None else failure_from(cause),
        Reason[document.get("reason", Reason.KIND_ONLY.name)],
        _open_choice(document.get("open_choice"), told),
        _finding(document.get("finding"), told),
    )


def _open_choice(written: Mapping[str, Any] | None, told: Mapping[str, Any]) -> OpenChoice | None:
    if written is not None:
        words, names = tuple(written["words"]), tuple(written["names"])
        return OpenChoice(words, names, written["slot"], written["unseen"], written["one_will_do"])
    if "choices" not in told:
        return None
    return OpenChoice(
        tuple(str(told["choices"]).split(CHOICES_JOINED_BY)),
        tuple(str(told["objects"]).split(CHOICES_JOINED_BY)) if "objects" in told else (),
        str(told.get("slot", "object")),
        int(told.get("unseen", 0)),
        bool(told.get("one_will_do", False)),
    )


def _place(written: Any) -> tuple[float, float, float] | None:
    if written is None:
        return None
    x, y, z = map(float, written)
    return x, y, z


def _finding(written: Mapping[str, Any] | None, told: Mapping[str, Any]) -> Finding | None:
    if written is not None:
        return Finding(
            FindingKind(written["kind"]),
            float(written["t_s"]),
            tuple(written["subject"]),
            float(written["value"]),
            float(written["limit"]),
            _place(written.get("place_m")),
        )
    if "finding" not in told:
        return None
    subject = tuple(str(told["subject"]).split(" and "))
    return Finding(
        FindingKind(told["finding"]),
        float(told["t_s"]),
        subject,
        float(told["value"]),
        float(told["limit"]),
    )
