"""What one stopped instant gave, and what many together say."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from tools.evaluate.records import Bar
from tools.evaluate.stopping.courses import CYCLE, CYCLES
from tools.evaluate.stopping.stop_judge import REST_RAD_S, REST_WITHIN_S, STAND_WITHIN_S
from tools.evaluate.stopping.timeline import MOVING_RAD_S

_ROOM = 1.005
"""Limits are kept when they are kept to half a percent: the room that the trajectory checker gives."""
_LEAST_OF_A_PHASE = 20
_OF = 300


@dataclass(frozen=True, slots=True)
class StopRecord:
    """One instant; see ``StopJudge`` for what is measured.

    Attributes:
        seed, course: The run.
        t_s, phase, arm_rad_s: The instant.
        category: Of the emergency stop; None for a cancel.
        outcome: How the task that was under way ended; empty when none was.
        refused: Whether a command while the stop was engaged was refused; None for a cancel.
        reset: What stood against the person's reset at the end, or None.
        next_task, next_outcome, next_reason: What was said after a cancel, and how it ended.
        compute_ms: Processor time of the control period in which the braking began.
        error: A traceback, when the evaluation broke.
    """

    seed: int
    course: str
    t_s: float = 0.0
    phase: str = ""
    arm_rad_s: float = 0.0
    category: int | None = None
    outcome: str = ""
    settle_s: float = 0.0
    rest_within_s: float = REST_WITHIN_S
    late_rad_s: float = 0.0
    late_joint: str = ""
    finger_rad_s: float = 0.0
    acceleration: float = 0.0
    acceleration_joint: str = ""
    jerk: float = 0.0
    jerk_joint: str = ""
    held: tuple[str, ...] = ()
    dropped: tuple[str, ...] = ()
    fell: bool = False
    foreign: tuple[str, ...] = ()
    bypassed: int = 0
    moved: bool = False
    refused: bool | None = None
    reset: str | None = None
    next_task: str = ""
    next_outcome: str = ""
    next_reason: str = ""
    compute_ms: float = 0.0
    error: str | None = None

    @property
    def faults(self) -> tuple[str, ...]:
        """Which demands it broke."""
        broken = {
            "broken": self.error is not None,
            "still moving": self.late_rad_s >= REST_RAD_S,
            "acceleration": self.acceleration > _ROOM,
            "jerk": self.jerk > _ROOM,
            "fell": self.fell,
            "dropped": bool(self.dropped),
            "foreign setpoints": bool(self.foreign) or self.bypassed > 0,
            "moved before the reset": self.moved,
            "command not refused": self.refused is False,
            "reset refused": self.reset is not None,
            "next task": self.next_task != "" and self.next_outcome != "done",
        }
        return tuple(name for name, is_so in broken.items() if is_so)


class StopSummary:
    """What the instants of one evaluation say together."""

    def __init__(self, suite: str, seed: int, records: Sequence[StopRecord]) -> None:
        self.suite, self.seed, self.records = suite, seed, records

    def bars(self) -> list[Bar]:
        """The demands of the suite."""
        count = len(self.records)
        moving = sum(record.arm_rad_s > MOVING_RAD_S for record in self.records)
        phases = Counter(record.phase for record in self.records)
        run = {record.course for record in self.records}
        cycle = next((one for one in CYCLES.values() if run <= {course.name for course in one}), CYCLE)
        least = min(phases[phase] for course in cycle for phase in course.wanted)
        wanted = _LEAST_OF_A_PHASE * count // _OF
        broken = Counter(fault for record in self.records for fault in record.faults)
        bars = [
            Bar("while an arm moves", f"{moving / max(count, 1):.0%}", "≥ 70%", moving >= 0.7 * count),
            Bar("rarest phase", str(least), f"≥ {wanted}", least >= wanted),
        ]
        names = [
            ("broken", "broken episodes"),
            (
                "still moving",
                f"a joint at {REST_RAD_S} rad/s after {REST_WITHIN_S} s, of a walk {STAND_WITHIN_S} s",
            ),
            ("acceleration", "acceleration limit left"),
            ("jerk", "jerk limit left"),
            ("fell", "falls"),
            ("dropped", "dropped objects"),
            ("foreign setpoints", "setpoints from anyone else"),
            ("moved before the reset", "motion before reset or next command"),
        ]
        if self.suite == "stop":
            names += [("command not refused", "command not refused"), ("reset refused", "reset refused")]
        else:
            names += [("next task", "next task not done")]
        return bars + [Bar(text, str(broken[name]), "0", broken[name] == 0) for name, text in names]

    def figures(self) -> dict[str, float]:
        """Numbers worth knowing."""
        settle = [r.settle_s for r in self.records if r.rest_within_s == REST_WITHIN_S] or [0.0]
        walks = [r.settle_s for r in self.records if r.rest_within_s > REST_WITHIN_S] or [0.0]
        compute = [record.compute_ms for record in self.records] or [0.0]
        return {
            "settle_s_p50": round(float(np.percentile(settle, 50)), 3),
            "late_rad_s_max": round(max((r.late_rad_s for r in self.records), default=0.0), 4),
            "finger_present_rad_s_max": round(max((r.finger_rad_s for r in self.records), default=0.0), 4),
            "settle_s_max": round(max(settle), 3),
            "walk_settle_s_max": round(max(walks), 3),
            "acceleration_share_max": round(max((r.acceleration for r in self.records), default=0.0), 4),
            "jerk_share_max": round(max((r.jerk for r in self.records), default=0.0), 4),
            "held_at_the_stop": float(sum(bool(record.held) for record in self.records)),
            "braking_ms_p50": round(float(np.percentile(compute, 50)), 2),
            "braking_ms_p95": round(float(np.percentile(compute, 95)), 2),
            "braking_ms_max": round(max(compute), 2),
            **{
                f"phase {name}": float(n)
                for name, n in sorted(Counter(r.phase for r in self.records).items())
            },
        }

    def to_json(self) -> dict[str, Any]:
        """The evaluation's document."""
        good = [record for record in self.records if not record.faults]
        failures = Counter(fault for record in self.records for fault in record.faults)
        return {
            "suite": self.suite,
            "episodes": len(self.records),
            "seed": self.seed,
            "success_rate": round(len(good) / max(len(self.records), 1), 4),
            "false_success": 0,
            "false_failure": 0,
            "falls": sum(record.fell for record in self.records),
            "failures": dict(sorted(failures.items())),
            "failed_seeds": sorted({record.seed for record in self.records if record.faults}),
            "phases": dict(sorted(Counter(record.phase for record in self.records).items())),
            "figures": self.figures(),
            "bars": [asdict(bar) for bar in self.bars()],
            "episodes_detail": [{**asdict(record), "faults": list(record.faults)} for record in self.records],
        }
