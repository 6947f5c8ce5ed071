"""Draw a robot's reachability map: ``python -m tools.pictures.draw_reachability talos reachability.svg``."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from kinematics.model.reachability import ReachabilityMap
from robots.models.description import load_description

HEIGHTS_M = (0.4, 0.7, 0.9, 1.2)
_PIXELS_M = 110.0
_LEFT, _TOP, _GAP = 90.0, 40.0, 16.0
_DARK = (11, 79, 108)


def picture(found: ReachabilityMap, heights_m: Sequence[float] = HEIGHTS_M) -> str:
    """The map as an SVG: a row for each hand, a panel for each height, ahead is up and left is left.

    Args:
        found: The map.
        heights_m: Of the panels.
    """
    cell = _PIXELS_M * found.ahead.step_m
    wide, deep = cell * found.aside.count, cell * found.ahead.count
    # the middle between the feet is below the grid's first row
    behind = _PIXELS_M * found.ahead.first_m
    width = _LEFT + len(heights_m) * (wide + _GAP)
    height = _TOP + len(found.shares) * (deep + behind + _GAP)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" '
        'font-family="sans-serif" font-size="12">'
        f'<rect width="{width:.0f}" height="{height:.0f}" fill="white"/>'
    ]
    for row, hand in enumerate(found.shares):
        top = _TOP + row * (deep + behind + _GAP)
        parts.append(f'<text x="8" y="{top + 0.5 * deep:.0f}">{hand} hand</text>')
        for column, z_m in enumerate(heights_m):
            left = _LEFT + column * (wide + _GAP)
            if row == 0:
                parts.append(
                    f'<text x="{left + 0.5 * wide:.0f}" y="24" text-anchor="middle">{z_m:g} m</text>'
                )
            for i, x_m in enumerate(found.ahead.values_m()):
                for j, y_m in enumerate(found.aside.values_m()):
                    x = left + (found.aside.count - 1 - j) * cell
                    y = top + (found.ahead.count - 1 - i) * cell
                    fill = _colour(found.share(hand, x_m, y_m, z_m))
                    parts.append(
                        f'<path d="M{x:.1f} {y:.1f}h{cell:.1f}v{cell:.1f}h-{cell:.1f}z" fill="{fill}"/>'
                    )
            feet = left + (found.aside.count - 1 + found.aside.first_m / found.aside.step_m + 0.5) * cell
            parts.append(
                f'<circle cx="{feet:.1f}" cy="{top + deep - 0.5 * cell + behind:.1f}" r="4" fill="#c8553d"/>'
            )
    parts.append("</svg>")
    return "\n".join(parts) + "\n"


def _colour(share: float) -> str:
    """White for nothing, dark for everything."""
    mixed = (round(255 - share * (255 - part)) for part in _DARK)
    return "#" + "".join(f"{part:02x}" for part in mixed)


def main() -> None:
    """Draw a robot's map."""
    parser = argparse.ArgumentParser(prog="tools.pictures.draw_reachability", description=__doc__)
    parser.add_argument("robot")
    parser.add_argument("svg", type=Path)
    chosen = parser.parse_args()
    found = load_description(chosen.robot).reachability
    if found is None:
        parser.error(f"{chosen.robot} has no reachability map; tools.robot_data.reachability_map makes one")
    chosen.svg.write_text(picture(found), "utf-8")


if __name__ == "__main__":
    main()
