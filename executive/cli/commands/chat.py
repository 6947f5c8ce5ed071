"""``executive chat``: a conversation with a robot in one terminal."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from executive.cli.commands.choices import (
    REAL_PACE,
    ConfidenceOption,
    ConfigOption,
    FolderOption,
    ModelOption,
    PolicyChoice,
    PolicyOption,
    SceneOption,
    ServedPaceOption,
    YesOption,
    options_of,
    robot_name,
    whole_number_from,
)
from executive.cli.own_service import serve_meanwhile
from executive.cli.standard_streams import sayable
from executive.config import runtime_directory, state_directory, use_config
from executive.exit_codes import ExitCode
from executive.runs.run_request import DEFAULT_ROBOT
from executive.trust import THRESHOLD

if TYPE_CHECKING:
    from executive.chat.robot_watch import RobotWatch
    from executive.chat.talk import Talk
    from executive.doors.served_robot import ServedRobot

_HISTORY = "chat_history"


def chat(
    robot: Annotated[
        str | None,
        typer.Option(
            help="Name of the robot, or its folder.", show_default=DEFAULT_ROBOT, callback=robot_name
        ),
    ] = None,
    scene: SceneOption = None,
    seed: Annotated[
        int | None,
        typer.Option(
            parser=whole_number_from(0), metavar="N", help="Of everything random.", show_default="0"
        ),
    ] = None,
    attach: Annotated[
        bool, typer.Option("--attach", help="Talk to the robot that is served, instead of one of its own.")
    ] = False,
    folder: FolderOption = None,
    record: Annotated[Path | None, typer.Option(metavar="DIR", help="Record the runs here.")] = None,
    pace: ServedPaceOption = REAL_PACE,
    confidence: ConfidenceOption = THRESHOLD,
    policy: PolicyOption = PolicyChoice.ASK,
    model: ModelOption = None,
    yes: YesOption = False,
    quiet: Annotated[bool, typer.Option("--quiet", help="Nothing but the conversation.")] = False,
    config: ConfigOption = None,
    plain: Annotated[
        bool, typer.Option("--plain", help="Lines instead of a screen; automatic in a pipe.")
    ] = False,
) -> None:
    """Talk to a robot: commands, questions, stops, and what became of them."""
    use_config(config)
    is_served = attach or folder is not None
    own = options_of({"robot": robot, "scene": scene, "seed": seed, "record": record, "model": model})
    own += ["--yes"] if yes else []
    own += [] if pace == REAL_PACE else [f"--pace={pace}"]
    own += [] if confidence == THRESHOLD else [f"--confidence={confidence}"]
    own += [] if policy is PolicyChoice.ASK else [f"--policy={policy.value}"]
    if is_served and own:
        raise typer.BadParameter(f"{own[0]}: the robot is served already, as it was started")

    def say(line: str) -> None:
        if not quiet:
            typer.echo(line, err=True)

    outlet: list[Callable[[str], None]] = [say]
    with ExitStack() as closing:
        if is_served:
            where = folder or runtime_directory()
        else:
            say("the robot gets ready …")
            where = serve_meanwhile(own, lambda line: outlet[0](line), closing)
        code = _talk(where, plain, outlet, closing)
    raise typer.Exit(code)


def _talk(where: Path, plain: bool, outlet: list[Callable[[str], None]], closing: ExitStack) -> ExitCode:
    """Talk on this terminal, or through this pipe; ``outlet`` is where lines about the robot go by now."""
    from executive.chat.robot_watch import RobotWatch
    from executive.doors.served_robot import ServedRobot

    robot = ServedRobot(where)
    about = robot.status()  # nobody serves there: said at once
    watch = RobotWatch(robot)
    closing.callback(watch.close)
    if plain or not all(stream.isatty() for stream in (sys.stdin, sys.stdout, sys.stderr)):
        return _talk_in_lines(robot, watch, where, outlet[0])
    return _talk_on_screen(robot, watch, where, f"{about['robot']} in {about['scene']}", outlet)


def _talk_in_lines(
    robot: ServedRobot, watch: RobotWatch, where: Path, say: Callable[[str], None]
) -> ExitCode:
    from executive.chat.plain_chat import PlainChat
    from executive.chat.talk import Talk

    is_typed = sys.stdin.isatty()
    lines = PlainChat(sys.stdin, lambda line: typer.echo(sayable(line)), is_typed)
    talk = Talk(robot, lines.show, say, lambda: watch.now, *_resetting(where, is_typed))
    if is_typed:
        say("Say what to do; 'help' tells more, Ctrl-D ends.")
    with _heeding(talk, lambda: False) as heed:
        lines.run(talk, heed)
    return talk.code


def _talk_on_screen(
    robot: ServedRobot, watch: RobotWatch, where: Path, place: str, outlet: list[Callable[[str], None]]
) -> ExitCode:
    from rich.console import Console

    from executive.chat.chat_screen import transcript
    from executive.chat.screen_chat import ScreenChat
    from executive.chat.talk import Talk
    from executive.chat.typed_before import TypedBefore
    from executive.screens.keyboard import Keyboard

    before = TypedBefore(state_directory() / _HISTORY)
    with Keyboard(sys.stdin) as keyboard:
        shown = ScreenChat(Console(stderr=True), keyboard, place, lambda: watch.now, before.lines())
        outlet[0] = shown.log
        talk = Talk(robot, shown.show, shown.log, lambda: watch.now, *_resetting(where, True))
        try:
            with _heeding(talk, shown.clear_line) as heed:
                shown.run(talk, heed)
        finally:
            before.remember(shown.line.history)
    for line in transcript(shown.said):
        typer.echo(sayable(line))
    return talk.code


def _resetting(where: Path, by_a_person: bool) -> tuple[str, Callable[[], str] | None]:
    """What a person does to leave an emergency stop, and what does it where one is at this terminal."""
    from executive.cli.commands.reset import leave_stop
    from robots.live.wire.runtime_folder import RuntimeFolder

    command = "`executive reset`" if where == runtime_directory() else f"`executive reset --folder {where}`"
    if not by_a_person:
        return f"Nothing moves until a person says {command} in a terminal.", None
    told = "Nothing moves until you type 'reset' here, once it is safe."
    return told, lambda: leave_stop(RuntimeFolder(where))


@contextmanager
def _heeding(talk: Talk, clear_line: Callable[[], bool]) -> Iterator[Callable[[], None]]:
    """Take signals to end; what is yielded heeds them: Ctrl-C is the conversation's, any other ends it."""
    from executive.ending_signals import taken_by, told

    signals: list[int] = []

    def heed() -> None:
        while signals:
            number = signals.pop(0)
            if number != signal.SIGINT:
                talk.end(told(number, "cancelled"))
            elif talk.under_way or not clear_line():
                talk.interrupt()

    with taken_by(signals.append):
        yield heed
