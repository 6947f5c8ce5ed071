"""Which robots and scenes there are, here and in other packages; nothing of them is read.

Whoever only lists them, or looks whether there is one of a name, needs none of what reading takes.
"""

from __future__ import annotations

import importlib.resources
from collections.abc import Mapping
from importlib.resources.abc import Traversable

from robots.outside import ROBOTS, SCENES, outside_files, outside_folders

DESCRIPTION = "description.toml"
"""The file that makes a folder a robot's."""


def robot_folders() -> Mapping[str, Traversable]:
    """The folder of data of each robot by its name; of equal names the one here."""
    here = {item.name: item for item in importlib.resources.files("robots.models").iterdir()}
    folders = {**outside_folders(ROBOTS).folders, **here}
    return {name: item for name, item in folders.items() if (item / DESCRIPTION).is_file()}


def known_robots() -> list[str]:
    """Names of the robots, sorted."""
    return sorted(robot_folders())


def scene_files() -> Mapping[str, Traversable]:
    """The file of each scene by its name; of equal names the one here."""
    here = importlib.resources.files("robots.scenes").iterdir()
    own = {item.name.removesuffix(".toml"): item for item in here if item.name.endswith(".toml")}
    return {**outside_files(SCENES), **own}


def known_scenes() -> list[str]:
    """Names of the scenes, sorted."""
    return sorted(scene_files())
