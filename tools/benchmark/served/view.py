"""The page: how soon it is there, how fast it follows, and what it costs the robot.

A real browser draws it: Debian's Chromium under Playwright. The robot is served as it is to a user.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser as Chromium
from playwright.sync_api import sync_playwright

from executive.doors.recorder.feed import RunFeed
from executive.doors.view.access import Access, new_token
from executive.doors.view.browser import Browser
from executive.doors.view.motion_read import recording_of
from executive.doors.view.page_server import PageServer
from executive.doors.view.seen import Seen
from executive.doors.view.timeline import timeline_beside
from executive.doors.view.viewer import DRAWN_EVERY_S
from executive.live.caller.caller import ask_at
from executive.runs.run import perform
from executive.runs.run_log import recorded_runs
from executive.runs.run_request import RunRequest
from executive.screens.display import NoDisplay
from executive.scripts.task_script import script_for
from executive.trust import USUAL_TRUST
from robots.clock import WallClock
from robots.live.wire.messages import GetStatus, Reset, write_control_message
from tools.benchmark.figures import Figure, figure
from tools.benchmark.served.served_robot import (
    LOOK_S,
    PAGE,
    SCENE,
    Measured,
    Moving,
    launched,
    opened,
    processor_s,
    served,
    wait,
)

_ROBOT = "talos"
_PHASE_S = 5.0
_COUNTED_S, _STEP_S = 3.0, 0.1
_NODES = 250
_MINUTES = 3.0
_COUNT = """pattern => {
    window.moments = 0;
    new MutationObserver(() => {
        const told = document.body.textContent.match(new RegExp(pattern));
        if (told && told[1] !== window.told) { window.told = told[1]; window.moments++; }
    }).observe(document.body, {subtree: true, childList: true, characterData: true});
}"""
"""Counts how often what a pattern finds in the page has changed: so many moments were shown."""
_TIME, _UPDATE = r"in \w+\s+([0-9.]+) s", r"update ([0-9]+)"


def view(quick: bool) -> list[Figure]:
    """Everything of the page, in turn."""
    wall, times = WallClock(), 2 if quick else 10
    with sync_playwright() as playwright, tempfile.TemporaryDirectory(prefix="view-") as folder:
        chromium = launched(playwright)
        with served(Path(folder), wall, "--view", "--view-port", "0", "--evaluation") as measured:
            found = [
                figure("page there, s", [_page_s(chromium, measured.address, wall) for _ in range(times)]),
                figure("STOP in force, ms", _stops(chromium, measured, wall, times)),
                *_cost(chromium, measured, wall, 2 if quick else 20),
            ]
        found.append(_scrubbing(chromium, Path(folder), wall, 5.0 if quick else 60.0 * _MINUTES))
        found.append(_tree(chromium, wall))
        chromium.close()
    return found


def _page_s(chromium: Chromium, address: str, wall: WallClock) -> float:
    """Wall time until the page says how the robot stands and has drawn it."""
    began_s = wall.now_s()
    page = opened(chromium, address)
    page.locator("canvas[data-engine]").wait_for()
    took_s = wall.now_s() - began_s
    page.close()
    return took_s


def _stops(chromium: Chromium, measured: Measured, wall: WallClock, times: int) -> list[float]:
    """Wall time in ms from a press of STOP until the control process has it."""
    page, took = opened(chromium, measured.address), []
    control = measured.where.control_socket

    def engaged() -> bool:
        return ask_at(control, write_control_message(GetStatus()))["emergency"] is not None

    for _ in range(times):
        began_s = wall.now_s()
        page.keyboard.press("Alt+s")
        wait(engaged, wall)
        took.append(1e3 * (wall.now_s() - began_s))
        ask_at(control, write_control_message(Reset("a measurement")))
        wait(lambda: not engaged(), wall)
        wall.sleep(0.5)
    page.close()
    return took


def _cost(chromium: Chromium, measured: Measured, wall: WallClock, turns: int) -> list[Figure]:
    """The page's share of a core while the robot moves, and lateness with and without it, in turns."""
    shares, late, late_alone = [], [], []
    pid = measured.pid(PAGE)
    with Moving(measured.robot, wall):
        for _ in range(turns):
            late_alone.append(measured.late_share(wall, _PHASE_S))
            page = opened(chromium, measured.address)
            before, began_s = processor_s(pid), wall.now_s()
            late.append(measured.late_share(wall, _PHASE_S))
            shares.append(100.0 * (processor_s(pid) - before) / (wall.now_s() - began_s))
            page.close()
    return [
        figure("share of a core of the page while the robot moves, %", shares),
        figure("periods late, % with a browser", late, "without one", late_alone),
    ]


