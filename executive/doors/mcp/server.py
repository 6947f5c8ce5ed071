"""The MCP server: tools that look, check, begin, watch, answer, cancel and stop, over stdio or HTTP.

A task is begun by one call and watched by others, since clients give up after a minute. What a client said
about a tool being harmless is a hint to people; the robot's own gate and checker judge every motion.

The annotations here are read by the SDK when the tools are made, so that they are no strings.
"""

from collections.abc import Callable
from dataclasses import asdict
from functools import partial
from typing import Annotated, Any, Literal, TypeVar

import anyio
import anyio.to_thread
from mcp.server import MCPServer
from mcp.server.elicitation import AcceptedElicitation, ElicitationResult
from mcp.server.mcpserver import Context, Elicit, Image, Resolve
from mcp.server.mcpserver.exceptions import ToolError
from mcp_types import ToolAnnotations
from pydantic import BaseModel, Field

from executive.doors.mcp.lease import Lease
from executive.doors.plan_picture import plan_picture
from executive.doors.served_robot import RESET_IS_A_PERSONS, Run, ServedRobot
from executive.errors import UserError
from executive.meaning import command_json
from executive.reports.meaning_words import meaning_words
from executive.understanding.understanding import understand
from robots.live.wire.errors import LiveError

LONGEST_WAIT_S = 45.0
"""Wall time that one call waits at most: many clients give up after a minute."""
_NEWS_EVERY_S = 0.5

_INSTRUCTIONS = (
    "A humanoid robot. It takes sentences of a plain command language ('pick up the red cup on the table', "
    "'walk to the kitchen and open the fridge'). check_command tells what a sentence is understood as; "
    "start_task begins it and answers at once with the id of the run; task_status tells how it stands, and "
    "its outcome says truthfully what happened. A question must be answered by the person: use answer. "
    f"stop is the emergency stop; {RESET_IS_A_PERSONS}."
)

Answered = TypeVar("Answered")


class Reply(BaseModel):
    """A person's answer to the robot's question."""

    answer: str = Field(description="One of the choices, or a sentence; empty to leave it open.")


def mcp_server(robot: ServedRobot, lease: Lease) -> MCPServer[None]:
    """The server with its tools and resources.

    Args:
        robot: The served robot behind it.
        lease: Ends tasks that no client asks about any more.
    """
    server: MCPServer[None] = MCPServer("humanoid-executive", instructions=_INSTRUCTIONS, log_level="ERROR")
    _add_reading(server, robot)
    _add_commanding(server, robot, lease)
    _add_resources(server, robot)
    return server


async def _call(function: Callable[[], Answered]) -> Answered:
    """Ask the robot in a thread; what goes wrong is told in its own words."""
    try:
        return await anyio.to_thread.run_sync(function)
    except (LiveError, UserError) as wrong:
        raise ToolError(str(wrong)) from None


def _add_reading(server: MCPServer[None], robot: ServedRobot) -> None:
    reads = ToolAnnotations(read_only_hint=True, open_world_hint=False)

    @server.tool(annotations=reads, structured_output=False)
    async def look() -> list[Any]:
        """What the robot believes to be around it: a picture from above, and a list of things."""
        things = await _call(robot.scene)
        return [Image(data=plan_picture(things), format="png"), {"things": things}]

    @server.tool(annotations=reads)
    async def check_command(text: str) -> dict[str, Any]:
        """What a sentence is understood as: tasks, a question or a refusal. Nothing moves.

        Args:
            text: The sentence.
        """
        parsed = (await _call(partial(understand, text))).parsed
        means = [meaning_words(command_json(one)) for one in parsed.commands]
        return {**parsed.to_json(), "means": ", then ".join(means)}


