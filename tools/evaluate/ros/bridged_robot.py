"""A served robot with the ROS bridge beside it, both watched from outside."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from types import TracebackType

from robots.live.wire.errors import LiveError
from tools.evaluate.live.served_robot import OPEN_FLOOR, ServedRobot

_FIRST_DOMAIN, _DOMAINS = 50, 50
_ENDS_WITHIN_S = 10.0


class BridgedRobot(ServedRobot):
    """A robot on an open floor, served and bridged; as a context it ends with it.

    Args:
        folder: For its files.
        seed: Of the run.
        robot: Its name.
        pace: Control time that passes in a second.
    """

    def __init__(self, folder: Path, seed: int, robot: str, pace: float) -> None:
        super().__init__(folder, seed, robot, pace, scene=OPEN_FLOOR)
        self.live, self.robot = folder / "live", robot
        self.domain = _FIRST_DOMAIN + os.getpid() % _DOMAINS  # what else is measured here is elsewhere
        module = "executive.doors.ros.bridge_process"
        command = [sys.executable, "-m", module, str(self.live), str(self.domain), "", "lo"]
        self.bridge = subprocess.Popen(command, start_new_session=True)

    def __enter__(self) -> BridgedRobot:
        """It is served."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, raised: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End bridge and robot."""
        self.bridge.terminate()
        try:
            self.bridge.wait(_ENDS_WITHIN_S)
        except subprocess.TimeoutExpired:
            self.bridge.kill()
            self.bridge.wait()
        self.end()

    @property
    def bridge_lives(self) -> bool:
        """Whether the bridge that was started is still there."""
        return self.bridge.poll() is None


def memory_kb(pid: int) -> int:
    """Resident memory of a process.

    Raises:
        LiveError: There is no such process.
    """
    try:
        for line in Path(f"/proc/{pid}/status").read_text("utf-8").splitlines():
            if line.startswith("VmRSS:"):
                return int(line.split()[1])
    except OSError:
        pass
    raise LiveError(f"process {pid} has ended")