def _scrubbing(chromium: Chromium, folder: Path, wall: WallClock, seconds: float) -> Figure:
    """Moments of a recorded run that a browser shows in a second of wall time while it is scrubbed."""
    runs, text = folder / "recorded", f"wait for {seconds:.0f} seconds"
    feed = RunFeed(NoDisplay(), print)
    said = script_for(text, USUAL_TRUST, SCENE)
    request = RunRequest(text, said.statements, _ROBOT, SCENE, 0, runs)
    perform(request, feed, on_assembly=feed.begin, on_record=feed.record)
    feed.close()
    (run,) = recorded_runs(runs)
    with timeline_beside(recording_of(run)) as timeline:

        def step(number: int) -> None:
            timeline.go_to(_STEP_S * number % timeline.ends_s)
            wall.sleep(LOOK_S)

        rates = _shown_a_second(chromium, timeline.address, _TIME, step, wall)
    return figure("moments shown a second while scrubbed", rates)


def _tree(chromium: Chromium, wall: WallClock) -> Figure:
    """Updates of a large tree, all of it open and each node with another message, that a browser shows."""
    access, browsers = Access(new_token()), list[Browser]()
    server = PageServer(0, access, "tree")

    def welcome(client: Any, may_command: bool) -> None:
        # nothing is pressed, so that nobody has to be served
        browsers.append(Browser(client, _NOBODY, access, lambda _line: None, may_command))

    server.on_client(welcome)

    def step(number: int) -> None:
        seen = Seen(t_s=0.1 * number, task="a large task", nodes=_nodes(number))
        for browser in browsers:
            browser.show(seen)
        wall.sleep(DRAWN_EVERY_S)

    rates = _shown_a_second(chromium, f"http://127.0.0.1:{server.port}/", _UPDATE, step, wall)
    server.close()
    return figure(f"updates shown a second of a tree of {_NODES} nodes", rates)


_NOBODY: Any = None


def _nodes(number: int) -> Sequence[Mapping[str, Any]]:
    """A tree of which every node says something new."""
    below = [
        {"depth": 1 + i % 9, "name": f"node {i}", "status": "running", "message": f"{i + number} mm to go"}
        for i in range(_NODES - 1)
    ]
    return [{"depth": 0, "name": "root", "status": "running", "message": f"update {number}"}, *below]


def _shown_a_second(
    chromium: Chromium, address: str, pattern: str, step: Callable[[int], None], wall: WallClock
) -> list[float]:
    """How often in a second what a pattern finds in a page has changed, while steps are taken."""
    page = chromium.new_page(viewport={"width": 1280, "height": 800})
    page.goto(address)
    page.locator("canvas[data-engine]").wait_for()
    page.evaluate(_COUNT, pattern)
    rates, steps = [], 0
    for turn in range(5):
        page.evaluate("window.moments = 0")
        began_s = wall.now_s()
        while (passed_s := wall.now_s() - began_s) < _COUNTED_S:
            step(steps)
            steps += 1
        if turn:  # the first one warms up
            rates.append(float(page.evaluate("window.moments")) / passed_s)
    page.close()
    return rates
