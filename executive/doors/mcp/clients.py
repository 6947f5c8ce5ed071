"""Who calls a tool, and whether the caller is still there."""

from __future__ import annotations

from dataclasses import dataclass

from mcp.server.mcpserver import Context
from mcp_types.version import MODERN_PROTOCOL_VERSIONS

_SESSION = "mcp-session-id"


@dataclass(frozen=True, slots=True)
class McpClient:
    """A client as the protocol tells it: a courtesy between clients, and no proof of who it is.

    Attributes:
        name: What it calls itself.
        session: Of the HTTP connection where the protocol's version has sessions; empty elsewhere, so that
            two clients of one name are one.
    """

    name: str
    session: str = ""


def client_of(ctx: Context) -> McpClient:
    """The client that has made a call."""
    told = ctx.session.client_params
    name = told.client_info.name if told is not None else "a client without a name"
    return McpClient(name[:80], (ctx.headers or {}).get(_SESSION, ""))


async def is_there(ctx: Context) -> bool:
    """Whether the connection that brought a call still stands.

    By the older versions of the protocol a call over HTTP outlives its connection, so that it is asked here.
    Over stdio, and by the newer versions, a call is cancelled when its connection ends.
    """
    request = ctx.request_context.request  # of the HTTP server; None over stdio
    if request is None or ctx.protocol_version in MODERN_PROTOCOL_VERSIONS:
        return True
    return not await request.is_disconnected()
