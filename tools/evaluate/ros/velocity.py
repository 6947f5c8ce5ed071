"""Suite ``ros_velocity``: velocities on ``/cmd_vel`` at 50 Hz, with jitter and losses; the sender is killed.

One robot walks on an open floor from episode to episode. Times are control time. Within 1.1 s of the last
sample the walk has to be told to end, which is when what is commanded begins to brake: the step under way
lands beside the other foot. The robot stands once that step, one that closes the feet, and the settling are
over. It must not fall, and has to walk at the next sender's velocities.
"""

from __future__ import annotations

import argparse
import json
import math
import subprocess
import sys
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
from rich.console import Console

from kinematics.model.robot_model import RobotModel
from robots.live.documents.robot_report import ReportLayout
from robots.live.wire.errors import LiveError
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.state_slot import StateSlotReader
from robots.models.description import load_description
from tools.evaluate.ros.bridged_robot import BridgedRobot

SUITE = "ros_velocity"
WITHIN_S = 1.1
_SENT_S = (1.0, 5.0)
_STANDS_S = 1.0
_FORWARD_M_S, _TURNING_RAD_S, _LEFT_OUT = (0.05, 0.15), 0.2, 0.3
_MOVES_M = 0.005
"""Who has not moved on so far has not set out."""
_MODULE = "tools.evaluate.ros.velocity_peer"


@dataclass(frozen=True, slots=True)
class VelocityRecord:
    """How an episode ended.

    Attributes:
        seed: Of speeds, losses and the instant.
        samples: That were sent.
        gone_m: How far the base has moved, by the robot's own estimate.
        begins_s: Control time from the last sample until what is commanded begins to brake.
        rest_s: Control time from the last sample to rest.
        allowed_s: In which it has to rest.
        after_m: How far the base has moved since 1.1 s after the last sample.
        fallen: Whether the robot fell.
        detail: What broke.
    """

    seed: int
    samples: int = 0
    gone_m: float = 0.0
    begins_s: float = math.inf
    rest_s: float = math.inf
    allowed_s: float = 0.0
    after_m: float = 0.0
    fallen: bool = False
    detail: str = ""

    @property
    def good(self) -> bool:
        """Whether everything was as it has to be."""
        moved = self.gone_m > _MOVES_M
        in_time = self.begins_s <= WITHIN_S and self.rest_s <= self.allowed_s
        return moved and not self.fallen and not self.detail and in_time


