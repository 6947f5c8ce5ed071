"""What one episode gave, and what many together say."""

from __future__ import annotations

import math
import traceback
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.scenes import BENCH_CLUTTER, CLUTTER

# A lifted object that moved less than this in the hand is held fast.
SLIP_BAR_M = 0.002
SUCCESS_BAR = 0.97
_PICK = "pick"
RECOVERY_BAR = 0.80
FALSE_FAILURE_BAR = 0.02


@dataclass(frozen=True, slots=True)
class EpisodeRecord:
    """One episode.

    Attributes:
        seed: Its seed, for the scene and for the run.
        outcome: What the executive said: "done", "failed", ...; "error" when the evaluation broke.
        truth: Whether the object really was lifted and held at the end.
        failure_kind: Kind of the failure at the root of the chain, or None.
        failure: The chain in one line, or None.
        attempts: How many grasps were tried.
        fault: The fault that was asked for, or None.
        fault_fired: Whether its moment came.
        recoverable: Whether another look or grasp can help against it; None without a fault.
        lift_m: Least height of the object above the furniture while it had to be held.
        slip_m: Farthest motion in the hand while lifted; None when it never was.
        fell: Whether the robot fell.
        furniture_contacts: Pairs of a link and a piece of furniture that touched.
        others_touched: Pairs of a link and an object that is not the target that touched.
        com_margin_m: Least distance of the CoM's projection to the edge of the support polygon.
        friction_error: Difference between the friction read back from the contacts and the scene's.
        planning_ms: Wall time of planning, for each attempt.
        simulated_s, wall_s: How long it took.
        realtime_factor: Simulated time over wall time, planning left out.
        detail: A traceback, when the evaluation broke.
        numbers: What a skill's judge measured.
    """

    seed: int
    outcome: str
    truth: bool
    failure_kind: str | None = None
    failure: str | None = None
    attempts: int = 0
    fault: str | None = None
    fault_fired: bool = False
    recoverable: bool | None = None
    lift_m: float = 0.0
    slip_m: float | None = None
    fell: bool = False
    furniture_contacts: tuple[str, ...] = ()
    others_touched: tuple[str, ...] = ()
    com_margin_m: float = math.inf
    friction_error: float | None = None
    planning_ms: float = 0.0
    simulated_s: float = 0.0
    wall_s: float = 0.0
    realtime_factor: float = 0.0
    detail: str | None = None
    numbers: Mapping[str, float | int | str | bool] = field(default_factory=dict)

    @property
    def claimed(self) -> bool:
        """Whether the executive said that it was done."""
        return self.outcome == "done"

    @property
    def false_success(self) -> bool:
        """Claimed, and not so."""
        return self.claimed and not self.truth

    @property
    def false_failure(self) -> bool:
        """So, and not claimed."""
        return self.truth and not self.claimed

    @property
    def bad(self) -> bool:
        """Whether it belongs on the list of seeds to look at."""
        return not (self.claimed and self.truth) or self.fell or bool(self.furniture_contacts)

    def to_json(self) -> dict[str, Any]:
        """As the evaluation's JSON holds it; infinities become null."""
        values = asdict(self)
        return {key: _finite(value) for key, value in values.items()}


Run = Callable[[EpisodeOrder], EpisodeRecord]
"""What runs one episode."""


def broken_episode(order: EpisodeOrder, broken: Exception) -> EpisodeRecord:
    """The record of an episode in which the evaluation itself broke; called where it was caught."""
    return EpisodeRecord(
        seed=order.seed,
        outcome="error",
        truth=False,
        failure_kind="ERROR",
        failure=f"{type(broken).__name__}: {broken}",
        fault=order.fault,
        detail=traceback.format_exc(),
    )


def dead_episode(order: EpisodeOrder) -> EpisodeRecord:
    """The record of an episode of which one process after another died."""
    return EpisodeRecord(
        seed=order.seed,
        outcome="error",
        truth=False,
        failure_kind="ERROR",
        failure="every process that ran this episode died",
        fault=order.fault,
    )


@dataclass(frozen=True, slots=True)
class Bar:
    """One demand and whether it was met."""

    name: str
    value: str
    limit: str
    met: bool


