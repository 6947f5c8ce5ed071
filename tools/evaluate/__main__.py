"""``python -m tools.evaluate pick --episodes 200 --seed 0 --jobs 2 [--fault NAME] [--scene NAME|FILE]``."""

from __future__ import annotations

import argparse
import json
import os
import sys
import textwrap
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from types import MappingProxyType

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from executive.ending_signals import interrupt_by_all
from executive.errors import UserError
from executive.exit_codes import ExitCode
from executive.runs.run_log import require_writable
from robots.errors import RobotsError
from robots.live.wire.faulty_connection import CONNECTION_FAULTS
from robots.models.description import load_description
from robots.outside import known_robots
from robots.scenes.light import LIGHT_KINDS
from robots.scenes.scene_description import PERCEPTION_KINDS
from robots.scenes.scene_file import load_scene
from tools.evaluate.ailing.body_fault import BODY_FAULTS
from tools.evaluate.ailing.fault_suite import run_fault_suite
from tools.evaluate.compare import COMPARE
from tools.evaluate.compare import main as compare
from tools.evaluate.digests import run_digests
from tools.evaluate.episode import run_episode
from tools.evaluate.faults import FAULTS
from tools.evaluate.front.suite import FRONT_SUITES, run_front_suite
from tools.evaluate.fusion.suite import FUSION_SUITE, run_fusion_suite
from tools.evaluate.harness.execution import Execution, run_each
from tools.evaluate.harness.journal import journal_of, set_aside
from tools.evaluate.harness.ray_cluster import LOCAL
from tools.evaluate.held_mass import HELD_MASS_SUITE, run_held_mass
from tools.evaluate.hostile import run_hostile
from tools.evaluate.live.connection import run_connection
from tools.evaluate.live.fuzz import run_fuzz
from tools.evaluate.live.kill import run_kill
from tools.evaluate.live.load import run_load
from tools.evaluate.mcp import run_mcp_suites
from tools.evaluate.opening.faults import OPENING_FAULTS
from tools.evaluate.opening.scenes import OPENED_BESIDE
from tools.evaluate.opening.suite import OPENING_SUITES, run_opening_suite
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.people_seen.suite import PEOPLE_SEEN_SUITE, run_people_seen
from tools.evaluate.perception.camera_faults import CAMERA_FAULTS
from tools.evaluate.perception.suite import PERCEPTION_SUITE, run_perception
from tools.evaluate.questions import run_question_episode
from tools.evaluate.records import EpisodeRecord, Run, Summary, dead_episode
from tools.evaluate.replays import run_replay_episode
from tools.evaluate.report import print_summary, save_scenes
from tools.evaluate.ros.suites import ROS_SUITES, run_ros_suite
from tools.evaluate.scenes import workspace_of
from tools.evaluate.shown.suite import SHOWN_SUITE, run_shown
from tools.evaluate.skills.episode import run_skill_episode, trial_of
from tools.evaluate.skills.faults import FAULTED_SUITES, SKILL_FAULTS
from tools.evaluate.skills.registry import SKILL_SUITES
from tools.evaluate.skills.summary import SkillSummary
from tools.evaluate.soak import run_soak
from tools.evaluate.stopping.courses import COURSES_BY_NAME
from tools.evaluate.stopping.stop_suite import run_stop_suite
from tools.evaluate.summed_suite import DISTURBED_SUITES, JOG_SUITES, run_summed_suite
from tools.evaluate.survival.survive import SURVIVE
from tools.evaluate.survival.survive import main as survive
from tools.evaluate.upon.grips import GRIPS_SUITE, run_grips

_CAMERA_SUITES: Mapping[str, Callable[[argparse.Namespace, Console], int]] = MappingProxyType(
    {PERCEPTION_SUITE: run_perception, PEOPLE_SEEN_SUITE: run_people_seen, SHOWN_SUITE: run_shown}
)
"""Pictures are taken and judged, and nothing moves."""

