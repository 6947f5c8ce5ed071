"""``executive mcp`` beside a served robot, and clients of it: those of the SDK, and one that dies."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import httpx2
from mcp import Client, StdioServerParameters
from mcp.client.streamable_http import streamable_http_client
from mcp_types import Implementation

from executive.cli.commands.mcp import TOKEN
from executive.doors.mcp.serving import LOOPBACK, new_token
from robots.clock import WallClock
from robots.live.wire.errors import LiveError
from robots.live.wire.runtime_folder import RuntimeFolder

KINDS = ("http", "http, legacy", "stdio", "stdio, legacy")
"""Transports and versions of the protocol."""
_READY_WITHIN_S = 120.0
_CALL_WITHIN_S = 90.0
_FIRST_PORT, _PORTS = 20_000, 12_000
"""A port of its own for each process that evaluates, below those that the system gives to clients."""


class McpDoor:
    """The server over HTTP, as a process; as a context it ends.

    Args:
        folder: Where the robot is served.
        lease_s: Of tasks whose client does not ask.

    Attributes:
        process: The server.
        url: Where it listens.
    """

    def __init__(self, folder: RuntimeFolder, lease_s: float) -> None:
        self.folder, self.lease_s, self.token = folder, lease_s, new_token()
        self.port = _FIRST_PORT + os.getpid() % _PORTS
        self.url = f"http://{LOOPBACK}:{self.port}/mcp"
        self.process = subprocess.Popen(
            [sys.executable, "-m", "executive", *self._arguments(), "--http", "--port", str(self.port)],
            env={**os.environ, TOKEN: self.token},
            stderr=subprocess.DEVNULL,
        )
        self._await()

    def __enter__(self) -> McpDoor:
        """It listens."""
        return self

    def __exit__(self, *_raised: object) -> None:
        """End it."""
        self.process.kill()
        self.process.wait()

    @property
    def headers(self) -> dict[str, str]:
        """What opens it."""
        return {"Authorization": f"Bearer {self.token}"}

    @asynccontextmanager
    async def client(self, kind: str, name: str, **options: Any) -> AsyncIterator[Client]:
        """A client of the SDK.

        Args:
            kind: One of ``KINDS``; over stdio it has a server of its own.
            name: What it calls itself.
            options: Of ``mcp.Client``.
        """
        known = {"mode": "legacy" if "legacy" in kind else "auto", **options}
        known["client_info"] = Implementation(name=name, version="1")
        if kind.startswith("stdio"):
            server = StdioServerParameters(
                command=sys.executable,
                args=["-m", "executive", *self._arguments()],
                env=dict(os.environ),
            )
            async with Client(server, **known) as client:
                yield client
            return
        async with (
            httpx2.AsyncClient(headers=self.headers, timeout=_CALL_WITHIN_S) as http,
            Client(streamable_http_client(self.url, http_client=http), **known) as client,
        ):
            yield client

    def mortal_client(self, kind: str, text: str, waits: bool) -> subprocess.Popen[str]:
        """A client in a process of its own that begins a task, tells the run's id, and stays until it dies.

        Args:
            kind: As ``client``.
            text: What it begins.
            waits: Whether it waits in a call, or between calls.
        """
        program = Path(__file__).parent / "mortal_client.py"
        where = [self.url, self.token] if kind.startswith("http") else ["", *self._arguments()]
        command = [sys.executable, str(program), kind, text, "waits" if waits else "idles", *where]
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)

    def _arguments(self) -> list[str]:
        return ["mcp", "--folder", os.fspath(self.folder.path), "--lease", f"{self.lease_s:g}"]

    def _await(self) -> None:
        wall = WallClock()
        until_s = wall.now_s() + _READY_WITHIN_S
        while True:
            with contextlib.suppress(httpx2.TransportError):
                httpx2.get(self.url)
                return
            if self.process.poll() is not None or wall.now_s() > until_s:
                raise LiveError("the MCP server does not listen")
            wall.sleep(0.1)
