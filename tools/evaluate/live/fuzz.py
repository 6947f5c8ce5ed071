"""Suite ``fuzz``: random and mutated messages to a served robot's control socket.

Nothing of it may end the control process, move the robot or make memory grow, and a proper client is
served all the while. ``--episodes N`` sends N thousand random and N hundred mutated messages.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from rich.console import Console

from executive.live.caller.caller import Caller
from kinematics.model.robot_model import RobotModel
from robots.clock import WallClock
from robots.live.documents.robot_report import ReportLayout
from robots.live.wire.errors import LiveError
from robots.live.wire.framing import FrameKind, encode_frame
from robots.live.wire.messages import (
    Admit,
    CancelMotion,
    ControlMessage,
    FinishMotion,
    GetStatus,
    Guarded,
    Heartbeat,
    Hello,
    Lead,
    Pause,
    Resume,
    Shutdown,
    Start,
    Walk,
    write_control_message,
    write_message,
)
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.state_slot import StateSlotReader
from robots.live.wire.unix_socket import connect_to
from robots.models.description import load_description

_SEEDS: tuple[ControlMessage, ...] = (
    Hello("observer"),
    Heartbeat(1, 0.0, True, True, True, 1),
    Admit(2, 0.0, 1, 1),
    Start(3, 0.0, 1, 1),
    Guarded(4, 0.0, 2, "close gripper", "left", 0.0),
    CancelMotion(5, 1, "why"),
    Lead(6, 0.0, 3, 1),
    Walk(7, 0.0, 4),
    FinishMotion(8, 4),
    Pause(9, "why"),
    Resume(10, 0.0),
    GetStatus(),
)
_LOOK_EVERY = 500
GROWTH = 0.05
"""Memory may grow by this share from the first tenth of the messages to the last."""
_READY_S = 120.0
_ANSWERED_WITHIN_S = 60.0


@dataclass(frozen=True, slots=True)
class FuzzResult:
    """What came of it."""

    random: int
    mutated: int
    alive: bool
    served: bool
    moved_rad: float
    started: int
    memory_kb: tuple[int, ...]

    @property
    def growth(self) -> float:
        """Share by which memory has grown since the first tenth."""
        settled = self.memory_kb[max(1, len(self.memory_kb) // 10)]
        return max(self.memory_kb) / settled - 1.0

    @property
    def good(self) -> bool:
        """Whether everything was as it has to be."""
        return (
            self.alive
            and self.served
            and self.moved_rad == 0.0
            and self.started == 0
            and self.growth <= GROWTH
        )


def run_fuzz(episodes: int, seed: int, robot: str, file: Path | None, messages: Console) -> int:
    """Run the suite; 0 when everything was as it has to be."""
    with tempfile.TemporaryDirectory(prefix="fuzz-") as folder:
        result = _fuzz(
            RuntimeFolder(Path(folder) / "live"), 1000 * episodes, 100 * episodes, seed, robot, messages
        )
    document = {
        "suite": "fuzz",
        "episodes": episodes,
        "seed": seed,
        "random": result.random,
        "mutated": result.mutated,
        "alive": result.alive,
        "served": result.served,
        "moved_rad": result.moved_rad,
        "motions_started": result.started,
        "memory_kb": list(result.memory_kb),
        "memory_growth": result.growth,
        "success_rate": float(result.good),
    }
    if file is not None:
        file.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    Console().print(
        json.dumps({key: value for key, value in document.items() if key != "memory_kb"}, indent=1)
    )
    return 0 if result.good else 1


def _fuzz(
    folder: RuntimeFolder, random: int, mutated: int, seed: int, robot: str, messages: Console
) -> FuzzResult:
    rng = np.random.default_rng(seed)
    layout = ReportLayout(RobotModel(load_description(robot)))
    command = [
        sys.executable,
        "-m",
        "robots.live.process.control_process",
        os.fspath(folder.path),
        "--robot",
        robot,
    ]
    command += ["--scene", "tabletop", "--ordinary", "--evaluation", "--pace", "1"]
    process = subprocess.Popen(command, start_new_session=True)
    try:
        proper = _await(folder, process)
        proper.ask(write_control_message(Hello("observer")))
        slot = StateSlotReader(folder.state_slot)
        evaluation = Caller(folder.evaluation_socket)
        evaluation.ask(write_message("pace", pace=0.0))
        at_rest = _reference(slot, layout)
        order = rng.permutation(np.repeat([True, False], [mutated, random]))
        memory: list[int] = []
        started, served, moved_rad = 0, True, 0.0
        for i, mutate in enumerate(order.tolist()):
            _send(folder, _mutated(rng) if mutate else _random(rng))
            if i % _LOOK_EVERY == 0:
                status = _status(proper)
                served = served and status is not None
                if status is None:
                    break
                started = max(started, len(status["motions"]))
                moved_rad = max(moved_rad, float(np.abs(_reference(slot, layout) - at_rest).max()))
                memory.append(_memory_kb(process.pid))
                if i % (10 * _LOOK_EVERY) == 0:
                    messages.print(f"{i} of {random + mutated}: {memory[-1]} kB", markup=False)
        alive = process.poll() is None
        proper.send(write_control_message(Shutdown()))
        process.wait(60.0)
        return FuzzResult(random, mutated, alive, served, moved_rad, started, tuple(memory))
    finally:
        process.kill()
        process.wait()


def _status(proper: Caller) -> dict[str, Any] | None:
    """The answer to a proper question; what an observer is told beside it is left out."""
    found: list[dict[str, Any]] = []

    def take(answer: dict[str, Any]) -> bool:
        found.append(answer)
        return bool(answer["type"] == "status")

    proper.send(write_control_message(GetStatus()))
    try:
        proper.listen(take, _ANSWERED_WITHIN_S)
    except LiveError:
        return None
    return found[-1]


def _await(folder: RuntimeFolder, process: subprocess.Popen[bytes]) -> Caller:
    wall = WallClock()
    while wall.now_s() < _READY_S:
        try:
            return Caller(folder.control_socket)
        except LiveError:
            if process.poll() is not None:
                break
            wall.sleep(0.1)
    raise LiveError("the control process does not serve")


def _send(folder: RuntimeFolder, data: bytes) -> None:
    """One connection for each: the first thing that is no message ends it."""
    connected = connect_to(folder.control_socket)
    try:
        connected.settimeout(5.0)
        connected.sendall(data)
    except OSError:  # it was ended while it was still sending
        pass
    finally:
        connected.close()


def _random(rng: np.random.Generator) -> bytes:
    kind = rng.integers(4)
    if kind == 0:
        return rng.bytes(int(rng.integers(1, 300)))
    if kind == 1:
        return encode_frame(FrameKind.MESSAGE, rng.bytes(int(rng.integers(0, 300))))
    if kind == 2:
        return encode_frame(FrameKind.MESSAGE, json.dumps(_value(rng, 3)).encode())
    fields: dict[str, Any] = {str(name): _value(rng, 1) for name in rng.choice(_NAMES, 3)}
    return encode_frame(FrameKind.MESSAGE, json.dumps({"type": str(rng.choice(_TYPES)), **fields}).encode())


_TYPES = (
    *("hello", "heartbeat", "admit", "start", "guarded", "lead", "walk", "steer", "finish", "cancel"),
    *("pause", "resume", "status", "reset", "welcome", ""),
)
_NAMES = ("number", "stamp_s", "motion", "trajectory", "role", "name", "hand", "reason", "person", "busy")


def _value(rng: np.random.Generator, depth: int) -> Any:
    kind = rng.integers(7 if depth > 0 else 5)
    if kind == 5:
        return [_value(rng, depth - 1) for _ in range(rng.integers(4))]
    if kind == 6:
        return {str(rng.choice(_NAMES)): _value(rng, depth - 1) for _ in range(rng.integers(4))}
    return (None, bool(rng.integers(2)), int(rng.integers(-9, 9)), float(rng.normal()), "left")[kind]


def _mutated(rng: np.random.Generator) -> bytes:
    """A proper message with some bytes changed, dropped, doubled or cut off."""
    message = _SEEDS[int(rng.integers(len(_SEEDS)))]
    data = bytearray(encode_frame(FrameKind.MESSAGE, write_control_message(message)))
    for _ in range(int(rng.integers(1, 4))):
        if not data:
            break
        at = int(rng.integers(len(data)))
        kind = rng.integers(4)
        if kind == 0:
            data[at] = int(rng.integers(256))
        elif kind == 1:
            del data[at]
        elif kind == 2:
            data[at:at] = data[at : at + int(rng.integers(1, 20))]
        else:
            del data[max(1, at) :]
    return bytes(data)


def _reference(slot: StateSlotReader, layout: ReportLayout) -> NDArray[np.float64]:
    """What is commanded in the newest state: no noise is in it."""
    wall = WallClock()
    while (row := slot.newest()) is None:
        wall.sleep(0.001)
    return layout.report(row).reference


def _memory_kb(pid: int) -> int:
    for line in Path(f"/proc/{pid}/status").read_text("ascii").splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1])
    return 0
