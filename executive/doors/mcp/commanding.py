"""Tools that command: begin a task, watch it, answer it, cancel it, stop.

A task is begun by one call and watched by others, since clients give up after a minute. One client commands
at a time: another one is told who does, and may watch, cancel and stop.

The annotations here are read by the SDK when the tools are made, so that they are no strings.
"""

from dataclasses import asdict
from functools import partial
from typing import Annotated, Any, Literal

import anyio
import anyio.lowlevel
from mcp.server import MCPServer
from mcp.server.elicitation import AcceptedElicitation, ElicitationResult
from mcp.server.mcpserver import Context, Elicit, Resolve
from mcp.server.mcpserver.exceptions import ToolError
from mcp_types import ToolAnnotations
from mcp_types.version import MODERN_PROTOCOL_VERSIONS

from executive.doors.mcp.calls import (
    NEWS_EVERY_S,
    HaltingCalls,
    Reply,
    ask_in_mid_call,
    await_news,
    call,
    can_ask,
    decline,
    halt_given_up,
)
from executive.doors.mcp.clients import client_of, is_there
from executive.doors.mcp.lease import Lease
from executive.doors.served_robot import RESET_IS_A_PERSONS, Run, ServedRobot
from executive.meaning import StopCommand
from executive.understanding.command_parser import parse

LONGEST_WAIT_S = 45.0
"""Wall time that one call waits at most: many clients give up after a minute."""
_MOST_TOLD = 40
"""Lines of feedback in one answer."""


def add_commanding_tools(server: MCPServer[None], robot: ServedRobot, lease: Lease) -> None:
    """``start_task``, ``task_status``, ``answer``, ``cancel`` and ``stop``."""
    moves = ToolAnnotations(read_only_hint=False, destructive_hint=True, idempotent_hint=False)
    halting = HaltingCalls()

    def require_command(ctx: Context) -> None:
        """Make sure that no other client commands."""
        if other := lease.other_commander(client_of(ctx)):
            raise ToolError(other)

    @server.tool(annotations=moves)
    async def start_task(ctx: Context, text: str) -> dict[str, str]:
        """Begin a task and answer at once with its run's id; watch it with task_status.

        Args:
            text: A sentence of the command language.
        """
        if not _says_stop(text):
            require_command(ctx)
        run = await call(partial(robot.begin, text))
        lease.begin(run, client_of(ctx))
        try:
            await anyio.lowlevel.checkpoint()
        except anyio.get_cancelled_exc_class():  # who does not hear of its run cannot end it
            await halt_given_up(robot, lease, run, ctx)
            raise
        return {"run": run.name}

    async def open_question(
        ctx: Context, run: str | None = None, wait_s: float = 0.0
    ) -> Reply | Elicit[Reply]:
        """Wait for news of the run, and put its question to the person where the client can."""
        found = robot.run(run)
        if found is None:
            return Reply(answer="")
        await await_news(ctx, robot, lease, found, min(max(wait_s, 0.0), LONGEST_WAIT_S))
        question = found.status().question
        if question is None or not can_ask(ctx) or not lease.is_commanded_by(found, client_of(ctx)):
            return Reply(answer="")
        choices = "".join(f"\n  {i}  {words}" for i, words in enumerate(question["choices"], 1))
        words = f"{question['text']}{choices}"
        if ctx.protocol_version in MODERN_PROTOCOL_VERSIONS:
            return Elicit(words, Reply)
        return await ask_in_mid_call(ctx, robot, lease, found, words)

    @server.tool(annotations=ToolAnnotations(read_only_hint=True))
    async def task_status(
        ctx: Context,
        reply: Annotated[ElicitationResult[Reply], Resolve(open_question)],
        run: str | None = None,
        wait_s: float = 0.0,
    ) -> dict[str, Any]:
        """How a task stands: outcome, newest line, tree, open question, evidence and failure chain.

        Args:
            run: Its id; the last one when left out.
            wait_s: Wait so long for its end or a question, 45 at most. A call that the client that began
                the task cancels while it waits cancels the task, and the robot holds.
        """
        del wait_s  # what is asked before the call has waited
        found = robot.run(run)
        if found is None:
            raise ToolError(
                f"no run {run!r}: start_task begins one" if run else "no run yet: start_task begins one"
            )
        if await is_there(ctx):
            lease.heard(found, client_of(ctx))
        if not isinstance(reply, AcceptedElicitation):
            await decline(robot, found)
        elif reply.data.answer.strip():
            await call(partial(robot.answer, reply.data.answer))
            await call(partial(found.wait, found.wait(0, 0.0), NEWS_EVERY_S))
        return await call(partial(_told, robot, found))

    @server.tool(annotations=moves)
    async def answer(ctx: Context, text: str) -> dict[str, Any]:
        """Answer the question that is open, with the words of the person who was asked.

        Args:
            text: A choice ("2", "the red one"), or a sentence.
        """
        require_command(ctx)
        return {"asked": await call(partial(robot.answer, text))}

    @server.tool(annotations=moves)
    async def cancel(reason: str = "cancelled by the client") -> dict[str, Any]:
        """End the task under way: the robot brakes along its path and holds.

        Args:
            reason: Why, for the report.
        """
        return {"under_way": await halting(partial(robot.cancel, reason))}

    @server.tool(annotations=moves)
    async def stop(category: Literal[0, 1, 2] = 1, reason: str = "stopped by the client") -> dict[str, Any]:
        """The emergency stop. It latches; only a person at the robot can reset it.

        Args:
            category: 1 brakes along the path, 2 holds at once, 0 takes the power away.
            reason: Why, for the log.
        """
        await halting(partial(robot.stop, reason, category))
        return {"engaged": True, "reset": RESET_IS_A_PERSONS}


def _says_stop(text: str) -> bool:
    """Whether a sentence is the spoken stop, which ends whatever is under way."""
    commands = parse(text).commands
    return len(commands) == 1 and isinstance(commands[0], StopCommand)


def _told(robot: ServedRobot, run: Run) -> dict[str, Any]:
    """A status as JSON values, with the tree where the task is under way."""
    told = asdict(run.status())
    if not run.ended:
        told["tree"] = robot.status().get("tree") or []
    return {key: value for key, value in told.items() if value not in (None, [], (), {})} | {
        "run": run.name,
        "lines": told["lines"][-_MOST_TOLD:],
    }
