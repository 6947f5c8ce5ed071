"""The page for long: how the memory of the robot's processes goes on while a browser looks."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from playwright.sync_api import sync_playwright

from robots.clock import WallClock
from tools.benchmark.figures import Figure, figure
from tools.benchmark.served.served_robot import (
    CONTROL,
    EXECUTIVE,
    PAGE,
    RECORDER,
    Moving,
    launched,
    memory_kb,
    opened,
    served,
)

_MINUTES, _SETTLED_AFTER = 40.0, 0.25
"""How long is looked, and the share of it after which memory is to have settled: ten minutes."""
_QUICK_MINUTES = 0.6
_EVERY_S = 5.0
_HOUR_S = 3600.0
_PROCESSES = {"page": PAGE, "control": CONTROL, "executive": EXECUTIVE, "recorder": RECORDER}


def view_long(quick: bool) -> list[Figure]:
    """The growth of each process, in % an hour, of a robot that moves all the time."""
    wall, lasts_s = WallClock(), 60.0 * (_QUICK_MINUTES if quick else _MINUTES)
    with sync_playwright() as playwright, tempfile.TemporaryDirectory(prefix="view-") as folder:
        chromium = launched(playwright)
        with served(Path(folder), wall, "--view", "--view-port", "0") as measured:
            page = opened(chromium, measured.address)
            pids = {name: measured.pid(module) for name, module in _PROCESSES.items()}
            kept: dict[str, list[tuple[float, float]]] = {name: [] for name in pids}
            with Moving(measured.robot, wall):
                began_s = wall.now_s()
                while (passed_s := wall.now_s() - began_s) < lasts_s:
                    for name, pid in pids.items():
                        kept[name].append((passed_s, memory_kb(pid)))
                    wall.sleep(_EVERY_S)
            page.close()
        chromium.close()
    return [
        figure(f"growth of the {name}, % an hour", [growth_an_hour(looks, _SETTLED_AFTER * lasts_s)])
        for name, looks in kept.items()
    ]


def growth_an_hour(looks: list[tuple[float, float]], settled_s: float) -> float:
    """The slope of the straight line through all looks after some time, in % an hour of where it begins.

    Args:
        looks: Times, s, and memory, in any unit.
        settled_s: Looks before are left out.
    """
    settled = np.array([look for look in looks if look[0] >= settled_s])
    slope, start = np.polyfit(settled[:, 0] - settled[0, 0], settled[:, 1], 1)
    return float(100.0 * _HOUR_S * slope / start)
