"""A robot that is served with every door open, for programs that nobody here wrote."""

import contextlib
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from executive.doors.served_robot import ServedRobot
from robots.live.wire.errors import LiveError
from tests.peers.served_page import ARGUMENTS, CHROMIUM
from tools.benchmark.peers.environments import ROS_NAMES, PeerEnvironment, default_cache

PROGRAMS = Path(__file__).parent / "programs"
READY_WITHIN_S = 240.0
DOMAIN = 41


SEEING_DOMAIN = 42


@pytest.fixture(scope="session")
def served(tmp_path_factory):
    """The folder of a robot in the flat, with the ROS door open on a domain of its own."""
    with _served(tmp_path_factory.mktemp("live"), DOMAIN, "--scene", "flat") as folder:
        yield folder


@pytest.fixture(scope="session")
def seeing(tmp_path_factory):
    """The same at a table, for a robot that sees with its camera; and the domain on which it is."""
    options = ("--scene", "tabletop", "--perception", "rgbd")
    with _served(tmp_path_factory.mktemp("seeing"), SEEING_DOMAIN, *options) as folder:
        yield folder, SEEING_DOMAIN


@pytest.fixture(scope="module")
def chromium():
    """A browser; of one module, since Playwright's event loop is in the way of other ones."""
    with pytest.importorskip("playwright.sync_api").sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        yield browser
        browser.close()


@contextlib.contextmanager
def _served(folder, domain, *options):
    command = [sys.executable, "-m", "executive", "serve", *options, "--folder", str(folder)]
    command += [
        "--ordinary",
        "--pace",
        "0.8",
        "--ros",
        "--ros-domain",
        str(domain),
        "--record",
        str(folder / "runs"),
    ]
    with subprocess.Popen(command) as process:
        try:
            robot, began_s = ServedRobot(folder), time.monotonic()
            while True:
                try:
                    robot.status()
                    break
                except LiveError:
                    assert process.poll() is None, "the robot is not served"
                    assert time.monotonic() - began_s < READY_WITHIN_S
                    time.sleep(0.5)
            yield folder
            process.terminate()
            process.wait(30.0)
        finally:
            process.kill()


@pytest.fixture(scope="session", params=ROS_NAMES)
def rclpy(request):
    """The interpreter of one distribution's rclpy; skipped, and named, where the registry gives none."""
    environment = PeerEnvironment(request.param, default_cache())
    if not environment.is_ready:
        pytest.skip(
            f"{environment.version} is not installed: python -m tools.benchmark.peers {request.param}"
        )
    return environment.python


@pytest.fixture
def peer(rclpy):
    """Runs a program of ``programs`` by rclpy, and answers its process; none outlives the test."""
    running = contextlib.ExitStack()

    def run(name, *arguments, domain=DOMAIN):
        surroundings = {
            **os.environ,
            "ROS_DOMAIN_ID": str(domain),
            "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        }
        surroundings.pop("PYTHONPATH", None)
        command = [str(rclpy), str(PROGRAMS / name), *map(str, arguments)]
        process = subprocess.Popen(command, env=surroundings, stdout=subprocess.PIPE, text=True)
        running.enter_context(process)
        running.callback(process.kill)
        return process

    with running:
        yield run


@pytest.fixture
def at_rest(served):
    """Waits until the robot has no task and stands."""

    def wait(within_s=60.0):
        robot, began_s = ServedRobot(served), time.monotonic()
        while robot.status()["task"] is not None:
            assert time.monotonic() - began_s < within_s, "the robot is still busy"
            time.sleep(0.1)

    return wait
