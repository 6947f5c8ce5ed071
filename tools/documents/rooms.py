"""The rooms of each floor: what import-linter holds of them, and what each says of itself."""

from __future__ import annotations

import ast
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]
FLOORS = ("tools", "executive", "trees", "robots", "kinematics")
"""From the top down; each imports only those after it."""


def layers(floor: str) -> list[list[str]]:
    """The rooms of a floor as its contract has them: the highest layer first, names without the floor's.

    A floor without a contract of its own has one layer, of all its packages.
    """
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    for contract in project["tool"]["importlinter"]["contracts"]:
        rows = [row.split(" | ") for row in contract.get("layers", ())]
        names = [name for row in rows for name in row]
        # of the contracts within one floor, the one that speaks of the whole floor has the most names
        if names and all(name.startswith(f"{floor}.") for name in names) and _is_whole(floor, names):
            return [[name.removeprefix(f"{floor}.") for name in row] for row in rows]
    return [packages(floor)]


def _is_whole(floor: str, names: list[str]) -> bool:
    return {name.split(".")[1] for name in names} >= set(packages(floor))


def packages(package: str) -> list[str]:
    """The packages right inside of a package that hold Python code, in alphabetical order."""
    folder = ROOT / package.replace(".", "/")
    return sorted(path.parent.name for path in folder.glob("*/__init__.py") if _has_code(path.parent))


def _has_code(folder: Path) -> bool:
    return any(path.name != "__init__.py" for path in folder.rglob("*.py"))


def says(package: str) -> str:
    """The first paragraph of a package's docstring; "" where it has none."""
    text = (ROOT / package.replace(".", "/") / "__init__.py").read_text("utf-8")
    told = (ast.get_docstring(ast.parse(text)) or "").partition("\n\n")[0]
    return " ".join(told.split())
