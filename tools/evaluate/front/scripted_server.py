"""An OpenAI-compatible server on loopback whose answers are given beforehand, bad ones among them."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from types import TracebackType
from typing import Any

PATH = "/v1/chat/completions"


@dataclass(frozen=True, slots=True)
class Answer:
    """What the server sends to one request.

    Attributes:
        body: The bytes of the body, in parts.
        status: The status of HTTP.
        headers: Further headers.
        pause_s: Wall time before each part.
    """

    body: tuple[bytes, ...]
    status: int = 200
    headers: dict[str, str] = field(default_factory=dict)
    pause_s: float = 0.0


def saying(content: Any, **message: Any) -> Answer:
    """An answer with a message of the usual form.

    Args:
        content: The message's text; anything else is written as JSON.
        message: Further keys of the message, or ``finish_reason``.
    """
    text = content if isinstance(content, str | None) else json.dumps(content)
    reason = message.pop("finish_reason", "stop")
    choice = {
        "index": 0,
        "finish_reason": reason,
        "message": {"role": "assistant", "content": text, **message},
    }
    body = {"id": "chatcmpl-0", "object": "chat.completion", "created": 0, "model": "scripted"}
    return Answer((json.dumps({**body, "choices": [choice]}).encode(),))


def steps(*sentences: str, confidence: float = 0.95) -> Answer:
    """An answer with some sentences as steps."""
    return saying(
        {"steps": [{"command": one, "confidence": confidence} for one in sentences], "question": None}
    )


class ScriptedServer:
    """Serves the answers one after the other, the last one again and again; a context.

    Attributes:
        requests: The bodies of all requests, as JSON values.
        headers: The headers of the last one, names in lower case.
    """

    def __init__(self, *answers: Answer, sleep: Callable[[float], None] | None = None) -> None:
        self.answers: list[Answer] = list(answers)
        self.requests: list[Any] = []
        self.headers: dict[str, str] = {}
        self._sleep = sleep
        self._server = ThreadingHTTPServer(("127.0.0.1", 0), _handler(self))
        self._server.daemon_threads = True

    @property
    def url(self) -> str:
        """Its base address."""
        return f"http://127.0.0.1:{self._server.server_address[1]}/v1"

    def script(self, answers: Sequence[Answer]) -> None:
        """Begin anew with other answers."""
        self.answers, self.requests = list(answers), []

    def settings(self, name: str = "scripted", **keys: Any) -> str:
        """A table of settings for it, as TOML."""
        told = {"url": self.url, "model": "scripted", "timeout_s": 20.0, **keys}
        return "\n".join(
            [f"[models.{name}]", *(f"{key} = {json.dumps(value)}" for key, value in told.items()), ""]
        )

    def __enter__(self) -> ScriptedServer:
        """Serve."""
        threading.Thread(target=self._server.serve_forever, args=(0.02,), daemon=True).start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, raised: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End."""
        self._server.shutdown()
        self._server.server_close()

    def next_answer(self) -> Answer:
        """The answer to one more request."""
        return self.answers.pop(0) if len(self.answers) > 1 else self.answers[0]

    def pause(self, seconds: float) -> None:
        """Let time pass where an answer is slow."""
        if seconds and self._sleep is not None:
            self._sleep(seconds)


def _handler(server: ScriptedServer) -> type[BaseHTTPRequestHandler]:
    class Handler(BaseHTTPRequestHandler):
        """Answers one request."""

        def do_POST(self) -> None:
            length = int(self.headers.get("Content-Length", 0))
            server.requests.append(json.loads(self.rfile.read(length)))
            server.headers = {name.lower(): value for name, value in self.headers.items()}
            answer = server.next_answer()
            self.send_response(answer.status if self.path == PATH else 404)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(sum(map(len, answer.body))))
            for name, value in answer.headers.items():
                self.send_header(name, value)
            self.end_headers()
            try:
                for part in answer.body:
                    server.pause(answer.pause_s)
                    self.wfile.write(part)
                    self.wfile.flush()
            except OSError:
                return

        def log_message(self, *_arguments: Any) -> None:
            """Say nothing."""

    return Handler
