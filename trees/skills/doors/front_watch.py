"""Watches, while a hand is on its way to a door or drawer, that it stays where it was."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from trees.beliefs.openings.handles import HandleTarget
from trees.beliefs.scene.scene_update import kind_of
from trees.toolbox import Toolbox

MOVED_M = 0.025
"""Farther from where it was believed than errors of a single picture explain; a door of 60 cm has turned by
5 degrees then."""
_FRAMES = 2
_SAME_M = 0.5
"""A front or bar farther from there than this is another one."""


class FrontWatch:
    """Compares each new picture with the planning scene, to notice that a door moves while a hand nears it.

    Args:
        toolbox: What the robot sees, and what it believes.
        target: What the hand is on its way to.
    """

    def __init__(self, toolbox: Toolbox, target: HandleTarget) -> None:
        self._toolbox = toolbox
        objects = toolbox.world.scene.objects
        names = dict.fromkeys((target.part, target.handle))
        self._stood: dict[str, NDArray[np.float64]] = {
            kind_of(name): objects[name].world_T_object[:3, 3] for name in names if name in objects
        }
        self._others = {
            kind: [
                item.world_T_object[:3, 3]
                for name, item in objects.items()
                if kind_of(name) == kind and name not in names
            ]
            for kind in self._stood
        }
        self._since_s, self._sequence = toolbox.clock.now_s(), -1
        self._moved: list[float] = []

    def moved_m(self) -> float | None:
        """How far it has moved, once several pictures in a row say that it has; else None."""
        frame = self._toolbox.detector.latest()
        if frame is None or frame.stamp_s < self._since_s or frame.sequence <= self._sequence:
            return None
        self._sequence = frame.sequence
        model = self._toolbox.model
        q = self._toolbox.sensing.state_at(frame.stamp_s).q
        odom_T_camera = model.frame_pose(q, model.description.camera.frame)
        nearest: dict[str, float] = {}
        for detection in frame.detections:
            stood = self._stood.get(detection.kind)
            if stood is None:
                continue
            place = (odom_T_camera @ detection.camera_T_object)[:3, 3]
            away_m = float(np.linalg.norm(place - stood))
            if any(float(np.linalg.norm(place - other)) < away_m for other in self._others[detection.kind]):
                continue  # that is the next drawer's
            nearest[detection.kind] = min(away_m, nearest.get(detection.kind, _SAME_M))
        farthest_m = max((away for away in nearest.values() if away < _SAME_M), default=0.0)
        self._moved = [*self._moved, farthest_m] if farthest_m > MOVED_M else []
        return min(self._moved) if len(self._moved) >= _FRAMES else None
