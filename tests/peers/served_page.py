"""A served robot with a page, and the browser that looks at it: Debian's Chromium under Playwright."""

import re
import shutil
import subprocess
import sys
import threading
import time

import pytest

from executive.doors.served_robot import ServedRobot
from executive.live.caller.caller import ask_at
from robots.live.wire.errors import LiveError
from robots.live.wire.messages import GetStatus, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder
from tests.peers.person import leave_stop

CHROMIUM = shutil.which("chromium")
ARGUMENTS = [
    "--no-sandbox",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
]
WINDOW, PHONE = (1280, 800), (390, 844)
WITHIN_S = 120.0
MARKS = [
    pytest.mark.timeout(600),
    pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed"),
]


class Served:
    """A robot with a page, and the address that was printed."""

    def __init__(self, folder, port, *options):
        command = [sys.executable, "-m", "executive", "serve", "--view", "--view-port", str(port)]
        command += ["--pace", "0.25", "--ordinary"]  # a browser draws on the same cores
        command += ["--folder", str(folder / "live"), "--record", str(folder / "runs"), *options]
        self.process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
        self.where = RuntimeFolder(folder / "live")
        self.robot, self.lines = ServedRobot(self.where.path), []
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

    def is_stopped(self):
        """Whether the control process, asked past the executive, has the emergency stop in force."""
        told = ask_at(self.where.control_socket, write_control_message(GetStatus()))
        return told["emergency"] is not None

    def reset(self):
        """Leave the emergency stop, as a person at the robot does."""
        leave_stop(self.where.path)

    def come_to_rest(self):
        """Cancel what is under way, and wait until nothing is."""
        if self.robot.status()["task"] is not None:
            self.robot.cancel("enough")
        until(lambda: self.robot.status()["task"] is None)

    def end(self):
        self.process.terminate()
        self.process.wait(30.0)


def until(so, within_s=WITHIN_S):
    begun_s = time.monotonic()
    while not so():
        assert time.monotonic() - begun_s < within_s
        time.sleep(0.2)


def opened(chromium, size=WINDOW):
    """A new page of a size, with the addresses that it has asked for."""
    width, height = size
    page = chromium.new_context(viewport={"width": width, "height": height}).new_page()
    page.set_default_timeout(1000.0 * WITHIN_S)
    page.asked_for = []
    page.on("request", lambda request: page.asked_for.append(request.url))
    return page


def say(page, text):
    page.locator("form input").first.fill(text)
    page.keyboard.press("Enter")
