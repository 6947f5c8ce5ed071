"""Suite ``mcp``: tasks over MCP, with questions, cancels and connections that end at random.

Each episode is a client that begins a task by one of the transports. It hears it out, answers a question by a
tool or as elicitation, cancels it by a tool or by giving up its call, or is killed, waiting or between calls.
What is told must be true, the robot must be at rest afterwards, within the lease where a client has gone, and
the next client must be served.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import traceback
from collections.abc import Awaitable, Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import anyio
import numpy as np
from mcp import Client
from mcp_types import ElicitResult
from rich.console import Console

from executive.doors.served_robot import ServedRobot as Door
from executive.runs.run_log import recorded_runs
from robots.clock import WallClock
from robots.live.wire.runtime_folder import RuntimeFolder
from tools.evaluate.live.served_robot import OPEN_FLOOR, OVERLOADED, ServedRobot
from tools.evaluate.mcp.door import KINDS, McpDoor

LEASE_S = 5.0
_SLACK_S = 10.0
"""Wall time beyond the lease in which the robot has come to rest: it brakes, and a busy machine is slow."""
_SHORT = ("wait for 1 second", "turn left 10 degrees", "move backward at 0.1 m/s for 1 second", "wave")
_LONG = ("wait for 300 seconds", "turn left 170 degrees", "move backward at 0.05 m/s for 20 seconds")
_ANSWERS = {"turn": "turn left 10 degrees", "wait": "wait for 1 second"}
"""Sentences that are asked back about, and what a person says then."""
_NEXT = "wait for 0.2 seconds"
_ENDS_WITHIN_S = 240.0
_TRIES = 5
"""Of an episode whose task is refused because the machine is too busy."""


@dataclass(frozen=True, slots=True)
class McpRecord:
    """How an episode ended.

    Attributes:
        seed: Of it.
        kind: Transport and version of the protocol.
        plan: What the client did.
        text: What it began.
        outcome: What it was told; "left" where it was gone while its task was under way.
        expected: Outcomes that are true here.
        rest_s: Wall time from the client's last act until nothing was under way.
        resting: Whether the body rested then.
        fallen: Whether the robot fell.
        resumed: Whether the next client's task was carried out.
        detail: What broke, or the line with the result where that is not as expected.
    """

    seed: int
    kind: str
    plan: str
    text: str
    outcome: str = ""
    expected: tuple[str, ...] = ()
    rest_s: float = 0.0
    resting: bool = False
    fallen: bool = False
    resumed: bool = False
    detail: str = ""

    @property
    def good(self) -> bool:
        """Whether everything was as it has to be."""
        in_time = self.rest_s <= LEASE_S + _SLACK_S
        return self.outcome in self.expected and in_time and self.resting and self.resumed and not self.fallen


def run_mcp(options: argparse.Namespace, messages: Console) -> int:
    """Run the suite; 0 when everything was as it has to be."""
    records: list[McpRecord] = []
    with tempfile.TemporaryDirectory(prefix="mcp-") as folder:
        robot = ServedRobot(Path(folder), options.seed, options.robot, options.pace, scene=OPEN_FLOOR)
        try:
            robot.wait_until_ready()
            where = RuntimeFolder(Path(folder) / "live")
            with McpDoor(where, LEASE_S) as door:
                for i in range(options.episodes):
                    record = _in_time(robot, where, door, options.seed + i)
                    records.append(record)
                    messages.print(
                        f"{i + 1} of {options.episodes}: {_line(record)}", markup=False, soft_wrap=True
                    )
        finally:
            robot.end()
    document = {
        "suite": "mcp",
        "episodes": len(records),
        "seed": options.seed,
        "success_rate": sum(one.good for one in records) / max(len(records), 1),
        "falls": sum(one.fallen for one in records),
        "longest_rest_s": max((one.rest_s for one in records), default=0.0),
        "failed_seeds": [one.seed for one in records if not one.good],
    }
    if options.json is not None:
        detail = {**document, "episodes_detail": [asdict(one) for one in records]}
        options.json.write_text(json.dumps(detail, indent=1) + "\n", "utf-8")
    Console().print(json.dumps(document, indent=1))
    return 0 if all(one.good for one in records) else 1


def _in_time(robot: ServedRobot, where: RuntimeFolder, door: McpDoor, seed: int) -> McpRecord:
    """An episode's record; it is begun again where the machine was too busy for its task."""
    for _ in range(_TRIES):
        record = _Episode(robot, where, door, seed).run()
        if OVERLOADED not in record.detail:
            break
    return record


