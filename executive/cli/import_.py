"""``executive import``: objects and scenes of somebody else, made usable here."""

from __future__ import annotations

import math
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from executive.errors import UserError


class What(StrEnum):
    """What is imported."""

    OBJECT = "object"
    SCENE = "scene"


_FILES = typer.Argument(
    metavar="FILE...", help="Objects (OBJ, STL, GLB, PLY, MJCF, URDF), or scenes (MJCF, URDF)."
)
_UP = typer.Option(metavar="AXIS", help='The axis of the mesh that is up: "+z", "+y", "-x", ...')
_SCALE = typer.Option(metavar="METRES", help="Metres that a unit of the mesh is.")
_MASS = typer.Option(metavar="KG", help="How heavy it is.")
_LABEL = typer.Option(metavar="NAME", help="What it is called, where it is one.")


def import_(
    what: Annotated[What, typer.Argument(help="What is imported.")],
    files: Annotated[
        list[Path],
        typer.Argument(metavar="FILE...", help="Meshes (OBJ, STL, GLB, PLY), or scenes (MJCF, URDF)."),
    ],
    up: Annotated[str | None, _UP] = None,
    scale: Annotated[float | None, _SCALE] = None,
    mass_kg: Annotated[float | None, _MASS] = None,
    label: Annotated[str | None, _LABEL] = None,
) -> None:
    """Make objects of meshes, or scenes of MJCF; what was guessed is written beside each, to be mended."""
    if what is What.SCENE:
        _import_scenes(files, [up, scale, mass_kg, label])
        return
    from robots.scenes.importing.import_object import import_object
    from robots.scenes.meshes.up_axis import UP_AXES
    from robots.simulated.importing.import_foreign_object import ENDINGS, import_foreign_object

    if up is not None and up not in UP_AXES:
        raise UserError(f"--up must be one of {', '.join(UP_AXES)}, not {up!r}")
    for option, value in (("--scale", scale), ("--mass-kg", mass_kg)):
        if value is not None and not (math.isfinite(value) and value > 0.0):
            raise UserError(f"{option} must be above 0, not {value:g}")
    if label is not None and len(files) > 1:
        raise UserError("--label is for one file")
    given = {"up": up, "scale": scale, "mass_kg": mass_kg, "label": label}
    said = {key: value for key, value in given.items() if value is not None}
    for file in files:
        foreign = file.suffix.lower() in ENDINGS
        made = (import_foreign_object if foreign else import_object)(file, said)
        told, of = made.guesses.values, made.guesses.measured
        size = " x ".join(f"{1000.0 * edge:.0f}" for edge in of["size_m"])
        parts = _counted(of["parts"], "part")
        typer.echo(
            f"{file}: {told['label']}, {size} mm, {told['mass_kg']:g} kg, {parts}, nearly a {of['outline']} "
            f"({1000.0 * of['outline_error_m']:.0f} mm)"
        )
        for key, reason in made.guesses.reasons.items():
            typer.echo(f"  {key} = {told[key]}: guessed, {reason}")
        typer.echo(f"  to mend: {made.sidecar}")


def _import_scenes(files: list[Path], of_objects: list[object]) -> None:
    if any(value is not None for value in of_objects):
        raise UserError("--up, --scale, --mass-kg and --label are for objects")
    from robots.simulated.importing.import_scene import import_scene

    for file in files:
        made = import_scene(file)
        things = (
            f"{_counted(len(made.objects), 'object')}, {_counted(len(made.furniture), 'piece')} of furniture"
        )
        typer.echo(f"{made.scene}: {things}: {', '.join([*made.objects, *made.furniture])}")
        for line in made.told:
            typer.echo(f"  {line}")
        for question in made.asked:
            typer.echo(f"  to be said by you: {question}")
        typer.echo(f"  every guess: {made.guesses}")


def _counted(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"
