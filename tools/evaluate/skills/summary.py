"""What the episodes of a skill say together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tools.evaluate.records import FALSE_FAILURE_BAR, SUCCESS_BAR, Bar, Summary
from tools.evaluate.skills.registry import SKILL_SUITES


@dataclass(frozen=True, slots=True)
class SkillSummary(Summary):
    """The demands on a household skill."""

    def bars(self) -> list[Bar]:
        """Truth, claims, falls, contacts and balance; under a fault, only what must never happen."""
        count = len(self.records)
        errors = sum(record.outcome == "error" for record in self.records)
        share = self.false_failure / max(count, 1)
        wanted = SKILL_SUITES[self.suite].bar if self.suite in SKILL_SUITES else SUCCESS_BAR
        done = Bar("truly done", f"{self.success_rate:.1%}", f"≥ {wanted:.0%}", self.success_rate >= wanted)
        return [
            *([] if self.fault is not None else [done]),
            Bar("claimed, and not so", str(self.false_success), "0", self.false_success == 0),
            Bar(
                "so, and not claimed",
                f"{share:.1%}",
                f"≤ {FALSE_FAILURE_BAR:.0%}",
                share <= FALSE_FAILURE_BAR,
            ),
            Bar("falls", str(self.falls), "0", self.falls == 0),
            Bar(
                "episodes with furniture or people touched",
                str(self.unwanted_contacts),
                "0",
                not self.unwanted_contacts,
            ),
            *self.balance(),
            Bar("broken episodes", str(errors), "0", errors == 0),
        ]

    def planning_ms(self) -> dict[str, float]:
        """Median and 95th percentile of the processor time of an attempt's planning."""
        values = [record.planning_ms for record in self.records if record.planning_ms > 0.0]
        if not values:
            return {"p50": 0.0, "p95": 0.0}
        p50, p95 = np.percentile(values, (50, 95))
        return {"p50": round(float(p50), 1), "p95": round(float(p95), 1)}
