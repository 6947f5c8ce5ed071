"""Errors of live mode.

LiveError                 base; a RobotsError
├── ProtocolError         bytes that are no message of this protocol; the connection is closed
├── NotServedError        nobody serves in that folder
├── AlreadyServedError    another control process holds the folder
└── RuntimeFolderError    the folder for the sockets is not private, or cannot be made
"""

from __future__ import annotations

from pathlib import Path

from robots.errors import RobotsError


class LiveError(RobotsError):
    """Base of the errors of live mode."""


class ProtocolError(LiveError):
    """Bytes that are no message of this protocol."""


class NotServedError(LiveError):
    """Nobody serves in a folder."""

    def __init__(self, folder: Path) -> None:
        super().__init__(f"no robot is served in {folder}; start one with `executive serve`")


class AlreadyServedError(LiveError):
    """Another control process holds the folder."""

    def __init__(self, folder: Path) -> None:
        super().__init__(f"a robot is served in {folder} already; `executive shutdown` ends it")


class RuntimeFolderError(LiveError):
    """The folder for the sockets is not private, or cannot be made."""

    def __init__(self, folder: Path, reason: str) -> None:
        super().__init__(f"cannot use {folder} for sockets: {reason}")
