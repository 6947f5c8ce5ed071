"""The page in a real browser: Debian's Chromium under Playwright."""

import os
import re
import signal
import time
from contextlib import suppress

import pytest

from tests.peers.served_page import MARKS, Served, opened, say, until

pytest.importorskip("playwright.sync_api", reason="playwright is not installed")

PORT = 8097
pytestmark = MARKS


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    made = Served(tmp_path_factory.mktemp("view"), PORT, "--scene", "clutter")
    until(made.is_ready, 240.0)
    yield made
    made.end()


@pytest.fixture
def page(chromium):
    made = opened(chromium)
    yield made
    made.context.close()


@pytest.fixture
def commanding(page, served):
    page.goto(served.address)
    page.get_by_text("waits for a task").wait_for()
    return page


def picture(page):
    """The middle of the page, where the robot is."""
    return page.screenshot(clip={"x": 420, "y": 200, "width": 480, "height": 400})


def test_a_page_without_the_token_shows_and_commands_nothing(page, served):
    page.goto(f"http://127.0.0.1:{PORT}/")
    page.get_by_text("talos").first.wait_for()
    page.locator("canvas[data-engine]").wait_for()
    page.get_by_text("take command").wait_for()

    assert page.get_by_text("cancel", exact=True).count() == 0
    assert page.get_by_text("the simulator's truth").count() == 0  # it is not served for evaluations


def test_the_page_loads_nothing_from_elsewhere(commanding):
    foreign = [
        url
        for url in commanding.asked_for
        if not url.startswith((f"http://127.0.0.1:{PORT}/", "data:", "blob:"))
    ]

    assert foreign == []


def test_a_foreign_page_gets_no_connection(page, served):
    page.route("http://evil.example/", lambda route: route.fulfill(body="<p>hello</p>"))
    page.goto("http://evil.example/")
    ended = page.evaluate(
        """port => new Promise(done => {
            const socket = new WebSocket(`ws://127.0.0.1:${port}`, ["viser-v1.1.1"]);
            socket.onopen = () => done("open");
            socket.onclose = () => done("refused");
        })""",
        PORT,
    )

    assert ended == "refused"


@pytest.mark.requirement("U6")
def test_a_typed_command_moves_the_drawn_robot_and_is_done(commanding, served):
    time.sleep(2.0)
    before = picture(commanding)
    commanding.get_by_text("log", exact=True).click()
    say(commanding, "move backward for 1 second")
    commanding.get_by_text(re.compile("done: ")).first.wait_for()

    assert picture(commanding) != before


@pytest.mark.requirement("U6")
def test_a_question_is_answered_by_its_button(commanding, served):
    say(commanding, "pick up the cup")
    until(lambda: served.robot.status()["question"] is not None)
    choice = served.robot.status()["question"]["choices"][0]
    commanding.get_by_role("button", name=choice, exact=True).click()

    until(lambda: served.robot.status()["question"] is None)
    until(lambda: served.robot.status()["task"] is not None)
    served.come_to_rest()


def test_the_page_goes_on_after_the_executive_was_killed(commanding, served):
    os.kill(served.robot.status()["commander"], signal.SIGKILL)
    until(served.is_ready)
    say(commanding, "wait for 1 second")

    until(lambda: served.robot.status()["task"] is not None)
    until(lambda: served.robot.status()["task"] is None)


@pytest.mark.requirement("U6")
def test_stop_latches_in_mid_motion_and_is_told(commanding, served):
    say(commanding, "wave")
    until(lambda: served.robot.status()["task"] is not None)
    commanding.get_by_role("button", name="STOP").click()

    until(served.is_stopped, 10.0)
    commanding.get_by_text("EMERGENCY STOP").first.wait_for()
    served.reset()


def test_stop_is_in_force_while_the_executive_hangs(commanding, served):
    say(commanding, "wave")
    until(lambda: served.robot.status()["task"] is not None)
    hung = served.robot.status()["commander"]
    os.kill(hung, signal.SIGSTOP)
    try:
        commanding.keyboard.press("Alt+s")
        until(served.is_stopped, 10.0)
    finally:
        with suppress(ProcessLookupError):  # one that hangs for long is replaced
            os.kill(hung, signal.SIGCONT)
