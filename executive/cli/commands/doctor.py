"""``executive doctor``: what works on this machine, what is missing, and the fix."""

from __future__ import annotations

from typing import Annotated

import typer

from executive.exit_codes import ExitCode


def doctor(
    warm: Annotated[bool, typer.Option("--warm", help="Load and cache everything once.")] = False,
) -> None:
    """Check this machine."""
    from executive.checks.machine import diagnose, warm_up

    findings = diagnose()
    for finding in findings:
        mark = "ok     " if finding.ok else ("MISSING" if finding.needed else "absent ")
        typer.echo(f"{mark} {finding.name}: {finding.detail}")
        if not finding.ok:
            typer.echo(f"        fix: {finding.fix}")
    if any(finding.needed and not finding.ok for finding in findings):
        raise typer.Exit(ExitCode.INVALID)
    if warm:
        typer.echo(warm_up(typer.echo))
