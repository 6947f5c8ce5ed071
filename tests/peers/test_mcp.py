"""``executive mcp`` before a real robot, with the client of the protocol's SDK on the other side."""

import base64
import io
import json
import os
import signal
import socket
import time

import anyio
import httpx2
import pytest
from mcp_types import ElicitResult
from PIL import Image

from executive.doors.served_robot import ServedRobot
from robots.live.wire.runtime_folder import RuntimeFolder
from tests.peers.person import leave_stop
from tools.evaluate.mcp.door import KINDS, McpDoor

pytestmark = [pytest.mark.requirement("L7"), pytest.mark.timeout(400)]
LEASE_S = 6.0
BRAKED_WITHIN_S = 30.0
READY_WITHIN_S = 120.0
TASK, LONG, ASKING, ANSWER = "wait for 1 second", "wait for 300 seconds", "turn", "turn left 10 degrees"
OVER_HTTP = [kind for kind in KINDS if kind.startswith("http")]


@pytest.fixture(scope="module")
def door(served):
    with McpDoor(RuntimeFolder(served), LEASE_S) as made:
        yield made


@pytest.fixture
def ready(served, at_rest):
    """Waits until the robot is at rest and takes a task: a busy machine stands against it."""

    def wait(within_s=60.0):
        at_rest(within_s)
        until_s = time.monotonic() + READY_WITHIN_S
        while ServedRobot(served).status()["reservations"]:
            assert time.monotonic() < until_s, "the machine is too busy"
            time.sleep(0.2)

    return wait


@pytest.fixture
def talk(door, at_rest, ready):
    """Lets a client talk to the server, once the robot is at rest; answers what the dialogue answers."""
    ready()

    def run(kind, dialogue, name="a test", **options):
        async def whole():
            async with door.client(kind, name, **options) as client:
                return await dialogue(client)

        return anyio.run(whole)

    yield run
    at_rest()


async def called(client, tool, **arguments):
    answer = await client.call_tool(tool, arguments)
    assert not answer.is_error, answer.content
    return answer.structured_content


async def begun(client, text):
    return (await called(client, "start_task", text=text))["run"]


async def ended(client, run):
    while not (told := await called(client, "task_status", run=run, wait_s=30.0))["ended"]:
        pass
    return told


@pytest.mark.parametrize("kind", KINDS)
def test_the_tools_are_listed_with_their_schemas_and_none_resets(talk, kind):
    async def dialogue(client):
        return {tool.name: tool.input_schema["type"] for tool in (await client.list_tools()).tools}

    tools = talk(kind, dialogue)
    names = ("look", "check_command", "start_task", "task_status", "answer", "cancel", "stop")
    assert tools == dict.fromkeys(names, "object")


@pytest.mark.parametrize("kind", KINDS)
def test_a_look_brings_a_picture_that_decodes(talk, kind):
    async def dialogue(client):
        return (await client.call_tool("look", {})).content

    picture, things = talk(kind, dialogue)
    image = Image.open(io.BytesIO(base64.b64decode(picture.data)))
    image.load()
    assert (image.format, image.size) == ("PNG", (640, 640))
    assert isinstance(json.loads(things.text)["things"], list)


@pytest.mark.requirement("A2")
@pytest.mark.parametrize("kind", KINDS)
def test_a_task_is_followed_to_its_end_and_brings_its_evidence(talk, kind):
    progress = []

    async def heard(_progress, _total, message):
        progress.append(message)

    async def dialogue(client):
        run = await begun(client, TASK)
        arguments = {"run": run, "wait_s": 30.0}
        await client.call_tool("task_status", arguments, progress_callback=heard)
        return await ended(client, run)

    told = talk(kind, dialogue)
    assert told["outcome"] == told["report"]["outcome"] == "done"
    assert told["report"]["tasks"][0]["outcome"] == "done"
    assert progress


@pytest.mark.requirement("L6")
@pytest.mark.parametrize("kind", KINDS)
def test_a_question_is_answered_by_the_tool(talk, kind):
    async def dialogue(client):
        run = await begun(client, ASKING)
        asked = await called(client, "task_status", run=run, wait_s=30.0)
        await called(client, "answer", text=ANSWER)
        return asked, await ended(client, run)

    asked, told = talk(kind, dialogue)
    assert asked["question"]["text"] == "to the left or to the right?"
    assert told["outcome"] == "done"


@pytest.mark.requirement("L6")
@pytest.mark.parametrize("kind", KINDS)
def test_a_question_is_answered_by_the_person_whom_the_client_asks(talk, kind):
    asked = []

    async def person(_context, parameters):
        asked.append(parameters.message.splitlines()[0])
        return ElicitResult(action="accept", content={"answer": ANSWER})

    async def dialogue(client):
        return await ended(client, await begun(client, ASKING))

    told = talk(kind, dialogue, elicitation_callback=person)
    assert asked == ["to the left or to the right?"]
    assert told["outcome"] == "done"


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("kind", KINDS)
def test_a_cancel_by_the_tool_ends_the_task(talk, kind):
    async def dialogue(client):
        run = await begun(client, LONG)
        await anyio.sleep(1.0)
        assert (await called(client, "cancel", reason="enough"))["under_way"]
        return await ended(client, run)

    assert talk(kind, dialogue)["outcome"] == "cancelled"


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("kind", KINDS)
def test_a_call_that_the_client_cancels_ends_the_task(talk, kind):
    async def dialogue(client):
        run = await begun(client, LONG)
        with anyio.move_on_after(2.0):
            await called(client, "task_status", run=run, wait_s=40.0)
        return await ended(client, run)

    assert talk(kind, dialogue)["message"].startswith("cancelled: the client cancelled its call")


