"""``executive status``, asked of a control socket that says how things stand."""

import threading
import time

import pytest
from typer.testing import CliRunner

from executive.cli import app as cli
from robots.live.wire.messages import write_message
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.socket_server import SocketServer

STANDS = {
    "robot": "talos", "scene": "tabletop", "t_s": 12.0, "motions": [], "resting": True, "emergency": None,
    "commander": 4711, "scheduling": "ordinary", "stops": [],
    "lateness": {"p50_ms": 0.1, "p99_ms": 0.2, "worst_ms": 3.0},
}  # fmt: skip


@pytest.fixture
def status(tmp_path):
    """Ask for the status of a robot whose control process tells this of itself."""
    folder = RuntimeFolder(tmp_path / "live")
    folder.make()

    def ask(**told):
        over = threading.Event()
        answer = write_message("status", **STANDS, **told)
        server = SocketServer(folder.control_socket, lambda caller, _frame: caller.send(answer))

        def serve():
            while not over.is_set():
                server.poll()
                time.sleep(0.002)
            server.close()

        thread = threading.Thread(target=serve)
        thread.start()
        try:
            return CliRunner().invoke(cli.app, ["status", "--folder", str(folder.path)]).stdout
        finally:
            over.set()
            thread.join()

    return ask


@pytest.mark.requirement("S3")
def test_that_nobody_supervises_is_told_with_what_follows_from_it(status):
    (line,) = [line for line in status(supervisor=None).splitlines() if line.startswith("supervisor")]

    assert "nobody" in line
    assert "executive shutdown" in line


def test_who_supervises_is_told(status):
    assert "supervisor 4242\n" in status(supervisor=4242)


def test_that_there_is_no_executive_is_told(status):
    assert "executive  there is none\n" in status(supervisor=4242)
