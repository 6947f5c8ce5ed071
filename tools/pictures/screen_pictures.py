"""What screens of the terminal look like: as snapshots for tests, and as pictures for the docs."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.text import Text

from executive.screens.display import painted
from executive.screens.rows import Row, text_of
from trees.snapshot import NodeSnapshot

ROOT = Path(__file__).parents[2]
PICTURES, TESTS = ROOT / "docs" / "pictures", ROOT / "tests" / "executive"
Size = tuple[int, int]
SMALL: Size = (80, 24)
WIDE: Size = (160, 50)
SIZES = (SMALL, WIDE)

Laid = Callable[[str, int, int], Sequence[Row]]
"""The rows of a screen, by its name, width and height."""


def node_from(said: dict[str, Any]) -> NodeSnapshot:
    """A node of a tree, read back."""
    return NodeSnapshot(**{**said, "children": tuple(map(node_from, said["children"]))})


def write_snapshots(folder: Path, names: Iterable[str], laid: Laid) -> None:
    """Write each screen in each size as text."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in names:
        for width, height in SIZES:
            text = text_of(laid(name, width, height)) + "\n"
            (folder / f"{name}_{width}x{height}.txt").write_text(text, "utf-8")


def write_pictures(
    prefix: str, title: str, shown: Iterable[tuple[str, Size, bool]], laid: Laid, of: str = ""
) -> None:
    """Write screens as SVG.

    Args:
        prefix: Of the files' names.
        title: Above each picture.
        shown: Which screen, how large, and whether without colour.
        laid: Lays a screen out.
        of: Before the ids in the pictures, which differ between pictures of one page.
    """
    for name, (width, height), plain in shown:
        suffix = "_plain" if plain else ""
        picture = PICTURES / f"{prefix}_{name}_{width}x{height}{suffix}.svg"
        picture.write_text(_picture(laid(name, width, height), title, f"{of}{name}", (width, height), plain))


def _picture(rows: Sequence[Row], title: str, its_id: str, size: Size, plain: bool) -> str:
    console = Console(
        file=io.TextIOWrapper(io.BytesIO(), "utf-8"),
        record=True,
        width=size[0],
        height=size[1],
        force_terminal=True,
        color_system="truecolor",
    )
    console.print(Text(text_of(rows)) if plain else painted(rows))
    return console.export_svg(title=title, unique_id=its_id)