@pytest.mark.requirement("S4", "A2")
@pytest.mark.parametrize("kind", ["http", "stdio"])
def test_a_stop_latches_and_no_tool_resets_it(served, talk, kind):
    async def dialogue(client):
        await called(client, "stop", reason="a test")
        for text in ("reset", "reset the emergency stop", TASK):
            assert (await ended(client, await begun(client, text)))["outcome"] != "done"
        return (await called(client, "stop"))["reset"]

    try:
        assert "a person" in talk(kind, dialogue)
        assert ServedRobot(served).status()["emergency"]
    finally:
        leave_stop(served)


@pytest.mark.requirement("S9")
@pytest.mark.parametrize("token", ["", "Bearer wrong", "Basic YTpi"])
def test_over_http_whoever_has_not_the_token_is_refused(door, token):
    headers = {"Authorization": token} if token else {}

    assert httpx2.post(door.url, headers=headers, json={}).status_code == 401


@pytest.mark.requirement("S9")
@pytest.mark.parametrize("kind", OVER_HTTP)
def test_a_second_client_is_told_who_commands_and_may_still_stop_the_task(door, talk, kind):
    async def dialogue(client):
        run = await begun(client, LONG)
        async with door.client(kind, "the second") as other:
            refused = await other.call_tool("start_task", {"text": TASK})
            await called(other, "cancel")
        return refused, await ended(client, run)

    refused, told = talk(kind, dialogue, name="the first")
    assert refused.is_error
    assert f"'the first' commands: {told['run']} ({LONG!r})" in refused.content[0].text
    assert told["outcome"] == "cancelled"


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("waits", [True, False])
@pytest.mark.parametrize("kind", KINDS)
def test_a_client_that_is_killed_ends_its_task_and_the_next_is_served(
    door, served, at_rest, talk, ready, kind, waits
):
    ready()
    robot = ServedRobot(served)
    with door.mortal_client(kind, LONG, waits) as process:
        assert process.stdout.readline().startswith("run-")
        time.sleep(1.0)
        assert robot.status()["task"] == LONG
        os.kill(process.pid, signal.SIGKILL)
    at_rest(LEASE_S + BRAKED_WITHIN_S)
    ready()

    async def dialogue(client):
        return await ended(client, await begun(client, TASK))

    assert talk("http", dialogue)["outcome"] == "done"


@pytest.mark.requirement("S7")
def test_a_socket_that_is_cut_in_mid_call_ends_the_task(door, served, at_rest, ready):
    ready()
    with socket.create_connection(("127.0.0.1", door.port)) as one:
        one.sendall(posted(door, "start_task", {"text": LONG}))
        answer = b""
        while b"run-" not in answer:  # its head and its body may come apart
            answer += (piece := one.recv(100_000))
            assert piece, answer
        one.sendall(posted(door, "task_status", {"wait_s": 40.0}))
        time.sleep(2.0)
        assert ServedRobot(served).status()["task"] == LONG
    at_rest(LEASE_S + BRAKED_WITHIN_S)


def posted(door, tool, arguments):
    """The bytes of a call over HTTP."""
    meta = {
        "io.modelcontextprotocol/protocolVersion": "2026-07-28",
        "io.modelcontextprotocol/clientCapabilities": {},
    }
    params = {"name": tool, "arguments": arguments, "_meta": meta}
    body = json.dumps({"jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": params})
    headers = {
        "Host": f"127.0.0.1:{door.port}",
        "Content-Type": "application/json",
        "Accept": "application/json, text/event-stream",
        "MCP-Protocol-Version": "2026-07-28",
        "Mcp-Method": "tools/call",
        "Mcp-Name": tool,
        "Content-Length": str(len(body)),
        **door.headers,
    }
    lines = [f"{name}: {value}\r\n" for name, value in headers.items()]
    return "".join(["POST /mcp HTTP/1.1\r\n", *lines, "\r\n", body]).encode()


@pytest.mark.parametrize("kind", KINDS)
def test_the_resources_are_read(talk, kind):
    async def dialogue(client):
        await ended(client, await begun(client, TASK))
        names = [str(one.uri) for one in (await client.list_resources()).resources]
        return {name: (await client.read_resource(name)).contents[0] for name in names}

    read = talk(kind, dialogue)
    assert "pick: " in read["robot://skills"].text
    assert json.loads(read["robot://report"].text)["input"] == TASK
    assert "things" in json.loads(read["robot://scene"].text)
    assert read["robot://picture"].mime_type == "image/png"
