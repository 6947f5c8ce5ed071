"""The MCP server, with the SDK's own client in front and a desk behind."""

from importlib.metadata import version

import anyio
import pytest
from mcp import Client, MCPError
from mcp_types import ElicitResult, Implementation

from executive.doors.mcp.lease import Lease
from executive.doors.mcp.server import mcp_server
from executive.doors.served_robot import ServedRobot
from executive.live.desk_messages import Say

pytestmark = pytest.mark.requirement("L7")
LONG_S = 60.0


def talk(served, dialogue, lease_s=LONG_S, **client):
    """Let a client talk to the server; answers what the dialogue answers."""
    robot = ServedRobot(served.folder.path)
    server = mcp_server(robot, Lease(robot, lease_s))

    async def whole():
        async with Client(server, **client) as one:
            return await dialogue(one)

    return anyio.run(whole)


async def called(client, tool, **arguments):
    answer = await client.call_tool(tool, arguments)
    assert not answer.is_error, answer.content
    return answer.structured_content


async def begun(client, text="wave"):
    return (await called(client, "start_task", text=text))["run"]


@pytest.mark.requirement("A2")
def test_there_are_few_tools_and_none_resets(served):
    async def dialogue(client):
        return {tool.name for tool in (await client.list_tools()).tools}

    tools = talk(served, dialogue)
    assert tools == {"look", "check_command", "start_task", "task_status", "answer", "cancel", "stop"}


def test_the_server_says_its_name_and_the_version_of_the_product(served):
    async def dialogue(client):
        return client.server_info

    told = talk(served, dialogue)
    assert (told.name, told.version) == ("humanoid-executive", version("humanoid-executive"))


def test_what_is_believed_comes_with_a_picture(served):
    async def dialogue(client):
        return (await client.call_tool("look", {})).content

    picture, things = talk(served, dialogue)
    assert picture.mime_type == "image/png"
    assert '"red cup"' in things.text


@pytest.mark.parametrize(
    ("text", "outcome"),
    [("pick up the red cup", "tasks"), ("pick up", "question"), ("frobnicate", "refused")],
)
def test_a_command_is_checked_and_nothing_begins(served, text, outcome):
    async def dialogue(client):
        return await called(client, "check_command", text=text)

    assert talk(served, dialogue)["outcome"] == outcome
    assert served.said == []


@pytest.mark.requirement("A2")
def test_a_task_is_begun_by_one_call_and_its_end_told_by_another(served):
    async def dialogue(client):
        return await called(client, "task_status", run=await begun(client), wait_s=10.0)

    told = talk(served, dialogue)
    assert (told["outcome"], told["ended"], told["message"]) == ("done", True, "done: it waves")


@pytest.mark.requirement("F1")
def test_the_name_of_a_file_is_a_sentence_to_a_model_and_no_script(served, tmp_path):
    script = tmp_path / "tidy.toml"
    script.write_text('[[task]]\nsay = "wave"\n')

    async def dialogue(client):
        return await called(client, "task_status", run=await begun(client, str(script)), wait_s=10.0)

    talk(served, dialogue)
    assert [type(one) for one in served.said] == [Say]


@pytest.mark.requirement("L6", "A2")
def test_a_client_that_can_ask_a_person_puts_the_question_and_the_answer_goes_on(served):
    served.asks, asked = True, []

    async def person(_context, parameters):
        asked.append(parameters.message)
        return ElicitResult(action="accept", content={"answer": "red"})

    async def dialogue(client):
        run = await begun(client)
        await called(client, "task_status", run=run, wait_s=10.0)
        return await called(client, "task_status", run=run, wait_s=10.0)

    told = talk(served, dialogue, elicitation_callback=person)
    assert asked[0].splitlines() == ["which cup?", "  1  red", "  2  blue"]
    assert told["outcome"] == "done"


