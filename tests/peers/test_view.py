"""The page in a real browser: Debian's Chromium under Playwright."""

import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time

import pytest

from executive.doors.served_robot import ServedRobot
from robots.live.wire.errors import LiveError

sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")

CHROMIUM = shutil.which("chromium")
ARGUMENTS = [
    "--no-sandbox",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
]
PORT = 8097
WITHIN_S = 120.0
pytestmark = [
    pytest.mark.timeout(600),
    pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed"),
]


class Served:
    """A robot with a page, and the address that was printed."""

    def __init__(self, folder):
        command = [sys.executable, "-m", "executive", "serve", "--view", "--view-port", str(PORT)]
        command += ["--scene", "clutter", "--pace", "0.25"]  # a browser draws on the same cores
        command += ["--ordinary", "--folder", str(folder / "live"), "--record", str(folder / "runs")]
        self.process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
        self.robot, self.lines = ServedRobot(folder / "live"), []
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        self.lines += iter(self.process.stderr.readline, "")

    @property
    def address(self):
        found = [re.search(r"http://\S+token=\S+", line) for line in list(self.lines)]
        return next((one[0] for one in found if one), None)

    def is_ready(self):
        try:
            return self.address is not None and bool(self.robot.status())
        except LiveError:
            return False


def until(so, within_s=WITHIN_S):
    begun_s = time.monotonic()
    while not so():
        assert time.monotonic() - begun_s < within_s
        time.sleep(0.2)


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    made = Served(tmp_path_factory.mktemp("view"))
    until(made.is_ready, 240.0)
    yield made
    made.process.terminate()
    made.process.wait(30.0)


@pytest.fixture(scope="module")
def chromium():
    with sync_api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        yield browser
        browser.close()


@pytest.fixture
def page(chromium):
    made = chromium.new_context(viewport={"width": 1280, "height": 800}).new_page()
    made.set_default_timeout(1000.0 * WITHIN_S)
    made.asked_for = []
    made.on("request", lambda request: made.asked_for.append(request.url))
    yield made
    made.context.close()


@pytest.fixture
def commanding(page, served):
    page.goto(served.address)
    page.get_by_text("waits for a task").wait_for()
    return page


def say(page, text):
    page.locator("form input").first.fill(text)
    page.keyboard.press("Enter")


def picture(page):
    """The middle of the page, where the robot is."""
    return page.screenshot(clip={"x": 420, "y": 200, "width": 480, "height": 400})


def test_a_page_without_the_token_shows_and_commands_nothing(page, served):
    page.goto(f"http://127.0.0.1:{PORT}/")
    page.get_by_text("talos").first.wait_for()
    page.locator("canvas[data-engine]").wait_for()
    page.get_by_text("take command").wait_for()

    assert page.get_by_text("cancel", exact=True).count() == 0


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


def test_a_typed_command_moves_the_drawn_robot_and_is_done(commanding, served):
    time.sleep(2.0)
    before = picture(commanding)
    commanding.get_by_text("log", exact=True).click()
    say(commanding, "move backward for 1 second")
    commanding.get_by_text(re.compile("done: ")).first.wait_for()

    assert picture(commanding) != before


def test_a_question_is_answered_by_its_button(commanding, served):
    say(commanding, "pick up the cup")
    until(lambda: served.robot.status()["question"] is not None)
    choice = served.robot.status()["question"]["choices"][0]
    commanding.get_by_role("button", name=choice, exact=True).click()

    until(lambda: served.robot.status()["question"] is None)
    until(lambda: served.robot.status()["task"] is not None)
    served.robot.cancel("enough")
    until(lambda: served.robot.status()["task"] is None)


def test_the_page_goes_on_after_the_executive_was_killed(commanding, served):
    os.kill(served.robot.status()["commander"], signal.SIGKILL)
    until(served.is_ready)
    say(commanding, "wait for 1 second")

    until(lambda: served.robot.status()["task"] is not None)
    until(lambda: served.robot.status()["task"] is None)


def test_stop_latches_in_mid_motion_and_is_told(commanding, served):
    say(commanding, "wave")
    until(lambda: served.robot.status()["task"] is not None)
    commanding.get_by_role("button", name="STOP").click()

    until(lambda: served.robot.status()["emergency"] is not None, 10.0)
    commanding.get_by_text("EMERGENCY STOP").first.wait_for()
