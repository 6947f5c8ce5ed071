"""``executive run``: carry out a sentence or a task script."""

from __future__ import annotations

import sys
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from executive.cli.commands.choices import (
    GROOT_PORT,
    LOOPBACK,
    VIEW_PORT,
    ConfidenceOption,
    ConfigOption,
    GrootOption,
    GrootPortOption,
    ModelOption,
    OnQuestionChoice,
    OnQuestionOption,
    PaceChoice,
    PerceptionOption,
    PolicyChoice,
    PolicyOption,
    RosDomainOption,
    RosInterfaceOption,
    RosNamespaceOption,
    RosOption,
    SceneOption,
    ViewOption,
    ViewPortOption,
    YesOption,
    options_of,
    robot_name,
    whole_number_from,
)
from executive.cli.own_service import serve_meanwhile
from executive.cli.standard_streams import tell_result
from executive.config import runs_directory, use_config
from executive.runs.run_request import DEFAULT_ROBOT, RunRequest
from executive.trust import THRESHOLD, Trust

if TYPE_CHECKING:
    from executive.dialogue.attendant import Attendant
    from executive.doors.recorder.feed import RunFeed
    from executive.screens.display import Display
    from robots.perception.labels.asking import AskAboutPictures


def run(
    text: Annotated[str, typer.Argument(metavar="SENTENCE|JSON|SCRIPT.toml", help="What to do.")],
    robot: Annotated[
        str | None,
        typer.Option(
            help="Name of the robot, or its folder.", show_default=DEFAULT_ROBOT, callback=robot_name
        ),
    ] = None,
    scene: SceneOption = None,
    perception: PerceptionOption = None,
    seed: Annotated[
        int | None,
        typer.Option(
            parser=whole_number_from(0), metavar="N", help="Of everything random.", show_default="0"
        ),
    ] = None,
    report: Annotated[Path | None, typer.Option(metavar="FILE.json", help="Write the report here.")] = None,
    snapshot: Annotated[Path | None, typer.Option(metavar="FILE.png", help="A picture of the end.")] = None,
    video: Annotated[Path | None, typer.Option(metavar="FILE.mp4", help="A film of the run.")] = None,
    panel: Annotated[
        bool, typer.Option("--panel", help="In the film, tree and log beside the picture.")
    ] = False,
    record: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Record the run here, its trajectories and motion too.")
    ] = None,
    junit: Annotated[Path | None, typer.Option(metavar="FILE.xml", help="Write a JUnit report here.")] = None,
    on_question: OnQuestionOption = OnQuestionChoice.ASK,
    confidence: ConfidenceOption = THRESHOLD,
    policy: PolicyOption = PolicyChoice.ASK,
    pace: Annotated[
        PaceChoice | None,
        typer.Option(
            help="As fast as the machine computes, or as time passes.",
            show_default="fast; with --ros, --view or --groot as time passes",
        ),
    ] = None,
    quiet: Annotated[bool, typer.Option("--quiet", help="Nothing but the result.")] = False,
    config: ConfigOption = None,
    plain: Annotated[
        bool, typer.Option("--plain", help="Lines instead of a drawing; automatic in a pipe.")
    ] = False,
    model: ModelOption = None,
    yes: YesOption = False,
    ros: RosOption = False,
    ros_domain: RosDomainOption = 0,
    ros_namespace: RosNamespaceOption = "",
    ros_interface: RosInterfaceOption = LOOPBACK,
    view: ViewOption = False,
    view_port: ViewPortOption = VIEW_PORT,
    groot: GrootOption = False,
    groot_port: GrootPortOption = GROOT_PORT,
) -> None:
    """Carry out one sentence, or a task script."""
    from executive.checks.machine import compile_kernel
    from executive.runs.run import perform
    from executive.runs.run_search import note_folder
    from executive.scripts.task_script import is_script, script_for
    from executive.session.cancellation import Cancellation
    from robots.models.usual_scene import usual_scene

    use_config(config)
    trust = Trust(confidence, policy.value)
    script = script_for(text, trust, scene, robot)
    if panel and video is None:
        raise typer.BadParameter("--panel stands beside the picture of --video FILE.mp4")
    doors = ["--ros"] * ros + ["--view"] * view + ["--groot"] * groot
    if doors:
        asked = None if on_question is OnQuestionChoice.ASK else on_question
        _refuse_with(
            doors[0],
            report=report,
            snapshot=snapshot,
            video=video,
            junit=junit,
            on_question=asked,
        )
        served = {
            "robot": robot or script.robot,
            "scene": scene or script.scene,
            "seed": script.seed if seed is None else seed,
            "record": record,
            "perception": None if perception is None else perception.value,
            "pace": (pace or PaceChoice.REAL).value,
            "confidence": confidence,
            "policy": policy.value,
            "model": model,
            "config": config,
            "ros-domain": ros_domain,
            "ros-namespace": ros_namespace,
            "ros-interface": ros_interface,
            "view-port": view_port,
            "groot-port": groot_port,
        }
        listeners = ros + view
        _run_served(text, [*options_of(served), *doors, *(["--yes"] if yes else [])], listeners, quiet)
    asker, front = None, None
    if model is not None:
        from executive.doors.model.front_model import front_model

        front, asker = front_model(model, trust, reads_back=not yes)
    machine = robot or script.robot or DEFAULT_ROBOT
    request = RunRequest(
        input=text,
        statements=script.statements,
        robot=machine,
        scene=scene or script.scene or usual_scene(machine),
        seed=next(value for value in (seed, script.seed, 0) if value is not None),
        record=record or runs_directory(),
        keep_trajectories=record is not None,
        report=report,
        snapshot=snapshot,
        video=video,
        panel=panel,
        on_question=on_question.value,
        trust=trust,
        in_real_time=pace is PaceChoice.REAL,
        script=Path(text) if is_script(text) else None,
        junit=junit,
        front=front,
        perception=None if perception is None else perception.value,
        seeing=_seeing_model,
    )
    cancellation = Cancellation()
    compile_kernel(lambda line: None if quiet else typer.echo(line, err=True))
    with ExitStack() as terminal:
        if asker is not None:
            terminal.enter_context(asker)
        display, attendant = _terminal(request, quiet, plain, terminal, lambda: cancellation.asked)
        note_folder(request.record)
        recorded = _recorded(display) if record is not None else None
        display = recorded or display
        try:
            performance = perform(
                request,
                display,
                attendant,
                cancellation=cancellation,
                on_assembly=lambda assembly: recorded.begin(assembly) if recorded else None,
                on_record=lambda folder, header: recorded.record(folder, header) if recorded else None,
            )
        finally:
            display.close()
    for complaint in performance.complaints:
        typer.echo(f"executive: {complaint}", err=True)
    tell_result(performance.line)
    raise typer.Exit(performance.exit_code)


