"""The token of the HTTP server."""

import anyio
import pytest

from executive.doors.mcp.serving import with_token

pytestmark = pytest.mark.requirement("S9")


def answered(headers):
    """The status with which a guarded application answers; 200 when it is reached."""
    sent = []

    async def app(_scope, _receive, send):
        await send({"type": "http.response.start", "status": 200, "headers": []})

    async def send(message):
        sent.append(message)

    scope = {"type": "http", "headers": headers}
    anyio.run(with_token(app, "secret"), scope, None, send)
    return sent[0]["status"]


@pytest.mark.parametrize(
    "headers",
    [[], [(b"authorization", b"Bearer wrong")], [(b"authorization", b"secret")], [(b"authorization", b"")]],
)
def test_whoever_has_not_the_token_is_refused(headers):
    assert answered(headers) == 401


def test_whoever_has_it_comes_through():
    assert answered([(b"authorization", b"Bearer secret")]) == 200
