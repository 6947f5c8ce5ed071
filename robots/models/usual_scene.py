"""Where a robot is when nobody says where: before furniture of its own size."""

from __future__ import annotations

from robots.outside import DESCRIPTION, robot_folder
from robots.toml_text import TomlTextError, read_toml

USUAL_SCENE = "tabletop"
"""Of a robot whose description names none."""


def usual_scene(robot: str) -> str:
    """The scene that a robot's description names as ``scene`` of ``[body]``, without reading the rest.

    Whoever reads the robot is told what is wrong with it; here, what cannot be read names no scene.

    Args:
        robot: As for ``robots.models.description.load_robot``.

    Returns:
        The name of a scene, or its path where the description says so, from the robot's folder on.
    """
    folder = robot_folder(robot)
    if folder is None:
        return USUAL_SCENE
    try:
        body = read_toml((folder / DESCRIPTION).read_text("utf-8")).get("body")
    except (OSError, UnicodeError, TomlTextError):
        return USUAL_SCENE
    scene = body.get("scene", USUAL_SCENE) if isinstance(body, dict) else USUAL_SCENE
    if not isinstance(scene, str):
        return USUAL_SCENE
    return str(folder / scene) if scene.endswith((".toml", ".xml")) else scene
