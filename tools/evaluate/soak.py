"""The suite ``soak``: random commands, stops, cancels and resets for long, and what grows meanwhile."""

from __future__ import annotations

import argparse
import json
from collections import Counter
from dataclasses import asdict
from pathlib import Path

import numpy as np
from rich.console import Console

from executive.assembly import assemble
from executive.command_parser import parse
from executive.events import Event, TaskAccepted, TaskEnded
from tools.evaluate.records import Bar
from tools.evaluate.scenes import SENTENCE, episode_rng, pick_scene, read_episode_scene

SECONDS_AN_EPISODE = 60.0
"""Simulated time that one of ``--episodes`` stands for: two hours are 120."""
GROWTH = 0.05
WARM_SHARE = 0.2
"""Memory is compared with what it was after this share of the time: caches fill first."""
_SENTENCES = (SENTENCE, "go home", "go home", "pick up the blue cup")
_DISTURBANCES = ("none", "none", "cancel", "stop 1", "stop 2")
_LATEST_S = 12.0


def run_soak(options: argparse.Namespace, messages: Console) -> int:
    """Run it in this process; 0 when every demand is met, 1 when not."""
    until_s = options.episodes * SECONDS_AN_EPISODE
    rng = episode_rng(options.seed, 5)
    told: Counter[str] = Counter()

    def take(event: Event) -> None:
        told[type(event).__name__] += 1

    scene = read_episode_scene(pick_scene(options.seed), options.seed)
    assembly = assemble(options.robot, scene, options.seed, sink=take)
    session, truth, clock = assembly.session, assembly.world.truth, assembly.clock
    due: list[tuple[float, str]] = []

    def disturb() -> None:
        if due and clock.now_s() >= due[0][0]:
            _, what = due.pop()
            if what == "cancel":
                session.cancel("the soak cancels it")
            else:
                session.emergency_stop("the soak stops it", int(what.split()[1]))

    session.watch_periods(disturb)
    outcomes: Counter[str] = Counter()
    memory: list[tuple[float, float]] = []
    fell, stuck_resets = False, 0
    while clock.now_s() < until_s and not fell:
        sentence = _SENTENCES[int(rng.integers(len(_SENTENCES)))]
        what = _DISTURBANCES[int(rng.integers(len(_DISTURBANCES)))]
        due[:] = [] if what == "none" else [(clock.now_s() + float(rng.uniform(0.0, _LATEST_S)), what)]
        (command,) = parse(sentence).commands
        outcomes[session.run_task(command).outcome] += 1
        session.hold(float(rng.uniform(0.2, 1.5)))
        due.clear()
        if assembly.loop.emergency is not None and session.reset("the soak") is not None:
            stuck_resets += 1
        fell = truth.fallen()
        memory.append((clock.now_s(), _resident_mb()))
        messages.print(f"{clock.now_s():.0f} s, {sum(outcomes.values())} commands, {memory[-1][1]:.0f} MB")
    growth = _growth(memory, until_s)
    lost = abs(told[TaskAccepted.__name__] - told[TaskEnded.__name__])
    bars = [
        Bar("memory growth", f"{growth:.1%}", f"≤ {GROWTH:.0%}", growth <= GROWTH),
        Bar("falls", str(int(fell)), "0", not fell),
        Bar("resets that a resting robot refused", str(stuck_resets), "0", stuck_resets == 0),
        Bar("commands without an end", str(lost), "0", lost == 0),
    ]
    document = {
        "suite": "soak",
        "seed": options.seed,
        "episodes": options.episodes,
        "simulated_s": round(clock.now_s(), 1),
        "falls": int(fell),
        "failures": dict(outcomes),
        "events": dict(sorted(told.items())),
        "memory_mb": [(round(t, 1), round(mb, 1)) for t, mb in memory],
        "bars": [asdict(bar) for bar in bars],
    }
    if options.json is not None:
        options.json.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    console = Console()
    for bar in bars:
        console.print(f"{bar.name}: {bar.value} ({bar.limit}) {'ok' if bar.met else 'MISSED'}")
    console.print(f"{clock.now_s():.0f} s simulated, outcomes {dict(outcomes)}")
    return 0 if all(bar.met for bar in bars) else 1


def _growth(memory: list[tuple[float, float]], until_s: float) -> float:
    """Share by which memory grew since it was warm."""
    warm = [mb for t, mb in memory if t >= WARM_SHARE * until_s]
    return float(np.max(warm)) / warm[0] - 1.0 if warm else 0.0


def _resident_mb() -> float:
    """What this process holds in memory now."""
    pages = int(Path("/proc/self/statm").read_text("utf-8").split()[1])
    return pages * 4096 / 1e6
