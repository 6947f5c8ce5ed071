"""Recorded runs as a referee of changes that should change nothing: ``python -m tools.evaluate digests``.

A run in lockstep gives the same events on the same machine and versions, byte for byte. ``--record FILE``
keeps what some sixty runs gave, over every scene and skill; ``--check FILE`` runs them again and tells which
differ.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass
from pathlib import Path
from types import MappingProxyType

from rich.console import Console

from executive.runs.run_request import DEFAULT_ROBOT

_SAID: Mapping[str, Sequence[str]] = MappingProxyType(
    {
        "tabletop": (
            "pick up the red cup on the table",
            "pick up the red cup with your left hand",
            "pick up the red cup and put it on the table",
            "pick up the red cup, then go home",
            "how many cups are on the table?",
            "what is on the table?",
            "where is the red cup?",
            "point at the red cup",
            "look at the table",
            "say hello and wave",
            "wait two seconds",
            "go home",
            "pick up the green bottle",
            "open the fridge",
            "walk to the table",
            "move_forward",
            "turn_left",
            "pick up something",
            "pick up the cup. stop",
            "pick up the red cup and give it to Ana",
        ),
        "clutter": (
            "pick up the red cup",
            "pick up a cup",
            "pick up the bottle",
            "how many things are on the table?",
            "take the cup left of the bottle",
            "pick up the red cup and put it on the table",
        ),
        "counter": (
            "pick up the red cup",
            "what is on the counter?",
            "pick up the cup and put it on the counter",
        ),
        "dinner": (
            "put the cup into the bowl",
            "pick up the bowl",
            "how many cups are there?",
            "what is on the table?",
        ),
        "drawers": (
            "open the drawer",
            "open the top drawer and close it",
            "open the drawer and put the cup into it",
            "close the drawer",
        ),
        "flat": (
            "walk to the kitchen",
            "walk to the kitchen and open the fridge",
            "find the bottle",
            "who is here?",
            "walk forward one meter",
            "walk to Ana and wave",
            "bring me the bottle from the fridge",
        ),
        "fridge": (
            "open the fridge",
            "open the fridge and close it",
            "close the fridge",
            "what is in the fridge?",
            "take the bottle from the fridge",
        ),
        "person": (
            "wave hello to the person in front of you",
            "give the cup to Ana",
            "point at Ana",
            "walk to Ana",
            "how many people are there?",
            "look at Ana",
        ),
        "shelf": (
            "pick up the red cup",
            "pick up the cup from the shelf",
            "what is on the shelf?",
            "put the cup on the shelf",
            "find the red cup",
        ),
        "watched": ("pick up the red cup", "how many things are on the table?"),
        "bench": (
            "pick up the red box on the table",
            "put the blue cup next to the red box",
            "walk to the table",
            "pick up the red bottle on the table",
        ),
        "bench_clutter": ("put the red cup into the bowl", "what is on the table?"),
        "bench_drawers": ("open the drawer and close it",),
        "low_kitchen": ("open the fridge", "walk to the kitchen"),
        "low_tabletop": ("pick up the red bottle on the table",),
        "cabinet": (
            "open the top drawer of the cabinet",
            "open the microwave and close it",
        ),
    }
)


_ROBOTS = {"bench": "panda", "low": "g1"}
"""Whose scenes some are, by the first word of their names."""


@dataclass(frozen=True, slots=True)
class RecordedRun:
    """One run and what became of it.

    Attributes:
        said: The sentence.
        scene: Name of the scene.
        seed: Of everything random.
        outcome: As the report tells it, empty where no run began.
        exit_code: Of the process.
        simulated_s: Simulated time of all tasks together, s.
        evidence: What was measured at the end of each task, as canonical JSON.
        events_sha256: Digest of the events.
        robot: Whose run it is.
    """

    said: str
    scene: str
    seed: int
    outcome: str = ""
    exit_code: int = 0
    simulated_s: float = 0.0
    evidence: str = ""
    events_sha256: str = ""
    robot: str = DEFAULT_ROBOT


def planned_runs() -> tuple[RecordedRun, ...]:
    """All runs, each with a seed of its own."""
    pairs = [(scene, text) for scene, texts in _SAID.items() for text in texts]
    return tuple(
        RecordedRun(text, scene, 100 + number, robot=_ROBOTS.get(scene.partition("_")[0], DEFAULT_ROBOT))
        for number, (scene, text) in enumerate(pairs)
    )


def carried_out(run: RecordedRun) -> RecordedRun:
    """Run it in a process of its own.

    Raises:
        RuntimeError: The process ended by a defect.
    """
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        command = [sys.executable, "-m", "executive", "run", run.said, "--scene", run.scene]
        command += ["--robot", run.robot]
        command += ["--seed", str(run.seed), "--on-question", "first", "--quiet", "--plain"]
        command += ["--record", folder, "--report", os.fspath(report)]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        if ended.returncode == 70:
            raise RuntimeError(f"{run.said!r} in {run.scene}, seed {run.seed}: {ended.stderr.strip()}")
        told = json.loads(report.read_text("utf-8")) if report.exists() else {}
    tasks = told.get("tasks", [])
    return RecordedRun(
        run.said,
        run.scene,
        run.seed,
        str(told.get("outcome", "")),
        ended.returncode,
        round(sum(task["time_s"]["simulated"] for task in tasks), 6),
        json.dumps([task["evidence"] for task in tasks], sort_keys=True),
        str(told.get("events_sha256", "")),
        run.robot,
    )


def differences(before: RecordedRun, now: RecordedRun) -> list[str]:
    """The names of what differs between two runs of one sentence."""
    old, new = asdict(before), asdict(now)
    return [name for name in old if old[name] != new[name]]


def run_digests(check: Path | None, record: Path | None, jobs: int, every: int, messages: Console) -> int:
    """Record the runs, or compare them with recorded ones; 0 when none differs.

    Args:
        check: A file that was recorded.
        record: Where to record.
        jobs: Processes at a time.
        every: Every so manyth run alone.
        messages: Where progress and differences are told.
    """
    runs = _read(check) if check is not None else planned_runs()
    chosen = runs[::every]
    differing, results = 0, []
    with ThreadPoolExecutor(jobs) as pool:
        for before, now in zip(chosen, pool.map(carried_out, chosen), strict=True):
            results.append(now)
            wrong = differences(before, now) if check is not None else []
            differing += bool(wrong)
            verdict = f"differs in {', '.join(wrong)}" if wrong else now.outcome or "no run"
            messages.print(f"{now.scene}, seed {now.seed}, {now.said!r}: {verdict}", markup=False)
    if record is not None:
        record.write_text(json.dumps([asdict(run) for run in results], indent=1) + "\n", "utf-8")
    if check is not None:
        messages.print(f"{len(results) - differing} of {len(results)} runs as recorded")
    return 1 if differing else 0


def _read(file: Path) -> tuple[RecordedRun, ...]:
    return tuple(RecordedRun(**entry) for entry in json.loads(file.read_text("utf-8")))
