"""Draw the page of the browser: ``python -m tools.pictures.draw_view docs/pictures [--only NAME]``.

Needs the extras ``view`` and ``record``, Playwright and Debian's Chromium. Runs are recorded in motion and
shown again, so that the same moments are drawn each time. The question is asked by a robot that is
served: a run that is over has no buttons.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from playwright.sync_api import Browser, Page, sync_playwright

from executive.doors.view.recording import Recording, first_difference
from executive.doors.view.timeline import timeline_beside
from robots.clock import WallClock
from tools.benchmark.served.served_robot import launched, opened, served
from tools.pictures.view_runs import MAIN_JOB, RUNS, at_the_end, recorded, refused

WINDOW, PHONE = (1280, 800), (390, 844)
_SETTLED_MS = 12_000.0
_WITHIN_MS = 120_000.0
_ASKED, _ASKED_SCENE = "pick up the cup", "clutter"
NAMES = (*RUNS, "view_phone", "view_dark", "view_refused", "view_two", "view_question")


def draw(page: Page, address: str, asked: str, target: Path, dark: bool) -> None:
    """Draw what a browser shows."""
    page.set_default_timeout(_WITHIN_MS)
    page.goto(address)
    page.get_by_text(asked).first.wait_for(state="attached")
    for notice in page.locator(".mantine-Notification-closeButton").all():
        notice.click()
    if dark:
        page.get_by_label("dark", exact=True).check()
    page.wait_for_timeout(_SETTLED_MS)
    page.screenshot(path=target)


def draw_question(browser: Browser, target: Path, folder: Path) -> None:
    """Draw a served robot that asks which of two things is meant, as it sees them with its own camera."""
    # a browser without a graphics card leaves the camera little of two cores
    slowly = ("--ordinary", "--pace", "0.25")
    options = ("--scene", _ASKED_SCENE, "--perception", "rgbd", "--evaluation", *slowly)
    with served(folder, WallClock(), *options, "--view", "--view-port", "0") as robot:
        page = opened(browser, robot.address)
        page.locator("form input").first.fill(_ASKED)
        page.keyboard.press("Enter")
        page.get_by_text("the robot asks").first.wait_for()
        page.wait_for_timeout(_SETTLED_MS)
        page.screenshot(path=target)
        page.close()


def moments(names: list[str], folder: Path) -> Iterator[tuple[str, Recording, float, Recording | None]]:
    """Each picture's name, run and moment, and the run beside it."""
    main: Recording | None = None
    for name in names:
        place = folder / name
        place.mkdir()
        if name == "view_refused":
            recording = refused(place)
            yield name, recording, at_the_end(recording), None
        elif name in RUNS and name != "view":
            recording = recorded(RUNS[name], place)
            yield name, recording, RUNS[name].at_s(recording), None
        else:
            main = main or recorded(MAIN_JOB, place)
            if name != "view_two":
                yield name, main, MAIN_JOB.at_s(main), None
                continue
            (place / "other").mkdir()
            other = recorded(replace(MAIN_JOB, seed=1), place / "other")
            differs = first_difference(main, other)
            yield name, main, 0.0 if differs is None else differs.t_s + 2.0, other


def main() -> None:
    """Draw the pictures into a folder."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", choices=NAMES, action="append", help="draw this one; may be said again")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = launched(playwright)
        wanted = arguments.only or list(NAMES)
        if "view_question" in wanted:
            draw_question(browser, arguments.folder / "view_question.png", Path(folder))
        again = [name for name in wanted if name != "view_question"]
        for name, recording, t_s, other in moments(again, Path(folder)):
            width, height = PHONE if name == "view_phone" else WINDOW
            page = browser.new_page(viewport={"width": width, "height": height})
            with timeline_beside(recording, other) as timeline:
                timeline.go_to(t_s)
                draw(
                    page,
                    timeline.address,
                    recording.asked,
                    arguments.folder / f"{name}.png",
                    name == "view_dark",
                )
            page.close()
            print(f"drew {name} at {t_s:.2f} s")
        browser.close()


if __name__ == "__main__":
    main()
