"""``executive send``: give a served robot a sentence, a script or a velocity, and hear what becomes of it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from executive.commands.serve import FolderOption
from executive.config import runtime_directory
from executive.exit_codes import ExitCode

if TYPE_CHECKING:
    from executive.live.desk import Say
    from robots.live.runtime_folder import RuntimeFolder


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
    from executive.live.desk import Say
    from executive.task_script import is_script, load_script
    from robots.live.runtime_folder import RuntimeFolder

    if (velocity is None) == (not text):
        raise typer.BadParameter("either a sentence or --velocity")
    where = RuntimeFolder(folder or runtime_directory())
    if velocity is not None:
        line, _, code = _say(where, Say("", 0.0, *velocity), quiet)
    elif not is_script(text):
        line, _, code = _say(where, Say(text), quiet)
    else:
        line, code = "the script has no statement", int(ExitCode.INVALID)
        for statement in load_script(Path(text)).statements:
            said = Say(statement.parsed.text, statement.timeout_s or 0.0)
            for _ in range(2 if statement.on_failure == "retry" else 1):
                line, outcome, code = _say(where, said, quiet)
                if outcome == statement.expect or code == ExitCode.CANCELLED:
                    break
            if outcome == statement.expect:
                code = int(ExitCode.DONE)
            elif statement.on_failure != "continue" or code == ExitCode.CANCELLED:
                code = code or int(ExitCode.FAILED)
                break
    typer.echo(line)
    raise typer.Exit(code)


def _say(where: RuntimeFolder, said: Say, quiet: bool) -> tuple[str, str, int]:
    """Say one thing; returns the line, the outcome and the exit code."""
    from executive.live.caller import Caller
    from executive.live.desk import Cancel, write_desk_message
    from executive.live.hearing import HungError, commander_of, hear_out
    from robots.live.messages import Stop, write_control_message

    result: dict[str, Any] = {}

    def take(answer: dict[str, Any]) -> bool:
        if answer["type"] == "line" and not quiet:
            typer.echo(answer["text"], err=True)
        if answer["type"] in ("result", "error"):
            result.update(answer)
        return bool(result)

    caller = Caller(where.executive_socket)
    caller.send(write_desk_message(said))
    interrupts = 0
    while not result:
        try:
            hear_out(caller, take, lambda: commander_of(where))
        except HungError as hung:
            return f"failed: {hung}", "failed", int(ExitCode.FAILED)
        except KeyboardInterrupt:
            interrupts += 1
            if interrupts == 1:
                typer.echo("cancelling; Ctrl-C again is the emergency stop", err=True)
                Caller(where.executive_socket).ask(write_desk_message(Cancel("cancelled from the keyboard")))
            else:
                Caller(where.control_socket).ask(write_control_message(Stop(1, "Ctrl-C, twice")))
    if result["type"] == "error":
        return f"refused: {result['reason']}", "refused", int(ExitCode.INVALID)
    return str(result["text"]), str(result["outcome"]), int(result["exit_code"])