def _line(record: McpRecord) -> str:
    good = "good" if record.good else "BAD"
    return (
        f"seed {record.seed}, {record.kind}: {record.plan}, {record.text!r}: {record.outcome}, at rest after "
        f"{record.rest_s:.1f} s, next {record.resumed}: {good} {record.detail[-500:]}"
    )


class _Episode:
    """One client and what comes after it."""

    def __init__(self, robot: ServedRobot, where: RuntimeFolder, door: McpDoor, seed: int) -> None:
        self._robot, self._door, self._seed = robot, door, seed
        self._rng = np.random.default_rng(seed)
        self._wall, self._desk = WallClock(), Door(where.path)
        self._kind = str(self._rng.choice(KINDS))
        plans = sorted(_PLANS)
        self._plan = plans[seed % len(plans)]
        self._message = ""

    def run(self) -> McpRecord:
        """The record of it."""
        plan, texts, expected = _PLANS[self._plan]
        text = str(self._rng.choice(texts))
        told = McpRecord(self._seed, self._kind, self._plan, text, expected=expected)
        values = asdict(told)
        try:
            self._robot.wait(self._robot.keeps_up, "the control process keeps up")
            values["outcome"] = plan(self, text)
            acted_s = self._wall.now_s()
            values["detail"] = "" if values["outcome"] in expected else self._message
            self._robot.wait(self._is_idle, "nothing is under way")
            values["rest_s"] = self._wall.now_s() - acted_s
            until_s = self._robot.look() + 1.0
            self._robot.wait(lambda: self._robot.look() > until_s, "it settles")
            values["resting"] = self._robot.resting
            values["fallen"] = self._robot.fallen()
            values["resumed"] = anyio.run(self._next) == "done"
        except Exception:
            values["detail"] = traceback.format_exc()
        return McpRecord(**values)

    def hear_out(self, text: str) -> str:
        """Begin it and wait for its end."""
        return self._talk(lambda client: self._begin_and_hear(client, text))

    def answer_by_tool(self, text: str) -> str:
        """Answer its question by a tool."""

        async def dialogue(client: Client) -> str:
            run = await _begun(client, text)
            told = await _status(client, run, 45.0)
            if told["outcome"] != "question" or not told.get("question"):
                return f"no question: {told['outcome']}"
            await _called(client, "answer", text=_ANSWERS[text])
            return await self._heard(client, run)

        return self._talk(dialogue)

    def answer_as_elicited(self, text: str) -> str:
        """Answer its question as the person whom the client asks."""
        asked: list[str] = []

        async def person(_context: object, parameters: Any) -> ElicitResult:
            asked.append(parameters.message)
            return ElicitResult(action="accept", content={"answer": _ANSWERS[text]})

        outcome = self._talk(lambda client: self._begin_and_hear(client, text), elicitation_callback=person)
        return outcome if asked else "nobody was asked"

    def cancel_by_tool(self, text: str) -> str:
        """Cancel it by a tool at a random instant."""

        async def dialogue(client: Client) -> str:
            run = await _begun(client, text)
            await self._random_while()
            await _called(client, "cancel", reason="an evaluation")
            return await self._heard(client, run)

        return self._talk(dialogue)

    def give_up(self, text: str) -> str:
        """Give up the call that waits for it."""

        async def dialogue(client: Client) -> str:
            run = await _begun(client, text)
            with anyio.move_on_after(float(self._rng.uniform(0.5, 4.0))):
                await _status(client, run, 45.0)
            return await self._heard(client, run)

        return self._talk(dialogue)

    def hang_up(self, text: str) -> str:
        """End the connection between two calls, as a client that is closed does."""

        async def dialogue(client: Client) -> str:
            await _begun(client, text)
            await self._random_while()
            return "left"

        return self._talk(dialogue)

    def die_waiting(self, text: str) -> str:
        """Be killed in mid-call."""
        return self._die(text, waits=True)

    def die_between_calls(self, text: str) -> str:
        """Be killed between two calls."""
        return self._die(text, waits=False)

    def _die(self, text: str, waits: bool) -> str:
        with self._door.mortal_client(self._kind, text, waits) as process:
            try:
                begun = process.stdout.readline() if process.stdout is not None else ""
                self._wall.sleep(float(self._rng.uniform(0.5, 4.0)))
                under_way = self._desk.status()["task"] == text
            finally:
                process.kill()
        if begun and under_way:
            return "left"
        self._message = str([run.report.get("tasks") for run in recorded_runs(self._robot.runs)[-1:]])
        return "it was not under way"

    def _talk(self, dialogue: Callable[[Client], Awaitable[str]], **options: Any) -> str:
        async def whole() -> str:
            async with self._door.client(self._kind, f"client {self._seed}", **options) as client:
                with anyio.fail_after(_ENDS_WITHIN_S):
                    return await dialogue(client)

        return anyio.run(whole)

    async def _begin_and_hear(self, client: Client, text: str) -> str:
        return await self._heard(client, await _begun(client, text))

    async def _heard(self, client: Client, run: str) -> str:
        while True:
            told = await _status(client, run, float(self._rng.uniform(0.0, 10.0)))
            if told["ended"]:
                self._message = str(told["message"])
                return str(told["outcome"])

    async def _next(self) -> str:
        async with self._door.client("http", f"next {self._seed}") as client:
            return await self._begin_and_hear(client, _NEXT)

    async def _random_while(self) -> None:
        await anyio.sleep(float(self._rng.uniform(0.5, 4.0)))

    def _is_idle(self) -> bool:
        self._wall.sleep(0.1)
        return self._desk.status()["task"] is None


