"""The robot in the page: its links' solids in frames that follow the joints."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
import viser
from numpy.typing import NDArray

from executive.doors.ros.frames import FrameTree
from executive.doors.view.robot_meshes import link_meshes
from kinematics.model.robot_description import RobotDescription

ROOT = "/robot"
REFUSED = (224, 32, 32)
_DARKEST = 110
"""Black links would not be seen on a dark page."""
_STILL = 3e-4
"""A frame that has moved by less, m or in its quaternion, is not sent: what stands trembles by that much."""

Floats = NDArray[np.float64]


class MovingFrames:
    """Which frames of a robot have moved since they were last drawn, and where they are now.

    Args:
        urdf: Of the robot.
        joints: Whose positions are told, in their order.
        base_link: The link whose pose in the odometry frame is told besides.

    Attributes:
        paths: Of each link's frame among the page's names, by link.
        fixed: Pose of each frame that never moves, by path: xyz and quaternion (w, x, y, z).
    """

    def __init__(self, urdf: str, joints: tuple[str, ...], base_link: str) -> None:
        self._tree = FrameTree(urdf, joints)
        parents = {child: parent for parent, child in self._tree.moving}
        parents |= {child: parent for parent, child, *_ in self._tree.fixed}
        roots = {parent for parent in parents.values() if parent not in parents}
        self.paths: dict[str, str] = {base_link: ROOT}
        for link in [*roots, *parents]:
            self.paths[link] = self._path(link, parents, base_link)
        self.fixed = {
            self.paths[child]: (np.array(xyz), _wxyz(np.array(turn)))
            for _, child, xyz, turn in self._tree.fixed
            if child != base_link
        }
        self._moving = [self.paths[child] for _, child in self._tree.moving]
        self._drawn = np.full((len(self._moving) + 1, 7), np.inf)

    def moved(self, q: Floats, base: Floats) -> dict[str, Floats]:
        """The frames that have moved: xyz and quaternion (w, x, y, z) in the parent, shape (7,), by path.

        Args:
            q: Joint positions, rad or m.
            base: Pose of the base: xyz and quaternion (x, y, z, w), shape (7,).
        """
        places, turns = self._tree.poses(q)
        rows = np.vstack([base, np.hstack([places, turns])])
        rows = rows[:, [0, 1, 2, 6, 3, 4, 5]]
        changed = np.flatnonzero(np.abs(rows - self._drawn).max(axis=1) > _STILL)
        self._drawn[changed] = rows[changed]
        paths = [ROOT, *self._moving]
        return {paths[i]: rows[i] for i in changed.tolist()}

    def _path(self, link: str, parents: dict[str, str], base_link: str) -> str:
        names = [link]
        while names[-1] in parents and names[-1] != base_link:
            names.append(parents[names[-1]])
        above = names[:-1] if names[-1] == base_link else names
        return "/".join([ROOT, *reversed(above)])


class RobotDrawing:
    """Draws one robot.

    Args:
        scene: Of the page.
        description: The robot.
    """

    def __init__(self, scene: viser.SceneApi, description: RobotDescription) -> None:
        self._frames = MovingFrames(description.urdf, description.actuated, description.base_link)
        self._handles = {
            path: scene.add_frame(path, show_axes=False)
            for path in sorted(set(self._frames.paths.values()), key=lambda one: one.count("/"))
        }
        for path, (xyz, wxyz) in self._frames.fixed.items():
            self._handles[path].position, self._handles[path].wxyz = xyz, wxyz
        self._solids: dict[str, list[tuple[viser.MeshHandle, tuple[int, int, int]]]] = {}
        for number, mesh in enumerate(link_meshes(description.urdf)):
            name = f"{self._frames.paths.get(mesh.link, ROOT)}/solid_{number}"
            rgb = lightened(mesh.rgb)
            # without a graphics card the insides cost a quarter of the pictures
            handle = scene.add_mesh_simple(
                name, mesh.vertices, mesh.faces, color=rgb, flat_shading=True, side="front"
            )
            self._solids.setdefault(mesh.link, []).append((handle, rgb))
        self._refused: frozenset[str] = frozenset()

    def move(self, q: Floats, base: Floats) -> None:
        """Draw it in another posture, at another place; as for ``MovingFrames.moved``."""
        for path, row in self._frames.moved(q, base).items():
            handle = self._handles[path]
            handle.position, handle.wxyz = row[:3], row[3:]

    def path_of(self, link: str) -> str:
        """The page's name of a link's frame; of the base for one that is not known."""
        return self._frames.paths.get(link, ROOT)

    def mark(self, links: Collection[str]) -> None:
        """Show some links in red, and no others."""
        marked = frozenset(links) & frozenset(self._solids)
        for link in marked ^ self._refused:
            for handle, rgb in self._solids[link]:
                handle.color = REFUSED if link in marked else rgb
        self._refused = marked


def lightened(rgb: tuple[int, int, int]) -> tuple[int, int, int]:
    """A colour as it is drawn: one that would not be seen on a dark page is made lighter, all others stay."""
    missing = max(_DARKEST - max(rgb), 0)
    red, green, blue = (one + missing for one in rgb)
    return red, green, blue


def _wxyz(xyzw: Floats) -> Floats:
    return xyzw[[3, 0, 1, 2]]
