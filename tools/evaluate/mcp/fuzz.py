"""Suite ``mcp-fuzz``: random and nearly fitting calls of every tool, and bodies that are no calls.

Every answer must be a result or an error that says what is wrong, nothing may move, and the server must go on
with steady memory. ``--episodes N`` makes N hundred calls, a twentieth of them as mutated bytes. Clients of
the newer and of the older protocol take turns, so that the first tenth of the calls has used everything once.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections import Counter
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

import anyio
import httpx2
import numpy as np
from mcp import Client, MCPError
from mcp_types import CallToolResult, TextContent
from rich.console import Console

from executive.live.caller.caller import ask_at
from robots.live.wire.messages import Reset, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder
from tools.evaluate.live.served_robot import ServedRobot
from tools.evaluate.mcp.arguments import ArgumentMaker
from tools.evaluate.mcp.door import McpDoor

GROWTH = 0.02
"""Resident memory may grow by this share from the first tenth of the calls to the last."""
_CALLS = 100
_BYTES_SHARE = 0.05
_STOP_SHARE = 0.1
"""Of calls of ``stop``, to one of another tool: each that latches is reset, which takes its time."""
_LOOKS = 50
_ROUNDS = 10
_LEASE_S = 60.0
_AFTERWARDS = "wait for 0.2 seconds"
_TRACES = ("Traceback (most recent call last)", 'File "/', "site-packages")
_RESTS_S = 1.0


@dataclass(slots=True)
class FuzzRecord:
    """What came of it.

    Attributes:
        calls: How many were made, by tool; bytes that are no call as "bytes".
        answers: How many ended as a result, an error of the tool, or one of the protocol.
        unclear: Answers that tell nothing, or too much: tool, arguments and answer.
        latched: Calls that were the emergency stop, and latched it.
        motions: Motions that began.
        fallen: Whether the robot fell.
        alive: Whether the server went on, and carried out a task at the end.
        memory_kb: Of the server, as it went on.
    """

    calls: Counter[str] = field(default_factory=Counter)
    answers: Counter[str] = field(default_factory=Counter)
    unclear: list[str] = field(default_factory=list)
    latched: int = 0
    motions: int = 0
    fallen: bool = False
    alive: bool = False
    memory_kb: list[int] = field(default_factory=list)

    @property
    def growth(self) -> float:
        """Share by which memory has grown since the first tenth."""
        return max(self.memory_kb) / self.memory_kb[max(1, len(self.memory_kb) // 10)] - 1.0

    @property
    def good(self) -> bool:
        """Whether everything was as it has to be."""
        still = self.motions == 0 and not self.fallen
        return self.alive and still and not self.unclear and self.growth <= GROWTH


def run_mcp_fuzz(options: argparse.Namespace, messages: Console) -> int:
    """Run the suite; 0 when everything was as it has to be."""
    with tempfile.TemporaryDirectory(prefix="mcp-fuzz-") as folder:
        robot = ServedRobot(Path(folder), options.seed, options.robot, options.pace)
        try:
            robot.wait_until_ready()
            where = RuntimeFolder(Path(folder) / "live")
            with McpDoor(where, _LEASE_S) as door:
                campaign = _Campaign(robot, where, door, options.seed, messages)
                record = anyio.run(campaign.run, _CALLS * options.episodes)
        finally:
            robot.end()
    document = {
        "suite": "mcp-fuzz",
        "episodes": options.episodes,
        "seed": options.seed,
        **{field.name: getattr(record, field.name) for field in fields(record)},
        "memory_growth": record.growth,
        "success_rate": float(record.good),
    }
    if options.json is not None:
        options.json.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    Console().print(json.dumps(document, indent=1), markup=False)
    return 0 if record.good else 1


class _Campaign:
    """All calls of one run."""

    def __init__(
        self, robot: ServedRobot, where: RuntimeFolder, door: McpDoor, seed: int, messages: Console
    ) -> None:
        self._robot, self._where, self._door, self._messages = robot, where, door, messages
        self._rng = np.random.default_rng(seed)
        self._record = FuzzRecord()

    async def run(self, count: int) -> FuzzRecord:
        """Make so many calls; what begins afterwards is proper, and is carried out."""
        began = self._robot.started
        for turn in range(2 * _ROUNDS):
            kind = ("http", "http, legacy")[turn % 2]
            async with self._door.client(kind, "fuzz") as client:
                await self._call_all(client, count // (2 * _ROUNDS), count)
        self._record.motions = self._robot.started - began
        self._record.fallen = self._robot.fallen()
        async with self._door.client("http", "proper") as client:
            run = (await client.call_tool("start_task", {"text": _AFTERWARDS})).structured_content or {}
            ended = await client.call_tool("task_status", {"run": run.get("run"), "wait_s": 45.0})
            self._record.alive = (ended.structured_content or {}).get("outcome") == "done"
        return self._record

    async def _call_all(self, client: Client, count: int, all_: int) -> None:
        tools = (await client.list_tools()).tools
        makers = [(tool.name, ArgumentMaker(tool.input_schema, self._rng)) for tool in tools]
        weights = np.array([_STOP_SHARE if name == "stop" else 1.0 for name, _ in makers])
        shares = weights / weights.sum()
        async with httpx2.AsyncClient(headers=self._door.headers, timeout=60.0) as http:
            for _ in range(count):
                made = self._record.calls.total()
                if made % max(1, all_ // _LOOKS) == 0:
                    self._note(made, all_)
                if self._rng.random() < _BYTES_SHARE:
                    await self._send_bytes(http)
                else:
                    name, maker = makers[int(self._rng.choice(len(makers), p=shares))]
                    await self._call(client, name, maker.make())

    async def _call(self, client: Client, tool: str, arguments: dict[str, Any]) -> None:
        if tool == "stop" and arguments.get("category") == 0:
            arguments["category"] = 3  # without power it falls, as it has to
        self._record.calls[tool] += 1
        try:
            answer = await client.call_tool(tool, arguments)
        except MCPError as wrong:
            self._judge(tool, arguments, "protocol's error", str(wrong))
            return
        except (ValueError, TypeError):
            self._record.answers["not sendable"] += 1  # the SDK's client itself refuses to write it
            return
        kind = "error" if answer.is_error else "result"
        self._judge(tool, arguments, kind, _words_of(answer))
        if tool == "stop" and not answer.is_error:
            self._reset(arguments)

    def _judge(self, tool: str, arguments: object, kind: str, words: str) -> None:
        self._record.answers[kind] += 1
        empty = kind != "result" and words.strip() in (
            "",
            f"Error executing tool {tool}",
            "Internal server error",
        )
        if empty or any(trace in words for trace in _TRACES):
            self._record.unclear.append(f"{tool} {str(arguments)[:300]}: {words[:300]}")

    def _reset(self, arguments: object) -> None:
        """A person's act after a stop that was one."""
        if not self._robot.status()["emergency"]:
            self._record.unclear.append(f"stop {str(arguments)[:300]}: it did not latch")
            return
        self._record.latched += 1
        until_s = self._robot.look() + _RESTS_S
        self._robot.wait(lambda: self._robot.look() > until_s, "it rests")
        ask_at(self._where.control_socket, write_control_message(Reset("an evaluation")))
        self._robot.wait(lambda: not self._robot.status()["emergency"], "it is reset")

    async def _send_bytes(self, http: httpx2.AsyncClient) -> None:
        """A body that is no call, or hardly one."""
        self._record.calls["bytes"] += 1
        body = bytearray(
            json.dumps(
                {"jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": {"name": "look"}}
            ).encode()
        )
        for _ in range(int(self._rng.integers(1, 6))):
            at = int(self._rng.integers(len(body)))
            match int(self._rng.integers(3)):
                case 0:
                    body[at] = int(self._rng.integers(256))
                case 1:
                    del body[at]
                case _:
                    body[at:at] = body[at : at + int(self._rng.integers(1, 30))]
        headers = {"Content-Type": "application/json", "Accept": "application/json, text/event-stream"}
        if self._rng.random() < 0.5:
            headers["MCP-Protocol-Version"] = "2026-07-28"
        answer = await http.post(self._door.url, content=bytes(body), headers=headers)
        kind = "protocol's error" if answer.status_code < 500 else f"HTTP {answer.status_code}"
        self._judge("bytes", bytes(body), kind, answer.text or str(answer.status_code))
        if answer.status_code >= 500:
            self._record.unclear.append(f"bytes {bytes(body)!r}: HTTP {answer.status_code}")

    def _note(self, index: int, count: int) -> None:
        self._record.memory_kb.append(_memory_kb(self._door.process.pid))
        self._messages.print(
            f"{index} of {count}: {self._record.memory_kb[-1]} kB, unclear {len(self._record.unclear)}",
            markup=False,
        )


def _words_of(answer: CallToolResult) -> str:
    return "\n".join(one.text for one in answer.content if isinstance(one, TextContent))


def _memory_kb(pid: int) -> int:
    for line in Path(f"/proc/{pid}/status").read_text("ascii").splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1])
    return 0
