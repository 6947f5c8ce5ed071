"""The page and the recorder: how soon, how fast, and what they cost the control.

A real browser draws it: Debian's Chromium under Playwright. The robot is served as it is to a user.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from playwright.sync_api import Browser, Page, sync_playwright

from executive.doors.recorder.feed import RunFeed
from executive.doors.served_robot import ServedRobot
from executive.doors.view.access import Access, new_token
from executive.doors.view.motion_read import recording_of
from executive.doors.view.page_server import PageServer
from executive.doors.view.timeline import Timeline
from executive.live.caller.caller import ask_at
from executive.runs.run import perform
from executive.runs.run_log import recorded_runs
from executive.runs.run_request import RunRequest
from executive.screens.display import NoDisplay
from executive.scripts.task_script import script_for
from executive.trust import USUAL_TRUST
from robots.clock import WallClock
from robots.live.wire.errors import LiveError
from robots.live.wire.messages import GetStatus, Reset, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder
from tools.benchmark.figures import Figure, figure

_ROBOT, _SCENE = "talos", "tabletop"
_ARGUMENTS = ("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
_WITHIN_S, _LOOK_S = 240.0, 0.005
_PHASE_S = 5.0
_SCRUBBED_S, _STEP_S = 3.0, 0.1
_COUNT_MOMENTS = r"""() => {
    window.moments = 0;
    new MutationObserver(() => {
        const told = document.body.textContent.match(/in \w+\s+([0-9.]+) s/);
        if (told && told[1] !== window.told) { window.told = told[1]; window.moments++; }
    }).observe(document.body, {subtree: true, childList: true, characterData: true});
}"""
"""Counts how often the time that the status of the page tells has changed: so many moments were shown."""
_TICKS = os.sysconf("SC_CLK_TCK")
_MINUTES = 3.0


def view(quick: bool) -> list[Figure]:
    """Everything of the page, in turn."""
    wall = WallClock()
    with sync_playwright() as playwright, tempfile.TemporaryDirectory(prefix="view-") as folder:
        chromium = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=list(_ARGUMENTS))
        with _served(Path(folder), wall) as (robot, address):
            found = [
                figure(
                    "page there, s", [_page_s(chromium, address, wall) for _ in range(2 if quick else 10)]
                ),
                figure("STOP in force, ms", _stops(chromium, address, robot, wall, 2 if quick else 10)),
                *_cost(chromium, address, robot, wall, 2 if quick else 20),
                *_recording(robot, wall, 2 if quick else 20),
            ]
        found.append(_scrubbing(chromium, Path(folder), wall, 5.0 if quick else 60.0 * _MINUTES))
        chromium.close()
    return found


@contextmanager
def _served(folder: Path, wall: WallClock) -> Iterator[tuple[RuntimeFolder, str]]:
    """A robot with a page; where it is served, and the page's address."""
    where = RuntimeFolder(folder / "live")
    command = [sys.executable, "-m", "executive", "serve", "--view", "--view-port", "0", "--scene", _SCENE]
    command += ["--folder", os.fspath(where.path), "--record", os.fspath(folder / "runs"), "--evaluation"]
    lines: list[str] = []
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        reader = threading.Thread(target=lambda: lines.extend(process.stderr or ()), daemon=True)
        reader.start()
        try:
            robot = ServedRobot(where.path)
            _wait(lambda: _address(lines) is not None and _is_ready(robot), wall)
            yield where, str(_address(lines))
        finally:
            process.terminate()
            process.wait()


def _address(lines: list[str]) -> str | None:
    found = (re.search(r"http://\S+token=\S+", line) for line in list(lines))
    return next((one[0] for one in found if one), None)


def _is_ready(robot: ServedRobot) -> bool:
    try:
        return bool(robot.status())
    except LiveError:
        return False


def _process(module: str, where: RuntimeFolder) -> int:
    """The process of a module that serves a folder."""
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            words = path.read_bytes().split(b"\0")
        except OSError:
            continue
        if module.encode() in words and os.fsencode(where.path) in words:
            return int(path.parent.name)
    raise ProcessLookupError(module)


def _wait(so: Callable[[], bool], wall: WallClock) -> None:
    until_s = wall.now_s() + _WITHIN_S
    while not so():
        if wall.now_s() > until_s:
            raise TimeoutError("in vain")
        wall.sleep(_LOOK_S)


def _opened(chromium: Browser, address: str) -> Page:
    page = chromium.new_page(viewport={"width": 1280, "height": 800})
    page.set_default_timeout(1000.0 * _WITHIN_S)
    page.goto(address)
    page.get_by_text("waits for a task").first.wait_for()
    return page


def _page_s(chromium: Browser, address: str, wall: WallClock) -> float:
    """Wall time until the page says how the robot stands and has drawn it."""
    began_s = wall.now_s()
    page = _opened(chromium, address)
    page.locator("canvas[data-engine]").wait_for()
    took_s = wall.now_s() - began_s
    page.close()
    return took_s


