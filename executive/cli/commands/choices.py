"""Options that several commands share."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from robots.models.usual_scene import USUAL_SCENE


def number_from(low: float, high: float) -> Callable[[str | float], float]:
    """A reader of numbers in a range; typer hands it defaults as numbers."""

    def read(text: str | float) -> float:
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not low <= value <= high:
            raise typer.BadParameter(f"{text!r} is not a number from {low:g} to {high:g}")
        return value

    return read


def whole_number_from(low: int, high: int | None = None) -> Callable[[str | int], int]:
    """A reader of whole numbers from ``low`` on, to ``high`` if there is one; as ``number_from``."""
    allowed = f"{low} or more" if high is None else f"from {low} to {high}"

    def read(text: str | int) -> int:
        try:
            value = int(text)
        except ValueError:
            value = low - 1
        if value < low or (high is not None and value > high):
            raise typer.BadParameter(f"{text!r} is not a whole number {allowed}")
        return value

    return read


ConfigOption = Annotated[
    Path | None,
    typer.Option("--config", metavar="FILE.toml", help="A TOML file with words of your own."),
]

ModelOption = Annotated[
    str | None,
    typer.Option("--model", metavar="NAME", help="A language model in front: [models.NAME] of the settings."),
]
YesOption = Annotated[
    bool, typer.Option("--yes", help="No read-back of what stands in your own words and is sure.")
]

FolderOption = Annotated[
    Path | None, typer.Option("--folder", metavar="DIR", help="Where the sockets are; one for each robot.")
]


def not_empty(name: str | None) -> str | None:
    """A name as it was given; an empty one is a mistake, not one that was left out."""
    if name is not None and not name.strip():
        raise typer.BadParameter("the name is empty; leave the option out for the usual one")
    return name


def robot_name(name: str | None) -> str | None:
    """A robot's name as it was given; the path of a folder is made absolute, for who opens it elsewhere."""
    not_empty(name)
    if name is None:
        return None
    from robots.outside import is_path

    return str(Path(name).expanduser().resolve()) if is_path(name) else name


REAL_PACE = 1.0
_PACES = {"real": REAL_PACE, "fast": 10.0}
_SLOWEST, _FASTEST = 0.01, 10.0


def served_pace(text: str | float) -> float:
    """The pace of a served robot by name or number; the default comes as a number."""
    try:
        pace = _PACES.get(str(text)) or float(text)
    except ValueError:
        raise typer.BadParameter(f"{text!r} is no pace; say 'real', 'fast' or a number") from None
    if not _SLOWEST <= pace <= _FASTEST:
        raise typer.BadParameter(f"{text} is not in the range {_SLOWEST:g} to {_FASTEST:g}")
    return pace


ServedPaceOption = Annotated[
    float,
    typer.Option(
        parser=served_pace,
        metavar="real|fast|NUMBER",
        help="Simulated seconds in a second, 0.01 to 10.",
        show_default="real",
    ),
]


class OnQuestionChoice(StrEnum):
    """What becomes of a question."""

    ASK = "ask"
    FAIL = "fail"
    FIRST = "first"


class PolicyChoice(StrEnum):
    """What happens to a model's step whose confidence is too low."""

    ASK = "ask"
    PARTIAL = "partial"


class PaceChoice(StrEnum):
    """How fast simulated time passes."""

    FAST = "fast"
    REAL = "real"


class PerceptionChoice(StrEnum):
    """How the robot sees: by a stub with declared errors, or with its own camera."""

    STUB = "stub"
    RGBD = "rgbd"


def scene_given(value: str | None) -> str | None:
    """A scene that was named; one of somebody else's files is imported at once.

    Raises:
        typer.BadParameter: It is empty.
        CannotImportError: Nothing can be made of the file.
    """
    named = not_empty(value)
    if named is None or not named.lower().endswith(FOREIGN_SCENES):
        return named
    from executive.cli.foreign_scene import imported_scene

    return imported_scene(named)


FOREIGN_SCENES = (".xml", ".mjcf", ".urdf")

SCENE_OF_THE_ROBOT = f"the robot's own; {USUAL_SCENE} for most"

SceneOption = Annotated[
    str | None,
    typer.Option(
        "--scene",
        metavar="NAME|FILE.toml|FILE.xml",
        help="Where.",
        show_default=SCENE_OF_THE_ROBOT,
        callback=scene_given,
    ),
]

PerceptionOption = Annotated[
    PerceptionChoice | None,
    typer.Option("--perception", help="How the robot sees.", show_default="what the scene says"),
]

OnQuestionOption = Annotated[
    OnQuestionChoice, typer.Option("--on-question", help="What becomes of a question.")
]
ConfidenceOption = Annotated[
    float,
    typer.Option(
        parser=number_from(0.0, 1.0), metavar="0..1", help="Below it a model's steps are not done unasked."
    ),
]
PolicyOption = Annotated[
    PolicyChoice, typer.Option(help="Below the confidence: ask, or do the other steps only.")
]

LOOPBACK = "lo"
RosOption = Annotated[
    bool, typer.Option("--ros", help="ROS 2 on the wire, this machine alone unless told otherwise.")
]
RosDomainOption = Annotated[
    int, typer.Option(parser=whole_number_from(0, 232), metavar="N", help="ROS_DOMAIN_ID.")
]
RosNamespaceOption = Annotated[str, typer.Option(metavar="NAME", help="Before every topic of ROS.")]
RosInterfaceOption = Annotated[
    str, typer.Option(metavar="NAME", help="Network interface; whoever is in that network commands.")
]

VIEW_PORT = 8095
ViewOption = Annotated[bool, typer.Option("--view", help="A page for browsers of this machine.")]
ViewPortOption = Annotated[
    int, typer.Option(parser=whole_number_from(0, 65535), metavar="N", help="Of 127.0.0.1; 0 is any.")
]

GROOT_PORT = 1667
GrootOption = Annotated[bool, typer.Option("--groot", help="Let Groot2 of this machine monitor the tree.")]
GrootPortOption = Annotated[
    int,
    typer.Option(
        parser=whole_number_from(1, 65534), metavar="N", help="Of 127.0.0.1; the next is taken too."
    ),
]


def options_of(given: Mapping[str, object]) -> list[str]:
    """Options as ``executive serve`` takes them; those without a value are left out."""
    return [f"--{name}={value}" for name, value in given.items() if value not in (None, "")]
