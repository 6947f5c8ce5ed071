"""Draw the page of the browser: ``python -m tools.pictures.draw_view docs/pictures``.

Needs the extra ``view``, Playwright and Debian's Chromium. A run of the main job is recorded and shown again,
so that the same moment is drawn each time: the hand on its way to the cup, in a window and on a phone.
"""

from __future__ import annotations

import argparse
import shutil
import tempfile
import threading
from pathlib import Path

from playwright.sync_api import Page, sync_playwright

from executive.doors.view.access import Access, new_token
from executive.doors.view.page_server import PageServer
from executive.doors.view.recording import Recording, recorded_again
from executive.doors.view.timeline import Timeline
from executive.runs.run import perform
from executive.runs.run_log import recorded_runs
from executive.runs.run_request import RunRequest
from executive.screens.display import NoDisplay
from executive.scripts.task_script import script_for
from executive.trust import USUAL_TRUST

SENTENCE, ROBOT, SCENE = "pick up the red cup on the table", "talos", "tabletop"
LEAF, SHARE = "stream reach", 0.7
"""The moment: how much of the time of this leaf has passed."""
SIZES = {"view": (1280, 800), "view_phone": (390, 844)}
_ARGUMENTS = ("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
_SETTLED_MS = 12_000.0
_WITHIN_MS = 120_000.0


def recorded() -> Recording:
    """The main job, carried out and seen again."""
    with tempfile.TemporaryDirectory() as folder:
        said = script_for(SENTENCE, USUAL_TRUST, SCENE)
        perform(RunRequest(SENTENCE, said.statements, ROBOT, SCENE, 0, Path(folder)), NoDisplay())
        (run,) = recorded_runs(Path(folder))
        return recorded_again(run, print)[0]


def moment_s(recording: Recording) -> float:
    """The time of the moment that is drawn."""
    while_running = [
        one.t_s
        for one in recording.moments
        if any(node["name"] == LEAF and node["status"] == "running" for node in one.nodes)
    ]
    return while_running[int(SHARE * len(while_running))]


def draw(page: Page, address: str, target: Path) -> None:
    """Draw what a browser shows."""
    page.set_default_timeout(_WITHIN_MS)
    page.goto(address)
    page.get_by_text(SENTENCE).first.wait_for(state="attached")
    for notice in page.locator(".mantine-Notification-closeButton").all():
        notice.click()
    page.wait_for_timeout(_SETTLED_MS)
    page.screenshot(path=target)


def main() -> None:
    """Draw the pictures into a folder."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    recording, over = recorded(), threading.Event()
    server = PageServer(0, Access(new_token()), "robot")
    timeline = Timeline(server, recording, over.is_set)
    timeline.go_to(moment_s(recording))
    threading.Thread(target=timeline.run, daemon=True).start()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=list(_ARGUMENTS))
        for name, (width, height) in SIZES.items():
            page = browser.new_page(viewport={"width": width, "height": height})
            draw(page, f"http://127.0.0.1:{server.port}/", folder / f"{name}.png")
            page.close()
        browser.close()
    over.set()
    server.close()


if __name__ == "__main__":
    main()
