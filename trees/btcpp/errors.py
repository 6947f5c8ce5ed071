"""What can be wrong with a tree that comes as a document, or cannot become one."""

from __future__ import annotations


class TreeDocumentError(ValueError):
    """A document is no tree that can be run here, or a tree cannot be written; one line says where and why.

    Attributes:
        where: Names of the elements from the tree down to the one at fault, joined by "/".
        reason: What is wrong.
    """

    def __init__(self, where: str, reason: str) -> None:
        self.where, self.reason = where, reason
        super().__init__(f"{where}: {reason}" if where else reason)
