"""Tools and resources that move nothing: what is seen, what a sentence means, what the robot can do.

The annotations here are read by the SDK when the tools are made, so that they are no strings.
"""

from functools import partial
from typing import Any

from mcp.server import MCPServer
from mcp.server.mcpserver import Image
from mcp_types import ToolAnnotations

from executive.doors.mcp.calls import call
from executive.doors.plan_picture import plan_picture
from executive.doors.served_robot import ServedRobot
from executive.meaning import command_json
from executive.reports.meaning_words import meaning_words
from executive.understanding.understanding import understand


def add_reading_tools(server: MCPServer[None], robot: ServedRobot) -> None:
    """``look`` and ``check_command``."""
    reads = ToolAnnotations(read_only_hint=True, open_world_hint=False)

    @server.tool(annotations=reads, structured_output=False)
    async def look() -> list[Any]:
        """What the robot believes to be around it: a picture from above, and a list of things."""
        things = await call(robot.scene)
        return [Image(data=plan_picture(things), format="png"), {"things": things}]

    @server.tool(annotations=reads)
    async def check_command(text: str) -> dict[str, Any]:
        """What a sentence is understood as: tasks, a question or a refusal. Nothing moves.

        Args:
            text: The sentence.
        """
        parsed = (await call(partial(understand, text))).parsed
        means = [meaning_words(command_json(one)) for one in parsed.commands]
        return {**parsed.to_json(), "means": ", then ".join(means)}


def add_resources(server: MCPServer[None], robot: ServedRobot) -> None:
    """Skills, scene, the last report and a picture."""

    @server.resource("robot://skills", mime_type="text/plain")
    def skills() -> str:
        """What the robot can do, an example sentence for each skill."""
        from trees.registry import skills as known

        return "\n".join(f"{name}: {skill.example}" for name, skill in known().items())

    @server.resource("robot://scene", mime_type="application/json")
    async def scene() -> dict[str, Any]:
        """What the robot believes to be around it."""
        return {"things": await call(robot.scene)}

    @server.resource("robot://report", mime_type="application/json")
    async def report() -> dict[str, Any]:
        """The report of the last task that has ended."""
        run = robot.run()
        return dict(run.status().report) if run is not None else {}

    @server.resource("robot://picture", mime_type="image/png")
    async def picture() -> bytes:
        """What is believed, from above."""
        return plan_picture(await call(robot.scene))
