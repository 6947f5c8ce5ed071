"""Who may see the page, and who may command by it.

The page is for browsers of this machine. Reading needs nothing; a request that another page's script makes,
or that comes by another name than this machine's, is refused. Commanding needs the token that was printed: a
browser that opens the page with it gets it as a cookie, which scripts cannot read and other pages cannot make
it send.
"""

from __future__ import annotations

import hmac
import secrets
from collections.abc import Mapping
from dataclasses import dataclass, field
from urllib.parse import parse_qs, urlsplit

HERE = ("127.0.0.1", "localhost")
OWN_CONTENT = (
    "default-src 'self' 'unsafe-inline' 'unsafe-eval' 'wasm-unsafe-eval' data: blob:; "
    "connect-src 'self' data: blob:; frame-ancestors 'none'; form-action 'none'; base-uri 'none'"
)
"""What the page may load: itself, what it makes of itself, and nothing from anywhere else."""


@dataclass(frozen=True, slots=True)
class Answer:
    """What becomes of a request.

    Attributes:
        status: Of HTTP; 200 lets it pass.
        text: For people, where it does not pass.
        headers: Further headers of the answer.
        commands: Whether who asks may command.
    """

    status: int = 200
    text: str = ""
    headers: Mapping[str, str] = field(default_factory=dict)
    commands: bool = False

    @property
    def passes(self) -> bool:
        """Whether the page is given, or the connection made."""
        return self.status == 200


def new_token() -> str:
    """A token that nobody guesses."""
    return secrets.token_urlsafe(24)


class Access:
    """Judges requests to one port of this machine.

    Args:
        token: Lets commanding.
    """

    def __init__(self, token: str) -> None:
        self._token = token.encode()

    def is_token(self, said: str) -> bool:
        """Whether that is the token."""
        return hmac.compare_digest(said.encode(), self._token)

    def judge(self, path: str, headers: Mapping[str, str], port: int) -> Answer:
        """Judge a request for the page, or for its connection.

        Args:
            path: Of the request, with its query.
            headers: Of the request, by name in any case.
            port: Where it came in.
        """
        told = {name.lower(): value for name, value in headers.items()}
        host = told.get("host", "")
        if host not in {f"{name}:{port}" for name in HERE}:
            return Answer(403, f"refused: this page is for http://{HERE[0]}:{port} alone\n")
        origin = told.get("origin")
        if origin is not None and origin != f"http://{host}":
            return Answer(403, "refused: another page may not reach this one\n")
        said = parse_qs(urlsplit(path).query).get("token")
        if said is None:
            return Answer(commands=self.is_token(_cookie(told.get("cookie", ""), _name(port))))
        if not self.is_token(said[-1]):
            return Answer(403, "refused: the token is not the one that was printed\n")
        kept = f"{_name(port)}={said[-1]}; Path=/; HttpOnly; SameSite=Strict"
        return Answer(303, "", {"Location": "/", "Set-Cookie": kept, "Cache-Control": "no-store"}, True)


def _name(port: int) -> str:
    """Of the cookie: browsers tell ports of a machine apart by nothing else."""
    return f"executive-view-{port}"


def _cookie(header: str, name: str) -> str:
    """The value of a cookie in the header that tells them all; empty where it is not among them."""
    for one in header.split(";"):
        found, _, value = one.strip().partition("=")
        if found == name:
            return value
    return ""
