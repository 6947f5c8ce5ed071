"""How a control loop stands, as JSON values: emergency stop, health, counts."""

from __future__ import annotations

from typing import Any

from robots.control.loop.control_loop import ControlLoop

_TOLD_STOPS = 5


def emergency_json(loop: ControlLoop) -> dict[str, Any]:
    """The latch as it is told; ``engaged`` is empty when it is not."""
    engaged = loop.emergency
    if engaged is None:
        return {"engaged": "", "category": 0, "t_s": 0.0}
    return {"engaged": engaged.reason, "category": engaged.category, "t_s": engaged.t_s}


def health_json(loop: ControlLoop) -> dict[str, list[str]]:
    """What is wrong with the robot: so that it must not move, so that it takes no new task."""
    return {"defects": list(loop.defects), "reservations": list(loop.reservations)}


def moves(loop: ControlLoop) -> bool:
    """Whether the body is commanded to move."""
    return not loop.motion.resting or loop.walking.active


def condition_json(loop: ControlLoop) -> dict[str, Any]:
    """For the status: the newest stops and the counts beside what is told of emergency and health."""
    statistics = loop.statistics
    return {
        "emergency": None if loop.emergency is None else emergency_json(loop),
        **health_json(loop),
        "resting": not moves(loop),
        "paused": loop.paused,
        "setpoints": {"accepted": statistics.accepted, "refused": statistics.refused},
        "stops": [f"{stop.t_s:.3f} s: {stop.reason}" for stop in statistics.stops[-_TOLD_STOPS:]],
    }
