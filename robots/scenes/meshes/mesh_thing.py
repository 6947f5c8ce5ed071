"""What a scene says of a thing that has a mesh, with what its sidecar and its model say besides."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from robots.errors import SceneError
from robots.scenes.meshes.object_model import (
    NoModelError,
    ObjectModel,
    digest_of,
    model_file,
    model_key,
    read_model,
)
from robots.scenes.meshes.sidecar import Sidecar, read_sidecar, sidecar_file
from robots.scenes.meshes.up_axis import name_of
from robots.scenes.scene_document import MeshTable
from robots.scenes.scene_words import COLORS
from robots.scenes.usual_properties import HEAVIEST_KG, LIGHTEST_KG, inside_m3


@dataclass(frozen=True, slots=True)
class MeshThing:
    """A thing that has a mesh.

    Attributes:
        file: The mesh.
        model: What was made of it, as large as the scene says.
        name: Of the thing in the scene.
        kind, color, names, categories: What it is called.
        mass_kg, friction: Of the whole.
    """

    file: str
    model: ObjectModel
    name: str
    kind: str
    color: str | None
    names: tuple[str, ...]
    categories: tuple[str, ...]
    mass_kg: float
    friction: float


def mesh_thing(table: MeshTable, source: str, fail: Callable[[str, str], SceneError]) -> MeshThing:
    """Look up what was made of a thing's mesh.

    Args:
        table: What the scene says.
        source: The scene's file, to which the mesh's is relative.
        fail: Makes an error of a key and a reason.

    Raises:
        SceneError: The mesh was not imported, or has changed since.
    """
    file = Path(table.mesh)
    if not file.is_absolute():
        file = Path(source).absolute().parent / file
    if not file.exists() and not model_file(file).exists():
        near = sorted(one.name for one in file.parent.glob(f"*{file.suffix}"))[:5]
        raise fail("mesh", f"there is no file {file}" + (f"; there are {', '.join(near)}" if near else ""))
    again = f"say `executive import object {table.mesh}`"
    if not sidecar_file(file).exists():
        raise fail("mesh", f"{table.mesh} was not imported yet: {again}")
    sidecar = read_sidecar(sidecar_file(file), Sidecar)
    try:
        model = read_model(model_file(file))
    except NoModelError as broken:
        raise fail("mesh", f"{broken}: {again}") from broken
    if file.exists() and _key(file, sidecar) != model.parts.key:
        raise fail("mesh", f"{table.mesh}, or what its sidecar says, has changed since the import: {again}")
    if table.up is not None and name_of(table.up) != name_of(sidecar.up):
        told = f"{table.mesh} was imported with up = {name_of(sidecar.up)!r}"
        raise fail("up", f"{told}: mend that in {sidecar_file(file).name} and {again}")
    if table.scale is not None and not table.scale > 0.0:
        raise fail("scale", f"must be above 0, not {table.scale:g}")
    factor = 1.0 if table.scale is None else table.scale / sidecar.scale
    label = table.label or sidecar.label
    names = (label, *(table.names or sidecar.names))
    scaled = model.scaled(factor)
    drawn = scaled if table.color is None else replace(scaled, color=COLORS.get(table.color, scaled.color))
    return MeshThing(
        file=str(file),
        model=drawn,
        name=table.name or label,
        kind=table.kind or label.split()[-1],
        color=table.color or sidecar.color,
        names=tuple(dict.fromkeys(name for name in names if name != table.kind)),
        categories=table.categories or sidecar.categories,
        mass_kg=_mass_kg(table, sidecar, scaled, factor),
        friction=sidecar.friction if table.friction is None else table.friction,
    )


def _key(file: Path, sidecar: Sidecar) -> str:
    return model_key(digest_of(file), sidecar.scale, sidecar.up, sidecar.turn_rad)


def _mass_kg(table: MeshTable, sidecar: Sidecar, model: ObjectModel, factor: float) -> float:
    """As the scene says, else by its density, else as the sidecar says, for a thing so much larger."""
    if table.mass_kg is not None:
        return table.mass_kg
    if table.density_kg_m3 is not None:
        return max(LIGHTEST_KG, min(HEAVIEST_KG, table.density_kg_m3 * inside_m3(model.outline)))
    return sidecar.mass_kg * factor**3