_OWN_WAYS: Mapping[str, Callable[[argparse.Namespace, Console], int]] = MappingProxyType(
    {
        **_CAMERA_SUITES,
        FUSION_SUITE: run_fusion_suite,
        GRIPS_SUITE: run_grips,
        HELD_MASS_SUITE: run_held_mass,
        "stop": run_stop_suite,
        "cancel": run_stop_suite,
        "soak": run_soak,
        "connection": run_connection,
        "load": run_load,
        **dict.fromkeys(("mcp", "mcp-fuzz"), run_mcp_suites),
        **dict.fromkeys(ROS_SUITES, run_ros_suite),
        **dict.fromkeys((*DISTURBED_SUITES, *JOG_SUITES), run_summed_suite),
        **dict.fromkeys(OPENING_SUITES, run_opening_suite),
    }
)
"""Suites that make their own sense of the options."""

_SUITES_BY_SUBJECT: Mapping[str, Sequence[str]] = MappingProxyType(
    {
        "what the camera sees": tuple(_CAMERA_SUITES),
        "the main job": ("pick", "question", "replay", HELD_MASS_SUITE),
        "stops and faults": ("stop", "cancel", "fault"),
        "senses that disagree": (FUSION_SUITE,),
        "live mode": ("kill", "connection", "load", "fuzz"),
        "doors of the robot": ("mcp", "mcp-fuzz"),
        "untrusted text": ("hostile",),
        "the ROS door": ROS_SUITES,
        "a language model in front": FRONT_SUITES,
        "changes that should change nothing": ("digests",),
        "hours on end": ("soak",),
        "doors and drawers": OPENING_SUITES,
        "skills and walks": tuple(SKILL_SUITES),
        "hands without arms": (GRIPS_SUITE,),
        "disturbed walks": tuple(DISTURBED_SUITES),
        "a person's hands": tuple(JOG_SUITES),
    }
)
SUITES = tuple(suite for suites in _SUITES_BY_SUBJECT.values() for suite in suites)

IN_A_ROW = frozenset(
    {"kill", "connection", "load", "fuzz", "mcp", "mcp-fuzz", "hostile", "digests", "soak"}
    | {*ROS_SUITES, *FRONT_SUITES}
)
"""Suites that have one robot or one recording for all episodes: no process takes one of them by itself."""

_FAULTS_BY_SUITE: Mapping[str, Sequence[str]] = MappingProxyType(
    {
        "pick": tuple(FAULTS),
        "pick, seen by the camera": tuple(CAMERA_FAULTS),
        "open, close": tuple(OPENING_FAULTS),
        ", ".join(sorted(FAULTED_SUITES)): tuple(SKILL_FAULTS),
        "fault (always one of them)": tuple(BODY_FAULTS),
        "connection": tuple(CONNECTION_FAULTS),
    }
)

_RUNS: dict[str, Run] = {"question": run_question_episode, "replay": run_replay_episode}
"""Suites whose episodes are judged like a skill's and made in a way of their own."""


_KILLING = f"what becomes of it when something is killed: {SURVIVE} WHAT"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a suite; 0 when every demand is met, 1 when not, 2 for a wrong option, 4 when a signal ended it."""
    given = sys.argv[1:] if arguments is None else arguments
    if given[:1] == [COMPARE]:
        return compare(given[1:])
    if given[:1] == [SURVIVE]:
        return survive(given[1:])
    options = _options(given)
    messages = Console(stderr=True)
    options.execution = Execution(options.suite, options.jobs, journal_of(options), options.ray)
    try:
        return _run_suite(options, messages)
    except KeyboardInterrupt as ended:
        there = options.execution.journal.exists()
        kept = f"; --resume goes on after what {options.execution.journal} keeps" if there else ""
        messages.print(f"{str(ended) or 'cancelled from the keyboard'}{kept}", markup=False, soft_wrap=True)
        return ExitCode.CANCELLED
    except UserError as wrong:
        messages.print(f"error: {wrong}", style="bold", markup=False)
        return 2


def own_scene(suite: str, robot: str) -> str | None:
    """The scene of a robot's own size where a suite has one for it and none was named."""
    own = workspace_of(robot)
    if suite in OPENING_SUITES:
        return None if own is None else OPENED_BESIDE[own]
    skill = SKILL_SUITES.get(suite)
    if skill is None:
        return own if suite in ("pick", "stop", "cancel") else None
    return own if skill.in_scene is None and skill.makes(own, robot) is not None else None


