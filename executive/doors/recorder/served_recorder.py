"""Records the runs of a served robot, each in its folder: one more process, for which nothing waits."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from executive.doors.companion import LeftBehind
from executive.doors.recorder.mend import mend
from executive.doors.recorder.parts import MotionParts
from executive.doors.recorder.recorder import Recorder
from executive.ending_signals import taken_by
from executive.live.caller.caller import Caller, ask_at
from executive.live.desk_messages import GetWorld, Watch, write_desk_message
from kinematics.model.robot_model import RobotModel
from robots.clock import WallClock
from robots.live.wire.errors import LiveError, ProtocolError
from robots.live.wire.messages import GetStatus, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.state_slot import StateSlotReader
from robots.models.description import load_description
from robots.perception.rgbd.picture_slot import PictureSlotReader

_POLL_S = 0.01
_ASK_EVERY_S, _AGAIN_S = 0.5, 0.5
_GOES_ON_S = 0.5
"""Wall time for which a run that has ended is recorded on, so that one sees where it came to rest."""
_WITHOUT_EXECUTIVE_S = 5.0
_READY_WITHIN_S = 120.0
_NICENESS = 5


class ServedRecorder:
    """Records until it is told to end.

    Args:
        folder: Where the robot is served.
        ended: Asked in between.

    Raises:
        LiveError: No robot is served there.
    """

    def __init__(self, folder: Path, ended: Callable[[], bool]) -> None:
        self._where, self._wall, self._ended = RuntimeFolder(folder), WallClock(), ended
        self._about = self._served()
        self._model = RobotModel(load_description(str(self._about["robot"])))
        self._slot = StateSlotReader(self._where.state_slot)
        self._pictures = PictureSlotReader(self._where.picture_slot)
        self._sees = self._about.get("perception") == "rgbd"
        self._executive: Caller | None = None
        self._control: Caller | None = None
        self._recorder: Recorder | None = None
        self._until_s = float("inf")
        self._t_s = 0.0

    def run(self) -> None:
        """Record run after run.

        Raises:
            OSError: Nothing more can be written.
        """
        asked_s = tried_s = float("-inf")
        while not self._ended():
            now_s = self._wall.now_s()
            if (self._executive is None or self._control is None) and now_s - tried_s > _AGAIN_S:
                tried_s = now_s
                self._connect()
            if now_s - asked_s > _ASK_EVERY_S and self._recorder is not None:
                asked_s = now_s
                self._ask()
            self._hear()
            self._look()
            if now_s > self._until_s:
                self._close()
            self._wall.sleep(_POLL_S)
        self._close()
        for caller in (self._executive, self._control):
            if caller is not None:
                caller.close()

    def _served(self) -> Mapping[str, Any]:
        """What the control process tells of itself, once it is there."""
        until_s = self._wall.now_s() + _READY_WITHIN_S
        while True:
            try:
                return ask_at(self._where.control_socket, write_control_message(GetStatus()))
            except LiveError:
                if self._ended() or self._wall.now_s() > until_s:
                    raise
                self._wall.sleep(_AGAIN_S)

    def _connect(self) -> None:
        """Listen where nobody is listened to; whoever is not there is asked again."""
        try:
            if self._control is None:
                self._control = Caller(self._where.control_socket)
            if self._executive is None:
                caller = Caller(self._where.executive_socket)
                caller.send(write_desk_message(Watch()))
                self._executive = caller
        except LiveError:
            pass

    def _ask(self) -> None:
        if self._executive is not None:
            self._executive.send(write_desk_message(GetWorld()))
        if self._control is not None:
            self._control.send(write_control_message(GetStatus()))

    def _hear(self) -> None:
        if self._executive is not None:
            try:
                for message in self._executive.poll():
                    self._take(message)
            except LiveError:
                self._executive.close()
                self._executive = None
                self._until_s = min(self._until_s, self._wall.now_s() + _WITHOUT_EXECUTIVE_S)
        if self._control is not None:
            try:
                for message in self._control.poll():
                    if message["type"] == "status" and self._recorder is not None:
                        self._recorder.status(self._t_s, message)
            except LiveError:
                self._control.close()
                self._control = None

    def _take(self, message: Mapping[str, Any]) -> None:
        """Take what the executive tells."""
        if message["type"] == "run":
            self._turn(str(message["path"]), bool(message["under_way"]))
            return
        recorder = self._recorder
        if recorder is None:
            return
        match message["type"]:
            case "event":
                recorder.event(message["told"], message["line"])
            case "tree":
                recorder.tree(float(message["t_s"]), message["nodes"])
            case "world":
                recorder.world(self._t_s, {key: one for key, one in message.items() if key != "type"})

    def _turn(self, path: str, under_way: bool) -> None:
        """A run begins or ends."""
        if not under_way:
            self._until_s = min(self._until_s, self._wall.now_s() + _GOES_ON_S)
            return
        self._close()
        folder = Path(path)
        for part in MotionParts(folder).all():
            mend(part)
        about = {key: str(self._about.get(key, "")) for key in ("robot", "scene", "seed")}
        self._recorder = Recorder(MotionParts(folder).next(), self._model, {**about, "run": folder.name})
        self._until_s = float("inf")
        if self._sees:
            self._pictures.want(True)
        self._ask()

    def _look(self) -> None:
        """Record what is new in the slots."""
        try:
            row = self._slot.newest()
        except ProtocolError:
            return
        if row is None:
            return
        self._t_s = float(row[0])
        if self._recorder is None:
            return
        self._recorder.state(row)
        if self._sees and (shown := self._pictures.newest()) is not None:
            self._recorder.picture(shown)

    def _close(self) -> None:
        """End the file that is open."""
        recorder, self._recorder, self._until_s = self._recorder, None, float("inf")
        if recorder is not None:
            recorder.close()
            if self._sees:
                self._pictures.want(False)


def main(folder: str) -> int:
    """Record the runs of the robot that is served in a folder until a signal ends it."""
    signals: list[int] = []
    os.nice(_NICENESS)  # the robot's own processes come first
    try:
        with taken_by(signals.append):
            ServedRecorder(Path(folder), LeftBehind(Path(folder), signals)).run()
    except (LiveError, OSError) as wrong:
        sys.stderr.write(f"executive: the recorder ended: {wrong}\n")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
