"""Sockets of this machine: the only module that opens any, and only between processes of one user."""

from __future__ import annotations

import contextlib
import os
import socket
import struct
from dataclasses import dataclass
from pathlib import Path

from robots.clock import WallClock
from robots.live.wire.errors import NotServedError

UnixSocket = socket.socket
_CREDENTIALS = struct.Struct("3i")
_BACKLOG = 64
_KNOCK_AGAIN_S = 0.005
_CONNECT_WITHIN_S = 3.0
"""A process that hangs accepts nobody; whoever knocks must not hang with it."""


@dataclass(frozen=True, slots=True)
class Peer:
    """Who is at the other end, as the kernel says."""

    pid: int
    uid: int


def listen_at(path: Path) -> UnixSocket:
    """Listen at a path that is this user's alone; what a dead process left there is removed.

    Raises:
        OSError: It cannot be.
    """
    with contextlib.suppress(FileNotFoundError):
        path.unlink()
    listening = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    before = os.umask(0o177)
    try:
        listening.bind(os.fspath(path))
    finally:
        os.umask(before)
    listening.listen(_BACKLOG)
    listening.setblocking(False)
    return listening


def connect_to(path: Path) -> UnixSocket:
    """Connect to who listens at a path; the socket does not block.

    Raises:
        NotServedError: Nobody does, or another user.
    """
    connected = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    connected.setblocking(False)
    wall = WallClock()
    while True:
        try:
            connected.connect(os.fspath(path))
        except BlockingIOError:  # too many knock at the same time
            if wall.now_s() < _CONNECT_WITHIN_S:
                wall.sleep(_KNOCK_AGAIN_S)
                continue
        except OSError:
            pass
        else:
            break
        connected.close()
        raise NotServedError(path.parent)
    if peer_of(connected).uid != os.geteuid():
        connected.close()
        raise NotServedError(path.parent)
    return connected


def peer_of(connected: UnixSocket) -> Peer:
    """Who is at the other end."""
    packed = connected.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, _CREDENTIALS.size)
    pid, uid, _group = _CREDENTIALS.unpack(packed)
    return Peer(pid, uid)
