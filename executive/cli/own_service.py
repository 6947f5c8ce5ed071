"""A robot that is served for one command: got ready, or given up where a signal ends the command before."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from pathlib import Path


def serve_meanwhile(
    options: Sequence[str], say: Callable[[str], None], closing: ExitStack, listeners: int = 0
) -> Path:
    """Have a robot served until the end of a context; returns the folder of its sockets.

    Args:
        options: Of ``executive serve``: robot, scene, seed and the like.
        say: Takes what it tells.
        closing: Ends it, at rest.
        listeners: So many have to listen to what it tells before it counts as ready.

    Raises:
        OwnRobotError: It ended before it was ready, or does not begin.
        EndedBySignal: A signal came before it was ready.
    """
    from executive.doors.own_robot import OwnRobot
    from executive.ending_signals import EndedBySignal, taken_by, told

    signals: list[int] = []
    with taken_by(signals.append):
        own = closing.enter_context(OwnRobot(options, say))
        own.wait(lambda: bool(signals), listeners)
    if signals:
        raise EndedBySignal(told(signals[0], "cancelled"))
    return own.folder
