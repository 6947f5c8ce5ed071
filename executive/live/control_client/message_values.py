"""What the control process says, as values of this side."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, get_args

import numpy as np

from kinematics.motion.verdict import Finding, FindingKind
from robots.control.events import ControlEvent
from robots.control.hands.yield_settings import YieldReport
from robots.control.loop.emergency_stop import EmergencyStop

_EVENTS: Mapping[str, type[ControlEvent]] = {kind.__name__: kind for kind in get_args(ControlEvent)}


def report_of(message: Mapping[str, Any]) -> YieldReport:
    """What a yielding hand felt."""
    return YieldReport(
        outcome=message["outcome"],
        s=float(message["s"]),
        peak_force_n=float(message["peak_force_n"]),
        peak_pull_n=float(message["peak_pull_n"]),
        bias=np.array(message["bias"], dtype=np.float64),
    )


def emergency_of(values: Mapping[str, Any]) -> EmergencyStop | None:
    """The emergency stop that is engaged, or None."""
    if not values["engaged"]:
        return None
    return EmergencyStop(float(values["t_s"]), int(values["category"]), str(values["engaged"]))


def event_of(message: Mapping[str, Any]) -> ControlEvent | None:
    """The control layer's event of a message; None for one that this side does not know."""
    kind = _EVENTS.get(str(message["event"]))
    values = {key: value for key, value in message.items() if key not in ("type", "event")}
    try:
        return None if kind is None else kind(**values)
    except TypeError:
        return None


def finding_of(values: list[Any]) -> Finding:
    """What a checker found."""
    kind, t_s, subject, value, limit = values
    return Finding(FindingKind(kind), float(t_s), tuple(map(str, subject)), float(value), float(limit))
