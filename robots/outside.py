"""Which scenes, robots and words there are, here and in other packages; what is in them is not read.

Those of other packages are found by their entry points when they are asked for.

A package declares a package of its own that holds the files::

    [project.entry-points."humanoid_executive.scenes"]
    theatre = "my_package.scenes"

Nothing of it is imported before somebody asks for the group, and what cannot be read is left out with a
complaint.
"""

from __future__ import annotations

import importlib.metadata
import importlib.resources
import os
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources.abc import Traversable
from pathlib import Path
from types import MappingProxyType

SCENES = "humanoid_executive.scenes"
"""Each names a package with scenes, ``<name>.toml``."""
ROBOTS = "humanoid_executive.robots"
"""Each names a package with a robot's ``description.toml``; the robot is called as the entry point is."""
BODIES = "humanoid_executive.bodies"
"""Each names a function that attaches a body: ``robots.interface.bodies.AttachBody``."""
VOCABULARY = "humanoid_executive.vocabulary"
"""Each names a package with word lists, ``*.toml``, in the form of a user's configuration."""


DESCRIPTION = "description.toml"
"""The file that makes a folder a robot's."""


@dataclass(frozen=True, slots=True)
class OutsideFolders:
    """Folders that other installed packages offer under one group of entry points.

    Attributes:
        folders: Folders of data by the names of the entry points, the smaller names first.
        complaints: Why an entry point was left out, one line each.
    """

    folders: Mapping[str, Traversable]
    complaints: tuple[str, ...] = ()


@cache
def outside_folders(group: str) -> OutsideFolders:
    """The folders of a group, looked for once."""
    folders: dict[str, Traversable] = {}
    complaints = []
    kind = group.rpartition(".")[2]
    for point in sorted(importlib.metadata.entry_points(group=group), key=lambda one: one.name):
        if point.name in folders:
            complaints.append(f"{kind} {point.name!r}: another package has that name already")
            continue
        try:
            folders[point.name] = importlib.resources.files(point.value)
        except Exception as broken:  # a package that cannot be imported may raise anything
            complaints.append(f"{kind} {point.name!r}: {type(broken).__name__}: {broken}")
    return OutsideFolders(MappingProxyType(folders), tuple(complaints))


@cache
def outside_files(group: str) -> Mapping[str, Traversable]:
    """All TOML files of a group's folders, by their names without the ending; of equals the first."""
    found: dict[str, Traversable] = {}
    for folder in outside_folders(group).folders.values():
        for file in sorted(folder.iterdir(), key=lambda item: item.name):
            if file.name.endswith(".toml"):
                found.setdefault(file.name.removesuffix(".toml"), file)
    return MappingProxyType(found)


def robot_folders() -> Mapping[str, Traversable]:
    """The folder of data of each robot by its name; of equal names the one here."""
    here = {item.name: item for item in importlib.resources.files("robots.models").iterdir()}
    folders = {**outside_folders(ROBOTS).folders, **here}
    return {name: item for name, item in folders.items() if (item / DESCRIPTION).is_file()}


def robot_folder(name: str) -> Traversable | None:
    """The folder of data of a robot.

    Args:
        name: Of one that is known, or the path of a folder with a description, anywhere.

    Returns:
        None when there is none.
    """
    if is_path(name):
        folder = Path(name).expanduser().resolve()
        return folder if (folder / DESCRIPTION).is_file() else None
    return robot_folders().get(name)


def is_path(name: str) -> bool:
    """Whether a robot is named by the path of its folder: it has a separator, or begins with a dot."""
    return "/" in name or os.sep in name or name.startswith(".")


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
