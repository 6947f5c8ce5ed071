"""The product's source as syntax trees, read once for every architecture test."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
PRODUCT = ("executive", "trees", "robots", "kinematics")


@dataclass(frozen=True)
class Module:
    """One file of the product or of the tools."""

    name: str
    path: Path
    tree: ast.Module

    @property
    def file(self) -> str:
        """Path below the project's root, with slashes."""
        return self.path.relative_to(ROOT).as_posix()

    @property
    def package(self) -> str:
        """Its top-level folder."""
        return self.name.split(".", 1)[0]

    def imports(self) -> Iterator[tuple[int, str]]:
        """Line and full dotted name of everything that is imported, wherever in the file."""
        for node in ast.walk(self.tree):
            if isinstance(node, ast.Import):
                for alias in node.names:
                    yield node.lineno, alias.name
            elif isinstance(node, ast.ImportFrom):
                base = node.module or ""
                if node.level:
                    above = self.name.split(".")
                    above = above[: len(above) - node.level + (self.path.name == "__init__.py")]
                    base = ".".join([*above, *([base] if base else [])])
                for alias in node.names:
                    yield node.lineno, f"{base}.{alias.name}"

    def bound(self) -> Iterator[tuple[str, str]]:
        """Each name that an import binds, wherever in the file, and the full name of what it stands for."""
        for node in ast.walk(self.tree):
            if isinstance(node, ast.Import):
                for alias in node.names:
                    first = alias.name.split(".")[0]
                    yield alias.asname or first, alias.name if alias.asname else first
            elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                for alias in node.names:
                    yield alias.asname or alias.name, f"{node.module}.{alias.name}"

    def calls(self) -> Iterator[tuple[int, str]]:
        """Line and full name of every dotted call or reference, with import aliases resolved."""
        names = dict(self.bound())
        for node in ast.walk(self.tree):
            if isinstance(node, ast.Attribute | ast.Name):
                dotted = _dotted(node)
                if dotted:
                    head, _, rest = dotted.partition(".")
                    if head in names:
                        yield node.lineno, names[head] + (f".{rest}" if rest else "")


def _dotted(node: ast.expr) -> str:
    parts: list[str] = []
    while isinstance(node, ast.Attribute):
        parts.append(node.attr)
        node = node.value
    if not isinstance(node, ast.Name):
        return ""
    return ".".join([node.id, *reversed(parts)])


def parse(source: str, file: str = "kinematics/example.py") -> Module:
    """A module from text, to try a rule on."""
    path = ROOT / file
    return Module(_module_name(path), path, ast.parse(source))


def _module_name(path: Path) -> str:
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@lru_cache(maxsize=1)
def modules(with_tools: bool = True) -> tuple[Module, ...]:
    """Every module of the four packages, and of the tools."""
    folders = (*PRODUCT, "tools") if with_tools else PRODUCT
    files = sorted(file for folder in folders for file in (ROOT / folder).rglob("*.py"))
    return tuple(Module(_module_name(file), file, ast.parse(file.read_text("utf-8"))) for file in files)
