"""Furniture that only carries: a shelf with its boards, a kitchen counter.

In the furniture's own frame (origin in its centre on the floor, x along its depth) the front is at
negative x, as of everything that a robot stands before.
"""

from __future__ import annotations

from robots.scene_description import Furniture

BOARD_KINDS = ("counter", "shelf")

BOARD_M = 0.02
"""Thickness of a shelf's boards and sides."""
PITCH_M = 0.40
"""From board to board, about: room for a bottle and a hand above it."""
WORKTOP_M = 0.04
OVERHANG_M = 0.03
"""A worktop stands out so far before what carries it: room for a thigh."""
PLINTH_HEIGHT_M, PLINTH_M = 0.10, 0.09
"""What carries a counter draws back so far at the floor: room for toes."""

Boxes = list[tuple[str, tuple[float, float, float], tuple[float, float, float]]]


def board_tops_m(item: Furniture) -> tuple[float, ...]:
    """Heights above the floor at which things can stand, the lowest first.

    A shelf has a board at its foot and one at its top, and others between them about ``PITCH_M`` apart;
    all else carries on its top alone.
    """
    height = item.size_m[2]
    if item.kind != "shelf":
        return (height,)
    rooms = max(1, round((height - BOARD_M) / PITCH_M))
    return tuple(BOARD_M + (height - BOARD_M) * k / rooms for k in range(rooms + 1))


def board_boxes(item: Furniture) -> Boxes:
    """The solids of a shelf or counter: part, size, and centre in its frame; the top first."""
    return _shelf(item) if item.kind == "shelf" else _counter(item)


def _shelf(item: Furniture) -> Boxes:
    depth, width, height = item.size_m
    *inner, top = board_tops_m(item)
    between, below = width - 2.0 * BOARD_M, height - BOARD_M
    y = 0.5 * (width - BOARD_M)
    return [
        ("top", (depth, width, BOARD_M), (0.0, 0.0, top - 0.5 * BOARD_M)),
        *(
            (f"board_{k}", (depth - BOARD_M, between, BOARD_M), (-0.5 * BOARD_M, 0.0, z - 0.5 * BOARD_M))
            for k, z in enumerate(inner)
        ),
        ("left", (depth, BOARD_M, below), (0.0, y, 0.5 * below)),
        ("right", (depth, BOARD_M, below), (0.0, -y, 0.5 * below)),
        ("back", (BOARD_M, between, below), (0.5 * (depth - BOARD_M), 0.0, 0.5 * below)),
    ]


def _counter(item: Furniture) -> Boxes:
    depth, width, height = item.size_m
    body, plinth = depth - OVERHANG_M, depth - PLINTH_M
    rise = height - WORKTOP_M - PLINTH_HEIGHT_M
    return [
        ("top", (depth, width, WORKTOP_M), (0.0, 0.0, height - 0.5 * WORKTOP_M)),
        ("body", (body, width, rise), (0.5 * OVERHANG_M, 0.0, PLINTH_HEIGHT_M + 0.5 * rise)),
        ("plinth", (plinth, width, PLINTH_HEIGHT_M), (0.5 * PLINTH_M, 0.0, 0.5 * PLINTH_HEIGHT_M)),
    ]
