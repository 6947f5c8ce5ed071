"""What only a person at the robot does: leave its emergency stop."""

import time

from executive.live.caller.caller import ask_at
from robots.live.wire.messages import Reset, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder

WITHIN_S = 120.0


def leave_stop(folder):
    """Ask until it is left: while the robot still brakes it is refused."""
    began_s = time.monotonic()
    socket, message = RuntimeFolder(folder).control_socket, write_control_message(Reset("a test"))
    while (answer := ask_at(socket, message))["type"] != "done":
        assert time.monotonic() - began_s < WITHIN_S, answer
        time.sleep(0.2)
