"""``executive send``: give a served robot a sentence, a script or a velocity, and hear what becomes of it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from executive.cli.commands.choices import FolderOption
from executive.cli.standard_streams import tell_result
from executive.config import runtime_directory
from executive.exit_codes import ExitCode

if TYPE_CHECKING:
    from executive.live.desk_messages import Say, ScriptLine
    from robots.live.wire.runtime_folder import RuntimeFolder


def send(
    text: Annotated[str, typer.Argument(metavar="SENTENCE|SCRIPT.toml", help="What to do.")] = "",
    velocity: Annotated[
        tuple[float, float] | None,
        typer.Option(metavar="LINEAR ANGULAR", help="A velocity in m/s and rad/s instead of a sentence."),
    ] = None,
    quiet: Annotated[bool, typer.Option("--quiet", help="Nothing but the result.")] = False,
    folder: FolderOption = None,
) -> None:
    """Have a served robot do something; Ctrl-C cancels it, a second one is the emergency stop."""
    from executive.live.desk_messages import Say
    from robots.live.wire.runtime_folder import RuntimeFolder

    if (velocity is None) == (not text):
        raise typer.BadParameter("either a sentence or --velocity")
    where = RuntimeFolder(folder or runtime_directory())
    if velocity is None:
        order = order_of(text, where)
    elif all(map(math.isfinite, velocity)):
        order = [Say("", 0.0, *velocity)]
    else:
        told = f"{velocity[0]:g} {velocity[1]:g}"
        raise typer.BadParameter(f"--velocity: {told} are not two finite numbers")
    line, code = give_order(where, order, quiet)
    tell_result(line)
    raise typer.Exit(code)


def order_of(text: str, where: RuntimeFolder) -> Sequence[Say | ScriptLine]:
    """A sentence, or a script, as it is sent to the robot that is served in a folder."""
    from executive.live.caller.sendable import sendable
    from executive.live.desk_messages import Say
    from executive.scripts.task_script import is_script

    return _script(Path(text), where) if is_script(text) else [Say(sendable(text))]


def _script(path: Path, where: RuntimeFolder) -> list[ScriptLine]:
    """A script's statements as they are sent; what is wrong with the file is found before."""
    from executive.live.caller.caller import ask_at
    from executive.live.caller.sendable import require_served_as, script_lines
    from executive.scripts.task_script import load_script
    from robots.live.wire.messages import GetStatus, write_control_message

    script = load_script(path)
    lines = script_lines(path, script)
    require_served_as(path, script, ask_at(where.control_socket, write_control_message(GetStatus())))
    return lines


def give_order(where: RuntimeFolder, order: Sequence[Say | ScriptLine], quiet: bool) -> tuple[str, ExitCode]:
    """Give an order, and hear how it ended: the line for people, and the exit code."""
    from executive.live.caller.caller import Caller, NoAnswerError, ask_at
    from executive.live.caller.hang_watch import HungError, commander_of, hear_out
    from executive.live.desk_messages import Cancel, write_desk_message
    from robots.live.wire.messages import Stop, write_control_message

    result: dict[str, Any] = {}

    def take(answer: dict[str, Any]) -> bool:
        if answer["type"] == "line" and not quiet:
            typer.echo(answer["text"], err=True)
        if answer["type"] in ("result", "error"):
            result.update(answer)
        return bool(result)

    interrupts = 0
    with closing(Caller(where.executive_socket)) as caller:
        for said in order:
            caller.send(write_desk_message(said))
        while not result:
            try:
                hear_out(caller, take, lambda: commander_of(where))
            except HungError as hung:
                return f"failed: {hung}", ExitCode.FAILED
            except NoAnswerError:
                gone = "the executive ended before it told the result; what moved is braked, and holds"
                return f"failed: {gone}", ExitCode.FAILED
            except KeyboardInterrupt as ended:
                interrupts += 1
                if interrupts == 1:
                    typer.echo("cancelling; Ctrl-C again is the emergency stop", err=True)
                    cancel = Cancel(str(ended) or "cancelled from the keyboard")
                    ask_at(where.executive_socket, write_desk_message(cancel))
                else:
                    ask_at(where.control_socket, write_control_message(Stop(1, "Ctrl-C, twice")))
    if result["type"] == "error":
        return f"refused: {result['reason']}", ExitCode.INVALID
    return str(result["text"]), ExitCode(int(result["exit_code"]))
