"""Seeing: what a pick costs through the robot's own camera, beside the same pick with the stub."""

from __future__ import annotations

import gc
import os

from tools.benchmark.figures import Figure, figure
from tools.evaluate.episode import run_episode
from tools.evaluate.orders import EpisodeOrder

_STUB, _CAMERA = "stub", "rgbd"
_FIRST_SEED = 7_300


def eyes(quick: bool) -> list[Figure]:
    """Pick the same things with either, taking turns; the first pick of each is not counted.

    What the camera's process takes, drawing and looking, counts for the pick.
    """
    samples: dict[str, list[float]] = {_STUB: [], _CAMERA: []}
    for turn in range(3 if quick else 21):
        for perception, times in samples.items():
            before_s = _processor_s()
            run_episode(EpisodeOrder(_FIRST_SEED + turn, perception=perception))
            gc.collect()  # the camera's process ends with its owner, and counts when it has ended
            if turn > 0:
                times.append(_processor_s() - before_s)
    return [figure("pick through the camera, s", samples[_CAMERA], "pick with the stub", samples[_STUB])]


def _processor_s() -> float:
    """Of this process and of its children that have ended."""
    now = os.times()
    return now.user + now.system + now.children_user + now.children_system
