"""What was guessed when a mesh was imported: a TOML file beside it, which a person mends."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Annotated, Any, TypeVar

from pydantic import BeforeValidator, Field, FiniteFloat

from robots.errors import SceneError
from robots.scenes.meshes.up_axis import UP_AXES, Up
from robots.strict_table import StrictTable, Text, Texts, as_tuple, read_table, said
from robots.toml_text import TomlTextError, read_toml

ENDING = ".toml"
"""What the name of the mesh's file has behind it."""


def _up(value: Any) -> Any:
    """An axis of the mesh's by name, or any direction."""
    if isinstance(value, str):
        if value not in UP_AXES:
            raise said(f"must be one of {', '.join(UP_AXES)} or a direction [x, y, z], not {value!r}")
        return UP_AXES[value]
    return as_tuple(value, 3)


UpKey = Annotated[Up, BeforeValidator(_up)]
"""The direction of a mesh that is up: "+z", or [x, y, z]."""


class SidecarDraft(StrictTable):
    """What a sidecar may say while lines of it may have been deleted, to be guessed anew.

    Attributes:
        scale: Metres that a unit of the mesh is.
        up: Direction of the mesh that is up when the object stands.
        turn_rad: How far it is turned about that, so that its sides are along x and y.
        label: What it is called.
        names, categories: What it is called besides, and what it belongs to.
        color: What colour people say that it has; none where they would not.
        mass_kg: How heavy it is.
        friction: Of its surface.
        measured: What came out; for people to read.
    """

    scale: FiniteFloat | None = None
    up: UpKey | None = None
    turn_rad: FiniteFloat = 0.0
    label: Text | None = None
    names: Texts = ()
    categories: Texts = ()
    color: Text | None = None
    mass_kg: FiniteFloat | None = None
    friction: FiniteFloat = 0.6
    measured: dict[str, Any] = Field(default_factory=dict)


class Sidecar(SidecarDraft):
    """A whole one; attributes as of ``SidecarDraft``."""

    scale: FiniteFloat
    up: UpKey
    label: Text
    mass_kg: FiniteFloat


@dataclass(frozen=True, slots=True)
class Guesses:
    """A sidecar before it is written: its values, and why each was taken that nobody said.

    Attributes:
        values: By key.
        reasons: In words, by the keys that were guessed.
        measured: What came out.
    """

    values: Mapping[str, Any]
    reasons: Mapping[str, str]
    measured: Mapping[str, Any] = field(default_factory=dict)


def sidecar_file(mesh: Path) -> Path:
    """Where the guesses about a mesh are written down."""
    return mesh.with_name(mesh.name + ENDING)


Kind = TypeVar("Kind", bound=SidecarDraft)


def read_sidecar(file: Path, kind: type[Kind]) -> Kind:
    """Read one, whole or not.

    Raises:
        SceneError: It is none; with file, key and reason.
    """
    try:
        data = read_toml(file.read_text("utf-8"))
    except (OSError, UnicodeDecodeError) as absent:
        raise SceneError(str(file), "file", f"cannot be read: {absent}") from absent
    except TomlTextError as broken:
        raise SceneError(str(file), "file", f"is no TOML: {broken}") from broken
    return read_table(kind, data, partial(SceneError, str(file)))


def sidecar_text(mesh: str, guesses: Guesses) -> str:
    """The file's text: a line for each value, with the reason of what was guessed behind it."""
    lines = [
        f"# What was made of {mesh}. Mend what is guessed wrongly, or delete a line to have it guessed anew,",
        f"# and say `executive import object {mesh}` again.",
        "",
    ]
    for key, value in guesses.values.items():
        reason = guesses.reasons.get(key)
        lines.append(f"{key} = {toml_text(value)}" + (f"  # guessed: {reason}" if reason else ""))
    lines += ["", "[measured]", *(f"{key} = {toml_text(value)}" for key, value in guesses.measured.items())]
    return "\n".join(lines) + "\n"


def toml_text(value: Any) -> str:
    """A value as TOML has it, numbers to a millionth."""
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml_text(one)}" for key, one in value.items()) + " }"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(toml_text, value)) + "]"
    if isinstance(value, bool | int):
        return str(value).lower()
    return repr(round(float(value), 6))
