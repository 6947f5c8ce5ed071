"""Answers about the day, the time and the robot, in words."""

from __future__ import annotations

from datetime import datetime, timedelta

from trees.self_knowledge import Identity

QUESTIONS = (
    "time",
    "day",
    "date",
    "tomorrow",
    "day of the week",
    "day of the month",
    "name",
    "team",
    "country",
    "affiliation",
    "about yourself",
)
"""What can be asked."""

_DAYS = ("Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday", "Sunday")
_MONTHS = (
    "January", "February", "March", "April", "May", "June",
    "July", "August", "September", "October", "November", "December",
)  # fmt: skip


def answer_to(asked: str, now: datetime, identity: Identity, model: str) -> str | None:
    """The answer to a question, as one sentence or two; None where nobody can ask so.

    Args:
        asked: One of ``QUESTIONS``.
        now: Local date and time.
        identity: What the robot knows of itself.
        model: Name of the robot's model, for one that was given no name.
    """
    name = identity.name or model.upper()
    match asked:
        case "time":
            return f"it is {now:%H:%M}"
        case "day" | "day of the week":
            return f"today is {_DAYS[now.weekday()]}"
        case "date":
            return f"today is {dated(now)}"
        case "tomorrow":
            return f"tomorrow is {dated(now + timedelta(days=1))}"
        case "day of the month":
            return f"today is the {_ordinal(now.day)} of {_MONTHS[now.month - 1]}"
        case "name":
            return f"my name is {name}"
        case "team":
            return _known("my team is", identity.team, "team")
        case "country":
            return _known("I come from", identity.country, "country")
        case "affiliation":
            return _known("my affiliation is", identity.affiliation, "affiliation")
        case "about yourself":
            return identity.about or _portrait(identity, name)
        case _:
            return None


def dated(day: datetime) -> str:
    """A day, as it is said: "Monday, the 5th of January 2026"."""
    return f"{_DAYS[day.weekday()]}, the {_ordinal(day.day)} of {_MONTHS[day.month - 1]} {day.year}"


def _ordinal(number: int) -> str:
    teens = 10 < number % 100 < 14
    return f"{number}{'th' if teens else {1: 'st', 2: 'nd', 3: 'rd'}.get(number % 10, 'th')}"


def _known(begins: str, value: str, what: str) -> str:
    return f"{begins} {value}" if value else f"nobody has told me my {what}"


def _portrait(identity: Identity, name: str) -> str:
    """What is known, where nobody wrote a text about the robot."""
    parts = [f"I am {name}, a humanoid robot"]
    parts += [f"from {identity.country}"] if identity.country else []
    parts += [f"of the team {identity.team}"] if identity.team else []
    parts += [f"at {identity.affiliation}"] if identity.affiliation else []
    return " ".join(parts)