@pytest.mark.requirement("L6")
def test_a_client_that_cannot_gets_the_question_and_answers_by_a_tool(served):
    served.asks = True

    async def dialogue(client):
        run = await begun(client)
        open_ = await called(client, "task_status", run=run, wait_s=10.0)
        await called(client, "answer", text="red")
        return open_, await called(client, "task_status", run=run, wait_s=10.0)

    open_, told = talk(served, dialogue)
    assert (open_["outcome"], open_["question"]["choices"]) == ("question", ["red", "blue"])
    assert told["outcome"] == "done"


@pytest.mark.requirement("S7", "A2")
def test_a_cancel_halts_the_task(served):
    served.holds = True

    async def dialogue(client):
        run = await begun(client)
        while not (await called(client, "cancel", reason="enough"))["under_way"]:
            pass
        return await called(client, "task_status", run=run, wait_s=10.0)

    assert talk(served, dialogue)["outcome"] == "cancelled"


@pytest.mark.requirement("S7")
def test_a_status_call_that_is_cancelled_while_it_waits_cancels_the_task(served):
    served.holds = True

    async def dialogue(client):
        run = await begun(client)
        with anyio.move_on_after(1.0):
            await called(client, "task_status", run=run, wait_s=30.0)
        return await called(client, "task_status", run=run, wait_s=10.0)

    assert talk(served, dialogue)["outcome"] == "cancelled"
    assert served.cancels == ["the client cancelled its call"]


@pytest.mark.requirement("S7")
def test_a_task_that_no_client_asks_about_is_cancelled(served):
    served.holds = True

    async def dialogue(client):
        await begun(client)
        with anyio.fail_after(10.0):
            while not served.cancels:
                await anyio.sleep(0.05)

    talk(served, dialogue, lease_s=0.5)
    assert served.cancels[0].startswith("its client has not asked about run-1")


def two(served, dialogue):
    """Let two clients talk to one server: the first one, and one that is called "second"."""
    robot = ServedRobot(served.folder.path)
    server = mcp_server(robot, Lease(robot, LONG_S))

    async def whole():
        second = Implementation(name="second", version="1")
        async with Client(server) as one, Client(server, client_info=second) as other:
            return await dialogue(one, other)

    return anyio.run(whole)


async def refused(client, tool, **arguments):
    answer = await client.call_tool(tool, arguments)
    assert answer.is_error
    return answer.content[0].text


@pytest.mark.requirement("S7")
def test_a_task_whose_client_waits_in_a_call_outlives_the_lease(served):
    served.holds = True

    async def dialogue(client):
        return await called(client, "task_status", run=await begun(client), wait_s=3.0)

    assert talk(served, dialogue, lease_s=0.6)["outcome"] == "running"


@pytest.mark.requirement("L6")
def test_a_question_that_is_open_outlives_the_lease_since_nothing_moves(served):
    served.asks = True

    async def dialogue(client):
        run = await begun(client)
        await anyio.sleep(2.5)
        return await called(client, "task_status", run=run)

    assert talk(served, dialogue, lease_s=0.5)["outcome"] == "question"


@pytest.mark.requirement("S9")
@pytest.mark.parametrize("tool", ["start_task", "answer"])
def test_a_second_client_is_told_who_commands(served, tool):
    served.holds = True

    async def dialogue(one, other):
        await begun(one, "wave")
        while not served.said:
            await anyio.sleep(0.01)
        words = await refused(other, tool, text="nod")
        await called(other, "cancel")
        return words

    words = two(served, dialogue)
    assert "'mcp'" in words
    assert "run-1 ('wave')" in words
    assert len(served.said) == 1


@pytest.mark.requirement("S7")
def test_a_second_client_that_gives_up_its_call_does_not_end_the_task_of_the_first(served):
    served.holds = True

    async def dialogue(one, other):
        run = await begun(one)
        with anyio.move_on_after(1.0):
            await called(other, "task_status", run=run, wait_s=30.0)
        return await called(one, "task_status", run=run)

    assert two(served, dialogue)["outcome"] == "running"
    assert served.cancels == []


