"""What one broken part gave, and what many together say."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from tools.evaluate.records import Bar
from tools.evaluate.stopping.stop_judge import REST_RAD_S

_FOLLOWED_RAD = 0.005
"""A joint that is never farther from where it is asked to be has a motor that gives what is asked for:
healthy joints are up to 5 mrad off."""


@dataclass(frozen=True, slots=True)
class FaultRecord:
    """One episode.

    Attributes:
        seed, fault: Which.
        part: The joint that was struck; empty for faults of no joint.
        t_s, phase: When, and what was under way.
        noticed_s: Time until the health monitor said so; None when it never did.
        ailment, blamed: What it said is wrong, and with which part.
        outcome, claimed_falsely: How the task ended, and whether it claimed what the truth denies.
        failure_kind: Kind of the failure at the top of the chain, or None.
        asked_rad: How far the struck joint was asked to move after the fault.
        off_rad: Farthest that it was from where it was asked to be, truly.
        asked_share: Largest effort that its servo asked for after the fault, share of the healthy limit.
        shown_rad: A joint that was asked to move by less, and is not off by as much, has not shown a jam.
        refused: Whether the next command was refused with the reason.
        state: The state machine's at the end.
        late_rad_s: Speed of the fastest joint in the last second; without the one whose motor fails.
        fell: Whether the robot fell.
        fells_standing: For a fall: whether the same fault fells a robot that stands still, at home or in the
            posture in which it was struck.
        dropped: Objects held at the end of the task that touched anything else later.
        typed: Whether the ailment is the fault, and the part is the one that was struck; a stuck joint of
            a leg holds the others back too, for both legs and the floor are one chain.
        of_a_motor: Whether the fault shows only where the motor is asked for more than it gives.
        error: A traceback, when the evaluation broke.
    """

    seed: int
    fault: str
    part: str = ""
    t_s: float = 0.0
    phase: str = ""
    noticed_s: float | None = None
    ailment: str = ""
    blamed: str = ""
    outcome: str = ""
    claimed_falsely: bool = False
    failure_kind: str | None = None
    asked_rad: float = 0.0
    off_rad: float = 0.0
    asked_share: float = 0.0
    shown_rad: float = 0.02
    refused: bool = False
    state: str = ""
    late_rad_s: float = 0.0
    fell: bool = False
    fells_standing: bool | None = None
    error: str | None = None
    typed: bool = False
    of_a_motor: bool = False

    @property
    def unchallenged(self) -> bool:
        """Whether the struck joint was never asked for anything that would have shown the fault."""
        if self.part == "" or self.fell:
            return False
        if self.of_a_motor:
            return self.off_rad < _FOLLOWED_RAD
        return max(self.asked_rad, self.off_rad) < self.shown_rad

    @property
    def faults(self) -> tuple[str, ...]:
        """Which demands it broke."""
        noticed = self.noticed_s is not None
        broken = {
            "broken": self.error is not None,
            "not noticed": not noticed and not self.unchallenged,
            "mistaken for another fault": noticed and not self.typed,
            "false success": self.claimed_falsely,
            "fell": self.fell and not self.fells_standing,
            "next command not refused": noticed and not self.refused,
            "not at rest": not self.fell and self.late_rad_s >= REST_RAD_S,
        }
        return tuple(name for name, is_so in broken.items() if is_so)


class FaultSummary:
    """What the episodes of one fault say together."""

    def __init__(self, fault: str, seed: int, records: Sequence[FaultRecord]) -> None:
        self.fault, self.seed, self.records = fault, seed, records

    def bars(self) -> list[Bar]:
        """The demands."""
        broken = Counter(name for record in self.records for name in record.faults)
        names = (
            "broken",
            "not noticed",
            "mistaken for another fault",
            "false success",
            "fell",
            "next command not refused",
            "not at rest",
        )
        return [Bar(name, str(broken[name]), "0", broken[name] == 0) for name in names]

    def figures(self) -> dict[str, float]:
        """Numbers worth knowing."""
        times = [record.noticed_s for record in self.records if record.noticed_s is not None] or [0.0]
        return {
            "noticed": float(sum(record.noticed_s is not None for record in self.records)),
            "never asked for anything": float(
                sum(record.noticed_s is None and record.unchallenged for record in self.records)
            ),
            "effort asked of those, largest share": max(
                [record.asked_share for record in self.records if record.unchallenged] or [0.0]
            ),
            "noticed after s, p50": round(float(np.percentile(times, 50)), 3),
            "noticed after s, p95": round(float(np.percentile(times, 95)), 3),
            "noticed after s, max": round(max(times), 3),
            "falls": float(sum(record.fell for record in self.records)),
            "falls excused": float(
                sum(record.fell and bool(record.fells_standing) for record in self.records)
            ),
        }

    def to_json(self) -> dict[str, Any]:
        """The evaluation's document."""
        good = sum(not record.faults for record in self.records)
        return {
            "suite": "fault",
            "fault": self.fault,
            "episodes": len(self.records),
            "seed": self.seed,
            "success_rate": round(good / max(len(self.records), 1), 4),
            "false_success": sum(record.claimed_falsely for record in self.records),
            "falls": sum(record.fell for record in self.records),
            "failures": dict(Counter(name for record in self.records for name in record.faults)),
            "failed_seeds": [record.seed for record in self.records if record.faults],
            "figures": self.figures(),
            "bars": [asdict(bar) for bar in self.bars()],
            "episodes_detail": [{**asdict(record), "faults": list(record.faults)} for record in self.records],
        }
