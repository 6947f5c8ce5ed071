"""Draw how many pushes were survived, by force: ``python -m tools.pictures.draw_pushes push.json
pushes.svg``.
"""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

BIN_N = 50.0
_WIDTH, _HEIGHT = 640.0, 360.0
_LEFT, _RIGHT, _TOP, _BOTTOM = 60.0, 200.0, 24.0, 48.0
_LINES = (
    ("standing", None, "#1b6ca8"),
    ("walking", "ahead or back", "#c8553d"),
    ("walking", "sideways", "#588157"),
)


def curves(records: Sequence[Mapping[str, Any]]) -> dict[str, list[tuple[float, int, int]]]:
    """For each gait and side: force in the middle of a bin, pushes that were survived, and all of them.

    Args:
        records: Episodes of the suite ``push``, as its JSON holds them; pushes at the torso are left out.
    """
    found: dict[str, list[tuple[float, int, int]]] = {}
    for gait, side, _ in _LINES:
        bins: dict[int, list[bool]] = {}
        for record in records:
            numbers = record["numbers"]
            mine = numbers.get("gait") == gait and side in (None, numbers.get("side"))
            if mine and numbers["at"] == "pelvis":
                bins.setdefault(math.floor(numbers["force_n"] / BIN_N), []).append(bool(record["truth"]))
        name = gait if side is None else f"{gait}, {side}"
        found[name] = [(BIN_N * (k + 0.5), sum(bins[k]), len(bins[k])) for k in sorted(bins)]
    return found


def picture(records: Sequence[Mapping[str, Any]]) -> str:
    """The curves as an SVG; a dot is a bin, its number how many pushes are in it."""
    lines = curves(records)
    most_n = BIN_N * math.ceil(max((f for line in lines.values() for f, _, _ in line), default=BIN_N) / BIN_N)

    def at(force_n: float, share: float) -> tuple[float, float]:
        x = _LEFT + force_n / most_n * (_WIDTH - _LEFT - _RIGHT)
        return round(x, 1), round(_TOP + (1.0 - share) * (_HEIGHT - _TOP - _BOTTOM), 1)

    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH:g} {_HEIGHT:g}" '
        'font-family="sans-serif" font-size="12">'
        f'<rect width="{_WIDTH:g}" height="{_HEIGHT:g}" fill="white"/>'
    ]
    for share in (0.0, 0.25, 0.5, 0.75, 1.0):
        (x, y), (end, _) = at(0.0, share), at(most_n, share)
        parts.append(f'<path d="M{x} {y}H{end}" stroke="#ddd"/>')
        parts.append(f'<text x="{x - 8}" y="{y + 4}" text-anchor="end">{share:.0%}</text>')
    for k in range(0, int(most_n) + 1, 100):
        x, y = at(k, 0.0)
        parts.append(f'<text x="{x}" y="{y + 18}" text-anchor="middle">{k}</text>')
    x, y = at(0.5 * most_n, 0.0)
    parts.append(f'<text x="{x}" y="{y + 38}" text-anchor="middle">push at the pelvis for 0.1 s, N</text>')
    for k, ((name, line), (_, _, color)) in enumerate(zip(lines.items(), _LINES, strict=True)):
        places = [at(force_n, stood / count) for force_n, stood, count in line]
        if places:
            way = " ".join(f"{'M' if i == 0 else 'L'}{px} {py}" for i, (px, py) in enumerate(places))
            parts.append(f'<path d="{way}" fill="none" stroke="{color}" stroke-width="2"/>')
        for (px, py), (_, _, count) in zip(places, line, strict=True):
            parts.append(f'<circle cx="{px}" cy="{py}" r="4" fill="{color}"/>')
            low = py + 16 + 11 * k
            look = f'text-anchor="middle" font-size="9" fill="{color}"'
            parts.append(f'<text x="{px}" y="{low}" {look}>{count}</text>')
        row = _TOP + 18.0 * (k + 1)
        parts.append(f'<text x="{_WIDTH - _RIGHT + 14:g}" y="{row:g}" fill="{color}">{name}</text>')
    parts.append("</svg>")
    return "\n".join(parts) + "\n"


def main(arguments: Sequence[str] | None = None) -> int:
    """Read an evaluation, write a picture."""
    parser = argparse.ArgumentParser(prog="python -m tools.pictures.draw_pushes", description=__doc__)
    parser.add_argument("evaluation", type=Path, metavar="FILE.json")
    parser.add_argument("picture", type=Path, metavar="FILE.svg")
    options = parser.parse_args(arguments)
    records = json.loads(options.evaluation.read_text("utf-8"))["episodes_detail"]
    options.picture.write_text(picture(records), "utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
