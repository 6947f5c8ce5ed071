"""``executive mcp``: a served robot as a server of the Model Context Protocol."""

from __future__ import annotations

from typing import Annotated

import typer

from executive.cli.commands.choices import FolderOption, whole_number_from
from executive.config import environment_value, runtime_directory

_USUAL_PORT = 8642
TOKEN = "HUMANOID_EXECUTIVE_MCP_TOKEN"  # the name of a variable of the environment


def mcp(
    http: Annotated[bool, typer.Option("--http", help="HTTP on loopback instead of stdio.")] = False,
    port: Annotated[
        int, typer.Option(parser=whole_number_from(1, 65535), metavar="N", help="Of 127.0.0.1.")
    ] = _USUAL_PORT,
    lease: Annotated[
        float, typer.Option(metavar="SECONDS", help="A task that no client asks about for so long ends.")
    ] = 60.0,
    folder: FolderOption = None,
) -> None:
    """Serve a served robot's tools to a language model's client; no tool resets it."""
    from executive.doors.companion import require_extra
    from executive.doors.served_robot import ServedRobot

    require_extra("mcp", "mcp")
    from executive.doors.mcp.lease import Lease
    from executive.doors.mcp.server import mcp_server
    from executive.doors.mcp.serving import LOOPBACK, new_token, serve_http, serve_stdio

    if not lease > 0.0:
        raise typer.BadParameter(f"--lease: {lease:g} is not above 0")
    robot = ServedRobot(folder or runtime_directory())
    robot.status()  # nobody serves there: said at once
    server = mcp_server(robot, Lease(robot, lease))
    if not http:
        serve_stdio(server)
        return
    token = environment_value(TOKEN) or new_token()
    typer.echo(f"http://{LOOPBACK}:{port}/mcp, token {token}", err=True)
    serve_http(server, port, token)
