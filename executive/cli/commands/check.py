"""``executive check``: judge without moving."""

from __future__ import annotations

import sys
from contextlib import ExitStack
from pathlib import Path
from typing import Annotated

import typer

from executive.cli.commands.choices import (
    SCENE_OF_THE_ROBOT,
    ConfidenceOption,
    ConfigOption,
    ModelOption,
    OnQuestionChoice,
    OnQuestionOption,
    PolicyChoice,
    PolicyOption,
    YesOption,
    number_from,
    robot_name,
    scene_given,
    whole_number_from,
)
from executive.config import use_config
from executive.errors import NotWritableError
from executive.runs.run_request import DEFAULT_ROBOT
from executive.trust import THRESHOLD, Trust


def check(
    text: Annotated[
        str, typer.Argument(metavar="SENTENCE|SCRIPT.toml|TRAJECTORY.json", help="What to judge.")
    ],
    robot: Annotated[
        str | None,
        typer.Option(
            help="Name of the robot, or its folder.",
            show_default=f"{DEFAULT_ROBOT}, or the file's",
            callback=robot_name,
        ),
    ] = None,
    scene: Annotated[
        str | None,
        typer.Option(
            metavar="NAME|FILE.toml|FILE.xml",
            help="Where.",
            show_default=f"{SCENE_OF_THE_ROBOT}; for a trajectory the TOML file beside it",
            callback=scene_given,
        ),
    ] = None,
    seed: Annotated[
        int | None,
        typer.Option(
            parser=whole_number_from(0), metavar="N", help="Of everything random.", show_default="0"
        ),
    ] = None,
    margin_m: Annotated[
        float,
        typer.Option(
            "--margin",
            parser=number_from(0.0, 1.0),
            metavar="METRES",
            help="Kept from a stored trajectory's scene.",
        ),
    ] = 0.0,
    report: Annotated[Path | None, typer.Option(metavar="FILE.json", help="Write the report here.")] = None,
    junit: Annotated[Path | None, typer.Option(metavar="FILE.xml", help="Write a JUnit report here.")] = None,
    on_question: OnQuestionOption = OnQuestionChoice.ASK,
    confidence: ConfidenceOption = THRESHOLD,
    policy: PolicyOption = PolicyChoice.ASK,
    config: ConfigOption = None,
    model: ModelOption = None,
    yes: YesOption = False,
    plain: Annotated[bool, typer.Option("--plain", help="Lines, as always here.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", help="Nothing but the result.")] = False,
) -> None:
    """Say whether a stored trajectory is safe, or what a sentence would do; moves nothing."""
    from executive.runs.run_log import require_writable, write_report

    use_config(config)
    del plain  # a check draws nothing
    for path in (report, junit):
        if path is not None:
            require_writable(path)
    if text.endswith(".json"):
        from executive.checks.check_trajectory_file import check_stored

        answer = check_stored(Path(text), robot, scene, margin_m)
    else:
        from executive.checks.check_sentence import rehearse

        trust = Trust(confidence, policy.value)
        with ExitStack() as closing:
            front = None
            if model is not None:
                from executive.doors.model.front_model import front_model

                front, asker = front_model(model, trust, reads_back=not yes)
                closing.enter_context(asker)
            answer = rehearse(text, robot, scene, seed, trust, on_question.value, front)
    lost: list[NotWritableError] = []
    try:
        if report is not None:
            write_report(report, answer.to_json())
        if junit is not None:
            from executive.runs.junit import write_check_junit

            write_check_junit(junit, text, answer)
    except NotWritableError as wrong:  # what was found out is told first
        lost.append(wrong)
    for line in [answer.message] if quiet else answer.lines():
        typer.echo(_sayable(line))
    if lost:
        raise lost[0]
    raise typer.Exit(answer.exit_code)


def _sayable(line: str) -> str:
    """What the terminal can show; names come from files, and must not steer it."""
    shown = "".join(char if char.isprintable() else f"\\x{ord(char):02x}" for char in line)
    encoding = sys.stdout.encoding or "utf-8"
    return shown.encode(encoding, "backslashreplace").decode(encoding)
