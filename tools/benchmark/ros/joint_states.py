"""The ROS door: how late joint states arrive beside a bare pair of DDS, and what it costs the control."""

from __future__ import annotations

import signal
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from cyclonedds.sub import DataReader

from executive.doors.ros.graph import RosNode, reliable, taken
from executive.doors.ros.messages import JointState
from executive.doors.ros.settings import RosSettings
from robots.clock import WallClock, utc_ns
from robots.models.description import load_description
from tools.benchmark.figures import Figure, figure
from tools.evaluate.ros.bridged_robot import BridgedRobot

_ROBOT, _BARE = "talos", "/bare_joint_states"
_BLOCK_S, _LOOK_S, _PHASE_S = 3.0, 0.0002, 4.0
_P99 = 99.0


def ros(quick: bool) -> list[Figure]:
    """Blocks of a few seconds: both writers at once, one reader; then control with and without the bridge."""
    joints = len(load_description(_ROBOT).actuated)
    command = [sys.executable, "-m", "tools.benchmark.ros.bare_writer"]
    with (
        tempfile.TemporaryDirectory(prefix="ros-") as folder,
        BridgedRobot(Path(folder), 0, _ROBOT, 1.0) as robot,
        subprocess.Popen([*command, str(robot.domain), _BARE, str(joints)]) as bare,
    ):
        try:
            robot.wait_until_ready()
            latency = _latency(robot.domain, 5 if quick else 40, bare)
        finally:
            bare.kill()
        late = _lateness(robot, 3 if quick else 20)
    return [*latency, *late]


def _latency(domain: int, blocks: int, bare: subprocess.Popen[bytes]) -> list[Figure]:
    node = RosNode(RosSettings(domain, node="listener"))
    readers = [node.reader(topic, JointState, reliable(100)) for topic in ("/joint_states", _BARE)]
    wall = WallClock()
    while not all(reader.get_matched_publications() for reader in readers):
        if bare.poll() is not None:
            raise RuntimeError(f"the bare writer ended ({bare.returncode})")
        wall.sleep(0.05)
    wall.sleep(1.0)
    medians: tuple[list[float], ...] = ([], [])
    highs: tuple[list[float], ...] = ([], [])
    rates: list[float] = []
    for _ in range(blocks):
        found = _listen(readers, wall)
        rates.append(len(found[0]) / _BLOCK_S)
        for i, times in enumerate(found):
            medians[i].append(float(np.median(times)))
            highs[i].append(float(np.percentile(times, _P99)))
    peer = "bare pair of DDS"
    return [
        figure("joint states' latency p99, ms", highs[0], peer, highs[1]),
        figure("joint states' latency p50, ms", medians[0], peer, medians[1]),
        figure("joint states' rate, Hz", rates),
    ]


def _listen(readers: Sequence[DataReader[Any]], wall: WallClock) -> list[list[float]]:
    """Milliseconds from stamp to arrival on each topic, for one block."""
    found: list[list[float]] = [[] for _ in readers]
    for reader in readers:
        taken(reader)
    until_s = wall.now_s() + _BLOCK_S
    while wall.now_s() < until_s:
        wall.sleep(_LOOK_S)
        for times, reader in zip(found, readers, strict=True):
            for one in taken(reader):
                stamp = one.header.stamp
                times.append((utc_ns() - stamp.sec * 1_000_000_000 - stamp.nanosec) / 1e6)
    return found


def _lateness(robot: BridgedRobot, phases: int) -> list[Figure]:
    """Late periods of the control process while the bridge works, and while it is stopped."""
    wall, found = WallClock(), {True: list[float](), False: list[float]()}
    for i in range(2 * phases):
        works = i % 2 == 0
        robot.bridge.send_signal(signal.SIGCONT if works else signal.SIGSTOP)
        wall.sleep(0.5)
        before = dict(robot.status()["lateness"]["histogram"])
        wall.sleep(_PHASE_S)
        after = dict(robot.status()["lateness"]["histogram"])
        found[works].append(_percentile({key: after[key] - before.get(key, 0) for key in after}))
    robot.bridge.send_signal(signal.SIGCONT)
    return [figure("control period late p99, ms", found[True], "without the bridge", found[False])]


def _percentile(histogram: dict[float, int]) -> float:
    """Upper edge of the bin that holds the 99th percentile."""
    counts = sorted(histogram.items())
    wanted, seen = _P99 / 100.0 * sum(count for _, count in counts), 0
    for upper, count in counts:
        seen += count
        if seen >= wanted:
            return upper
    return counts[-1][0]
