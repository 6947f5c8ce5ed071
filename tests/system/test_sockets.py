"""Who configures nothing opens nothing: a served robot and a run have sockets of files alone."""

import os
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from executive.live.caller.caller import Caller, ask_at
from executive.live.desk_messages import Say, write_desk_message
from robots.live.wire.errors import LiveError
from robots.live.wire.messages import GetStatus, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder

pytestmark = [pytest.mark.requirement("S9"), pytest.mark.minutes, pytest.mark.timeout(700)]
PATIENCE_S = 280.0
LISTENER = """
import os, sys

ASKED = ("socket.getaddrinfo", "socket.gethostbyname")
REACHED = ("socket.connect", "socket.bind", "socket.sendto")

def note(event, arguments):
    if event in ASKED + REACHED:
        address = arguments[event in REACHED]
        file = os.open(os.environ["SOCKETS_SEEN"], os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o600)
        os.write(file, f"{event} {address!r}\\n".encode())
        os.close(file)

sys.addaudithook(note)
"""
"""What every Python process of the tree runs as it starts: it notes what is bound or connected to."""
TALKATIVE = """
import socket
one = socket.socket()
one.bind(("127.0.0.1", 0))
one.listen()
other = socket.create_connection(one.getsockname())
input()
"""


class Watched:
    """A process whose sockets are watched, those of its children too.

    ``/proc`` tells of what is open at an instant, whoever opened it; what Python opens is noted at once.
    """

    def __init__(self, folder, command):
        self._noted = folder / "noted.txt"
        (folder / "listener").mkdir()
        (folder / "listener" / "sitecustomize.py").write_text(LISTENER)
        paths = [str(folder / "listener"), str(Path.cwd()), os.environ.get("PYTHONPATH", "")]
        surroundings = {
            **os.environ,
            "PYTHONPATH": os.pathsep.join(paths),
            "SOCKETS_SEEN": str(self._noted),
            "XDG_DATA_HOME": str(folder / "data"),
        }
        self.process = subprocess.Popen(command, env=surroundings, stdin=subprocess.PIPE, cwd=folder)
        self.network = set()

    def look(self):
        """Take in the network sockets that are open in the tree now."""
        for pid in tree(self.process.pid):
            self.network |= network_sockets(pid)

    def noted(self):
        """Addresses that were bound or connected to."""
        return self._noted.read_text().splitlines() if self._noted.exists() else []

    def addresses(self):
        """Those of what was noted that are of the network: a socket of a file has a path, no pair."""
        return [line for line in self.noted() if "(" in line or "getaddrinfo" in line or "gethost" in line]

    def end(self):
        """End it, where it has not ended."""
        self.process.stdin.close()
        self.process.terminate()
        self.process.wait(60.0)


def tree(root):
    """A process, its children and theirs; those of its session that were started apart too."""
    found, new = set(), {root}
    while new:
        found |= new
        new = {child for pid in new for child in children(pid)} - found
    return found


def children(pid):
    try:
        threads = list(Path(f"/proc/{pid}/task").iterdir())
        return [int(one) for thread in threads for one in (thread / "children").read_text().split()]
    except OSError:
        return []


def network_sockets(pid):
    """Sockets of the network that a process holds: protocol, local and remote address."""
    try:
        held = {str(one.readlink()) for one in Path(f"/proc/{pid}/fd").iterdir()}
    except OSError:
        return set()
    found = set()
    for protocol in ("tcp", "tcp6", "udp", "udp6", "raw", "raw6"):
        try:
            rows = Path(f"/proc/{pid}/net/{protocol}").read_text().splitlines()[1:]
        except OSError:
            continue
        found |= {(protocol, *row.split()[1:3]) for row in rows if f"socket:[{row.split()[9]}]" in held}
    return found


def watch_until(watched, condition, what):
    until_s = time.monotonic() + PATIENCE_S
    while not condition():
        watched.look()
        assert time.monotonic() < until_s, f"in vain: {what}"
        time.sleep(0.1)
    watched.look()


def answers(folder):
    try:
        ask_at(folder.executive_socket, write_desk_message(GetStatus()))
    except LiveError:
        return False
    return ask_at(folder.control_socket, write_control_message(GetStatus()))["commander"] is not None


def test_a_served_robot_that_carries_out_a_task_has_no_socket_of_the_network(tmp_path):
    folder = RuntimeFolder(tmp_path / "live")
    command = [sys.executable, "-m", "executive", "serve", "--folder", str(folder.path)]
    watched = Watched(tmp_path, command)
    try:
        watch_until(watched, lambda: answers(folder) or watched.process.poll() is not None, "it is served")
        told = []
        threading.Thread(target=lambda: told.append(carried_out(folder)), daemon=True).start()
        watch_until(watched, lambda: told, "the task ends")
    finally:
        watched.end()
    listening = {line.rpartition("/")[2].strip("'") for line in watched.noted() if "socket.bind" in line}

    assert told == ["done"]
    assert (watched.network, watched.addresses()) == (set(), [])
    assert listening == {"control.sock", "executive.sock"}


def carried_out(folder):
    """The outcome of a task."""
    caller, results = Caller(folder.executive_socket), []
    caller.send(write_desk_message(Say("wait for 0.2 seconds")))

    def take(answer):
        results.extend([answer["outcome"]] if answer["type"] == "result" else [])
        return bool(results)

    caller.listen(take, PATIENCE_S)
    caller.close()
    return results[0]


def test_a_run_opens_no_socket_of_the_network(tmp_path):
    command = [
        sys.executable,
        "-m",
        "executive",
        "run",
        "wait for 0.2 seconds",
        "--record",
        str(tmp_path / "r"),
    ]
    watched = Watched(tmp_path, command)
    try:
        watch_until(watched, lambda: watched.process.poll() is not None, "the run ends")
    finally:
        watched.end()

    assert watched.process.returncode == 0
    assert (watched.network, watched.addresses()) == (set(), [])


def test_a_process_that_opens_one_is_found_out_by_both_ways(tmp_path):
    parent = f"import subprocess, sys; subprocess.run([sys.executable, '-c', {TALKATIVE!r}])"
    watched = Watched(tmp_path, [sys.executable, "-c", parent])
    try:
        watch_until(watched, lambda: watched.network and watched.noted(), "it is found out")
    finally:
        watched.end()

    assert {protocol for protocol, _, _ in watched.network} == {"tcp"}
    assert len(watched.addresses()) >= 2