_Plan = Callable[[_Episode, str], str]
_PLANS: dict[str, tuple[_Plan, tuple[str, ...], tuple[str, ...]]] = {
    "hears it out": (_Episode.hear_out, _SHORT, ("done",)),
    "answers by a tool": (_Episode.answer_by_tool, tuple(_ANSWERS), ("done",)),
    "answers as elicited": (_Episode.answer_as_elicited, tuple(_ANSWERS), ("done",)),
    "cancels by a tool": (_Episode.cancel_by_tool, _LONG, ("cancelled",)),
    "gives up its call": (_Episode.give_up, _LONG, ("cancelled",)),
    "hangs up": (_Episode.hang_up, _LONG, ("left",)),
    "dies waiting": (_Episode.die_waiting, _LONG, ("left",)),
    "dies between calls": (_Episode.die_between_calls, _LONG, ("left",)),
}
"""What a client does: how, with which sentences, and what it may truthfully be told."""


async def _called(client: Client, tool: str, **arguments: Any) -> dict[str, Any]:
    answer = await client.call_tool(tool, arguments)
    if answer.is_error or answer.structured_content is None:
        raise ValueError(f"{tool}: {answer.content}")
    return dict(answer.structured_content)


async def _begun(client: Client, text: str) -> str:
    return str((await _called(client, "start_task", text=text))["run"])


async def _status(client: Client, run: str, wait_s: float) -> dict[str, Any]:
    return await _called(client, "task_status", run=run, wait_s=wait_s)
