"""``executive status``: how a served robot stands."""

from __future__ import annotations

import json
from typing import Annotated, Any

import typer

from executive.cli.commands.choices import FolderOption
from executive.config import runtime_directory

_UNSUPERVISED = (
    "nobody: `executive serve` has gone, and an executive that ends or hangs is not replaced; "
    "`executive shutdown` ends the robot's control"
)


def status(
    as_json: Annotated[bool, typer.Option("--json", help="As one JSON document.")] = False,
    folder: FolderOption = None,
) -> None:
    """Tell how a served robot stands; asks the control process, and the executive if it answers."""
    from executive.live.caller.caller import ask_at
    from robots.live.wire.errors import LiveError, NotServedError
    from robots.live.wire.messages import GetStatus, write_control_message
    from robots.live.wire.runtime_folder import RuntimeFolder

    where = RuntimeFolder(folder or runtime_directory())
    control = ask_at(where.control_socket, write_control_message(GetStatus()))
    try:
        executive = ask_at(where.executive_socket, write_control_message(GetStatus()), within_s=2.0)
    except NotServedError:
        executive = {"silent": "there is none"}
    except LiveError as silent:
        executive = {"silent": str(silent)}
    for answer in (control, executive):
        answer.pop("type", None)
    if as_json:
        typer.echo(json.dumps({"schema": 1, "control": control, "executive": executive}))
        return
    for line in _lines(control, executive):
        typer.echo(line)


def _lines(control: dict[str, Any], executive: dict[str, Any]) -> list[str]:
    lateness = control["lateness"]
    moving = ", ".join(control["motions"]) or ("stands" if control["resting"] else "comes to rest")
    lines = [
        f"robot      {control['robot']} in {control['scene']}, {control['t_s']:.1f} s, {moving}",
        f"emergency  {(control['emergency'] or {}).get('engaged') or 'not engaged'}",
        f"executive  {executive.get('silent') or executive.get('task') or 'waits for a task'}"
        f"{', paused' if executive.get('paused') else ''}"
        f"{', ' + executive['state'] if 'state' in executive else ''}",
        f"commander  {control['commander'] or 'nobody'}",
        f"supervisor {control.get('supervisor') or _UNSUPERVISED}",
        f"control    {control['scheduling']}; late p50 {lateness['p50_ms']:.2f} ms, "
        f"p99 {lateness['p99_ms']:.2f} ms, worst {lateness['worst_ms']:.0f} ms",
    ]
    return lines + [f"stop       {stop}" for stop in control["stops"]]
