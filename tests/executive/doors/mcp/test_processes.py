"""``executive mcp`` as a process, over stdio and HTTP, with clients that die in mid-call."""

import json
import os
import signal
import socket
import subprocess
import sys
import time
from contextlib import asynccontextmanager, contextmanager
from pathlib import Path

import anyio
import httpx2
import pytest
from mcp import Client, StdioServerParameters
from mcp.client.streamable_http import streamable_http_client
from mcp_types import ElicitResult

pytestmark = [pytest.mark.requirement("L7"), pytest.mark.slow]
TOKEN = "a-token-of-a-test"
LEASE_S = 2.0
PATIENCE_S = 60.0
CLIENT_THAT_DIES = """
import sys, anyio, httpx2
from mcp import Client, StdioServerParameters
from mcp.client.streamable_http import streamable_http_client

async def whole(target, mode, waits):
    async with Client(target, mode=mode) as client:
        run = (await client.call_tool("start_task", {"text": "wave"})).structured_content["run"]
        print(run, flush=True)
        if waits:
            await client.call_tool("task_status", {"run": run, "wait_s": 40.0})
        await anyio.sleep(100.0)

kind, mode, waits, *rest = sys.argv[1:]
if kind == "stdio":
    target = StdioServerParameters(command=sys.executable, args=["-m", "executive", *rest])
else:
    url, token = rest
    headers = {"Authorization": f"Bearer {token}"}
    target = streamable_http_client(url, http_client=httpx2.AsyncClient(headers=headers, timeout=60.0))
anyio.run(whole, target, mode, waits == "waits")
"""


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def over_stdio(served, **client):
    arguments = ["-m", "executive", "mcp", "--folder", str(served.folder.path), "--lease", str(LEASE_S)]
    environment = {**os.environ, "PYTHONWARNINGS": "ignore"}
    return Client(StdioServerParameters(command=sys.executable, args=arguments, env=environment), **client)


class HttpServer:
    """A server over HTTP, and clients of it."""

    def __init__(self, port):
        self.port, self.url = port, f"http://127.0.0.1:{port}/mcp"

    @asynccontextmanager
    async def client(self, token=TOKEN, **client):
        headers = {"Authorization": f"Bearer {token}"} if token else {}
        http = httpx2.AsyncClient(headers=headers, timeout=60.0)
        async with http, Client(streamable_http_client(self.url, http_client=http), **client) as one:
            yield one


@pytest.fixture
def http(served):
    port = free_port()
    command = [sys.executable, "-m", "executive", "mcp", "--http", "--port", str(port)]
    command += ["--folder", str(served.folder.path), "--lease", str(LEASE_S)]
    with subprocess.Popen(command, env={**os.environ, "HUMANOID_EXECUTIVE_MCP_TOKEN": TOKEN}) as process:
        await_that(lambda: answers(port), "the server listens")
        yield HttpServer(port)
        process.terminate()
        process.wait(20.0)


def answers(port):
    with socket.socket() as one:
        return one.connect_ex(("127.0.0.1", port)) == 0


def await_that(condition, what):
    until_s = time.monotonic() + PATIENCE_S
    while not condition():
        assert time.monotonic() < until_s, f"in vain: {what}"
        time.sleep(0.05)


async def called(client, tool, **arguments):
    answer = await client.call_tool(tool, arguments)
    assert not answer.is_error, answer.content
    return answer.structured_content


async def carried_out(client, text="wave"):
    run = (await called(client, "start_task", text=text))["run"]
    return await called(client, "task_status", run=run, wait_s=10.0)


def talk(client, dialogue):
    async def whole():
        async with client as one:
            return await dialogue(one)

    return anyio.run(whole)


@contextmanager
def dying_client(*arguments):
    """A client in a process of its own that has begun a task."""
    command = [sys.executable, "-c", CLIENT_THAT_DIES, *arguments]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline().strip() == "run-1"
        yield process


@pytest.mark.parametrize("mode", ["auto", "legacy"])
def test_a_task_is_carried_out_over_stdio(served, mode):
    assert talk(over_stdio(served, mode=mode), carried_out)["outcome"] == "done"


@pytest.mark.parametrize("mode", ["auto", "legacy"])
def test_a_task_is_carried_out_over_http(http, mode):
    assert talk(http.client(mode=mode), carried_out)["outcome"] == "done"


