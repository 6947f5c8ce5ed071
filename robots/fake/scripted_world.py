"""A world that does what its script says: things stand still until somebody moves or carries them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from kinematics.model.robot_description import Hand
from robots.perception.truth_view import TrueObject

PoseOf = Callable[[str], Transform]
"""Gives ``world_T_frame`` of one of the robot's frames, shape (4, 4)."""


@dataclass(frozen=True, slots=True)
class _Carried:
    hand: Hand
    frame: str
    frame_T_object: Transform


class ScriptedWorld:
    """The truth of a scripted scene; a ``TruthView`` without occlusion.

    Attributes:
        hidden: Names of things that the camera does not see.
    """

    def __init__(self, objects: Iterable[TrueObject], pose_of: PoseOf, camera_frame: str) -> None:
        """Set the scene.

        Args:
            objects: What is there.
            pose_of: The robot's forward kinematics.
            camera_frame: The camera's optical frame.
        """
        self.hidden: set[str] = set()
        self._objects = {item.name: item for item in objects}
        self._pose_of = pose_of
        self._camera_frame = camera_frame
        self._carried: dict[str, _Carried] = {}
        self._solids: tuple[TrueObject, ...] | None = None

    # the truth, for sensors that are scripted and for tests

    def solids(self) -> tuple[TrueObject, ...]:
        """Everything there, in the order of its names."""
        if self._solids is None:
            self._solids = tuple(self._objects[name] for name in sorted(self._objects))
        return self._solids

    def world_T_camera(self) -> Transform:
        """Pose of the camera's optical frame, shape (4, 4)."""
        return self._pose_of(self._camera_frame)

    def visible(self, name: str, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        """All points of what is not hidden; ``points`` have shape (n, 3)."""
        return np.full(len(points), name not in self.hidden)

    def object(self, name: str) -> TrueObject:
        """One thing by its name.

        Raises:
            KeyError: It is not there.
        """
        return self._objects[name]

    def carried_by(self, name: str) -> Hand | None:
        """The hand that carries a thing, or None."""
        carried = self._carried.get(name)
        return None if carried is None else carried.hand

    # what a script may do

    def put(self, item: TrueObject) -> None:
        """Add a thing, or replace the one of the same name."""
        self._objects[item.name] = item
        self._solids = None

    def move(self, name: str, offset_m: tuple[float, float, float]) -> None:
        """Push a thing along the world's axes; a hand that carried it loses it."""
        self._carried.pop(name, None)
        self._place(name, poses.translation(*offset_m) @ self._objects[name].world_T_object)

    def shift_in_hand(self, name: str, down_m: float) -> None:
        """Let a carried thing slip down a little, still held."""
        carried = self._carried[name]
        rotation = self._pose_of(carried.frame)[:3, :3]
        slipped = carried.frame_T_object.copy()
        slipped[:3, 3] += rotation.T @ np.array([0.0, 0.0, -down_m])
        self._carried[name] = replace(carried, frame_T_object=slipped)
        self.carry()

    def remove(self, name: str) -> None:
        """Take a thing away, out of a hand too."""
        self._carried.pop(name, None)
        del self._objects[name]
        self._solids = None

    def drop(self, name: str) -> None:
        """Let a carried thing fall to whatever is below: a piece of furniture, a box, or the floor."""
        self._carried.pop(name, None)
        item = self._objects[name]
        place = item.world_T_object.copy()
        place[2, 3] = self._ground_m(place[:3, 3], name) + 0.5 * _height_m(item.shape)
        self._place(name, place)

    # for the robot's side

    def between(self, world_T_tcp: Transform, opening_m: float) -> TrueObject | None:
        """The object that stands between open fingers, or the handle."""
        for item in self.solids():
            if item.category != "object" and item.kind != "handle":
                continue
            x, y, z = (poses.inverse(world_T_tcp) @ item.world_T_object)[:3, 3]
            room_m = 0.5 * (opening_m - diameter_m(item.shape))
            if abs(x) <= 0.02 and abs(y) <= room_m and abs(z) <= 0.5 * _height_m(item.shape):
                return item
        return None

    def grip(self, name: str, hand: Hand, frame: str) -> None:
        """From now on a hand carries a thing."""
        frame_T_object = poses.inverse(self._pose_of(frame)) @ self._objects[name].world_T_object
        self._carried[name] = _Carried(hand, frame, frame_T_object)

    def carry(self) -> None:
        """Move what is carried along with the hands."""
        for name, carried in self._carried.items():
            there = self._pose_of(carried.frame) @ carried.frame_T_object
            there[:3, :3] = np.eye(3)  # hands of the fake turn as it comes; what they carry hangs upright
            self._place(name, there)

    def _place(self, name: str, world_T_object: Transform) -> None:
        self.put(replace(self._objects[name], world_T_object=world_T_object))

    def pressed_m(self, name: str, within_m: float = 0.0005) -> float | None:
        """How deep a carried thing is pressed into what is below it; None when it does not touch it."""
        item = self._objects[name]
        place = item.world_T_object[:3, 3].copy()
        low = float(place[2]) - 0.5 * _height_m(item.shape)
        place[2] += 0.05  # a thing that is pressed into its support is above it all the same
        depth = self._ground_m(place, name) - low
        return max(depth, 0.0) if depth >= -within_m else None

    def _ground_m(self, point: NDArray[np.float64], name: str) -> float:
        """Height of what is below a thing: furniture, or a box; what is round is hollow here, as a bowl."""
        tops = [0.0]
        for item in self._objects.values():
            if item.category != "person" and item.name != name and isinstance(item.shape, Box):
                centre = item.world_T_object[:3, 3]
                if np.all(np.abs(point[:2] - centre[:2]) <= 0.5 * np.array(item.shape.size_m[:2])):
                    tops.append(float(centre[2]) + 0.5 * item.shape.height_m)
        return max(top for top in tops if top <= point[2])


def diameter_m(shape: Shape) -> float:
    """Extent of a shape between two fingers that close on its middle."""
    if isinstance(shape, Cylinder | Ball):
        return 2.0 * shape.radius_m
    return min(shape.size_m[:2])


def _height_m(shape: Shape) -> float:
    return shape.height_m
