"""Starting: what a user waits for before anything happens, as processor time of fresh processes."""

from __future__ import annotations

import os
import subprocess
import sys

from tools.benchmark.figures import Figure, figure

# What is started, and the libraries that it cannot do without, started alone as what it is compared to.
_STARTS = {
    "help, ms": ("-m", "executive", "--help"),
    "a sentence understood, ms": ("-m", "executive", "parse", "pick up the red cup on the table"),
    "import of the whole executive, ms": ("-c", "import executive.runs.run, executive.session.assembly"),
}
_PEER = "interpreter with numpy, pinocchio, coal, placo and mujoco"
_LIBRARIES = ("-c", "import numpy, pinocchio, coal, placo, mujoco")


def startup(quick: bool) -> list[Figure]:
    """Start each in turn, several times; the first round warms the disk's cache and is not counted."""
    samples: dict[str, list[float]] = {name: [] for name in (*_STARTS, _PEER)}
    for turn in range(3 if quick else 11):
        for name, arguments in {**_STARTS, _PEER: _LIBRARIES}.items():
            seconds = _processor_s(arguments)
            if turn > 0:
                samples[name].append(1e3 * seconds)
    return [figure(name, samples[name], _PEER, samples[_PEER]) for name in _STARTS]


def _processor_s(arguments: tuple[str, ...]) -> float:
    """Processor time of a Python process from its start to its end, its children included.

    Raises:
        subprocess.CalledProcessError: It failed.
    """
    before = os.times()
    subprocess.run([sys.executable, *arguments], check=True, stdout=subprocess.DEVNULL)
    after = os.times()
    return (after.children_user - before.children_user) + (after.children_system - before.children_system)
