"""What a terminal shows while a person jogs the robot, as plain lines for any width."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from executive.manual.keys import ANGULAR_RAD_S, BASE_M_S, BASE_SHARE, JOINT_RAD_S, LINEAR_M_S, Jogged, Mode

_OWN: Mapping[Mode, tuple[str, ...]] = MappingProxyType(
    {
        "hand": (
            "up down forward, back   left right   ; up   . down",
            "j l turn left, right   i k nod   u o roll   w world   e tool   q base",
        ),
        "joints": ("1-7 joints of the arm, shoulder to wrist   r the other way",),
        "base": ("i forward   , back   j l turn   u o m . arcs   k stand",),
    }
)
_ALL = (
    "h hand   n joints   b base   x other hand   z speed   s step or hold",
    "g close   f open fingers   [ ] - = head   p fingers may touch",
    "space brake   enter give back",
)
_INDENT, _MOST_LINES = 8, 3
_ENDING = (
    "1 it is in the right hand   2 it is in the left hand",
    "3 go on by yourself   4 give up   space jog on",
)
"""What is asked when the robot is given back."""


@dataclass(frozen=True, slots=True)
class JogScreen:
    """What is shown.

    Attributes:
        task: What the robot was told to do, or nothing.
        jogged: What the person has chosen.
        held_back: What holds the robot back, or nothing.
        line: What was said last by the robot.
        ending: Whether the person is asked what is so.
    """

    task: str
    jogged: Jogged
    held_back: str = ""
    line: str = ""
    ending: bool = False


def jog_lines(screen: JogScreen, width: int = 80) -> list[str]:
    """The lines, none wider than the terminal."""
    jogged = screen.jogged
    held = f"back: {screen.held_back}" if screen.held_back else "back by nothing"
    lines = [
        *_told("task", screen.task or "none", width),
        *_told("jog", f"{_moved(jogged)}, {jogged.pace}: {_speed(jogged)}, {_manner(jogged)}", width),
        *_told("held", held, width),
        *(_told("robot", screen.line, width) if screen.line else ()),
    ]
    if screen.ending:
        lines += [f"{'what is so?' if k == 0 else '':13}{line}" for k, line in enumerate(_ENDING)]
    else:
        lines += [f"{'keys' if k == 0 else '':8}{line}" for k, line in enumerate(_OWN[jogged.mode])]
        lines += [f"{'always' if k == 0 else '':8}{line}" for k, line in enumerate(_ALL)]
    return [line if len(line) <= width else line[: max(width - 1, 0)] + "~" for line in lines]


def _told(head: str, text: str, width: int) -> list[str]:
    """A line with its head, or more where it is wider than the terminal: none of a reason is lost."""
    plain = "".join(one if one.isprintable() else " " for one in text)
    told = textwrap.wrap(plain, max(width - _INDENT, 1), max_lines=_MOST_LINES, placeholder=" ~")
    return [f"{head if k == 0 else '':{_INDENT}}{line}" for k, line in enumerate(told or [""])]


def _moved(jogged: Jogged) -> str:
    match jogged.mode:
        case "hand":
            return f"{jogged.hand} hand along the {jogged.frame}'s axes"
        case "joints":
            return f"joints of the {jogged.hand} arm{', reversed' if jogged.reversed else ''}"
        case "base":
            return "base"


def _speed(jogged: Jogged) -> str:
    match jogged.mode:
        case "hand":
            return f"{LINEAR_M_S[jogged.pace]:g} m/s, {ANGULAR_RAD_S[jogged.pace]:g} rad/s"
        case "joints":
            return f"{JOINT_RAD_S[jogged.pace]:g} rad/s"
        case "base":
            return f"{BASE_SHARE[jogged.pace] * BASE_M_S:.2g} m/s"


def _manner(jogged: Jogged) -> str:
    manner = "step" if jogged.steps else "hold"
    return manner + (", fingers may touch" if jogged.may_touch else "")