def run_ros_velocity(options: argparse.Namespace, messages: Console) -> int:
    """Run the suite; 0 when every episode was as it has to be."""
    records: list[VelocityRecord] = []
    settings = load_description(options.robot).walking
    if settings is None:
        messages.print(f"error: {options.robot} does not walk", style="bold", markup=False)
        return 2
    a_step_s = settings.single_support_s + settings.double_support_s
    allowed_s = WITHIN_S + 2.0 * a_step_s + settings.closing_s + settings.settle_s
    with (
        tempfile.TemporaryDirectory(prefix="ros-velocity-") as folder,
        BridgedRobot(Path(folder), options.seed, options.robot, options.pace) as robot,
    ):
        robot.wait_until_ready()
        watch = Watch(robot)
        for i in range(options.episodes):
            try:
                record = _episode(robot, watch, options.seed + i, allowed_s)
            except LiveError as wrong:
                record = VelocityRecord(options.seed + i, detail=str(wrong))
            records.append(record)
            messages.print(f"{i + 1} of {options.episodes}: {record}", markup=False, soft_wrap=True)
    begins = sorted(record.begins_s for record in records)
    rests = sorted(record.rest_s for record in records)
    document = {
        "suite": SUITE,
        "episodes": len(records),
        "seed": options.seed,
        "success_rate": sum(record.good for record in records) / len(records),
        "falls": sum(record.fallen for record in records),
        "begins_s": {"p50": begins[len(begins) // 2], "worst": begins[-1], "allowed": WITHIN_S},
        "rest_s": {"p50": rests[len(rests) // 2], "worst": rests[-1], "allowed": allowed_s},
        "failed_seeds": [record.seed for record in records if not record.good],
        "episodes_detail": [asdict(record) for record in records],
    }
    if options.json is not None:
        options.json.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    Console().print(json.dumps({k: v for k, v in document.items() if k != "episodes_detail"}, indent=1))
    return 0 if all(record.good for record in records) else 1


class Watch:
    """Where the base is, from instant to instant.

    Args:
        robot: Whose.

    Attributes:
        track: Control time, place and direction of the base at each look.
        resting: Whether the robot rested at the last look.
        ending_s: Control time since when the walk that was looked at last has been ending; infinite before.
    """

    def __init__(self, robot: BridgedRobot) -> None:
        folder = RuntimeFolder(robot.live)
        self._layout = ReportLayout(RobotModel(load_description(robot.robot)))
        self._slot = StateSlotReader(folder.state_slot)
        self.track: list[tuple[float, float, float, float]] = []
        self.resting, self.ending_s = True, math.inf

    def look(self) -> float:
        """Take the newest state in; returns its control time."""
        row = self._slot.newest()
        if row is not None:
            report = self._layout.report(row)
            x, y, *_, sin, cos = report.sensed.q[:7].tolist()
            self.track.append((report.t_s, x, y, 2.0 * math.atan2(sin, cos)))
            self.resting = report.resting
            if report.walking:
                self.ending_s = min(self.ending_s, report.t_s) if report.ending else math.inf
        return self.track[-1][0] if self.track else 0.0

    def moved_m(self, since_s: float) -> float:
        """How far the base went since an instant, as the crow flies."""
        first = next((one for one in self.track if one[0] >= since_s), self.track[-1])
        return math.dist(first[1:3], self.track[-1][1:3])


def _episode(robot: BridgedRobot, watch: Watch, seed: int, allowed_s: float) -> VelocityRecord:
    rng = np.random.default_rng(seed)
    began_s = watch.look()
    _, x, y, yaw = watch.track[-1]
    ahead = x * math.cos(yaw) + y * math.sin(yaw)
    forward = float(rng.uniform(*_FORWARD_M_S)) * (-1.0 if ahead > 0.0 else 1.0)  # towards the start
    turning = float(rng.uniform(-_TURNING_RAD_S, _TURNING_RAD_S))
    kind = "stamped" if rng.random() < 0.5 else "twist"
    numbers = (forward, turning, rng.uniform(0.0, _LEFT_OUT), seed)
    command = [sys.executable, "-m", _MODULE, str(robot.live), str(robot.domain), kind, *map(str, numbers)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as peer:
        robot.wait(lambda: watch.look() > 0.0 and not watch.resting, "the robot sets out")
        kill_s = watch.look() + float(rng.uniform(*_SENT_S))
        robot.wait(lambda: watch.look() >= kill_s, "the instant comes")
        peer.kill()
        assert peer.stdout is not None
        sent = [float(line) for line in peer.stdout.read().splitlines() if line]
    last_s = sent[-1]
    robot.wait(lambda: watch.look() > last_s + 0.1 and watch.resting, "the robot rests")
    rest_s, begins_s = watch.look() - last_s, watch.ending_s - last_s
    after_m, gone_m = watch.moved_m(last_s + WITHIN_S), watch.moved_m(began_s)
    until_s = watch.look() + _STANDS_S
    robot.wait(lambda: watch.look() > until_s, "it stands for a while")
    del watch.track[:-1]
    detail = "" if robot.bridge_lives else f"the bridge ended ({robot.bridge.returncode})"
    fallen = robot.fallen()
    return VelocityRecord(seed, len(sent), gone_m, begins_s, rest_s, allowed_s, after_m, fallen, detail)
