"""Which sources hold compiled code, and what that code is made from.

Compiled code holds what its source imports, inlined or as constants. What it was made from is therefore
the source and all that it imports from this project, and all that those import, wherever they lie: it is
found by following the imports, not by names of folders.
"""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

_FROM = re.compile(rb"^[ \t]*from[ \t]+([\w.]+)[ \t]+import[ \t]+(\([^)]*\)|(?:[^\n\\]|\\\n)*)", re.MULTILINE)
_IMPORT = re.compile(rb"^[ \t]*import[ \t]+([\w. \t,]+)", re.MULTILINE)
_COMMENT = re.compile(rb"#[^\n]*")
_NAME = re.compile(rb"\w+")


def package_of(source: Path) -> Path:
    """The outermost folder of the package that a source belongs to."""
    folder = source.parent
    while (folder.parent / "__init__.py").is_file():
        folder = folder.parent
    return folder


class CompiledSources:
    """The sources of some packages as they are now, and what imports what among them."""

    def __init__(self, packages: Iterable[Path], compiler: Path) -> None:
        """Look at the names of all sources.

        Args:
            packages: Outermost folders of packages.
            compiler: The module with the decorators that compile; it lies in one of them.
        """
        self._compiler = compiler
        self._modules: dict[str, Path] = {}
        self._names: dict[Path, str] = {}
        self._texts: dict[Path, bytes] = {}
        for package in packages:
            for name, source in _modules(package):
                self._modules[name] = source
                self._names[source] = name

    def compiled(self) -> list[Path]:
        """Sources, in any folder, that import the compiler's decorators."""
        word = self._compiler.stem.encode()
        return [
            source
            for source in sorted(self._names)
            if word in self._text(source) and self._compiler in self._imported(source)
        ]

    def made_from(self, sources: Iterable[Path]) -> list[Path]:
        """Some sources and all that they import, directly or not, in order."""
        found: set[Path] = set()
        pending = list(sources)
        while pending:
            source = pending.pop()
            if source not in found:
                found.add(source)
                pending += self._imported(source)
        return sorted(found)

    def digest(self, sources: Iterable[Path]) -> str:
        """Hash of what some sources are made from: content and modules' names, not where they lie."""
        digest = hashlib.sha256()
        for name, text in sorted((self._names[s], self._text(s)) for s in self.made_from(sources)):
            digest.update(name.encode() + b"\0" + text + b"\0")
        return digest.hexdigest()

    def _text(self, source: Path) -> bytes:
        if source not in self._texts:
            self._texts[source] = source.read_bytes()
        return self._texts[source]

    def _imported(self, source: Path) -> set[Path]:
        """What a source names in its imports, and what the packages on the way run before it."""
        text = self._text(source)
        found: set[Path] = set()
        for statement in _FROM.finditer(text):
            base = self._absolute(statement[1].decode(), source)
            if base.split(".")[0] in self._modules:
                found.update(self._files(base))
                for name in _NAME.findall(_COMMENT.sub(b"", statement[2])):
                    if (module := self._modules.get(f"{base}.{name.decode()}")) is not None:
                        found.add(module)
        for statement in _IMPORT.finditer(text):
            for part in statement[1].decode().split(","):
                found.update(self._files(part.strip().split(" ")[0]))
        return found

    def _absolute(self, name: str, source: Path) -> str:
        """The full name of a module that may be given relative to a source."""
        dots = len(name) - len(name.lstrip("."))
        if not dots:
            return name
        up = dots - (source.name == "__init__.py")
        above = self._names[source].split(".")
        return ".".join([*above[: len(above) - up], *filter(None, [name[dots:]])])

    def _files(self, name: str) -> Iterator[Path]:
        """The sources of a module and of the packages that it lies in."""
        parts = name.split(".")
        for k in range(1, len(parts) + 1):
            if (source := self._modules.get(".".join(parts[:k]))) is not None:
                yield source


def _modules(package: Path) -> Iterator[tuple[str, Path]]:
    """Full names and sources of all modules of a package."""
    above = len(package.parent.parts)
    for folder, _, files in os.walk(package):
        place = Path(folder)
        prefix = ".".join(place.parts[above:])
        for file in files:
            if file.endswith(".py"):
                stem = file[: -len(".py")]
                yield prefix if stem == "__init__" else f"{prefix}.{stem}", place / file
