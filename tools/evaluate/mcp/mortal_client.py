"""A client of the SDK that begins a task and stays until it is killed: KIND TEXT waits|idles WHERE..."""

from __future__ import annotations

import sys

import anyio
import httpx2
from mcp import Client, StdioServerParameters
from mcp.client.streamable_http import streamable_http_client

_STAYS_S = 600.0


async def main(kind: str, text: str, waits: bool, url: str, rest: list[str]) -> None:
    """Begin the task, tell its run's id, and stay."""
    mode = "legacy" if "legacy" in kind else "auto"
    if kind.startswith("stdio"):
        server = StdioServerParameters(command=sys.executable, args=["-m", "executive", *rest])
        client = Client(server, mode=mode)
    else:
        http = httpx2.AsyncClient(headers={"Authorization": f"Bearer {rest[0]}"}, timeout=_STAYS_S)
        client = Client(streamable_http_client(url, http_client=http), mode=mode)
    async with client as one:
        begun = (await one.call_tool("start_task", {"text": text})).structured_content or {}
        print(begun["run"], flush=True)
        if waits:
            await one.call_tool("task_status", {"run": begun["run"], "wait_s": 45.0})
        await anyio.sleep(_STAYS_S)


if __name__ == "__main__":
    _, _kind, _text, _waits, _url, *_rest = sys.argv
    anyio.run(main, _kind, _text, _waits == "waits", _url, _rest)