def _run_suite(options: argparse.Namespace, messages: Console) -> int:
    try:
        description = load_description(options.robot)
        if options.scene is None:
            options.scene = own_scene(options.suite, options.robot)
        else:
            load_scene(options.scene)
        if options.json is not None:
            require_writable(options.json)
        _require_folder(options.failed)
        asked = {"--resume": options.resume, "--journal": options.journal, "--ray": options.ray}
        if options.suite in IN_A_ROW and (no := [name for name, value in asked.items() if value]):
            raise UserError(f"{no[0]}: the episodes of {options.suite} are run in a row, by one process")
        if not options.resume:
            set_aside(options.execution.journal)
    except (RobotsError, UserError) as wrong:
        messages.print(f"error: {wrong}", style="bold", markup=False)
        return 2
    if options.suite == "fault":
        if options.fault not in BODY_FAULTS:
            messages.print(f"error: --fault must be one of {', '.join(BODY_FAULTS)}", style="bold")
            return 2
        return run_fault_suite(options, messages)
    if options.suite in _OWN_WAYS:
        return _OWN_WAYS[options.suite](options, messages)
    if options.suite == "fuzz":
        return run_fuzz(options.episodes, options.seed, options.robot, options.json, messages)
    if options.suite == "hostile":
        return run_hostile(options.episodes, options.seed, options.json, messages)
    if options.suite in FRONT_SUITES:
        return run_front_suite(
            options.suite,
            options.episodes,
            options.seed,
            options.every,
            options.robot,
            options.json,
            messages,
        )
    if options.suite == "digests":
        return run_digests(options.check, options.record, options.jobs, options.every, messages)
    if options.suite == "kill":
        return run_kill(options.episodes, options.seed, options.robot, options.pace, options.json, messages)
    faulted = options.suite in FAULTED_SUITES and options.fault in SKILL_FAULTS
    seen = options.suite == "pick" and options.fault in CAMERA_FAULTS
    seeing = "rgbd" if seen else options.perception
    if options.fault is not None and options.fault not in FAULTS and not faulted and not seen:
        messages.print(f"error: {options.fault} is a fault of the suite 'fault'", style="bold")
        return 2
    orders = [
        EpisodeOrder(
            options.seed + i,
            options.robot,
            options.fault,
            options.scene,
            seeing,
            options.wire,
        )
        for i in range(options.episodes)
    ]
    skill = options.suite in (*SKILL_SUITES, *_RUNS)
    suite = SKILL_SUITES.get(options.suite)
    known = suite is not None and suite.makes(options.scene, options.robot) is not None
    if suite is not None and options.scene is None and not known:
        messages.print(f"error: the suite {options.suite} needs a scene: --scene FILE", style="bold")
        return 2
    if skill and ((options.fault and not faulted) or (options.scene and not known)):
        messages.print(f"error: the suite {options.suite} takes no such fault and no scene", style="bold")
        return 2
    if suite is not None and suite.in_scene is not None:
        try:
            trial_of(options.suite, options.seed, options.scene, options.robot)
        except ValueError as nothing:
            messages.print(f"error: {nothing}", style="bold", markup=False, soft_wrap=True)
            return 2
    run: Run = partial(run_skill_episode, options.suite) if skill else run_episode
    run = _RUNS.get(options.suite, run)
    records = _run(orders, options.execution, messages, run)
    make = SkillSummary if skill else Summary
    summary = make(
        options.suite, options.seed, options.fault, description.com_margin_m, records, options.scene
    )
    if options.json is not None:
        options.json.write_text(json.dumps(summary.to_json(), indent=1) + "\n", "utf-8")
    scenes = save_scenes(summary, options.failed, options.robot)
    print_summary(summary, scenes, Console(), options.robot, seeing)
    return 0 if all(bar.met for bar in summary.bars()) else 1


def _require_folder(folder: Path) -> None:
    """Find out beforehand whether a folder can be made and written; made it is when it is needed.

    Raises:
        UserError: It cannot.
    """
    there = next(path for path in (folder.absolute(), *folder.absolute().parents) if path.exists())
    if not there.is_dir() or not os.access(there, os.W_OK):
        raise UserError(f"cannot keep scenes in {folder}: {there} is no folder that you may write")


