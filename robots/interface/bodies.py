"""How a body that is not simulated is attached: a function, found by its entry point.

A package declares it::

    [project.entry-points."humanoid_executive.bodies"]
    mine = "my_package.body:attach"
"""

from __future__ import annotations

import difflib
import importlib.metadata
from collections.abc import Mapping
from typing import Protocol, cast

from robots.clock import Clock
from robots.errors import RobotsError
from robots.interface.hardware import RobotData
from robots.interface.robot import Robot
from robots.outside import BODIES


class BodyError(RobotsError):
    """A body that cannot be attached: none has that name, it lacks a library, or an option is wrong."""


class AttachBody(Protocol):
    """Attaches a body: it can be read and commanded when this returns."""

    def __call__(self, data: RobotData, clock: Clock, options: Mapping[str, str]) -> Robot:
        """Attach it.

        Args:
            data: The robot's.
            clock: Time from outside: a real body's time passes by itself.
            options: Its own, as a user gave them, "interface": "eth0".

        Raises:
            BodyError: A library is missing, or an option is none of its own.
            RobotsError: Nobody answers.
        """
        ...


def body_named(name: str) -> AttachBody:
    """The function that attaches bodies of a kind.

    Raises:
        BodyError: There is none of that name, or it cannot be imported.
    """
    points = {point.name: point for point in importlib.metadata.entry_points(group=BODIES)}
    if name not in points:
        close = difflib.get_close_matches(name, points, n=1, cutoff=0.0)
        raise BodyError(f"no body {name!r}{f'; the nearest is {close[0]!r}' if close else ''}")
    try:
        return cast(AttachBody, points[name].load())
    except Exception as broken:  # a package that cannot be imported may raise anything
        raise BodyError(f"body {name!r}: {type(broken).__name__}: {broken}") from broken


def require_known(options: Mapping[str, str], known: tuple[str, ...]) -> None:
    """Refuse an option that a body does not have.

    Raises:
        BodyError: There is one; the message names the nearest.
    """
    for name in options:
        if name not in known:
            nearest = difflib.get_close_matches(name, known, n=1, cutoff=0.0)[0]
            raise BodyError(f"unknown option {name!r} of the body; the nearest is {nearest!r}")
