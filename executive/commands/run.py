"""``executive run``: carry out a sentence or a task script."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from executive.config import runs_directory
from executive.run_request import DEFAULT_ROBOT, DEFAULT_SCENE, RunRequest

if TYPE_CHECKING:
    from executive.outputs.display import Display


def run(
    text: Annotated[str, typer.Argument(metavar="SENTENCE|SCRIPT.toml", help="What to do.")],
    robot: Annotated[str | None, typer.Option(help="Name of the robot.", show_default=DEFAULT_ROBOT)] = None,
    scene: Annotated[
        str | None, typer.Option(metavar="NAME|FILE.toml", help="Where.", show_default=DEFAULT_SCENE)
    ] = None,
    seed: Annotated[int | None, typer.Option(min=0, help="Of everything random.", show_default="0")] = None,
    report: Annotated[Path | None, typer.Option(metavar="FILE.json", help="Write the report here.")] = None,
    snapshot: Annotated[Path | None, typer.Option(metavar="FILE.png", help="A picture of the end.")] = None,
    video: Annotated[Path | None, typer.Option(metavar="FILE.mp4", help="A film of the run.")] = None,
    record: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Record the run here, its trajectories too.")
    ] = None,
    quiet: Annotated[bool, typer.Option("--quiet", help="Nothing but the result.")] = False,
    plain: Annotated[
        bool, typer.Option("--plain", help="Lines instead of a drawing; automatic in a pipe.")
    ] = False,
) -> None:
    """Carry out one sentence, or a task script."""
    from executive.diagnosis import compile_kernel
    from executive.performance import perform
    from executive.statement import Statement
    from executive.task_script import TaskScript, is_script, load_script

    if is_script(text):
        script = load_script(Path(text))
    else:
        from executive.command_parser import parse

        script = TaskScript((Statement(parse(text)),))
    request = RunRequest(
        input=text,
        statements=script.statements,
        robot=robot or script.robot or DEFAULT_ROBOT,
        scene=scene or script.scene or DEFAULT_SCENE,
        seed=next(value for value in (seed, script.seed, 0) if value is not None),
        record=record or runs_directory(),
        keep_trajectories=record is not None,
        report=report,
        snapshot=snapshot,
        video=video,
    )
    compile_kernel(lambda line: None if quiet else typer.echo(line, err=True))
    display = _display(quiet, plain)
    try:
        performance = perform(request, display)
    finally:
        display.close()
    typer.echo(_sayable(performance.line))
    raise typer.Exit(performance.exit_code)


def _display(quiet: bool, plain: bool) -> Display:
    from executive.outputs.display import LiveDisplay, NoDisplay, PlainDisplay

    if quiet:
        return NoDisplay()
    if plain or not sys.stdout.isatty() or not sys.stderr.isatty():
        return PlainDisplay(sys.stderr)
    from rich.console import Console

    return LiveDisplay(Console(stderr=True))


def _sayable(line: str) -> str:
    encoding = sys.stdout.encoding or "utf-8"
    return line.encode(encoding, "backslashreplace").decode(encoding)
