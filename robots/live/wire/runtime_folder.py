"""The private folder where a served robot's sockets, state slot and lock are."""

from __future__ import annotations

import fcntl
import os
import stat
from dataclasses import dataclass
from pathlib import Path

from robots.live.wire.errors import AlreadyServedError, RuntimeFolderError

_LONGEST_SOCKET = 100
"""A Unix socket's path has 107 bytes at most."""


@dataclass(frozen=True, slots=True)
class RuntimeFolder:
    """The folder of a served robot's sockets, with the names of what is in it."""

    path: Path

    @property
    def control_socket(self) -> Path:
        """Where the control process listens."""
        return self.path / "control.sock"

    @property
    def executive_socket(self) -> Path:
        """Where the executive listens."""
        return self.path / "executive.sock"

    @property
    def evaluation_socket(self) -> Path:
        """Where evaluations read the simulator's truth; only there when it was asked for."""
        return self.path / "evaluation.sock"

    @property
    def state_slot(self) -> Path:
        """The newest state of the robot, mapped into memory."""
        return self.path / "state"

    @property
    def picture_slot(self) -> Path:
        """The newest picture of the robot's camera; only there while somebody wants it."""
        return self.path / "picture"

    @property
    def tree_document(self) -> Path:
        """The newest tree that somebody asked for, as a document; only there once that was so."""
        return self.path / "tree.xml"

    @property
    def lock(self) -> Path:
        """Held by the control process while it lives."""
        return self.path / "lock"

    def make(self) -> None:
        """Make the folder, for its owner alone, or make sure that it is so.

        Raises:
            RuntimeFolderError: It belongs to somebody else, is open to others, or cannot be made.
        """
        if len(os.fsencode(self.executive_socket)) > _LONGEST_SOCKET:
            raise RuntimeFolderError(self.path, "its path is too long for a socket")
        try:
            self.path.mkdir(mode=0o700, parents=True, exist_ok=True)
            found = self.path.lstat()
        except OSError as failed:
            raise RuntimeFolderError(self.path, failed.strerror or str(failed)) from failed
        if not stat.S_ISDIR(found.st_mode):
            raise RuntimeFolderError(self.path, "it is no folder")
        if found.st_uid != os.geteuid():
            raise RuntimeFolderError(self.path, "it belongs to another user")
        if stat.S_IMODE(found.st_mode) & 0o077:
            raise RuntimeFolderError(self.path, "others may enter it; its mode must be 0700")

    def hold(self) -> int:
        """Take the folder for this process; the lock ends with the process, however that ends.

        Returns:
            The file descriptor that holds the lock.

        Raises:
            AlreadyServedError: Another process holds it.
            RuntimeFolderError: The lock cannot be made.
        """
        try:
            descriptor = os.open(self.lock, os.O_CREAT | os.O_RDWR | os.O_CLOEXEC | os.O_NOFOLLOW, 0o600)
        except OSError as failed:
            raise RuntimeFolderError(self.path, failed.strerror or str(failed)) from failed
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            os.close(descriptor)
            raise AlreadyServedError(self.path) from None
        return descriptor
