"""What one pick with a planted disagreement gave, and what many together say."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from tools.evaluate.records import Bar

NOTICED_BAR = 0.90
FALSE_ALARM_BAR = 0.02


@dataclass(frozen=True, slots=True)
class FusionRecord:
    """One episode.

    Attributes:
        seed: Of the episode.
        planted: What was planted; "none".
        fired: Whether its moment came.
        noticed, said: Reasons by which disagreements were told, and the sentences.
        outcome: What the executive said: "done", "failed", ...
        truth: Whether the thing really was lifted and held at the end.
        told: Whether a person was told that something is not as it should be.
        attempts: Grasps that were tried.
        fell: Whether the robot fell.
        failure: The chain in one line, or empty.
        error: A traceback, when the evaluation broke.
    """

    seed: int
    planted: str
    fired: bool = False
    noticed: tuple[str, ...] = ()
    said: tuple[str, ...] = ()
    outcome: str = ""
    truth: bool = False
    told: bool = False
    attempts: int = 0
    fell: bool = False
    failure: str = ""
    error: str | None = None

    @property
    def is_planted(self) -> bool:
        """Whether something was planted, and its moment came."""
        return self.fired

    @property
    def recovered(self) -> bool:
        """Whether the thing was picked up all the same."""
        return self.outcome == "done" and self.truth

    @property
    def faults(self) -> tuple[str, ...]:
        """Which demands it broke."""
        broken = {
            "broken": self.error is not None,
            "not noticed": self.is_planted and not self.noticed,
            "false alarm": self.error is None and not self.is_planted and bool(self.noticed),
            "false success": self.outcome == "done" and not self.truth,
            "neither recovered nor told": self.is_planted and not self.recovered and not self.told,
            "fell": self.fell,
        }
        return tuple(name for name, is_so in broken.items() if is_so)


class FusionSummary:
    """What the episodes say together."""

    def __init__(self, seed: int, own_m: float, records: Sequence[FusionRecord]) -> None:
        self.seed, self.own_m, self.records = seed, own_m, records

    def bars(self) -> list[Bar]:
        """The demands."""
        broken = Counter(name for record in self.records for name in record.faults)
        planted = sum(record.is_planted for record in self.records)
        clean = len(self.records) - planted
        noticed = 1.0 - broken["not noticed"] / planted if planted else 1.0
        alarms = broken["false alarm"] / clean if clean else 0.0
        return [
            Bar(f"noticed, of {planted}", f"{noticed:.1%}", f"≥ {NOTICED_BAR:.0%}", noticed >= NOTICED_BAR),
            Bar(
                f"false alarms, of {clean}",
                f"{alarms:.1%}",
                f"≤ {FALSE_ALARM_BAR:.0%}",
                alarms <= FALSE_ALARM_BAR,
            ),
            *(
                Bar(name, str(broken[name]), "0", broken[name] == 0)
                for name in ("false success", "neither recovered nor told", "fell", "broken")
            ),
        ]

    def figures(self) -> dict[str, float]:
        """Numbers worth knowing."""
        told: dict[str, float] = {"declared error of each thing's own, mm": 1e3 * self.own_m}
        for kind in sorted({record.planted for record in self.records}):
            of_kind = [record for record in self.records if record.planted == kind]
            told[f"{kind}, of {len(of_kind)}, noticed"] = float(sum(bool(one.noticed) for one in of_kind))
            told[f"{kind}, of {len(of_kind)}, picked up"] = float(sum(one.recovered for one in of_kind))
        return told

    def to_json(self) -> dict[str, Any]:
        """The evaluation's document."""
        return {
            "suite": "fusion",
            "seed": self.seed,
            "bars": [asdict(bar) for bar in self.bars()],
            "figures": self.figures(),
            "records": [{**asdict(record), "faults": list(record.faults)} for record in self.records],
        }