def _stops(chromium: Browser, address: str, where: RuntimeFolder, wall: WallClock, times: int) -> list[float]:
    """Wall time in ms from a press of STOP until the control process has it."""
    page, took = _opened(chromium, address), []

    def engaged() -> bool:
        told = ask_at(where.control_socket, write_control_message(GetStatus()))
        return told["emergency"] is not None

    for _ in range(times):
        began_s = wall.now_s()
        page.keyboard.press("Alt+s")
        _wait(engaged, wall)
        took.append(1e3 * (wall.now_s() - began_s))
        ask_at(where.control_socket, write_control_message(Reset("a measurement")))
        _wait(lambda: not engaged(), wall)
        wall.sleep(0.5)
    page.close()
    return took


def _cost(chromium: Browser, address: str, where: RuntimeFolder, wall: WallClock, turns: int) -> list[Figure]:
    """Share of a core that the page takes, and lateness of control with and without a browser, in turns."""
    shares, late, late_alone = [], [], []
    robot, page_pid = ServedRobot(where.path), _process("executive.doors.view.view_process", where)
    for _ in range(turns):
        late_alone.append(_late(robot, wall))
        page = _opened(chromium, address)
        before, began_s = _processor_s(page_pid), wall.now_s()
        late.append(_late(robot, wall))
        shares.append(100.0 * (_processor_s(page_pid) - before) / (wall.now_s() - began_s))
        page.close()
    return [
        figure("share of a core of the page, %", shares),
        figure("periods late, % with a browser", late, "without one", late_alone),
    ]


def _late(robot: ServedRobot, wall: WallClock) -> float:
    """Share of control periods, in %, that were late within some seconds."""
    before = robot.status()["lateness"]
    wall.sleep(_PHASE_S)
    after = robot.status()["lateness"]
    periods = float(after["periods"] - before["periods"])
    return 100.0 * float(after["late"] - before["late"]) / max(periods, 1.0)


def _recording(where: RuntimeFolder, wall: WallClock, turns: int) -> list[Figure]:
    """What recording costs the control: its time and lateness while the recorder works and is held."""
    robot, recorder, control = (
        ServedRobot(where.path),
        _process("executive.doors.recorder.served_recorder", where),
        _process("robots.live.process.control_process", where),
    )
    robot.begin(f"wait for {2.0 * (_PHASE_S + 1.0) * (turns + 1):.0f} seconds")
    wall.sleep(1.0)
    shares: dict[bool, list[float]] = {True: [], False: []}
    late: dict[bool, list[float]] = {True: [], False: []}
    for turn in range(2 * turns):
        works = turn % 2 == 0
        os.kill(recorder, signal.SIGCONT if works else signal.SIGSTOP)
        wall.sleep(0.5)
        before, began_s = _processor_s(control), wall.now_s()
        late[works].append(_late(robot, wall))
        shares[works].append(100.0 * (_processor_s(control) - before) / (wall.now_s() - began_s))
    os.kill(recorder, signal.SIGCONT)
    robot.cancel("measured")
    peer = "while the recorder is held"
    return [
        figure("share of a core of the control while recorded, %", shares[True], peer, shares[False]),
        figure("periods late, % while recorded", late[True], peer, late[False]),
    ]


def _processor_s(pid: int) -> float:
    """Processor time of a process so far."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / _TICKS


def _scrubbing(chromium: Browser, folder: Path, wall: WallClock, seconds: float) -> Figure:
    """Moments of a recorded run that a browser shows in a second of wall time while it is scrubbed."""
    runs, text = folder / "recorded", f"wait for {seconds:.0f} seconds"
    feed = RunFeed(NoDisplay(), print)
    said = script_for(text, USUAL_TRUST, _SCENE)
    request = RunRequest(text, said.statements, _ROBOT, _SCENE, 0, runs)
    perform(request, feed, on_assembly=feed.begin, on_record=feed.record)
    feed.close()
    (run,) = recorded_runs(runs)
    recording, over = recording_of(run), threading.Event()
    server = PageServer(0, Access(new_token()), "run")
    timeline = Timeline(server, recording, over.is_set)
    page = chromium.new_page(viewport={"width": 1280, "height": 800})
    page.goto(f"http://127.0.0.1:{server.port}/")
    page.locator("canvas[data-engine]").wait_for()
    page.evaluate(_COUNT_MOMENTS)
    thread = threading.Thread(target=timeline.run)
    thread.start()
    rates = []
    for _ in range(4):
        page.evaluate("window.moments = 0")
        began_s, steps = wall.now_s(), 0
        while (passed_s := wall.now_s() - began_s) < _SCRUBBED_S:
            timeline.go_to(_STEP_S * steps % recording.ends_s)
            steps += 1
            wall.sleep(_LOOK_S)
        rates.append(float(page.evaluate("window.moments")) / passed_s)
    over.set()
    thread.join()
    page.close()
    server.close()
    return figure("moments shown a second while scrubbed", rates)
