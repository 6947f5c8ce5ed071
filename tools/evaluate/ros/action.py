"""Suite ``ros_action``: tasks by the action of the rclpy node; clients hear out, cancel, or are killed.

Three of five episodes are heard out, one is cancelled, and one's client is killed. Each result has to be what
the sentence comes to, the robot has to rest afterwards, and the next goal has to be accepted. Every second
killed client tells its goal's id; how long a dead one goes unnoticed is told in wall time.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import subprocess
import tempfile
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console

import executive.doors.ros.node
from executive.doors.served_robot import ServedRobot
from executive.live.caller.caller import NoAnswerError
from robots.clock import WallClock
from robots.live.wire.errors import LiveError
from tools.benchmark.peers.environments import ROS_NAMES, PeerEnvironment, default_cache
from tools.evaluate.ros.bridged_robot import BridgedRobot

_NODE = Path(executive.doors.ros.node.__file__).parent / "humanoid_node.py"
_CLIENT = Path(__file__).parent / "client" / "action_client.py"
_SHORT = (
    ("wait for 0.5 seconds", 0),
    ("move forward at 0.1 m/s for 1 second", 0),
    ("move backward at 0.1 m/s for 1 second", 0),
    ("say hello", 0),
    ("move forward at 0.8 m/s for 1 second", 2),
    ("fly to the moon", 2),
)
"""Sentences with the exit code that each comes to on an open floor."""
_LONG = ("wait for 200 seconds", "turn left at 0.1 rad/s for 60 seconds")
_SENTENCES = (*(text for text, _ in _SHORT), *_LONG)
_ENDINGS = ("hear", "hear", "hear", "cancel", "die")
_STATUS = {0: 4, 2: 6}
_CANCELED, _CANCELLED_CODE = 5, 4
_AFTER_S = (0.3, 4.0)
_CLIENT_WITHIN_S, _AT_REST_WITHIN_S = 300.0, 60.0


@dataclass(frozen=True, slots=True)
class ActionRecord:
    """How an episode ended.

    Attributes:
        seed: Of its choices.
        sentence: What was asked.
        ending: "hear", "cancel" or "die".
        tells: Whether the client told its goal's id.
        told: What the client was told: status of the goal, exit code, messages of feedback.
        noticed_s: Wall time from the death of a client to the end of its task.
        good: Whether everything was as it has to be.
        detail: What was not.
    """

    seed: int
    sentence: str
    ending: str
    tells: bool
    told: dict[str, Any]
    noticed_s: float | None
    good: bool
    detail: str = ""


def run_ros_action(options: argparse.Namespace, messages: Console) -> int:
    """Run the suite with the newest distribution that is installed; 0 when everything was as it has to be."""
    environments = [PeerEnvironment(name, default_cache()) for name in ROS_NAMES]
    ready = [one for one in environments if one.is_ready]
    if not ready:
        messages.print(
            f"error: no rclpy: python -m tools.benchmark.peers {' '.join(ROS_NAMES)}", markup=False
        )
        return 2
    records: list[ActionRecord] = []
    with (
        tempfile.TemporaryDirectory(prefix="ros-action-") as folder,
        BridgedRobot(Path(folder), options.seed, options.robot, options.pace) as robot,
    ):
        robot.wait_until_ready()
        with _node(robot, Path(folder), ready[-1]) as surroundings:
            for i in range(options.episodes):
                rng = np.random.default_rng(options.seed + i)
                ending = _ENDINGS[i % len(_ENDINGS)]
                tells = i // len(_ENDINGS) % 2 == 1
                try:
                    record = _episode(robot, rng, options.seed + i, ending, tells, surroundings)
                except (LiveError, subprocess.SubprocessError, ValueError) as wrong:
                    record = ActionRecord(options.seed + i, "", ending, tells, {}, None, False, str(wrong))
                records.append(record)
                messages.print(f"{i + 1} of {options.episodes}: {record}", markup=False, soft_wrap=True)
        fallen = robot.fallen()
    document = {
        "suite": "ros_action",
        "peer": ready[-1].version,
        "episodes": len(records),
        "seed": options.seed,
        "success_rate": sum(record.good for record in records) / len(records),
        "falls": int(fallen),
        "noticed_s": {
            "telling": _noticed(records, tells=True),
            "saying nothing": _noticed(records, tells=False),
        },
        "failed_seeds": [record.seed for record in records if not record.good],
        "episodes_detail": [asdict(record) for record in records],
    }
    if options.json is not None:
        options.json.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    Console().print(json.dumps({k: v for k, v in document.items() if k != "episodes_detail"}, indent=1))
    return 0 if all(record.good for record in records) and not fallen else 1


def _noticed(records: list[ActionRecord], *, tells: bool) -> list[float]:
    times = [one.noticed_s for one in records if one.noticed_s is not None and one.tells == tells]
    return sorted(round(time_s, 1) for time_s in times)


@contextlib.contextmanager
def _node(robot: BridgedRobot, folder: Path, environment: PeerEnvironment) -> Iterator[list[Any]]:
    """The node in front of the robot; yields its interpreter and its environment."""
    sentences = folder / "sentences.txt"
    sentences.write_text("\n".join(_SENTENCES), "utf-8")
    surroundings = {
        **os.environ,
        "ROS_DOMAIN_ID": str(robot.domain),
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
    }
    surroundings.pop("PYTHONPATH", None)
    python = str(environment.python)
    command = [python, str(_NODE), str(robot.live), "--sentences", str(sentences)]
    with subprocess.Popen(command, env=surroundings) as process:
        try:
            yield [python, surroundings]
        finally:
            process.kill()


def _episode(
    robot: BridgedRobot, rng: np.random.Generator, seed: int, ending: str, tells: bool, client: list[Any]
) -> ActionRecord:
    short = ending == "hear"
    number = int(rng.integers(len(_SHORT)) if short else rng.integers(len(_SHORT), len(_SENTENCES)))
    sentence, python, surroundings = _SENTENCES[number], client[0], client[1]
    after_s = 0.0 if short else float(rng.uniform(*_AFTER_S))
    command = [python, str(_CLIENT), str(number), ending, str(after_s), "tell" if tells else "-"]
    with subprocess.Popen(command, env=surroundings, stdout=subprocess.PIPE, text=True) as process:
        text, _ = process.communicate(timeout=_CLIENT_WITHIN_S)
    told = json.loads(text.strip().splitlines()[-1]) if text.strip() else {}
    noticed_s = _rest(robot)
    if short:
        code = dict(_SHORT)[sentence]
        good = (told.get("status"), told.get("code")) == (_STATUS[code], code)
    elif ending == "cancel":
        good = (told.get("status"), told.get("code")) == (_CANCELED, _CANCELLED_CODE)
    else:
        good = bool(told.get("died"))
    dead_s = noticed_s if ending == "die" else None
    return ActionRecord(seed, sentence, ending, tells, told, dead_s, good)


def _rest(robot: BridgedRobot) -> float:
    """Wait until no task is under way and the body rests; wall seconds until the task had ended.

    Raises:
        LiveError: It goes on.
    """
    wall, door = WallClock(), ServedRobot(robot.live)
    began_s = wall.now_s()
    while True:
        with contextlib.suppress(NoAnswerError):
            if door.status()["task"] is None:
                break
        if wall.now_s() - began_s > _AT_REST_WITHIN_S:
            raise LiveError("the task of a client that has gone goes on")
        wall.sleep(0.05)
    ended_s = wall.now_s() - began_s
    robot.wait(lambda: robot.look() > 0.0 and robot.resting, "the robot rests")
    return ended_s
