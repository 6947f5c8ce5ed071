"""What every tool does: ask the robot in a thread, wait for news of a run, put its question to a person.

The annotations of ``Reply`` are read by the SDK when the tools are made, so that they are no strings.
"""

import contextlib
from collections.abc import Callable
from functools import partial
from typing import TypeVar

import anyio
import anyio.to_thread
from mcp.server.elicitation import AcceptedElicitation, ElicitationResult
from mcp.server.mcpserver import Context
from mcp.server.mcpserver.exceptions import ToolError
from pydantic import BaseModel, Field

from executive.doors.mcp.clients import client_of, is_there
from executive.doors.mcp.lease import Lease
from executive.doors.served_robot import Run, ServedRobot
from executive.errors import UserError
from robots.live.wire.errors import LiveError

NEWS_EVERY_S = 0.5
GIVEN_UP = "the client cancelled its call"
_AT_ONCE = 20

Answered = TypeVar("Answered")


class Reply(BaseModel):
    """A person's answer to the robot's question."""

    answer: str = Field(description="One of the choices, or a sentence; empty to leave it open.")


class HaltingCalls:
    """Runs what halts the robot in threads of its own, so that no number of waiting calls delays it."""

    def __init__(self) -> None:
        self._limiter = anyio.CapacityLimiter(_AT_ONCE)

    async def __call__(self, function: Callable[[], Answered]) -> Answered:
        """As ``call``."""
        return await call(function, self._limiter)


async def call(function: Callable[[], Answered], limiter: anyio.CapacityLimiter | None = None) -> Answered:
    """Ask the robot in a thread; what goes wrong is told in its own words."""
    try:
        return await anyio.to_thread.run_sync(function, limiter=limiter)
    except (LiveError, UserError) as wrong:
        raise ToolError(str(wrong)) from None


async def await_news(ctx: Context, robot: ServedRobot, lease: Lease, run: Run, within_s: float) -> None:
    """Wait for the end of a run, or its question, while the client is there.

    A call that is cancelled meanwhile by the client that began the task cancels the task.
    """
    client = client_of(ctx)
    seen, waited_s = 0, 0.0
    try:
        while waited_s < within_s and not run.ended and run.status().question is None:
            if not await is_there(ctx):
                return
            lease.heard(run, client)
            news = await anyio.to_thread.run_sync(run.wait, seen, NEWS_EVERY_S)
            waited_s += NEWS_EVERY_S
            if news > seen:
                await ctx.report_progress(news, message=run.status().message)
            seen = news
    except anyio.get_cancelled_exc_class():
        await halt_given_up(robot, lease, run, ctx)
        raise


async def halt_given_up(robot: ServedRobot, lease: Lease, run: Run, ctx: Context) -> None:
    """End a task whose client has cancelled the call; one of another client goes on."""
    if not lease.is_commanded_by(run, client_of(ctx)):
        return
    with anyio.CancelScope(shield=True):
        try:
            await anyio.to_thread.run_sync(robot.cancel, GIVEN_UP)
        except LiveError:
            return  # nobody is there who would go on


def can_ask(ctx: Context) -> bool:
    """Whether the client can put a question to a person."""
    known = ctx.client_capabilities
    return known is not None and known.elicitation is not None


async def ask_in_mid_call(ctx: Context, robot: ServedRobot, lease: Lease, run: Run, words: str) -> Reply:
    """Put a question in mid-call, as older clients want it, no longer than the robot keeps it open."""
    asked = run.status().question
    replies: list[ElicitationResult[Reply]] = []

    async def ask(scope: anyio.CancelScope) -> None:
        with contextlib.suppress(ValueError):  # what does not fit the schema is no answer
            replies.append(await ctx.elicit(words, Reply))
        scope.cancel()

    try:
        async with anyio.create_task_group() as group:
            group.start_soon(ask, group.cancel_scope)
            while run.status().question == asked and await is_there(ctx):
                await anyio.sleep(NEWS_EVERY_S)
            group.cancel_scope.cancel()
    except anyio.get_cancelled_exc_class():
        await halt_given_up(robot, lease, run, ctx)
        raise
    match replies:
        case [AcceptedElicitation(data=reply)]:
            return reply
        case [_]:
            await decline(robot, run)
    return Reply(answer="")


async def decline(robot: ServedRobot, run: Run) -> None:
    """End a task whose question the person declined."""
    await call(partial(robot.cancel, "the question was declined"))
    await call(partial(run.wait, run.wait(0, 0.0), NEWS_EVERY_S))