def _run(
    orders: Sequence[EpisodeOrder], execution: Execution, messages: Console, run: Run
) -> list[EpisodeRecord]:
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    records: list[EpisodeRecord] = []
    with Progress(*columns, console=messages) as progress:
        task = progress.add_task("episodes", total=len(orders))
        for record in run_each(orders, execution, run, dead_episode):
            records.append(record)
            held = sum(item.truth for item in records)
            progress.update(task, advance=1, description=f"true in {held} of {len(records)}")
            if not messages.is_terminal:  # a bar is drawn only at its end there
                count = f"{len(records)} of {len(orders)}"
                messages.print(f"{count}: seed {record.seed} {record.outcome}, true in {held}")
    return sorted(records, key=lambda record: record.seed)


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    lists = _listed("suites", _SUITES_BY_SUBJECT), _listed("faults of each suite", _FAULTS_BY_SUITE)
    parser = argparse.ArgumentParser(
        prog="python -m tools.evaluate",
        description="Random episodes, judged by the simulator's truth.",
        epilog="\n\n".join((*lists, f"two results, pair by pair: {COMPARE} A B", _KILLING)) + "\n",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("suite", choices=SUITES, metavar="SUITE", help="one of those below")
    parser.add_argument("--episodes", type=_positive, default=200, help="how many (200)")
    parser.add_argument("--seed", type=int, default=0, help="seed of the first episode; the others follow")
    parser.add_argument("--jobs", type=_positive, default=2, help="processes")
    faults = sorted({fault for some in _FAULTS_BY_SUITE.values() for fault in some})
    parser.add_argument("--fault", choices=faults, metavar="NAME", help="what goes wrong on purpose")
    parser.add_argument("--scene", help="a scene's name or file that the random ones are made from")
    parser.add_argument(
        "--course", choices=sorted(COURSES_BY_NAME), help="of suites stop and cancel: this one alone"
    )
    parser.add_argument("--perception", choices=PERCEPTION_KINDS, help="how the robot sees")
    parser.add_argument(
        "--wire",
        action="store_true",
        help="of suite pick and those of skills: a body of Unitree behind its low-level interface, with 2 ms "
        "of delay and 1 percent of the messages lost",
    )
    parser.add_argument("--light", choices=LIGHT_KINDS, help="of suite perception: another light than drawn")
    parser.add_argument(
        "--own",
        type=float,
        metavar="MM",
        help="of suite fusion: the part of the usual declared error that each thing has for itself (2)",
    )
    parser.add_argument(
        "--cameras",
        type=int,
        choices=(1, 2),
        default=1,
        help="of suite perception: 2 compares the robot's own with both, the other somewhere in the room",
    )
    parser.add_argument(
        "--pictures", type=Path, metavar="FILE", help="of suite perception: keep the records here"
    )
    parser.add_argument("--robot", default="talos", choices=known_robots())
    parser.add_argument(
        "--pace",
        type=float,
        default=1.0,
        help="of suites kill, connection and load: simulated seconds in a second, for slow machines",
    )
    parser.add_argument("--record", type=Path, metavar="FILE", help="of suite digests: keep the runs here")
    parser.add_argument("--check", type=Path, metavar="FILE", help="of suite digests: compare with these")
    parser.add_argument(
        "--every",
        type=_positive,
        default=1,
        help="of suite digests: every so manyth run alone; of front and free-speech: simulate these alone",
    )
    parser.add_argument(
        "--resume", action="store_true", help="go on where the same suite with the same options was ended"
    )
    parser.add_argument(
        "--journal",
        type=Path,
        metavar="FILE",
        help="keep each record here as it comes (a file in the folder of --failed, named by the options)",
    )
    parser.add_argument(
        "--ray",
        nargs="?",
        const=LOCAL,
        metavar="ADDRESS",
        help="on a Ray cluster: without ADDRESS one of this machine alone",
    )
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures here")
    parser.add_argument(
        "--failed",
        type=Path,
        default=Path("runs/evaluate"),
        metavar="DIR",
        help="keep the scenes of failed episodes here",
    )
    return parser.parse_args(arguments)


def _listed(heading: str, names: Mapping[str, Sequence[str]]) -> str:
    """Names for the help, a paragraph for each subject."""
    paragraphs = (
        textwrap.fill(f"{subject}: {', '.join(some)}", 78, initial_indent="  ", subsequent_indent="    ")
        for subject, some in names.items()
    )
    return "\n".join([f"{heading}:", *paragraphs])


def _positive(text: str) -> int:
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError("must be at least 1")
    return value


if __name__ == "__main__":
    interrupt_by_all()
    sys.exit(main())
