"""Compiling a foreign model in spite of what is wrong with it but does not matter here; each mend is told."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mujoco

from robots.errors import CannotImportError
from robots.simulated.body.body_model import compiled_spec
from robots.simulated.importing.urdf import LEAST_INERTIA, LEAST_MASS_KG, make_readable

_MOST_MENDS = 40
_ATTRIBUTE = re.compile(r"unrecognized attribute:\s+'(\w+)'")
_ELEMENT = re.compile(r"unrecognized element\s+Element '(\w+)'")
_PICTURES = re.compile(r"(?i)(texture|png|image|cube|file format)")


@dataclass(frozen=True, slots=True)
class Compiled:
    """A foreign model that the simulator takes.

    Attributes:
        model: MuJoCo's.
        mends: What had to be mended.
        are_drawn: Its solids are what their meshes show (URDF), not the hulls of these (MJCF).
    """

    model: Any
    mends: tuple[str, ...]
    are_drawn: bool


def compiled(file: Path) -> Compiled:
    """A model of an MJCF or URDF file.

    Zero masses and inertias are made small ones; of assets of one name the first is taken; attributes that
    nobody knows are left out; pictures that cannot be read are left out.

    Raises:
        CannotImportError: There is no such file, or the simulator refuses it still; with its reason.
    """
    try:
        tree = ElementTree.parse(file)
    except OSError as absent:
        raise CannotImportError(f"{file}: cannot be read: {absent.strerror}") from absent
    except ElementTree.ParseError as broken:
        raise CannotImportError(f"{file}: is no XML: {broken}") from broken
    root = tree.getroot()
    if root.tag not in ("mujoco", "robot"):
        raise CannotImportError(f"{file}: is neither MJCF (<mujoco>) nor URDF (<robot>), but <{root.tag}>")
    mends: list[str] = []
    meshes: dict[str, bytes] = {}
    if root.tag == "mujoco":
        _include(root, file, file, ())
        for compiler in root.iter("compiler"):
            compiler.attrib.pop("coordinate", None)
        ElementTree.SubElement(
            root,
            "compiler",
            balanceinertia="true",
            boundmass=str(LEAST_MASS_KG),
            boundinertia=str(LEAST_INERTIA),
        )
        mends += _without_twins(root)
    else:
        told, meshes = make_readable(root, file)
        mends += told
    for _ in range(_MOST_MENDS):
        try:
            spec = mujoco.MjSpec.from_string(ElementTree.tostring(root, "unicode"), assets=meshes)
            spec.modelfiledir = str(file.absolute().parent)
            return Compiled(compiled_spec(spec), tuple(mends), root.tag == "robot")
        except ValueError as refused:
            mend = _mended(root, str(refused))
            if mend is None:
                reason = " ".join(str(refused).split())
                raise CannotImportError(f"{file}: the simulator refuses it: {reason}") from refused
            mends.append(mend)
    raise CannotImportError(f"{file}: more than {_MOST_MENDS} things of it had to be mended")


def _include(root: ElementTree.Element, of: Path, whole: Path, within: tuple[Path, ...]) -> None:
    """Put what a file includes where it is included.

    The file is looked for from where it is named, and else, as the simulator does, from the whole model's
    file: what is written to be included anywhere names it in either way.
    """
    for parent in list(root.iter()):
        for place, item in reversed([each for each in enumerate(parent) if each[1].tag == "include"]):
            named = item.get("file", "")
            found = [each for base in (of, whole) if (each := base.parent / named).is_file()]
            if not named or not found:
                raise CannotImportError(f"{of}: it includes {named!r}, and there is no such file")
            if found[0].resolve() in within:
                raise CannotImportError(f"{of}: it includes {named!r}, which includes itself")
            try:
                inner = ElementTree.parse(found[0]).getroot()
            except ElementTree.ParseError as broken:
                raise CannotImportError(f"{found[0]}: is no XML: {broken}") from broken
            _include(inner, found[0], whole, (*within, found[0].resolve()))
            parent.remove(item)
            for child in reversed(list(inner)):
                parent.insert(place, child)


def _without_twins(root: ElementTree.Element) -> list[str]:
    """Leave out assets whose kind and name were there before."""
    seen: set[tuple[str, str]] = set()
    told = []
    for assets in root.iter("asset"):
        for item in list(assets):
            name = item.get("name")
            if name is None:
                continue
            if (item.tag, name) in seen:
                assets.remove(item)
                told.append(f"a second {item.tag} {name!r} was left out")
            seen.add((item.tag, name))
    return told


def _mended(root: ElementTree.Element, refusal: str) -> str | None:
    """Take out what a refusal is about; None where that cannot be told, or matters."""
    found = _ATTRIBUTE.search(refusal)
    if found is not None:
        key = found.group(1)
        for element in root.iter():
            element.attrib.pop(key, None)
        return f"the attribute {key!r}, which the simulator does not know, was left out"
    found = _ELEMENT.search(refusal)
    if found is not None:
        tag = found.group(1)
        for parent in list(root.iter()):
            for child in [each for each in parent if each.tag == tag]:
                parent.remove(child)
        return f"<{tag}>, which the simulator does not know, was left out"
    if _PICTURES.search(refusal):
        textures = [(assets, item) for assets in root.iter("asset") for item in list(assets)
                    if item.tag == "texture" and item.get("file")]  # fmt: skip
        named = [each for each in textures if Path(each[1].get("file", "")).name in refusal
                 or (each[1].get("name") or "\0") in refusal]  # fmt: skip
        for assets, item in named[:1] or textures:
            assets.remove(item)
            for material in root.iter("material"):
                if material.get("texture") == item.get("name"):
                    del material.attrib["texture"]
        if textures:
            return "pictures that cannot be read were left out"
    return None
