"""What many judged pictures say together: demands, figures, calibration."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from tools.evaluate.perception.judge import VISIBLE, PictureRecord, ThingRecord
from tools.evaluate.records import Bar

BINS = 10
_COLOR_BARS = {"bright": 0.95, "dim": 0.90, "warm": 0.90}
_WORST = 10


@dataclass(frozen=True, slots=True)
class PerceptionSummary:
    """Judged pictures."""

    records: Sequence[PictureRecord]

    @property
    def _things(self) -> list[ThingRecord]:
        return [thing for record in self.records for thing in record.things]

    @property
    def _counted(self) -> list[ThingRecord]:
        """True things of which enough is in sight."""
        return [thing for thing in self._things if thing.name and thing.visible >= VISIBLE]

    def bars(self) -> list[Bar]:
        """The demands."""
        counted, told = self._counted, [thing for thing in self._things if thing.found]
        found = [thing for thing in counted if thing.found]
        position = [1e3 * thing.position_m for thing in found]
        size = [1e3 * value for thing in found for value in thing.size_m]
        false = sum(not thing.name for thing in told)
        looked = [1e3 * record.looked_s for record in self.records if not record.broken]
        bars = [
            _least("recall", _share(len(found), len(counted)), 0.98),
            _most("false things", _share(false, len(told)), 0.01),
            *_spread("position", position, 5.0, 12.0, "mm"),
            *_spread("size", size, 3.0, 9.0, "mm"),
            *(
                _least(f"colour, {light} light", self._colors_right(light), least)
                for light, least in _COLOR_BARS.items()
                if any(record.light == light for record in self.records)
            ),
            _error("expected calibration error", self.calibration_error(), 0.05),
            *_spread("processor time of a picture", looked, 70.0, 150.0, "ms"),
        ]
        broken = sum(bool(record.broken) for record in self.records)
        return [*bars, Bar("broken pictures", str(broken), "0", broken == 0)]

    def figures(self) -> Mapping[str, float]:
        """Numbers worth knowing."""
        counted = self._counted
        whole = [thing for thing in counted if not thing.cut]
        found = [thing for thing in whole if thing.found]
        figures = {
            "things": float(len(counted)),
            "of them cut by the picture's edge": float(len(counted) - len(whole)),
            "recall of whole ones": _share(len(found), len(whole)),
            "kind right": _share(sum(thing.kind == thing.told_kind for thing in found), len(found)),
            "kind right or alike": _share(
                sum(thing.kind in (thing.told_kind, *thing.alike) for thing in found), len(found)
            ),
        }
        if any(record.light == "side" for record in self.records):
            figures["colour, light from the side"] = self._colors_right("side")
        for name, values in zip(
            ("height of the table mm", "near edge of the table mm"),
            np.array([record.table_m for record in self.records]).T * 1e3,
            strict=True,
        ):
            off = np.abs(values[np.isfinite(values)])
            if len(off):
                figures[f"{name}, p95"] = round(float(np.percentile(off, 95.0)), 1)
        return {name: round(value, 4) for name, value in figures.items()}

    def calibration(self) -> list[tuple[float, float, int]]:
        """Mean confidence, share that was right, and count, of each of ``BINS`` bins that is not empty."""
        told = [thing for thing in self._things if thing.found]
        bins: dict[int, list[ThingRecord]] = {}
        for thing in told:
            bins.setdefault(min(int(thing.confidence * BINS), BINS - 1), []).append(thing)
        return [
            (
                float(np.mean([thing.confidence for thing in some])),
                float(np.mean([thing.right for thing in some])),
                len(some),
            )
            for _, some in sorted(bins.items())
        ]

    def calibration_error(self) -> float:
        """Mean distance of confidence and share that was right, by bins."""
        bins = self.calibration()
        total = max(sum(count for _, _, count in bins), 1)
        return sum(count * abs(sure - right) for sure, right, count in bins) / total

    def confusions(self) -> list[tuple[str, str, int]]:
        """Colours that were told for others, the most frequent first."""
        wrong = Counter(
            (str(thing.color), str(thing.told_color))
            for thing in self._counted
            if thing.found and thing.color != thing.told_color
        )
        return [(true, told, count) for (true, told), count in wrong.most_common(_WORST)]

    def worst(self) -> list[PictureRecord]:
        """The pictures that went worst, the worst first."""
        return sorted(self.records, key=_badness, reverse=True)[:_WORST]

    def to_json(self) -> dict[str, Any]:
        """The evaluation's document."""
        return {
            "suite": "perception",
            "pictures": len(self.records),
            "bars": [asdict(bar) for bar in self.bars()],
            "figures": dict(self.figures()),
            "calibration": self.calibration(),
            "colors": self.confusions(),
            "worst": [{"seed": record.seed, "badness": _badness(record)} for record in self.worst()],
        }

    def _colors_right(self, light: str) -> float:
        found = [
            thing
            for record in self.records
            if record.light == light
            for thing in record.things
            if thing.name and thing.found and thing.visible >= VISIBLE
        ]
        return _share(sum(thing.color == thing.told_color for thing in found), len(found))


def _badness(record: PictureRecord) -> float:
    bad = 10.0 if record.broken else 0.0
    for thing in record.things:
        if not thing.name:
            bad += 1.0 + thing.confidence
        elif thing.visible >= VISIBLE:
            bad += 0.0 if thing.found else 2.0
            bad += 0.5 * (thing.found and thing.color != thing.told_color)
            bad += 0.5 * (thing.found and thing.kind != thing.told_kind)
            bad += min(thing.position_m / 0.02, 2.0) ** 2 * 0.5
    return bad


def _share(some: int, of: int) -> float:
    return some / of if of else math.nan


def _least(name: str, value: float, limit: float) -> Bar:
    return Bar(name, f"{100.0 * value:.1f}%", f"≥ {100.0 * limit:g}%", value >= limit)


def _most(name: str, value: float, limit: float) -> Bar:
    return Bar(name, f"{100.0 * value:.2f}%", f"≤ {100.0 * limit:g}%", value <= limit)


def _error(name: str, value: float, limit: float) -> Bar:
    return Bar(name, f"{value:.3f}", f"≤ {limit:g}", value <= limit)


def _spread(name: str, values: Sequence[float], median: float, p95: float, unit: str) -> list[Bar]:
    half, most = (float(np.percentile(values, share)) if values else math.nan for share in (50.0, 95.0))
    return [
        Bar(f"{name}, median", f"{half:.1f} {unit}", f"≤ {median:g} {unit}", half <= median),
        Bar(f"{name}, p95", f"{most:.1f} {unit}", f"≤ {p95:g} {unit}", most <= p95),
    ]
