"""The page of the events: every class that a run's log may hold, with its fields."""

from __future__ import annotations

import dataclasses
from typing import get_args

from executive.session.events import SessionEvent
from robots.control.events import ControlEvent
from tools.documents.markdown import attributes, summary, table
from trees.events import TreeEvent

_HEAD = """\
# Events

What a run tells while it goes on. `events.jsonl` of a [recorded run](../guides/replay.md) holds one event
on a line, as a JSON object with the class's name under `event`; `ticket.subscribe` hands on [the values
themselves](../guides/python.md). `t_s` is simulated time in seconds (control time, live). No event holds a
wall-clock time, so that the same run has the same events; the report's digest is taken over them.
"""
_GROUPS = (
    ("Session", "What becomes of what was said.", SessionEvent),
    ("Tree", "What the behavior tree does.", TreeEvent),
    ("Control", "What the control loop does.", ControlEvent),
)


def events_page() -> str:
    """The page, in three groups: session, tree, control loop."""
    parts = [_HEAD]
    for name, about, union in _GROUPS:
        parts.append(f"## {name}\n\n{about}\n")
        for event in get_args(union):
            parts.append(f"### {event.__name__}\n\n{summary(event)}\n")
            parts.append(_fields(event))
    return "\n".join(parts)


def _fields(event: type) -> str:
    meant, fields = attributes(event), _declared(event)
    if not meant:
        return ", ".join(f"`{field.name}` ({field.type})" for field in fields) + "\n"
    rows = [(f"`{field.name}`", str(field.type), meant.get(field.name, "")) for field in fields]
    return table(("field", "type", "meaning"), rows)


def _declared(event: type) -> tuple[dataclasses.Field[object], ...]:
    return dataclasses.fields(event)
