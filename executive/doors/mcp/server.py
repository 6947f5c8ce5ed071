"""The MCP server: tools that look, check, begin, watch, answer, cancel and stop, over stdio or HTTP.

What a client said about a tool being harmless is a hint to people; the robot's own gate and checker judge
every motion.
"""

from __future__ import annotations

import importlib.metadata

from mcp.server import MCPServer

from executive.doors.mcp.commanding import add_commanding_tools
from executive.doors.mcp.lease import Lease
from executive.doors.mcp.reading import add_reading_tools, add_resources
from executive.doors.served_robot import RESET_IS_A_PERSONS, ServedRobot

_PRODUCT = "humanoid-executive"
_INSTRUCTIONS = (
    "A humanoid robot. It takes sentences of a plain command language ('pick up the red cup on the table', "
    "'walk to the kitchen and open the fridge'). check_command tells what a sentence is understood as; "
    "start_task begins it and answers at once with the id of the run; task_status tells how it stands, and "
    "its outcome says truthfully what happened. A question must be answered by the person: use answer. "
    f"stop is the emergency stop; {RESET_IS_A_PERSONS}."
)


def mcp_server(robot: ServedRobot, lease: Lease) -> MCPServer[None]:
    """The server with its tools and resources.

    Args:
        robot: The served robot behind it.
        lease: Ends tasks that no client asks about any more.
    """
    server: MCPServer[None] = MCPServer(
        _PRODUCT, version=_version(), instructions=_INSTRUCTIONS, log_level="ERROR"
    )
    add_reading_tools(server, robot)
    add_commanding_tools(server, robot, lease)
    add_resources(server, robot)
    return server


def _version() -> str:
    """The product's; none where it is run from its source and not installed."""
    try:
        return importlib.metadata.version(_PRODUCT)
    except importlib.metadata.PackageNotFoundError:
        return ""
