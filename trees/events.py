"""What a running tree tells: frozen values, put into a sink."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from trees.failures import Failure, Number


@dataclass(frozen=True, slots=True)
class NodeChanged:
    """A node's status changed."""

    t_s: float
    where: str
    status: str
    message: str


@dataclass(frozen=True, slots=True)
class LeafFailed:
    """A leaf has failed; the tree may still find another way."""

    t_s: float
    failure: Failure


@dataclass(frozen=True, slots=True)
class NotSo:
    """A leaf that only asks whether something is so has found that it is not; nothing has gone wrong."""

    t_s: float
    failure: Failure


@dataclass(frozen=True, slots=True)
class Measured:
    """A leaf measured something worth keeping as evidence or timing."""

    t_s: float
    where: str
    numbers: Mapping[str, Number]


@dataclass(frozen=True, slots=True)
class Said:
    """The robot said something; ``to`` names the person, empty when it is for everybody."""

    t_s: float
    text: str
    to: str = ""


@dataclass(frozen=True, slots=True)
class Offered:
    """A hand holds something out to somebody from now on."""

    t_s: float
    what: str
    to: str


@dataclass(frozen=True, slots=True)
class ThingPictured:
    """What a person is asked about, as the camera shows it.

    Attributes:
        t_s: When it was asked.
        what: What it may be.
        png_base64: The part of the picture that shows it.
    """

    t_s: float
    what: str
    png_base64: str


TreeEvent = NodeChanged | LeafFailed | NotSo | Measured | Said | Offered | ThingPictured
TreeSink = Callable[[TreeEvent], None]
