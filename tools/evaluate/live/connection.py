"""Suite ``connection``: what crosses the socket comes late, never, twice, in another order, or ends.

The fault strikes at a random instant of a pick and stays. The robot must not fall, no setpoint may be
refused, the task must end as done or with a typed reason, or its executive must lose its place; afterwards
the robot rests, and a new executive completes a task.
"""

from __future__ import annotations

import argparse
import json
import signal
import tempfile
import traceback
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console

from executive.live.caller.caller import NoAnswerError
from robots.live.wire.faulty_connection import CONNECTION_FAULTS
from tools.evaluate.live.kill_episode import AFTERWARDS, first_stop
from tools.evaluate.live.served_robot import ServedRobot

_ENDS_WITHIN_S = 150.0
"""Control time in which the task has ended, one way or the other."""
_STANDS_S = 5.0
_TYPED = (0, 1, 4, 5)


@dataclass(frozen=True, slots=True)
class ConnectionRecord:
    """How an episode ended.

    Attributes:
        seed: Of scene, run, instant and fault.
        fault: Its name.
        ended: The task's result line, or that its executive lost its place, or what broke.
        code: Its exit code; None when nobody told one.
        motion: What was under way when the fault struck.
        noticed_s: Control time from there to the first stop, or to the task's end.
        refused: Setpoints that the gate refused.
        fallen: Whether the robot fell.
        resumed: Whether a new executive completed a task.
    """

    seed: int
    fault: str
    ended: str
    code: int | None = None
    motion: str = ""
    noticed_s: float | None = None
    refused: int = 0
    fallen: bool = False
    resumed: bool = False

    @property
    def good(self) -> bool:
        """Whether everything was as it has to be."""
        typed = self.code is None or self.code in _TYPED
        return typed and self.resumed and not self.fallen and self.refused == 0


def run_connection(options: argparse.Namespace, messages: Console) -> int:
    """Run the suite, with one fault or all in turn; 0 when all was as it has to be, 2 for another fault."""
    episodes, seed, robot, pace, file = (
        getattr(options, name) for name in ("episodes", "seed", "robot", "pace", "json")
    )
    if options.fault not in (None, *CONNECTION_FAULTS):
        messages.print(f"error: --fault must be one of {', '.join(CONNECTION_FAULTS)}", style="bold")
        return 2
    faults = CONNECTION_FAULTS if options.fault is None else (options.fault,)
    records: list[ConnectionRecord] = []
    for i in range(episodes):
        record = _episode(seed + i // len(faults), robot, pace, faults[i % len(faults)])
        records.append(record)
        good = sum(one.good for one in records)
        noticed = "unnoticed" if record.noticed_s is None else f"noticed after {record.noticed_s:.2f} s"
        where = f"seed {record.seed} {record.fault} at {record.motion or 'rest'}"
        messages.print(
            f"{i + 1} of {episodes}: {where}, {noticed}, exit {record.code}; good {good}: "
            f"{record.ended[-300:]}",
            markup=False,
            soft_wrap=True,
        )
    if file is not None:
        file.write_text(json.dumps(_summary(records, seed), indent=1) + "\n", "utf-8")
    Console().print(
        json.dumps({k: v for k, v in _summary(records, seed).items() if k != "episodes_detail"}, indent=1)
    )
    return 0 if all(record.good for record in records) else 1


def _summary(records: list[ConnectionRecord], seed: int) -> dict[str, Any]:
    failures: dict[str, int] = {}
    for record in records:
        if not record.good:
            failures[record.fault] = failures.get(record.fault, 0) + 1
    return {
        "suite": "connection",
        "episodes": len(records),
        "seed": seed,
        "success_rate": sum(record.good for record in records) / max(len(records), 1),
        "falls": sum(record.fallen for record in records),
        "failures": failures,
        "failed_seeds": [[record.seed, record.fault] for record in records if not record.good],
        "episodes_detail": [asdict(record) for record in records],
    }


def _episode(seed: int, robot: str, pace: float, fault: str) -> ConnectionRecord:
    with tempfile.TemporaryDirectory(prefix="connection-") as folder:
        try:
            served = ServedRobot(Path(folder), seed, robot, pace, fault=fault)
        except Exception:
            return ConnectionRecord(seed, fault, traceback.format_exc(), 70)
        try:
            return _run(served, seed, fault)
        except Exception:
            return ConnectionRecord(seed, fault, traceback.format_exc(), 70)
        finally:
            served.end()


def _run(robot: ServedRobot, seed: int, fault: str) -> ConnectionRecord:
    robot.wait_until_ready()
    robot.send()
    motion = robot.wait_for_instant(np.random.default_rng([seed, CONNECTION_FAULTS.index(fault)]))
    struck = robot.service.executive
    struck_s = robot.look()
    struck.send_signal(signal.SIGUSR1)
    ended, code = _end_of_task(robot, struck_s)
    ended_s = robot.look()
    struck.kill()
    struck.wait()
    robot.wait(lambda: robot.look() > ended_s + 0.5 and robot.resting, "the robot rests")
    fallen = robot.stand(_STANDS_S)
    stop = first_stop(robot, struck_s)
    robot.service.start_another_executive()
    robot.wait(robot.commanded, "a new executive attaches")
    again, line = robot.carry_out(AFTERWARDS)
    noticed_s = stop if stop is not None and stop <= ended_s else ended_s
    return ConnectionRecord(
        seed,
        fault,
        ended if again == 0 else f"{ended}; then {AFTERWARDS}: {line}",
        code,
        motion,
        noticed_s=max(0.0, noticed_s - struck_s),
        refused=robot.status()["setpoints"]["refused"],
        fallen=fallen or robot.fallen(),
        resumed=again == 0,
    )


def _end_of_task(robot: ServedRobot, struck_s: float) -> tuple[str, int | None]:
    while robot.look() < struck_s + _ENDS_WITHIN_S:
        try:
            results = robot.results()
        except NoAnswerError:
            return "its executive lost its place", None
        if results:
            return str(results[0]["text"]), int(results[0]["exit_code"])
        seen_s = robot.now_s
        robot.wait(lambda seen_s=seen_s: robot.look() > seen_s + 0.05, "time goes on")  # type: ignore[misc]
    return f"no end within {_ENDS_WITHIN_S:g} s", 70
