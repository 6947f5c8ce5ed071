"""The file that holds a robot's reachability map: ``robots/models/<name>/reachability.toml``.

It can be read by eye: each height is a picture from above, ahead of the robot is up, its left is left; a
digit is a share in ninths, a dot nothing. ``tools.robot_data.reachability_map`` makes it.
"""

from __future__ import annotations

from typing import Any

from kinematics.model.reachability import Cells, GridAxis, ReachabilityMap
from kinematics.model.robot_description import HANDS
from robots.errors import DescriptionError
from robots.toml_text import read_toml

REACHABILITY = "reachability.toml"
SCHEMA = 1
_MOST = 9
_NOTHING = "."


def reachability_text(found: ReachabilityMap, robot: str, command: str) -> str:
    """The file's text.

    Args:
        found: The map.
        robot: Whose it is.
        command: What makes it.
    """
    lines = [
        f"# How well {robot} reaches what is around it, standing at home; made by",
        f"# {command}",
        "# Each picture is seen from above, the robot below its middle: ahead is up, its left is left. A",
        "# digit is the share of directions, in ninths, in which the hand gets there; a dot is nothing.",
        f"schema = {SCHEMA}",
        "# first value, step and count, m, from the middle between the feet, on the floor",
    ]
    for name in ("ahead", "aside", "height"):
        axis: GridAxis = getattr(found, name)
        lines.append(f"{name} = [{axis.first_m:g}, {axis.step_m:g}, {axis.count}]")
    for hand, cells in found.shares.items():
        lines.append(f"\n{hand} = [")
        for z_m, layer in zip(found.height.values_m(), cells, strict=True):
            rows = ["".join(_digit(share) for share in reversed(row)) for row in reversed(layer)]
            lines += [f"# {z_m:.2f} m", '"""', *rows, '""",']
        lines.append("]")
    return "\n".join(lines) + "\n"


def read_reachability(text: str) -> ReachabilityMap:
    """The map of a file's text.

    Raises:
        DescriptionError: It is no such file, or of another schema, or a picture does not fit its grid.
    """
    try:
        data = read_toml(text)
        axes = [GridAxis(float(a), float(b), int(n)) for a, b, n in (data[k] for k in _AXES)]
    except (KeyError, TypeError, ValueError) as wrong:
        raise DescriptionError(f"{REACHABILITY} cannot be read: {wrong}") from wrong
    if data.get("schema") != SCHEMA:
        raise DescriptionError(
            f"{REACHABILITY} has schema {data.get('schema')!r}, not {SCHEMA}; make it anew"
        )
    ahead, aside, height = axes
    shares: dict[str, Cells] = {
        hand: _cells(data[hand], hand, ahead, aside, height) for hand in HANDS if hand in data
    }
    return ReachabilityMap(ahead, aside, height, shares)


_AXES = ("ahead", "aside", "height")


def _cells(pictures: Any, hand: str, ahead: GridAxis, aside: GridAxis, height: GridAxis) -> Cells:
    layers = []
    for picture in pictures:
        rows = str(picture).split()
        if len(rows) != ahead.count or any(len(row) != aside.count for row in rows):
            raise DescriptionError(
                f"{REACHABILITY}: a picture of the {hand} hand is not {ahead.count} by {aside.count}"
            )
        layers.append(tuple(tuple(_share(sign, hand) for sign in reversed(row)) for row in reversed(rows)))
    if len(layers) != height.count:
        raise DescriptionError(
            f"{REACHABILITY}: the {hand} hand has {len(layers)} heights, not {height.count}"
        )
    return tuple(layers)


def _digit(share: float) -> str:
    ninths = round(_MOST * share)
    return str(ninths) if ninths else _NOTHING


def _share(sign: str, hand: str) -> float:
    if sign == _NOTHING:
        return 0.0
    if not sign.isdecimal():
        raise DescriptionError(f"{REACHABILITY}: {sign!r} in a picture of the {hand} hand is no digit")
    return int(sign) / _MOST
