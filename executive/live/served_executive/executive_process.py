"""The executive of a served robot: ``python -m executive.live.served_executive.executive_process``.

It attaches as the robot's commander and carries out what it is told. When the control process lets it go
(it hung, and has woken up) it attaches again; when that is gone, it ends. Its arguments: the folder of the
sockets, the robot, the folder of the records, confidence and policy for models' output, the name of the
model in front, and whether it is not read back what need not be ("yes"). Evaluations add a
fault of the connection and a seed, and let it strike with SIGUSR1.
"""

from __future__ import annotations

import contextlib
import gc
import signal
import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType

from executive.config import config_files
from executive.front.front_model import FrontModel
from executive.front.model_asker import ModelAsker
from executive.front.model_settings import model_called
from executive.live.control_client.control_link import AttachRefusedError, ControlLostError
from executive.live.served_executive.faulty_connections import StruckConnections
from executive.live.served_executive.live_executive import LiveExecutive
from executive.trust import Trust
from executive.understanding.command_parser import parse
from kinematics.model.robot_model import RobotModel
from robots.clock import WallClock
from robots.live.wire.child_process import ChildProcess
from robots.live.wire.connection import Connection
from robots.live.wire.errors import LiveError, NotServedError
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.unix_socket import UnixSocket
from robots.models.description import load_description
from trees.world_model import WorldModel

_FIRST_SENTENCE = "pick up the red cup on the table"
_AGAIN_S = 0.5
_PATIENCE = 40
"""Attempts to become the commander, half a second apart."""


def serve(
    folder: RuntimeFolder,
    robot: str,
    record: Path,
    trust: Trust,
    connection: Callable[[UnixSocket], Connection] = Connection,
    front: FrontModel | None = None,
) -> int:
    """Serve until the control process ends; 0 then, 1 when it never took this process."""
    wall = WallClock()
    model = RobotModel(load_description(robot))
    planning = ChildProcess("executive.live.control_client.planning_process", [robot])
    world = WorldModel()
    parse(_FIRST_SENTENCE)  # loads now what the first order would wait for
    refused = 0
    try:
        while refused < _PATIENCE:
            try:
                executive = LiveExecutive(folder, model, planning, world, record, connection, trust, front)
            except NotServedError:
                return 0
            except AttachRefusedError as wrong:
                refused += 1
                _say(str(wrong))
                wall.sleep(_AGAIN_S)
                continue
            refused = 0
            gc.collect()
            gc.freeze()  # what is there now stays: to look for garbage takes milliseconds without it
            try:
                executive.run()
            except ControlLostError as lost:
                _say(str(lost))
            finally:
                executive.close()
    finally:
        planning.close()
        if front is not None:
            front.close()
    return 1


def _front(name: str, trust: Trust, reads_back: bool) -> FrontModel | None:
    if not name:
        return None
    settings = model_called(name, config_files())
    return FrontModel(settings, ModelAsker(settings), trust, reads_back)


def _say(line: str) -> None:
    with contextlib.suppress(OSError):  # nobody may be there to read it any more
        sys.stderr.write(f"executive: {line}\n")
        sys.stderr.flush()


def _terminated(_number: int, _frame: FrameType | None) -> None:
    raise SystemExit(0)


def main() -> int:
    """Serve."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, _terminated)
    folder, robot, record, threshold, policy, model, yes, *fault = sys.argv[1:]
    trust = Trust(float(threshold), "partial" if policy == "partial" else "ask")
    front = _front(model, trust, reads_back=not yes)
    connection = StruckConnections(fault[0], int(fault[1])) if fault else Connection
    try:
        return serve(RuntimeFolder(Path(folder)), robot, Path(record), trust, connection, front)
    except LiveError as wrong:
        _say(str(wrong))
        return 1


if __name__ == "__main__":
    sys.exit(main())