def _recorded(display: Display) -> RunFeed | None:
    """A display that records the motion besides; None where what that needs is missing, and that is said."""
    from executive.doors.recorder.feed import RunFeed, complaint_without_extra

    def complain(line: str) -> None:
        typer.echo(f"executive: {line}", err=True)

    if (missing := complaint_without_extra()) is not None:
        complain(missing)
        return None
    return RunFeed(display, complain)


def _seeing_model() -> AskAboutPictures | None:
    """The model that is asked what pictures show, where a user has set one up."""
    from executive.doors.model.seeing_model import seeing_model

    return seeing_model()


def _refuse_with(door: str, **given: object) -> None:
    """Refuse the first option that is given and that only a run in this process knows."""
    for name, value in given.items():
        if value is not None:
            told = name.replace("_", "-")
            raise typer.BadParameter(
                f"--{told}: not with {door}; the robot is served, and --record keeps its run"
            )


def _run_served(text: str, options: list[str], listeners: int, quiet: bool) -> NoReturn:
    """Have a robot served with its doors open for as long as one order takes; it begins when they listen."""
    from executive.cli.commands.send import give_order, order_of
    from robots.live.wire.runtime_folder import RuntimeFolder

    def say(line: str) -> None:
        if not quiet:
            typer.echo(line, err=True)

    with ExitStack() as closing:
        where = RuntimeFolder(serve_meanwhile(options, say, closing, listeners))
        line, code = give_order(where, order_of(text, where), quiet)
    tell_result(line)
    raise typer.Exit(code)


def _terminal(
    request: RunRequest, quiet: bool, plain: bool, closing: ExitStack, interrupted: Callable[[], bool]
) -> tuple[Display, Attendant]:
    """Who shows the run and who attends to it: a drawing with keys, lines, or nothing but questions."""
    from executive.screens.display import LiveDisplay, NoDisplay, PlainDisplay
    from executive.screens.terminal_attendant import ANSWER_TIMEOUT_S, TerminalAttendant

    def lines(show: Callable[[str], None]) -> Attendant:
        return TerminalAttendant(sys.stdin, show, ANSWER_TIMEOUT_S, interrupted)

    if quiet or plain or not sys.stdout.isatty() or not sys.stderr.isatty():
        display = NoDisplay() if quiet else PlainDisplay(sys.stderr)
        return display, lines(lambda line: typer.echo(line, err=True))
    from rich.console import Console

    place = f"{request.robot} in {request.scene}, seed {request.seed}"
    keys = sys.stdin.isatty()
    live = LiveDisplay(Console(stderr=True), place, keys)
    if not keys:
        return live, lines(live.note)
    from executive.manual.keys import keys_for
    from executive.screens.keyboard import Keyboard
    from executive.screens.keyboard_attendant import KeyboardAttendant
    from robots.models.description import load_description

    keyboard = closing.enter_context(Keyboard(sys.stdin))
    jog_keys = keys_for(load_description(request.robot))
    return live, KeyboardAttendant(keyboard, live, ANSWER_TIMEOUT_S, interrupted, jog_keys)
