"""The guard before viser's server, over real sockets."""

import http.client

import pytest
import viser
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

from executive.doors.view.access import Access
from executive.doors.view.page_server import PageServer, PortTakenError

TOKEN = "the-printed-one"


@pytest.fixture(scope="module")
def server():
    made = PageServer(0, Access(TOKEN), "robot")
    yield made
    made.close()


def get(server, path="/", **headers):
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=10.0)
    connection.request(
        "GET", path, headers={name.replace("_", "-"): value for name, value in headers.items()}
    )
    answer = connection.getresponse()
    answer.read()
    connection.close()
    return answer


def talk(server, **options):
    return connect(f"ws://127.0.0.1:{server.port}", subprotocols=[f"viser-v{viser.__version__}"], **options)


def test_the_page_is_given_and_may_load_nothing_from_elsewhere(server):
    answer = get(server)

    assert answer.status == 200
    assert "connect-src 'self'" in answer.headers["Content-Security-Policy"]
    assert "frame-ancestors 'none'" in answer.headers["Content-Security-Policy"]


def test_a_foreign_page_gets_neither_the_page_nor_a_connection(server):
    assert get(server, Origin="http://evil.example").status == 403
    assert get(server, Host="evil.example").status == 403
    with pytest.raises(InvalidStatus, match="403"):
        talk(server, origin="http://evil.example")


def test_the_pages_own_connection_is_made(server):
    with talk(server, origin=f"http://127.0.0.1:{server.port}") as connection:
        assert connection.recv(10.0)


def test_the_token_is_taken_into_a_cookie_and_out_of_the_address(server):
    answer = get(server, f"/?token={TOKEN}")

    assert (answer.status, answer.headers["Location"]) == (303, "/")
    assert TOKEN in answer.headers["Set-Cookie"]


def test_viser_opens_no_tunnel_however_it_is_asked(server):
    assert server.viser.request_share_url() is None
    assert server.viser._share_tunnel is None


def test_a_port_that_is_taken_is_said(server):
    with pytest.raises(PortTakenError, match=str(server.port)):
        PageServer(server.port, Access(TOKEN), "robot")