@pytest.mark.requirement("S7")
def test_a_second_client_that_asks_does_not_keep_the_task_of_the_first_alive(served):
    served.holds = True
    robot = ServedRobot(served.folder.path)
    server = mcp_server(robot, Lease(robot, 1.0))

    async def whole():
        async with Client(server) as one:
            run = await begun(one)
        async with Client(server, client_info=Implementation(name="second", version="1")) as other:
            with anyio.fail_after(20.0):
                return await called(other, "task_status", run=run, wait_s=15.0)

    assert anyio.run(whole)["outcome"] == "cancelled"


@pytest.mark.requirement("S7")
def test_a_second_client_may_say_stop(served):
    served.holds = True

    async def dialogue(one, other):
        run = await begun(one)
        await called(other, "start_task", text="stop")
        return await called(one, "task_status", run=run, wait_s=10.0)

    assert two(served, dialogue)["outcome"] == "cancelled"


@pytest.mark.requirement("L6")
@pytest.mark.parametrize("mode", ["auto", "legacy"])
def test_a_question_that_the_person_declines_ends_the_task(served, mode):
    served.asks = True

    async def person(_context, _parameters):
        return ElicitResult(action="decline")

    async def dialogue(client):
        run = await begun(client)
        await called(client, "task_status", run=run, wait_s=10.0)
        return await called(client, "task_status", run=run, wait_s=10.0)

    assert talk(served, dialogue, elicitation_callback=person, mode=mode)["outcome"] == "cancelled"
    assert served.cancels == ["the question was declined"]


@pytest.mark.requirement("L6")
def test_a_person_who_thinks_too_long_is_not_waited_for_once_the_question_is_over(served):
    served.asks = True

    async def person(_context, _parameters):
        await anyio.sleep(60.0)

    async def dialogue(client):
        run = await begun(client)
        async with anyio.create_task_group() as group:
            group.start_soon(cancel_soon, client)
            with anyio.fail_after(20.0):
                return await called(client, "task_status", run=run, wait_s=10.0)

    async def cancel_soon(client):
        await anyio.sleep(2.0)
        await called(client, "cancel", reason="somebody else decided")

    told = talk(served, dialogue, elicitation_callback=person, mode="legacy")
    assert told["outcome"] == "cancelled"


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("reason", ["\x00", "x" * 30_000, "\u202e"])
def test_a_stop_stops_whatever_its_reason_holds(served, reason):
    async def dialogue(client):
        return await called(client, "stop", reason=reason)

    assert talk(served, dialogue)["engaged"]
    assert len(served.stops) == 1


@pytest.mark.requirement("S4", "A2")
def test_the_stop_reaches_the_control_and_says_who_resets(served):
    async def dialogue(client):
        return await called(client, "stop", category=2, reason="too close")

    told = talk(served, dialogue)
    assert [(one["category"], one["reason"]) for one in served.stops] == [(2, "too close")]
    assert "a person" in told["reset"]


@pytest.mark.requirement("F1")
@pytest.mark.parametrize(
    ("tool", "arguments"),
    [
        ("reset", {}),
        ("start_task", {}),
        ("start_task", {"text": 7}),
        ("start_task", {"text": "wave\x00"}),
        ("start_task", {"text": ""}),
        ("task_status", {"run": "run-9"}),
        ("stop", {"category": 3}),
        ("answer", {"text": ["red"]}),
    ],
)
def test_a_bad_call_is_an_error_with_words_and_nothing_begins(served, tool, arguments):
    async def dialogue(client):
        try:
            answer = await client.call_tool(tool, arguments)
        except MCPError as wrong:
            return str(wrong)
        assert answer.is_error
        return answer.content[0].text

    assert talk(served, dialogue)
    assert (served.said, served.stops) == ([], [])


def test_the_skills_the_scene_and_the_last_report_are_resources(served):
    async def dialogue(client):
        names = {str(one.uri) for one in (await client.list_resources()).resources}
        skills = (await client.read_resource("robot://skills")).contents[0].text
        return names, skills

    names, skills = talk(served, dialogue)
    assert names == {"robot://skills", "robot://scene", "robot://report", "robot://picture"}
    assert "pick: " in skills
