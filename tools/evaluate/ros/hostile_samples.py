"""Suite ``ros_hostile``: malformed and hostile samples on every topic that the ROS door reads.

None may end the bridge, the executive or the control, none may move the robot or engage its stop; the memory
of each of the three stays within 2 % of what it was after the first tenth; a proper sentence is carried out
afterwards. ``--episodes N`` sends N thousand samples to every topic; one that our own writer refuses to send
does not count. Last come as many on the stop's topic, which may stop the robot and nothing else.
"""

from __future__ import annotations

import argparse
import json
import math
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from cyclonedds.core import DDSException
from cyclonedds.idl import IdlStruct
from cyclonedds.pub import DataWriter
from rich.console import Console

from executive.doors.ros.graph import RosNode, best_effort, reliable, taken
from executive.doors.ros.messages import Bool, String, Twist, TwistStamped
from executive.doors.ros.settings import RosSettings
from robots.clock import WallClock
from tools.evaluate.ros.bridged_robot import BridgedRobot, memory_kb
from tools.evaluate.ros.hostile_bytes import hostile

SUITE = "ros_hostile"
GROWTH = 0.02
_AT_ONCE, _PAUSE_S = 8, 0.004
_LOOKS = 20
_SETTLED = 2
"""Memory is compared with this look, after the first tenth."""
_SETTLES_S = 5.0
_TRIES = 50
_AFTERWARDS = "wait for 0.2 seconds"
_SAYS_EVERY_S, _ENDS_WITHIN_S = 10.0, 60.0


def run_ros_hostile(options: argparse.Namespace, messages: Console) -> int:
    """Run the suite; 0 when everything was as it has to be."""
    with (
        tempfile.TemporaryDirectory(prefix="ros-hostile-") as folder,
        BridgedRobot(Path(folder), options.seed, options.robot, options.pace) as robot,
    ):
        robot.wait_until_ready()
        found = _Trial(robot, options.seed, messages).run(1000 * options.episodes)
    growth = {name: growth_of(kept) for name, kept in found["memory_kb"].items()}
    good = (
        found["alive"]
        and found["moved"] == 0
        and found["afterwards"].startswith("done")
        and not found["emergency"]
        and all(one["within"] for one in growth.values())
    )
    document = {
        "suite": SUITE,
        "episodes": options.episodes,
        "seed": options.seed,
        "success_rate": float(good),
        "memory_growth": growth,
        **found,
    }
    if options.json is not None:
        options.json.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    Console().print(json.dumps(document, indent=1))
    return 0 if good else 1


def growth_of(kept_kb: list[int]) -> dict[str, Any]:
    """How the memory of a process went on from the look at which it has settled.

    Args:
        kept_kb: Resident memory at each look.

    Returns:
        Then, and the lowest and the highest after it, in kB; these two as shares of that; whether both lie
        within the bar.
    """
    settled, after = kept_kb[min(_SETTLED, len(kept_kb) - 1)], kept_kb[_SETTLED:] or kept_kb[-1:]
    low, high = min(after) / settled - 1.0, max(after) / settled - 1.0
    return {
        "settled_kb": settled,
        "lowest_kb": min(after),
        "highest_kb": max(after),
        "share": [round(low, 5), round(high, 5)],
        "within": low >= -GROWTH and high <= GROWTH,
    }


class _Trial:
    def __init__(self, robot: BridgedRobot, seed: int, messages: Console) -> None:
        self._robot, self._messages, self._wall = robot, messages, WallClock()
        self._rng = np.random.default_rng(seed)
        self._node = RosNode(RosSettings(robot.domain, node="hostile"))
        self._heard = self._node.reader("/ai/status", String, reliable(100))
        self._writers: list[tuple[DataWriter[Any], type[IdlStruct]]] = [
            (self._node.writer("/ai/command", String, reliable()), String),
            (self._node.writer("/ai/answer", String, reliable()), String),
            (self._node.writer("/cmd_vel", Twist, best_effort()), Twist),
            (self._node.writer("/cmd_vel", TwistStamped, reliable()), TwistStamped),
        ]
        self._stops = self._node.writer("/emergency_stop", Bool, reliable())
        self._said = self._writers[0][0]

    def run(self, samples: int) -> dict[str, Any]:
        """Send so many samples to each topic, and find out what came of it."""
        robot = self._robot
        everyone = [writer for writer, _ in self._writers] + [self._stops]
        robot.wait(lambda: all(one.get_matched_subscriptions() for one in everyone), "the bridge listens")
        memory: dict[str, list[int]] = {}
        sent = self._flood(self._writers, samples, memory)
        moved, emergency = robot.started, bool(robot.status()["stops"])
        alive = robot.bridge_lives and robot.service.executive.poll() is None
        line = self._afterwards() if alive else "the bridge or the executive has ended"
        sent += self._flood([(self._stops, Bool)], samples, memory)
        self._wall.sleep(1.0)
        return {
            "samples": sent,
            "alive": alive and robot.bridge_lives and robot.service.control.poll() is None,
            "moved": max(moved, robot.started),
            "emergency": emergency,
            "afterwards": line,
            "stopped_by_broken_stops": list(robot.status()["stops"]),
            "memory_kb": memory,
        }

    def _flood(
        self,
        writers: list[tuple[DataWriter[Any], type[IdlStruct]]],
        samples: int,
        memory: dict[str, list[int]],
    ) -> int:
        sent = 0
        every = max(samples // _LOOKS // _AT_ONCE, 1)
        for turn in range(samples // _AT_ONCE):
            for writer, kind in writers:
                sent += sum(self._send(writer, kind) for _ in range(_AT_ONCE))
            self._wall.sleep(_PAUSE_S)
            taken(self._heard)
            if turn % every == 0 and not self._look(sent, memory):
                break
        self._wall.sleep(_SETTLES_S)
        self._look(sent, memory)
        return sent

    def _send(self, writer: DataWriter[Any], kind: type[IdlStruct]) -> bool:
        """Send a sample, and tell whether that was possible; what the writer refuses is made anew."""
        for _ in range(_TRIES):
            try:
                writer.write(hostile(kind, self._rng))
            except DDSException:  # it is no CDR by the writer's own lights, or the reliable reader is behind
                continue
            return True
        return False

    def _look(self, sent: int, memory: dict[str, list[int]]) -> bool:
        robot = self._robot
        robot.look()
        service = robot.service
        processes = {"executive": service.executive, "control": service.control, "bridge": robot.bridge}
        ended = [name for name, one in processes.items() if one.poll() is not None]
        if ended:
            self._messages.print(f"{sent}: {ended} ended", markup=False)
            return False
        for name, one in processes.items():
            memory.setdefault(name, []).append(memory_kb(one.pid))
        newest = {name: kept[-1] for name, kept in memory.items()}
        self._messages.print(f"{sent} samples, kB {newest}", markup=False)
        return True

    def _afterwards(self) -> str:
        """Say a sentence as anybody does, again where it is refused, and hear its last line.

        What was queued up before it has to be refused first.
        """
        lines: list[str] = []

        def ended() -> bool:
            lines.extend(one.data for one in taken(self._heard))
            return any(line.startswith("done") for line in lines)

        until_s, said_s = self._wall.now_s() + _ENDS_WITHIN_S, -math.inf
        while not ended() and self._wall.now_s() < until_s:
            if self._wall.now_s() - said_s >= _SAYS_EVERY_S:
                said_s = self._wall.now_s()
                self._said.write(String(_AFTERWARDS))
            self._wall.sleep(0.05)
        return lines[-1] if lines else "nothing was heard"
