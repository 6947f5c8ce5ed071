"""A robot that is served to be measured, and what is read of its processes."""

from __future__ import annotations

import ctypes.util
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

from playwright.sync_api import Browser, Page, Playwright

from executive.doors.served_robot import Run, ServedRobot
from robots.clock import WallClock
from robots.live.wire.errors import LiveError
from robots.live.wire.runtime_folder import RuntimeFolder

PAGE = "executive.doors.view.view_process"
RECORDER = "executive.doors.recorder.served_recorder"
CONTROL = "robots.live.process.control_process"
EXECUTIVE = "executive.live.served_executive.executive_process"
"""The modules of the processes."""
SCENE = "tabletop"
LOOK_S = 0.005
_ARGUMENTS = ("--no-sandbox",)
_BY_MESA = ("--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist")
_BY_CHROMIUM = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
"""Without a graphics card Mesa draws nearly twice as fast as what Chromium brings."""
_WITHIN_S = 240.0
_TICKS = os.sysconf("SC_CLK_TCK")
_MOVES = "wave"


class Measured:
    """A served robot.

    Args:
        process: That serves it.
        folder: For its sockets and its runs.

    Attributes:
        where: Its sockets.
        runs: Folder of its recorded runs.
        robot: It, as a door sees it.
        serve: The process that serves it.
    """

    def __init__(self, process: subprocess.Popen[str], folder: Path) -> None:
        self.serve, self.where, self.runs = process, _sockets(folder), folder / "runs"
        self.robot = ServedRobot(self.where.path)
        self._lines: list[str] = []
        threading.Thread(target=lambda: self._lines.extend(process.stderr or ()), daemon=True).start()

    @property
    def address(self) -> str:
        """Of its page, with the token; empty until it is told."""
        found = (re.search(r"http://\S+token=\S+", line) for line in list(self._lines))
        return next((one[0] for one in found if one), "")

    def is_ready(self) -> bool:
        """Whether it takes commands."""
        try:
            return bool(self.robot.status())
        except LiveError:
            return False

    def pid(self, module: str) -> int:
        """The process of a module that serves it.

        Raises:
            ProcessLookupError: There is none.
        """
        for pid, words in self._processes():
            if module.encode() in words:
                return pid
        raise ProcessLookupError(module)

    def end(self) -> None:
        """End all of it, where what serves was killed too: the robot's control outlives that."""
        for pid, _ in self._processes():
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)

    def _processes(self) -> Iterator[tuple[int, list[bytes]]]:
        """Each process that serves it, with the words of its command."""
        for path in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                words = path.read_bytes().split(b"\0")
            except OSError:
                continue
            if os.fsencode(self.where.path) in words:
                yield int(path.parent.name), words

    def late_share(self, wall: WallClock, seconds: float) -> float:
        """Share of control periods, in %, that were late within some seconds of wall time."""
        before = self.robot.status()["lateness"]
        wall.sleep(seconds)
        after = self.robot.status()["lateness"]
        periods = float(after["periods"] - before["periods"])
        return 100.0 * float(after["late"] - before["late"]) / max(periods, 1.0)


@contextmanager
def served(folder: Path, wall: WallClock, *options: str) -> Iterator[Measured]:
    """A robot while it is served, with more options of the command."""
    command = [sys.executable, "-m", "executive", "serve", "--scene", SCENE]
    command += ["--folder", os.fspath(_sockets(folder).path), "--record", os.fspath(folder / "runs")]
    with subprocess.Popen([*command, *options], stderr=subprocess.PIPE, text=True) as process:
        made = Measured(process, folder)
        try:
            wait(lambda: made.is_ready() and ("--view" not in options or bool(made.address)), wall)
            yield made
        finally:
            process.terminate()
            process.wait()
            made.end()


class Moving:
    """Keeps a robot moving: as a context it waves, again and again, until it is left.

    Args:
        robot: Who moves.
    """

    def __init__(self, robot: ServedRobot, wall: WallClock) -> None:
        self._robot, self._wall = robot, wall
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._move, daemon=True)

    def __enter__(self) -> Moving:
        """It begins."""
        self._thread.start()
        wait(lambda: self._robot.status()["task"] is not None, self._wall)
        return self

    def __exit__(self, *_: object) -> None:
        """It comes to rest."""
        self._over.set()
        self._robot.cancel("measured")
        self._thread.join()
        wait(lambda: self._robot.status()["task"] is None, self._wall)

    def _move(self) -> None:
        while not self._over.is_set():
            run: Run = self._robot.begin(_MOVES)
            while not run.ended:
                run.wait(0, 0.1)
                self._wall.sleep(0.05)


def wait(so: Callable[[], bool], wall: WallClock, within_s: float = _WITHIN_S) -> None:
    """Wait until something is so.

    Raises:
        TimeoutError: In vain.
    """
    until_s = wall.now_s() + within_s
    while not so():
        if wall.now_s() > until_s:
            raise TimeoutError("in vain")
        wall.sleep(LOOK_S)


def processor_s(pid: int) -> float:
    """Processor time of a process so far."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / _TICKS


def memory_kb(pid: int) -> int:
    """Resident memory of a process."""
    lines: Sequence[str] = Path(f"/proc/{pid}/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmRSS:"))


def launched(playwright: Playwright) -> Browser:
    """Debian's Chromium, drawing without a graphics card."""
    drawn = _BY_MESA if ctypes.util.find_library("EGL_mesa") else _BY_CHROMIUM
    return playwright.chromium.launch(executable_path=shutil.which("chromium"), args=[*_ARGUMENTS, *drawn])


def opened(chromium: Browser, address: str) -> Page:
    """A page of a served robot that tells how that stands."""
    page = chromium.new_page(viewport={"width": 1280, "height": 800})
    page.set_default_timeout(1000.0 * _WITHIN_S)
    page.goto(address)
    page.get_by_text(re.compile("waits for a task|task: ")).first.wait_for()
    return page


def _sockets(folder: Path) -> RuntimeFolder:
    return RuntimeFolder(folder / "live")
