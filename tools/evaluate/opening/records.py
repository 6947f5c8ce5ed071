"""What the episodes of opening and closing gave."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from tools.evaluate.records import Bar

OPEN_DEG, OPEN_M = 65.0, 0.25
SHUT_DEG, SHUT_M = 3.0, 0.01
"""A door or drawer that is so far open counts as open; so little, as closed."""
CLAIM_DEG, CLAIM_M = 3.0, 0.03
FELT_N, TRUE_N, SLIP_M, SUCCESS = 65.0, 95.0, 0.002, 0.95
_LIMIT_ROOM_N = 3.0
"""The estimate may overshoot its limit by its own noise."""


@dataclass(frozen=True, slots=True)
class OpeningRecord:
    """One episode; openings in degrees of doors and metres of drawers.

    Attributes:
        seed: Its seed.
        kind: "door" or "drawer"; ``hinge`` of a door.
        locked: Whether it could not be opened.
        outcome, failure: What the executive said.
        stuck: Whether it said that it is stuck.
        opening: By the truth at the end; ``claimed`` by the robot, None without a claim.
        felt_n, peak_n: Largest estimated and true force.
        fault_fired: Whether the episode's injected fault happened.
    """

    seed: int
    suite: str
    kind: str
    hinge: str
    locked: bool
    outcome: str
    failure: str | None = None
    failure_kind: str | None = None
    stuck: bool = False
    attempts: int = 0
    opening: float = 0.0
    claimed: float | None = None
    felt: float | None = None
    felt_n: float = 0.0
    peak_n: float = 0.0
    fault_fired: bool = False
    feet_slip_m: float = 0.0
    com_margin_m: float = 0.0
    fell: bool = False
    touched: tuple[str, ...] = ()
    simulated_s: float = 0.0
    wall_s: float = 0.0
    planning_ms: float = 0.0
    detail: str | None = None

    @property
    def truth(self) -> bool:
        """Whether it is as it was asked to be."""
        door = self.kind == "door"
        if self.suite == "close":
            return abs(self.opening) <= (SHUT_DEG if door else SHUT_M)
        return self.opening >= (OPEN_DEG if door else OPEN_M)

    @property
    def claim_error(self) -> float | None:
        """How far the claim is off, or None."""
        return None if self.claimed is None else abs(self.claimed - self.opening)

    @property
    def faults(self) -> tuple[str, ...]:
        """Which demands it broke."""
        done = self.outcome == "done"
        claim = CLAIM_DEG if self.kind == "door" else CLAIM_M
        broken = {
            "broken": self.outcome == "error",
            "fell": self.fell,
            "claimed, and not so": done and not self.truth,
            "not done": not self.locked and not (done and self.truth),
            "locked, and not told to be stuck": self.locked and not self.stuck,
            "claim off": done and (self.claim_error or 0.0) > claim,
            "estimated force": self.felt_n > FELT_N + _LIMIT_ROOM_N,
            "true force": self.peak_n > TRUE_N,
            "feet slipped": self.feet_slip_m > SLIP_M,
        }
        return tuple(name for name, so in broken.items() if so)


class OpeningSummary:
    """What many say together."""

    def __init__(
        self, suite: str, seed: int, records: Sequence[OpeningRecord], fault: str | None = None
    ) -> None:
        self.suite, self.seed, self.records, self.fault = suite, seed, records, fault

    def bars(self) -> list[Bar]:
        """The demands of the suite."""
        faults = Counter(fault for record in self.records for fault in record.faults)
        free = [record for record in self.records if not record.locked]
        good = sum(record.truth and record.outcome == "done" for record in free)
        share = good / max(len(free), 1)
        what = "opened" if self.suite == "open" else "closed"
        wanted = SUCCESS if self.fault is None else 0.0
        bars = [Bar(f"{what}, of {len(free)}", f"{share:.1%}", f"≥ {wanted:.0%}", share >= wanted)]
        names = [
            ("broken", "broken episodes"),
            ("fell", "falls"),
            ("claimed, and not so", "claimed, and not so"),
            ("claim off", f"claims off by more than {CLAIM_DEG:g} deg or {CLAIM_M:g} m"),
            ("estimated force", f"estimated force above {FELT_N:g} N"),
            ("true force", f"true force above {TRUE_N:g} N"),
            ("feet slipped", f"feet slipped by more than {1e3 * SLIP_M:g} mm"),
        ]
        if self.suite == "open":
            names.append(("locked, and not told to be stuck", "locked, and not reported as stuck"))
        return bars + [Bar(text, str(faults[name]), "0", faults[name] == 0) for name, text in names]

    def figures(self) -> dict[str, float]:
        """Numbers worth knowing."""
        if not self.records:
            return {}
        errors = [r.claim_error for r in self.records if r.claim_error is not None and r.kind == "door"]
        return {
            "peak_n_p50": round(float(np.median([r.peak_n for r in self.records])), 1),
            "peak_n_max": round(max(r.peak_n for r in self.records), 1),
            "felt_n_max": round(max(r.felt_n for r in self.records), 1),
            "feet_slip_mm_max": round(1e3 * max(r.feet_slip_m for r in self.records), 2),
            "com_margin_mm_min": round(1e3 * min(r.com_margin_m for r in self.records), 1),
            "claim_error_deg_max": round(max(errors, default=0.0), 2),
            "simulated_s_p50": round(float(np.median([r.simulated_s for r in self.records])), 1),
            "faults_fired": float(sum(r.fault_fired for r in self.records)),
            "furniture_touched": float(sum(bool(r.touched) for r in self.records)),
        }

    def to_json(self) -> dict[str, Any]:
        """The evaluation's document."""
        records = self.records
        good = sum(not record.faults for record in records)
        kinds = Counter(r.failure_kind or r.outcome for r in records if r.outcome != "done" and not r.locked)
        planning = [r.planning_ms for r in records] or [0.0]
        p50, p95 = np.percentile(planning, (50, 95))
        factors = [r.simulated_s / r.wall_s for r in records if r.wall_s > 0.0] or [0.0]
        return {
            "suite": self.suite,
            "fault": self.fault,
            "episodes": len(records),
            "seed": self.seed,
            "success_rate": round(good / max(len(records), 1), 4),
            "false_success": sum("claimed, and not so" in r.faults for r in records),
            "false_failure": sum(r.truth and r.outcome != "done" for r in records),
            "falls": sum(r.fell for r in records),
            "unwanted_contacts": sum(bool(r.touched) for r in records),
            "failures": dict(sorted(kinds.items())),
            "failed_seeds": [r.seed for r in records if r.faults],
            "planning_ms": {"p50": round(float(p50), 1), "p95": round(float(p95), 1)},
            "realtime_factor": round(float(np.median(factors)), 2),
            "figures": self.figures(),
            "bars": [asdict(bar) for bar in self.bars()],
            "episodes_detail": [{**asdict(r), "truth": r.truth, "faults": list(r.faults)} for r in records],
        }
