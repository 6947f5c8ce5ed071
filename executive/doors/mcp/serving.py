"""Serve the tools to one client over stdio, or over HTTP on loopback, where a token is asked for."""

from __future__ import annotations

import hmac
import secrets
from collections.abc import Awaitable, Callable, MutableMapping
from typing import Any

import anyio
import uvicorn
from mcp.server import MCPServer
from mcp.server.transport_security import TransportSecuritySettings

Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]
Application = Callable[[Message, Receive, Send], Awaitable[None]]

LOOPBACK = "127.0.0.1"


def serve_stdio(server: MCPServer[None]) -> None:
    """Serve the client at stdin and stdout until it ends."""
    anyio.run(server.run_stdio_async)


def serve_http(server: MCPServer[None], port: int, token: str) -> None:
    """Serve on loopback until interrupted; whoever has not the token is refused.

    Args:
        server: The tools.
        port: Of 127.0.0.1.
        token: What a client sends as ``Authorization: Bearer TOKEN``.
    """
    here = [f"{LOOPBACK}:{port}", f"localhost:{port}"]
    security = TransportSecuritySettings(
        enable_dns_rebinding_protection=True,
        allowed_hosts=here,
        allowed_origins=[f"http://{one}" for one in here],
    )
    app = server.streamable_http_app(transport_security=security)
    config = uvicorn.Config(with_token(app, token), host=LOOPBACK, port=port, log_level="warning")
    uvicorn.Server(config).run()


def new_token() -> str:
    """A token that nobody guesses."""
    return secrets.token_urlsafe(24)


def with_token(app: Application, token: str) -> Application:
    """The same application behind a token.

    Args:
        app: An ASGI application.
        token: Of the header ``Authorization``.
    """
    wanted = f"Bearer {token}".encode()

    async def guarded(scope: Message, receive: Receive, send: Send) -> None:
        if scope["type"] == "http":
            headers = dict(scope["headers"])
            if not hmac.compare_digest(headers.get(b"authorization", b""), wanted):
                await _refuse(send)
                return
        await app(scope, receive, send)

    return guarded


async def _refuse(send: Send) -> None:
    body = b'{"error": "the token is missing or wrong: send it as Authorization: Bearer TOKEN"}'
    headers = [(b"content-type", b"application/json"), (b"www-authenticate", b"Bearer")]
    await send({"type": "http.response.start", "status": 401, "headers": headers})
    await send({"type": "http.response.body", "body": body})
