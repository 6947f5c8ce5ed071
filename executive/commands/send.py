"""``executive send``: give a served robot a sentence, a script or a velocity, and hear what becomes of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from executive.commands.serve import FolderOption
from executive.config import runtime_directory
from executive.exit_codes import ExitCode

if TYPE_CHECKING:
    from executive.live.desk import Say
    from executive.statement import Statement
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
        heard = _say(where, Say("", 0.0, *velocity), quiet)
        line, code = heard.line, heard.exit_code
    elif not is_script(text):
        heard = _say(where, Say(text), quiet)
        line, code = heard.line, heard.exit_code
    else:
        line, code = _say_all(where, load_script(Path(text)).statements, quiet)
    typer.echo(line)
    raise typer.Exit(code)


@dataclass(frozen=True, slots=True)
class _Heard:
    """How it ended, as the served executive said: the line for people, the outcome, and the exit code."""

    line: str
    outcome: str
    exit_code: ExitCode


def _say_all(where: RuntimeFolder, statements: Sequence[Statement], quiet: bool) -> tuple[str, ExitCode]:
    """Say a script's statements; the line and the exit code of the first that did not end as expected."""
    from executive.live.desk import Say
    from executive.script_order import first_unexpected, in_order, unexpected_code

    def carry_out(statement: Statement) -> list[_Heard]:
        return [_say(where, Say(statement.parsed.text, statement.timeout_s or 0.0), quiet)]

    results = in_order(statements, carry_out)
    unexpected = first_unexpected(results)
    if unexpected is not None:
        _, heard = unexpected
        return heard.line, unexpected_code(heard)
    _, said = results[-1]
    return said[-1].line, ExitCode.DONE


def _say(where: RuntimeFolder, said: Say, quiet: bool) -> _Heard:
    """Say one thing, and hear how it ended."""
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
            return _Heard(f"failed: {hung}", "failed", ExitCode.FAILED)
        except KeyboardInterrupt:
            interrupts += 1
            if interrupts == 1:
                typer.echo("cancelling; Ctrl-C again is the emergency stop", err=True)
                Caller(where.executive_socket).ask(write_desk_message(Cancel("cancelled from the keyboard")))
            else:
                Caller(where.control_socket).ask(write_control_message(Stop(1, "Ctrl-C, twice")))
    if result["type"] == "error":
        return _Heard(f"refused: {result['reason']}", "refused", ExitCode.INVALID)
    return _Heard(str(result["text"]), str(result["outcome"]), ExitCode(int(result["exit_code"])))
