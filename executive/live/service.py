"""``executive serve``: starts the control process and the executive, and sees to it that both live."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import FrameType

from executive.errors import UserError
from executive.live.caller import Caller
from executive.live.hearing import HangWatch, commander_of
from executive.trust import USUAL_TRUST, Trust
from robots.clock import WallClock
from robots.live.errors import AlreadyServedError, LiveError, NotServedError
from robots.live.messages import GetStatus, Shutdown, Stop, write_control_message
from robots.live.runtime_folder import RuntimeFolder

_READY_WITHIN_S = 120.0
_LOOK_EVERY_S = 0.1
_HUNG_S = 5.0
"""An executive that was let go for so long hangs."""
_ASK_EVERY = 20
_RESTARTS = 5
"""An executive that ended so often is not started again: it would end once more."""


class ServiceError(UserError):
    """The robot cannot be served."""


@dataclass(frozen=True, slots=True)
class ServiceRequest:
    """What to serve; as the control process's options.

    ``fault`` is one of the connection's, for evaluations: it strikes at a signal; ``trust`` is for models'
    output.
    """

    folder: Path
    robot: str
    scene: str
    seed: int
    record: Path
    pace: float = 1.0
    realtime: bool = True
    evaluation: bool = False
    fault: str = ""
    trust: Trust = USUAL_TRUST


class Service:
    """Both processes and their watch.

    Attributes:
        control, executive: The processes; an executive that dies is replaced by a new one.
    """

    def __init__(self, request: ServiceRequest, say: Callable[[str], None]) -> None:
        """Start the control process, then the executive.

        Raises:
            ServiceError: The control process does not begin to serve.
            AlreadyServedError: Another one serves there.
        """
        self._request, self._say = request, say
        self._wall = WallClock()
        self._interrupts = 0
        self.folder = RuntimeFolder(request.folder)
        self.folder.make()
        try:
            Caller(self.folder.control_socket).close()
        except NotServedError:
            pass
        else:
            raise AlreadyServedError(request.folder)
        self.control = subprocess.Popen(
            _control_command(request), stdin=subprocess.DEVNULL, start_new_session=True
        )
        self._await_control()
        self.executive = self._start_executive(request.fault)
        self._started = 1
        self._hang_watch = HangWatch(_HUNG_S)

    def watch(self) -> int:
        """Watch until the control process ends; Ctrl-C ends it, a second one is the emergency stop."""
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self._interrupted)
        heeded = looks = 0
        while self.control.poll() is None:
            self._wall.sleep(_LOOK_EVERY_S)
            looks += 1
            if self._interrupts > heeded:
                heeded = self._interrupts
                self._end(heeded)
            if looks % _ASK_EVERY == 0 and not heeded:
                self._end_what_hangs()
            if self.executive.poll() is not None and not heeded and self.control.poll() is None:
                self._replace_executive()
        self.close()
        return 0 if self.control.returncode == 0 else 1

    def start_another_executive(self) -> None:
        """Start a new executive in the place of one that is gone, or does nothing any more."""
        self._started += 1
        self.executive = self._start_executive("")

    def close(self) -> None:
        """End what is still there."""
        if self.executive.poll() is None:
            self.executive.terminate()
            try:
                self.executive.wait(5.0)
            except subprocess.TimeoutExpired:
                self.executive.kill()
                self.executive.wait()

    def _interrupted(self, _number: int, _frame: FrameType | None) -> None:
        self._interrupts += 1

    def _end(self, times: int) -> None:
        try:
            caller = Caller(self.folder.control_socket)
            if times > 1:
                self._say("emergency stop")
                caller.ask(write_control_message(Stop(1, "Ctrl-C, twice")))
            self._say("the robot brakes and holds, then its control ends")
            caller.ask(write_control_message(Shutdown()))
            caller.close()
        except LiveError as gone:
            self._say(str(gone))

    def _end_what_hangs(self) -> None:
        if not self._hang_watch.is_hung(commander_of(self.folder), self.executive.pid, self._wall.now_s()):
            return
        self._say(f"the executive hangs: the robot has been without it for {_HUNG_S:.0f} s; it is ended")
        self.executive.kill()
        self.executive.wait()
        self._hang_watch.forget()

    def _await_control(self) -> None:
        until_s = self._wall.now_s() + _READY_WITHIN_S
        while self._wall.now_s() < until_s:
            if self.control.poll() is not None:
                raise ServiceError("the control process ended before it served; its reason is above")
            try:
                caller = Caller(self.folder.control_socket)
                caller.ask(write_control_message(GetStatus()))
                caller.close()
            except LiveError:
                self._wall.sleep(_LOOK_EVERY_S)
                continue
            return
        self.control.kill()
        raise ServiceError(f"the control process did not begin to serve within {_READY_WITHIN_S:.0f} s")

    def _start_executive(self, fault: str) -> subprocess.Popen[bytes]:
        request = self._request
        arguments = [os.fspath(request.folder), request.robot, os.fspath(request.record)]
        arguments += [f"{request.trust.threshold!r}", request.trust.policy]
        arguments += [fault, str(request.seed)] if fault else []
        return subprocess.Popen(
            [sys.executable, "-m", "executive.live.executive_process", *arguments],
            stdin=subprocess.DEVNULL,
            start_new_session=True,
        )

    def _replace_executive(self) -> None:
        if self._started <= _RESTARTS:
            self._say(f"the executive ended ({self.executive.returncode}); a new one takes its place")
            self.start_another_executive()


def _control_command(request: ServiceRequest) -> list[str]:
    command = [sys.executable, "-m", "robots.live.control_process", os.fspath(request.folder)]
    command += ["--robot", request.robot, "--scene", request.scene, "--seed", str(request.seed)]
    command += ["--pace", str(request.pace)]
    command += [] if request.realtime else ["--ordinary"]
    return command + (["--evaluation"] if request.evaluation else [])