@pytest.mark.requirement("L6")
@pytest.mark.parametrize("mode", ["auto", "legacy"])
def test_a_question_is_put_to_the_person_over_http(served, http, mode):
    served.asks = True

    async def person(_context, _parameters):
        return ElicitResult(action="accept", content={"answer": "red"})

    async def dialogue(client):
        told = await carried_out(client)
        return told if told["ended"] else await called(client, "task_status", wait_s=10.0)

    assert talk(http.client(mode=mode, elicitation_callback=person), dialogue)["outcome"] == "done"


@pytest.mark.requirement("S9")
def test_without_the_token_nothing_is_answered(served, http):
    for token in ("", "wrong", TOKEN + "x"):
        with pytest.raises(BaseExceptionGroup):
            talk(http.client(token), carried_out)
        headers = {"Authorization": f"Bearer {token}"} if token else {}
        assert httpx2.post(http.url, headers=headers, json={}).status_code == 401
    assert served.said == []


@pytest.mark.requirement("S7")
@pytest.mark.parametrize(("mode", "waits"), [("auto", "waits"), ("legacy", "between calls")])
def test_a_client_over_http_that_is_killed_ends_its_task_and_the_next_is_served(served, http, mode, waits):
    served.holds = True
    with dying_client("http", mode, waits, http.url, TOKEN) as process:
        await_that(lambda: served.said, "the task begins")
        time.sleep(1.0)
        process.kill()
        await_that(lambda: served.cancels, "the task is cancelled")
    served.holds = False
    assert talk(http.client(), carried_out)["outcome"] == "done"


@pytest.mark.requirement("S7")
@pytest.mark.parametrize(("mode", "waits"), [("auto", "waits"), ("legacy", "between calls")])
def test_a_client_over_stdio_that_is_killed_ends_its_server_and_its_task(served, mode, waits):
    served.holds = True
    with dying_client("stdio", mode, waits, "mcp", "--folder", str(served.folder.path)) as process:
        await_that(lambda: served.said, "the task begins")
        (server,) = children(process.pid)
        process.kill()
        await_that(lambda: served.cancels, "the task is cancelled")
        await_that(lambda: not Path(f"/proc/{server}").exists(), "the server ends")
    served.holds = False
    assert talk(over_stdio(served), carried_out)["outcome"] == "done"


def children(pid):
    return [int(one) for one in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


@pytest.mark.requirement("S7")
def test_a_socket_that_is_cut_in_mid_call_ends_the_task(served, http):
    served.holds = True
    cut = socket.create_connection(("127.0.0.1", http.port))

    def post(tool, arguments):
        meta = {
            "io.modelcontextprotocol/protocolVersion": "2026-07-28",
            "io.modelcontextprotocol/clientCapabilities": {},
        }
        params = {"name": tool, "arguments": arguments, "_meta": meta}
        body = json.dumps({"jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": params})
        cut.sendall(
            (
                f"POST /mcp HTTP/1.1\r\nHost: 127.0.0.1:{http.port}\r\nAuthorization: Bearer {TOKEN}\r\n"
                "Content-Type: application/json\r\nAccept: application/json, text/event-stream\r\n"
                "MCP-Protocol-Version: 2026-07-28\r\nMcp-Method: tools/call\r\n"
                f"Mcp-Name: {tool}\r\nContent-Length: {len(body)}\r\n\r\n{body}"
            ).encode()
        )

    post("start_task", {"text": "wave"})
    answer = b""
    while b"run-1" not in answer:
        answer += cut.recv(10_000)
    post("task_status", {"run": "run-1", "wait_s": 40.0})
    time.sleep(1.5)
    cut.close()
    await_that(lambda: served.cancels, "the task is cancelled")
    assert served.cancels[0] == "the client cancelled its call"


@pytest.mark.requirement("S7")
def test_a_server_that_is_killed_leaves_no_task_behind(served):
    served.holds = True
    with dying_client("stdio", "auto", "waits", "mcp", "--folder", str(served.folder.path)) as process:
        await_that(lambda: served.said, "the task begins")
        os.kill(children(process.pid)[0], signal.SIGKILL)
        await_that(lambda: served.cancels, "the task is cancelled")
        process.kill()
