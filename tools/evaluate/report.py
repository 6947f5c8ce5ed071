"""Show an evaluation: a table, and for every episode that went wrong the command that shows it again."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from pathlib import Path

from rich.console import Console
from rich.table import Table

from robots.scenes.scene_writer import dump
from tools.evaluate.questions import ambiguous_trial
from tools.evaluate.records import EpisodeRecord, Summary
from tools.evaluate.scenes import BENCH_CLUTTER, CLUTTER, SENTENCE, episode_scene
from tools.evaluate.skills.episode import trial_of
from tools.evaluate.skills.registry import SKILL_SUITES

# More than anybody reads; the JSON has them all.
_SHOWN = 25


def save_scenes(summary: Summary, folder: Path, robot: str = "talos") -> dict[int, Path]:
    """Write the scene of every episode of a robot that went wrong; returns the file of each seed."""
    files = {}
    for record in summary.records:
        if record.bad:
            folder.mkdir(parents=True, exist_ok=True)
            name = f"{summary.suite}-{record.seed}" + (f"-{record.fault}" if record.fault else "")
            files[record.seed] = folder / f"{name}.toml"
            files[record.seed].write_text(_scene_text(summary, record, robot), "utf-8")
    return files


def _scene_text(summary: Summary, record: EpisodeRecord, robot: str) -> str:
    if summary.suite in SKILL_SUITES:
        return dump(trial_of(summary.suite, record.seed, summary.scene, robot).scene)
    if summary.suite == "question":
        return dump(ambiguous_trial(record.seed).scene)
    return episode_scene(record.seed, record.fault, summary.scene)


def print_summary(
    summary: Summary,
    scenes: Mapping[int, Path],
    console: Console,
    robot: str = "talos",
    seeing: str | None = None,
) -> None:
    """Print demands, figures and the commands that show again what went wrong.

    Args:
        summary: The figures.
        scenes: The file of each seed's scene.
        console: Where to.
        robot: Whose episodes these were.
        seeing: How it saw, when not as the scenes say.
    """
    unusual = "" if robot == "talos" else f" --robot {robot}"
    unusual += "" if seeing is None else f" --perception {seeing}"
    fault = f", fault {summary.fault}" if summary.fault else ""
    table = Table(
        "", "measured", "demanded", "", title=f"{summary.suite}: {len(summary.records)} episodes{fault}"
    )
    for bar in summary.bars():
        table.add_row(bar.name, bar.value, bar.limit, "ok" if bar.met else "MISSED")
    table.add_section()
    if summary.fault is not None:
        table.add_row("truly done", f"{summary.success_rate:.1%}", "", "")
        fired = sum(record.fault_fired for record in summary.records)
        table.add_row("the fault came", f"{fired} of {len(summary.records)}", "", "")
    if summary.others_touched is not None and summary.scene not in (
        CLUTTER,
        BENCH_CLUTTER,
    ):  # there it is a demand
        table.add_row("episodes with another object touched", str(summary.others_touched), "", "")
    planning = summary.planning_ms()
    table.add_row("planning", f"{planning['p50']:.0f} ms, p95 {planning['p95']:.0f} ms", "", "")
    table.add_row("simulation with control", f"{summary.realtime_factor():.1f} × real time", "", "")
    for kind, count in summary.failures().items():
        table.add_row(f"failed: {kind}", str(count), "", "")
    console.print(table)
    bad = [record for record in summary.records if record.bad]
    for record in bad[:_SHOWN]:
        verdict = "so" if record.truth else "not so"
        reason = record.failure or ", ".join(record.furniture_contacts) or ("fell" if record.fell else "")
        console.print(f"seed {record.seed}: {record.outcome}, truly {verdict}. {reason}", markup=False)
        console.print(f"    {_again(summary, record.seed, scenes)}{unusual}", markup=False, soft_wrap=True)
    if len(bad) > _SHOWN:
        console.print(f"and {len(bad) - _SHOWN} more, all in the JSON")


def _again(summary: Summary, seed: int, scenes: Mapping[int, Path]) -> str:
    """The command that shows one episode again; a fault needs the evaluation to bring it about."""
    if summary.fault is None and seed in scenes and summary.suite not in SKILL_SUITES:
        return f"executive run {shlex.quote(SENTENCE)} --scene {shlex.quote(str(scenes[seed]))} --seed {seed}"
    fault = f" --fault {summary.fault}" if summary.fault else ""
    scene = f" --scene {shlex.quote(summary.scene)}" if summary.scene else ""
    return f"python -m tools.evaluate {summary.suite} --episodes 1 --jobs 1 --seed {seed}{fault}{scene}"
