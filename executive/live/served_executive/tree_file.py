"""The tree under way as a document in a file, for programs that draw it: too long for a message."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from kinematics.whole_file import write_whole
from trees.build import TaskTree


class TreeFile:
    """Knows the newest tree, and writes it down for who asks.

    Args:
        path: Of the file.

    Attributes:
        number: Of the newest tree; another one has another number.
    """

    def __init__(self, path: Path) -> None:
        self._path, self._written, self.number = path, 0, 0
        self._tree: TaskTree | None = None

    def note(self, tree: TaskTree) -> None:
        """Know the tree under way."""
        if tree is not self._tree:
            self._tree, self.number = tree, self.number + 1

    def written(self) -> Mapping[str, Any]:
        """Number and file of the newest tree; no file where there is no tree, or it cannot be written."""
        if self._tree is None:
            return {"number": self.number, "path": ""}
        from trees.btcpp.errors import TreeDocumentError
        from trees.btcpp.writer import write_tree

        try:
            if self._written != self.number:
                write_whole(self._path, write_tree(self._tree.root).encode())
                self._written = self.number
        except (TreeDocumentError, OSError):
            return {"number": self.number, "path": ""}
        return {"number": self.number, "path": str(self._path)}