def _add_commanding(server: MCPServer[None], robot: ServedRobot, lease: Lease) -> None:
    moves = ToolAnnotations(read_only_hint=False, destructive_hint=True, idempotent_hint=False)

    @server.tool(annotations=moves)
    async def start_task(text: str) -> dict[str, str]:
        """Begin a task and answer at once with its run's id; watch it with task_status.

        Args:
            text: A sentence of the command language.
        """
        run = await _call(partial(robot.begin, text))
        lease.begin(run)
        return {"run": run.name}

    async def open_question(
        ctx: Context, run: str | None = None, wait_s: float = 0.0
    ) -> Reply | Elicit[Reply]:
        """Wait for news of the run, and put its question to the person where the client can."""
        found = robot.run(run)
        if found is None:
            return Reply(answer="")
        lease.heard(found)
        await _await_news(ctx, robot, found, min(max(wait_s, 0.0), LONGEST_WAIT_S))
        question = found.status().question
        if question is None or not _can_ask(ctx):
            return Reply(answer="")
        choices = "".join(f"\n  {i}  {words}" for i, words in enumerate(question["choices"], 1))
        return Elicit(f"{question['text']}{choices}", Reply)

    @server.tool(annotations=ToolAnnotations(read_only_hint=True))
    async def task_status(
        reply: Annotated[ElicitationResult[Reply], Resolve(open_question)],
        run: str | None = None,
        wait_s: float = 0.0,
    ) -> dict[str, Any]:
        """How a task stands: outcome, newest line, tree, open question, evidence and failure chain.

        Args:
            run: Its id; the last one when left out.
            wait_s: Wait so long for its end or a question, 45 at most. A call that is cancelled while it
                waits cancels the task, and the robot holds.
        """
        del wait_s  # what is asked before the call has waited
        found = robot.run(run)
        if found is None:
            raise ToolError(f"no run {run!r}: start_task begins one")
        lease.heard(found)
        if isinstance(reply, AcceptedElicitation):
            if reply.data.answer.strip():
                await _call(partial(robot.answer, reply.data.answer))
                await _await_news(None, robot, found, _NEWS_EVERY_S)
        else:
            await _call(partial(robot.cancel, "the question was declined"))
        return await _call(partial(_told, robot, found))

    @server.tool(annotations=moves)
    async def answer(text: str) -> dict[str, Any]:
        """Answer the question that is open, with the words of the person who was asked.

        Args:
            text: A choice ("2", "the red one"), or a sentence.
        """
        return {"asked": await _call(partial(robot.answer, text))}

    @server.tool(annotations=moves)
    async def cancel(reason: str = "cancelled by the client") -> dict[str, Any]:
        """End the task under way: the robot brakes along its path and holds.

        Args:
            reason: Why, for the report.
        """
        return {"under_way": await _call(partial(robot.cancel, reason))}

    @server.tool(annotations=moves)
    async def stop(category: Literal[0, 1, 2] = 1, reason: str = "stopped by the client") -> dict[str, Any]:
        """The emergency stop. It latches; only a person at the robot can reset it.

        Args:
            category: 1 brakes along the path, 2 holds at once, 0 takes the power away.
            reason: Why, for the log.
        """
        await _call(partial(robot.stop, reason, category))
        return {"engaged": True, "reset": RESET_IS_A_PERSONS}


def _add_resources(server: MCPServer[None], robot: ServedRobot) -> None:
    @server.resource("robot://skills", mime_type="text/plain")
    def skills() -> str:
        """What the robot can do, an example sentence for each skill."""
        from trees.registry import skills as known

        return "\n".join(f"{name}: {skill.example}" for name, skill in known().items())

    @server.resource("robot://scene", mime_type="application/json")
    async def scene() -> dict[str, Any]:
        """What the robot believes to be around it."""
        return {"things": await _call(robot.scene)}

    @server.resource("robot://report", mime_type="application/json")
    async def report() -> dict[str, Any]:
        """The report of the last task that has ended."""
        run = robot.run()
        return dict(run.status().report) if run is not None else {}

    @server.resource("robot://picture", mime_type="image/png")
    async def picture() -> bytes:
        """What is believed, from above."""
        return plan_picture(await _call(robot.scene))


def _can_ask(ctx: Context) -> bool:
    """Whether the client can put a question to a person."""
    known = ctx.client_capabilities
    return known is not None and known.elicitation is not None


async def _await_news(ctx: Context | None, robot: ServedRobot, run: Run, within_s: float) -> None:
    """Wait for the end of a run, or its question; a call that is cancelled meanwhile cancels the task."""
    seen, waited_s = 0, 0.0
    try:
        while waited_s < within_s and not run.ended and run.status().question is None:
            news = await anyio.to_thread.run_sync(run.wait, seen, _NEWS_EVERY_S)
            waited_s += _NEWS_EVERY_S
            if ctx is not None and news > seen:
                await ctx.report_progress(news, message=run.status().message)
            seen = news
    except anyio.get_cancelled_exc_class():
        with anyio.CancelScope(shield=True):
            await anyio.to_thread.run_sync(robot.cancel, "the client cancelled its call")
        raise


def _told(robot: ServedRobot, run: Run) -> dict[str, Any]:
    """A status as JSON values, with the tree where the task is under way."""
    told = asdict(run.status())
    if not run.ended:
        told["tree"] = robot.status().get("tree") or []
    return {key: value for key, value in told.items() if value not in (None, [], (), {})} | {
        "run": run.name,
        "lines": told["lines"][-40:],
    }
