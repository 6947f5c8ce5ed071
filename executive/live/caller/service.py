"""``executive serve``: starts the control process and the executive, and sees to it that both live."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType

from executive.config import shown_directory
from executive.ending_signals import taken_by, told
from executive.errors import UserError
from executive.live.caller.caller import Caller
from executive.live.caller.hang_watch import HangWatch, commander_of
from executive.trust import USUAL_TRUST, Trust
from robots.clock import WallClock
from robots.live.wire.errors import AlreadyServedError, LiveError, NotServedError
from robots.live.wire.messages import GetStatus, Shutdown, Stop, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder

MOST = 5
WITHIN_S = 300.0
"""``MOST`` replacements within this time did not help: one more would end as well."""
WELL_AFTER_S = 60.0
"""An executive that has commanded the robot for so long is well, and what was before it counts no more."""


class Restarts:
    """Decides whether an executive that ended is replaced: not too often within a window of wall time."""

    def __init__(
        self, most: int = MOST, within_s: float = WITHIN_S, well_after_s: float = WELL_AFTER_S
    ) -> None:
        self._most, self._within_s, self._well_after_s = most, within_s, well_after_s
        self._taken_s: list[float] = []
        self._well_since_s: float | None = None

    def note_health(self, commands: bool, now_s: float) -> None:
        """Note whether the executive of the moment commands the robot; for long enough, and it is well."""
        if not commands:
            self._well_since_s = None
        elif self._well_since_s is None:
            self._well_since_s = now_s
        elif now_s - self._well_since_s >= self._well_after_s:
            self._taken_s.clear()

    def take(self, now_s: float) -> bool:
        """Take one replacement; False when there were too many within the window."""
        self._well_since_s = None
        self._taken_s = [taken_s for taken_s in self._taken_s if now_s - taken_s < self._within_s]
        if len(self._taken_s) >= self._most:
            return False
        self._taken_s.append(now_s)
        return True


_READY_WITHIN_S = 120.0
_LOOK_EVERY_S = 0.1
_HUNG_S = 5.0
"""An executive that was let go for so long hangs."""
_ASK_EVERY = 20
_ENDS_WITHIN_S = 20.0
"""Wall time in which a control process that is asked to end brakes, holds and ends; it may load yet."""


class ServiceError(UserError):
    """The robot cannot be served."""


@dataclass(frozen=True, slots=True)
class ServiceRequest:
    """What to serve; as the control process's options.

    ``fault`` is one of the connection's, for evaluations: it strikes at a signal; ``trust`` is for models'
    output, ``model`` the name of the one in front, ``reads_back`` whether all that it proposes is read back;
    ``perception`` is "stub" or "rgbd", or None for what the scene says; ``body`` is one that is not
    simulated.
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
    model: str = ""
    reads_back: bool = True
    perception: str | None = None
    body: str = ""
    body_options: tuple[tuple[str, str], ...] = ()


class Service:
    """Both processes and their watch; as a context it ends both where the watch cannot go on.

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
        self._signals: list[int] = []
        self._restarts, self._given_up = Restarts(), False
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
        self._hang_watch = HangWatch(_HUNG_S)
        try:
            self._await_control()
            self.executive = self._start_executive(request.fault)
        except BaseException:  # a signal to end among them: nothing is left that nobody watches
            self._end_control()
            raise

    def __enter__(self) -> Service:
        """Both run."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, raised: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Neither is left where nobody watches it."""
        self._end_control()
        self.close()

    def watch(self) -> int:
        """Watch until the control process ends.

        A signal to end, Ctrl-C among them, has the robot brake and hold, then ends it; a second one is the
        emergency stop. An executive that ends is replaced, unless that did not help the last times; then
        that is told, and the robot stands under its control alone.
        """
        with taken_by(self._signals.append):
            heeded = looks = 0
            while self.control.poll() is None:
                self._wall.sleep(_LOOK_EVERY_S)
                looks += 1
                if len(self._signals) > heeded:
                    heeded = len(self._signals)
                    self._end(heeded)
                if looks % _ASK_EVERY == 0 and not heeded:
                    self._look_after_executive()
                if self.executive.poll() is not None and not heeded and self.control.poll() is None:
                    self._replace_executive()
            self.close()
        return 0 if self.control.returncode == 0 else 1

    def start_another_executive(self) -> None:
        """Start a new executive in the place of one that is gone, or does nothing any more."""
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

    def _end_control(self) -> None:
        """Let the control process bring the robot to rest and end; one that does not is killed."""
        if self.control.poll() is None:
            self.control.terminate()
            try:
                self.control.wait(_ENDS_WITHIN_S)
            except subprocess.TimeoutExpired:
                self.control.kill()
                self.control.wait()

    def _end(self, times: int) -> None:
        try:
            caller = Caller(self.folder.control_socket)
            if times > 1:
                self._say("emergency stop")
                caller.ask(write_control_message(Stop(1, told(self._signals[-1], "stopped"))))
            self._say("the robot brakes and holds, then its control ends")
            caller.ask(write_control_message(Shutdown()))
            caller.close()
        except LiveError as gone:
            self._say(str(gone))

    def _look_after_executive(self) -> None:
        """Note whether it commands the robot; one that hangs is ended."""
        commander, now_s = commander_of(self.folder), self._wall.now_s()
        self._restarts.note_health(commander == self.executive.pid, now_s)
        if self._given_up or not self._hang_watch.is_hung(commander, self.executive.pid, now_s):
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
        arguments += [request.model, "" if request.reads_back else "yes"]
        arguments += [fault, str(request.seed)] if fault else []
        return subprocess.Popen(
            [sys.executable, "-m", "executive.live.served_executive.executive_process", *arguments],
            stdin=subprocess.DEVNULL,
            start_new_session=True,
        )

    def _replace_executive(self) -> None:
        ended = f"the executive ended ({self.executive.returncode})"
        if self._given_up:
            return
        if self._restarts.take(self._wall.now_s()):
            self._say(f"{ended}; a new one takes its place")
            self.start_another_executive()
            return
        self._given_up = True
        self._say(
            f"{ended}, as did {MOST} before it within {WITHIN_S:.0f} s: no other one is started. The robot "
            "stands under its control alone, and takes no task; `executive shutdown` ends it"
        )


def _control_command(request: ServiceRequest) -> list[str]:
    command = [sys.executable, "-m", "robots.live.process.control_process", os.fspath(request.folder)]
    command += ["--robot", request.robot, "--scene", request.scene, "--seed", str(request.seed)]
    command += ["--pace", str(request.pace), "--supervisor", str(os.getpid())]
    command += ["--shown", os.fspath(shown_directory())]
    command += [] if request.perception is None else ["--perception", request.perception]
    command += [] if request.realtime else ["--ordinary"]
    command += ["--body", request.body] if request.body else []
    for key, value in request.body_options:
        command += ["--body-option", key, value]
    return command + (["--evaluation"] if request.evaluation else [])