@dataclass(frozen=True, slots=True)
class Summary:
    """What the episodes of one run of a suite say together."""

    suite: str
    seed: int
    fault: str | None
    com_margin_limit_m: float
    records: Sequence[EpisodeRecord] = field(default_factory=tuple)
    scene: str | None = None

    @property
    def success_rate(self) -> float:
        """Share of episodes in which the truth says that the object is held."""
        return _share(record.truth for record in self.records)

    @property
    def false_success(self) -> int:
        """Number of claims that the truth denies."""
        return sum(record.false_success for record in self.records)

    @property
    def false_failure(self) -> int:
        """Number of failures that the truth denies."""
        return sum(record.false_failure for record in self.records)

    @property
    def falls(self) -> int:
        """Number of episodes in which the robot fell."""
        return sum(record.fell for record in self.records)

    @property
    def unwanted_contacts(self) -> int:
        """Number of episodes in which the robot touched furniture."""
        return sum(bool(record.furniture_contacts) for record in self.records)

    @property
    def others_touched(self) -> int | None:
        """Number of episodes in which another object than the target was touched; only picks tell."""
        if self.suite != _PICK:
            return None
        return sum(bool(record.others_touched) for record in self.records)

    @property
    def recoverable(self) -> list[EpisodeRecord]:
        """Episodes whose fault came and can be recovered from."""
        return [record for record in self.records if record.recoverable and record.fault_fired]

    def failures(self) -> dict[str, int]:
        """How many episodes failed for which kind of reason."""
        kinds = Counter(
            record.failure_kind or record.outcome for record in self.records if not record.claimed
        )
        return dict(sorted(kinds.items()))

    def balance(self) -> list[Bar]:
        """The demand on the CoM; none where it was not watched, as in walks and with a welded robot."""
        margin = min((record.com_margin_m for record in self.records), default=math.inf)
        if math.isinf(margin):
            return []
        limit = self.com_margin_limit_m
        return [Bar("CoM margin", f"{1e3 * margin:.0f} mm", f"≥ {1e3 * limit:.0f} mm", margin >= limit)]

    def bars(self) -> list[Bar]:
        """The demands that this run can judge."""
        count = len(self.records)
        bars = [
            Bar("claimed, and not so", str(self.false_success), "0", self.false_success == 0),
            Bar(
                "so, and not claimed",
                f"{self.false_failure / max(count, 1):.1%}",
                f"≤ {FALSE_FAILURE_BAR:.0%}",
                self.false_failure <= FALSE_FAILURE_BAR * count,
            ),
            Bar("falls", str(self.falls), "0", self.falls == 0),
            Bar(
                "episodes with furniture touched",
                str(self.unwanted_contacts),
                "0",
                not self.unwanted_contacts,
            ),
            Bar("broken episodes", str(self._errors()), "0", self._errors() == 0),
        ]
        if self.scene in (CLUTTER, BENCH_CLUTTER):
            touched = self.others_touched
            bars.append(Bar("episodes with another object touched", str(touched), "0", touched == 0))
        if self.fault is None:
            slips = [record.slip_m for record in self.records if record.slip_m is not None and record.truth]
            worst_slip = max(slips, default=0.0)
            bars += [
                Bar(
                    "lifted and held",
                    f"{self.success_rate:.1%}",
                    f"≥ {SUCCESS_BAR:.0%}",
                    self.success_rate >= SUCCESS_BAR,
                ),
                Bar(
                    "slip while held",
                    f"{1e3 * worst_slip:.2f} mm",
                    f"≤ {1e3 * SLIP_BAR_M:.0f} mm",
                    worst_slip <= SLIP_BAR_M,
                ),
                *self.balance(),
            ]
        if self.recoverable:
            share = _share(record.truth and record.claimed for record in self.recoverable)
            bars.append(
                Bar(
                    f"recovered, of {len(self.recoverable)} that can be",
                    f"{share:.1%}",
                    f"≥ {RECOVERY_BAR:.0%}",
                    share >= RECOVERY_BAR,
                )
            )
        return bars

    def to_json(self) -> dict[str, Any]:
        """As the command-line contract writes an evaluation."""
        return {
            "suite": self.suite,
            "fault": self.fault,
            "episodes": len(self.records),
            "seed": self.seed,
            "success_rate": round(self.success_rate, 4),
            "false_success": self.false_success,
            "false_failure": self.false_failure,
            "falls": self.falls,
            "unwanted_contacts": self.unwanted_contacts,
            "others_touched": self.others_touched,
            "fault_fired": sum(record.fault_fired for record in self.records),
            "failures": self.failures(),
            "failed_seeds": [record.seed for record in self.records if record.bad],
            "planning_ms": self.planning_ms(),
            "realtime_factor": round(self.realtime_factor(), 2),
            "bars": [asdict(bar) for bar in self.bars()],
            "episodes_detail": [record.to_json() for record in self.records],
        }

    def planning_ms(self) -> dict[str, float]:
        """Median and 95th percentile of the planning time of an attempt."""
        values = [record.planning_ms for record in self.records if record.attempts > 0]
        if not values:
            return {"p50": 0.0, "p95": 0.0}
        p50, p95 = np.percentile(values, (50, 95))
        return {"p50": round(float(p50), 1), "p95": round(float(p95), 1)}

    def realtime_factor(self) -> float:
        """Median over the episodes."""
        values = [record.realtime_factor for record in self.records if record.realtime_factor > 0.0]
        return float(np.median(values)) if values else 0.0

    def _errors(self) -> int:
        return sum(record.outcome == "error" for record in self.records)


def _share(values: Any) -> float:
    listed = [bool(value) for value in values]
    return sum(listed) / len(listed) if listed else 0.0


def _finite(value: Any) -> Any:
    if isinstance(value, float):
        return round(value, 6) if math.isfinite(value) else None
    return value
