"""The command line. Heavy libraries are imported by the commands that need them, not here."""

from __future__ import annotations

import sys
from typing import Any

import typer
from typer.core import TyperGroup

from executive.cli.commands import (
    answer,
    cancel,
    chat,
    check,
    doctor,
    jog,
    learn,
    list_,
    mcp,
    parse,
    pause,
    replay,
    reset,
    resume,
    run,
    runs,
    send,
    serve,
    shutdown,
    status,
    stop,
    tree,
    why,
)
from executive.cli.import_ import import_
from executive.cli.standard_streams import secure_standard_streams
from executive.errors import OutputLostError, UserError
from executive.exit_codes import ExitCode
from robots.errors import (
    CannotImportError,
    DescriptionError,
    RenderingUnavailableError,
    SceneError,
    UnknownRobotError,
    UnknownRobotFolderError,
)
from robots.live.wire.errors import LiveError

_ENVIRONMENT = (
    UserError,
    CannotImportError,
    DescriptionError,
    LiveError,
    RenderingUnavailableError,
    SceneError,
    UnknownRobotError,
    UnknownRobotFolderError,
)
"""Faults of what was asked or of the machine: one line and exit code 2."""


_OWN_PACKAGES = ("executive", "trees", "robots", "kinematics")


class ExecutiveGroup(TyperGroup):
    """Turns whatever a command raises into a line and an exit code: no traceback reaches a user."""

    def invoke(self, ctx: Any) -> Any:
        """Run the chosen command."""
        try:
            return super().invoke(ctx)
        except OutputLostError:
            raise
        except _ENVIRONMENT as fault:
            _complain(" ".join(str(fault).split()))
            raise typer.Exit(ExitCode.INVALID) from None
        except KeyboardInterrupt as ended:
            _complain(str(ended) or "cancelled from the keyboard")
            raise typer.Exit(ExitCode.CANCELLED) from None
        except ModuleNotFoundError as missing:
            if (missing.name or "").partition(".")[0] in _OWN_PACKAGES:
                raise typer.Exit(_defect(missing)) from None
            _complain(f"the package {missing.name!r} is not installed; `executive doctor` tells the fix")
            raise typer.Exit(ExitCode.INVALID) from None
        except Exception as defect:
            if _is_for_typer(defect):
                raise
            raise typer.Exit(_defect(defect)) from None


app = typer.Typer(
    name="executive",
    cls=ExecutiveGroup,
    help="One sentence in, a verified physical result out, or a clear reason why not.",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)
app.command("run")(run.run)
app.command("parse")(parse.parse)
app.command("tree")(tree.tree)
app.command("check")(check.check)
app.command("replay")(replay.replay)
app.command("export")(runs.export)
app.command("why")(why.why)
app.command("runs")(runs.runs)
app.command("learn")(learn.learn)
app.command("list")(list_.list_)
app.command("import")(import_)
app.command("doctor")(doctor.doctor)
app.command("serve")(serve.serve)
app.command("send")(send.send)
app.command("answer")(answer.answer)
app.command("status")(status.status)
app.command("cancel")(cancel.cancel)
app.command("pause")(pause.pause)
app.command("resume")(resume.resume)
app.command("stop")(stop.stop)
app.command("reset")(reset.reset)
app.command("shutdown")(shutdown.shutdown)
app.command("chat")(chat.chat)
app.command("jog")(jog.jog)
app.command("mcp")(mcp.mcp)


def main() -> None:
    """Run the command line with this process's arguments and streams."""
    secure_standard_streams()
    try:
        app()
    except OutputLostError as lost:
        if not lost.unread:
            _complain(str(lost))
        sys.exit(ExitCode.UNREAD if lost.unread else ExitCode.INVALID)


def _is_for_typer(raised: Exception) -> bool:
    """Whether typer itself knows what to do: its own exits and usage errors."""
    return isinstance(raised, (typer.Exit, typer.Abort)) or hasattr(raised, "exit_code")


def _defect(defect: Exception) -> ExitCode:
    from executive.cli.crash_report import write_crash_report

    path = write_crash_report(defect)
    where = f"a crash report is in {path}" if path else "no folder was writable for a crash report"
    _complain(f"a defect of this program ({type(defect).__name__}); {where}")
    return ExitCode.DEFECT


def _complain(line: str) -> None:
    encoding = sys.stderr.encoding or "utf-8"
    shown = f"executive: {line}".encode(encoding, "backslashreplace").decode(encoding)
    typer.echo(shown, err=True)
