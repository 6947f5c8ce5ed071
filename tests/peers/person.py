"""What only a person at the robot does: leave its emergency stop."""

import time

from executive.cli.commands import reset
from robots.live.wire.runtime_folder import RuntimeFolder

WITHIN_S = 120.0


def leave_stop(folder):
    """Ask until it is left: while the robot still brakes it is refused."""
    began_s = time.monotonic()
    while (told := reset.leave_stop(RuntimeFolder(folder))) != reset.LEFT:
        assert time.monotonic() - began_s < WITHIN_S, told
        time.sleep(0.2)
