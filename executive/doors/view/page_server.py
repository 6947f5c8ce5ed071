"""The page's server: viser's, on loopback, behind a guard of its own that judges each request first.

viser serves page and connection at one port and asks nobody who comes. The guard stands where its server
takes requests (``process_request`` of websockets), so that a foreign page gets neither the page nor a
connection, and it adds the headers by which a browser loads nothing from elsewhere.
"""

from __future__ import annotations

import contextlib
import io
import threading
from collections.abc import Awaitable, Callable
from contextvars import ContextVar
from types import FunctionType
from typing import Any, cast

import viser
import websockets
import websockets.asyncio
import websockets.asyncio.server
from viser import _messages, infra
from websockets.asyncio.server import ServerConnection
from websockets.http11 import Request, Response

from executive.doors.view.access import HERE, OWN_CONTENT, Access
from executive.errors import UserError

Handler = Callable[[ServerConnection], Awaitable[None]]
_commands: ContextVar[bool] = ContextVar("commands", default=False)
"""Whether the connection at hand may command; viser's callbacks run in its context."""
FIELDS = """
if (!window.fieldsAreMended) {
    window.fieldsAreMended = true;
    const isField = element => /^(INPUT|TEXTAREA|SELECT)$/.test(element.tagName);
    window.addEventListener("keydown", event => {
        if (!isField(event.target) || !event.altKey || event.ctrlKey || event.metaKey) return;
        if (!document.body.dispatchEvent(new KeyboardEvent("keydown", event))) event.preventDefault();
    }, true);

    const SETTLED_MS = 150;
    let typedAt = -Infinity;
    window.addEventListener("input", () => { typedAt = performance.now(); }, true);
    const later = (event, again) => {
        if (performance.now() - typedAt > SETTLED_MS) return;
        event.preventDefault();
        event.stopImmediatePropagation();
        setTimeout(again, SETTLED_MS + 1);
    };
    window.addEventListener("submit", event => later(event, () => event.target.requestSubmit()), true);
    window.addEventListener("click", event => {
        const button = event.target.closest?.("form button");
        if (button && button.type !== "submit") later(event, () => button.click());
    }, true);
}
"""
"""What viser's fields lack: keys of commands while one is written in, and sending all that was written.

viser hears keys outside of fields alone: who types the next command would press Alt+S, for STOP, in vain.
Those with Alt are told once more, outside. It holds back what is typed for 50 ms, and forgets it where a form
is sent meanwhile: "move 10" would be done as "move 1". Sending waits until it has told what was typed.
"""


class PortTakenError(UserError):
    """Another program listens at the page's port."""

    def __init__(self, port: int) -> None:
        super().__init__(f"port {port} of {HERE[0]} is taken; choose another one with --view-port")


class PageServer:
    """Serves one page at 127.0.0.1 until it is closed.

    Attributes:
        viser: What is drawn and asked for is put here.
        port: Where it is served.
    """

    def __init__(self, port: int, access: Access, name: str) -> None:
        """Begin to serve.

        Args:
            port: Of 127.0.0.1; 0 for any that is free.
            access: Judges who comes.
            name: Of the page, for people.

        Raises:
            PortTakenError: Another program listens there.
        """
        with contextlib.redirect_stdout(io.StringIO()):  # viser prints a banner
            self.viser = _guarded(access)(host=HERE[0], port=port, label=name, verbose=False)
        self.port: int = self.viser.get_port()
        if port not in (0, self.port):
            self.viser.stop()
            raise PortTakenError(port)
        # the way of viser's own scripts; it has none for those of others
        self.viser._websock_server.queue_message(_messages.RunJavascriptMessage(source=FIELDS))

    def on_client(self, welcome: Callable[[viser.ClientHandle, bool], None]) -> None:
        """Call a function with each browser that comes, in a thread, and whether it may command."""

        async def arrived(client: viser.ClientHandle) -> None:
            may = _commands.get()
            threading.Thread(target=welcome, args=(client, may), name="browser", daemon=True).start()

        self.viser.on_client_connect(arrived)

    def close(self) -> None:
        """Serve no more."""
        with contextlib.redirect_stdout(io.StringIO()):
            self.viser.stop()


def _guarded(access: Access) -> type[viser.ViserServer]:
    """The server of viser, whose sockets judge each request first.

    viser has no place of its own for that: the two functions that make its server are derived, with other
    meanings of a name of theirs.
    """
    serving = _Instead(websockets.asyncio.server, serve=_judging(access))
    sockets = _Instead(websockets, asyncio=_Instead(websockets.asyncio, server=serving))
    worker = _derived(infra.WebsockServer._background_worker, websockets=sockets)
    server = type("GuardedSockets", (infra.WebsockServer,), {"_background_worker": worker})
    made = _derived(viser.ViserServer.__init__, infra=_Instead(infra, WebsockServer=server))
    # any browser could ask viser for a tunnel that shows the page to the world
    return type("GuardedViser", (viser.ViserServer,), {"__init__": made, "request_share_url": _no_share})


class _Instead:
    """A module with another meaning of some of its names."""

    def __init__(self, module: Any, **others: Any) -> None:
        self._module = module
        self.__dict__.update(others)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._module, name)


def _derived(function: Callable[..., None], **others: Any) -> FunctionType:
    """The same function, with another meaning of some names of its module."""
    given = cast(FunctionType, function)
    names = {**given.__globals__, **others}
    made = FunctionType(given.__code__, names, given.__name__, given.__defaults__, given.__closure__)
    made.__kwdefaults__ = given.__kwdefaults__
    return made


def _no_share(_server: viser.ViserServer, verbose: bool = True) -> None:
    """What viser does when a browser asks for a tunnel: nothing."""


def _judging(access: Access) -> Callable[..., Any]:
    """``serve`` of websockets, behind the guard."""

    def serve(handler: Handler, *arguments: Any, **options: Any) -> Any:
        page = options.pop("process_request", None)

        def judged(connection: ServerConnection, request: Request) -> Response | None:
            answer = access.judge(request.path, dict(request.headers.raw_items()), _port_of(connection))
            if not answer.passes:
                refused = connection.respond(answer.status, answer.text)
                for name, value in answer.headers.items():
                    refused.headers[name] = value
                return refused
            given: Response | None = page(connection, request) if page else None
            if given is not None:
                given.headers["Content-Security-Policy"] = OWN_CONTENT
                given.headers["Referrer-Policy"] = "no-referrer"
                given.headers["X-Content-Type-Options"] = "nosniff"
            return given

        async def known(connection: ServerConnection) -> None:
            request = connection.request
            if request is not None:
                headers = dict(request.headers.raw_items())
                _commands.set(access.judge(request.path, headers, _port_of(connection)).commands)
            await handler(connection)

        return websockets.asyncio.server.serve(known, *arguments, process_request=judged, **options)

    return serve


def _port_of(connection: ServerConnection) -> int:
    return int(connection.local_address[1])
