"""Recorded runs in a real browser: Debian's Chromium under Playwright."""

import io
import re
import signal
import subprocess
import sys
import time

import pytest
from PIL import Image

from executive.doors.recorder.feed import RunFeed
from executive.doors.view.motion_read import recording_of
from executive.doors.view.timeline import timeline_beside
from executive.runs.run import perform
from executive.runs.run_log import recorded_runs
from executive.runs.run_request import RunRequest
from executive.screens.display import NoDisplay
from executive.scripts.task_script import script_for
from executive.trust import Trust
from tests.peers.served_page import MARKS, PHONE, WINDOW, opened, until

pytest.importorskip("playwright.sync_api", reason="playwright is not installed")

TEXT = "move backward for 1 second, then wait for 15 seconds"
FAILS = "wait for 2 seconds, then point at the purple ball"
"""Nothing is purple: the robot looks for it, and cannot turn around before the table."""
SLOW = "0.1 x"
"""A browser on a busy machine can take seconds until it tells of a key: the run must not end meanwhile."""
PICTURE_S = 8.0
pytestmark = MARKS


def a_picture():
    """One of the camera that shows nothing but a colour that nothing else has."""
    file = io.BytesIO()
    Image.new("RGB", (640, 480), (255, 0, 255)).save(file, "JPEG")
    return file.getvalue()


def pixels(page):
    return list(Image.open(io.BytesIO(page.screenshot())).convert("RGB").get_flattened_data())


def recorded(folder, seed, text=TEXT):
    said = script_for(text, Trust(), "tabletop")
    feed = RunFeed(NoDisplay(), print)
    request = RunRequest(text, said.statements, "talos", "tabletop", seed, folder)
    perform(request, feed, on_assembly=feed.begin, on_record=feed.record)
    feed.close()
    (run,) = recorded_runs(folder)
    return recording_of(run)


@pytest.fixture(scope="module")
def timeline(tmp_path_factory):
    one, other = (recorded(tmp_path_factory.mktemp(f"seed_{seed}"), seed) for seed in (2, 3))
    one.pictures.append((PICTURE_S, a_picture()))
    with timeline_beside(one, other, SLOW) as made:
        yield made


@pytest.fixture(scope="module")
def failed(tmp_path_factory):
    """The page of a run in which a wait is done, and what comes after it fails."""
    run = recorded(tmp_path_factory.mktemp("failed"), 4, FAILS)
    with timeline_beside(run, pace=SLOW) as made:
        made.run_shown = run
        yield made


@pytest.fixture(params=[WINDOW, PHONE], ids=["window", "phone"])
def page(chromium, timeline, request):
    made = opened(chromium, request.param)
    made.goto(timeline.address)
    made.get_by_text("play", exact=True).wait_for()
    made.locator("canvas[data-engine]").wait_for()
    timeline.go_to(0.0)
    yield made
    made.context.close()


def test_the_first_difference_of_two_runs_is_told_and_gone_to_by_a_key(page, timeline):
    page.get_by_text("differs").first.wait_for()
    page.keyboard.press("Alt+d")

    until(lambda: timeline.t_s > 0.0)
    assert timeline.t_s == pytest.approx(timeline.difference.t_s, abs=0.02)


def test_keys_alone_play_and_hold_and_move_the_time(page, timeline):
    page.keyboard.press("Shift+ArrowRight")
    until(lambda: timeline.t_s == pytest.approx(0.1, abs=0.02))
    page.keyboard.press("Alt+p")
    until(lambda: timeline.t_s > 0.15)
    page.keyboard.press("Alt+p")

    until(lambda: held(timeline))


def held(timeline):
    """Whether the time stands, somewhere before the end."""
    before_s = timeline.t_s
    time.sleep(1.0)
    return before_s == timeline.t_s < timeline.ends_s


@pytest.mark.requirement("U6")
def test_the_drawn_robots_move_with_the_time(page, timeline):
    time.sleep(3.0)
    before = page.screenshot()
    timeline.go_to(0.7 * timeline.ends_s)
    time.sleep(3.0)

    assert page.screenshot() != before


def test_the_cameras_picture_is_shown_where_it_looks(page, timeline):
    def magenta():
        return sum(one[0] > 150 and one[1] < 90 and one[2] > 150 for one in pixels(page))

    timeline.go_to(PICTURE_S - 0.1)
    until(lambda: magenta() == 0)
    timeline.go_to(PICTURE_S + 0.1)
    until(lambda: magenta() > 100)
    timeline.go_to(PICTURE_S - 0.1)
    until(lambda: magenta() == 0)


def test_a_key_goes_to_the_failure_and_the_page_tells_it(chromium, failed):
    page = opened(chromium, WINDOW)
    page.goto(failed.address)
    page.get_by_text("next failure", exact=True).wait_for()
    page.locator("canvas[data-engine]").wait_for()
    assert page.get_by_text("no room to turn").count() == 0
    page.keyboard.press("Alt+f")

    until(lambda: failed.t_s > 0.0)
    assert failed.t_s == failed.run_shown.failures_s[0]
    page.get_by_text("no room to turn").first.wait_for()
    page.context.close()


def test_the_command_shows_two_runs_beside_each_other(chromium, tmp_path):
    for seed in (5, 6):
        recorded(tmp_path / str(seed), seed, "wait for 1 second")
    runs = [recorded_runs(tmp_path / str(seed))[0] for seed in (5, 6)]
    names = [str(run.path) for run in runs]
    command = [sys.executable, "-m", "executive", "replay", *names, "--view", "--view-port", "0"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    lines = []
    address = next(
        found[0]
        for line in process.stdout
        if (lines.append(line) or (found := re.search(r"http://127.0.0.1:\S+", line)))
    )
    page = opened(chromium, WINDOW)
    page.goto(address)

    page.get_by_text("first difference", exact=True).wait_for()
    for run in runs:
        page.get_by_text(run.name, exact=True).first.wait_for()
    page.context.close()
    process.send_signal(signal.SIGINT)
    assert process.wait(60.0) == 0, lines


def test_a_tab_reaches_the_button_that_plays(page, timeline):
    for _ in range(40):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.textContent").strip() == "play":
            break
    page.keyboard.press("Enter")

    until(lambda: timeline.t_s > 0.2)
    timeline.hold()
