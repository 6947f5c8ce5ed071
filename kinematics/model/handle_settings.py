"""How a robot holds handles and pushes fronts, and where it stands for it: data of its description."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class BarGrip:
    """How a hand takes hold of a bar. The defaults are those of pads that close on either side of it.

    Attributes:
        approach_rad: How far the way on which the left hand comes to the bar is turned from x about the TCP's
            z: a palm is laid on the bar, and the fingers close behind it.
        along_m: Where along the fingers, from the TCP, the bar is to be when they close on it.
        turns_rad: How far the hand is turned about the bar, away from the hinge of a door, against coming to
            it squarely; what lets the arm follow farthest comes first.
        spin: Weight of the hand's turn about the bar while a door is led: pads leave it nearly open, fingers
            that are around the bar meet the door unless they turn with it.
    """

    approach_rad: float = 0.0
    along_m: float = 0.0
    turns_rad: tuple[float, float, float, float] = (
        math.radians(20),
        math.radians(0),
        math.radians(40),
        math.radians(-20),
    )
    spin: float = 0.001


@dataclass(frozen=True, slots=True)
class HandleStanding:
    """Where a robot stands to open or close something. The defaults are TALOS's: docs/notes/doors.md.

    Attributes:
        hinge_ahead_m, hinge_aside_m, door_turned_rad: The plane of a door's hinge ahead, the hinge to the
            side of the hand, and the door turned towards it.
        upright_aside_m: A door's bar to that side, for arms whose reach decides, not the door's width: the
            hinge is then wherever it is. None where ``hinge_aside_m`` says it.
        bar_ahead_m, bar_aside_m: A drawer's bar, before the shoulder.
        near_m, near_rad: A robot that stands so near to the place does not walk: the planner says whether the
            handle is in reach.
    """

    hinge_ahead_m: float = 0.80
    hinge_aside_m: float = 0.75
    door_turned_rad: float = 0.15
    upright_aside_m: float | None = None
    bar_ahead_m: float = 0.66
    bar_aside_m: float = 0.34
    near_m: float = 0.22
    near_rad: float = 0.25


@dataclass(frozen=True, slots=True)
class Pushing:
    """How a robot pushes shut what is open. The defaults are TALOS's.

    Attributes:
        places_m: On a door: distance from the hinge and height, clear of where handles are, the best first.
        drawers: Whether it pushes drawers too; else it closes them by their handles.
        past_rad: A door is led so far beyond where it is shut: its frame stops it before, and which part of
            the hand touches it there is not known to some centimetres.
        before_m: It stands so far before the front as it is; None where it stands as to open it.
        beyond_hinge_m: And so far beyond a door's hinge: an open door looks to that side.
        heading_weight: How much it matters that the hand keeps its heading, nearly square to the front when
            that is shut: one that turns slides along it. None where the hand turns as it likes.
        button_past_m: What presses a button is led so far beyond where that was seen: what is behind it stops
            the hand, and a soft arm gives way by more than a stiff one before it presses hard enough.
    """

    places_m: tuple[tuple[float, float], ...] = (
        (0.40, 1.05),
        (0.30, 1.05),
        (0.48, 1.38),
        (0.36, 1.25),
        (0.24, 1.05),
    )
    drawers: bool = False
    past_rad: float = 0.12
    before_m: float | None = None
    beyond_hinge_m: float = 0.0
    heading_weight: float | None = None
    button_past_m: float = 0.02


PADS_ON_A_BAR, FAR_REACH, AS_IT_OPENS = BarGrip(), HandleStanding(), Pushing()
"""What counts where a robot's data say nothing."""
