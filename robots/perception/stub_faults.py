"""Errors of the perception stub beyond its model, injected by tests and evaluations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform

# A look is over when the camera has turned by two degrees, or after a second.
_LOOK_TURN_RAD = np.deg2rad(2.0)
_LOOK_S = 1.0
# Between two frames of a camera at rest; a nod of the head is a hundred times faster.
_REST_RAD = 1e-3


@dataclass(slots=True)
class _Misplacement:
    offset_m: NDArray[np.float64]
    first_look_only: bool
    look_since_s: float | None = None
    look_from: NDArray[np.float64] | None = None
    over: bool = False


class StubFaults:
    """Switches for a perception that is wrong in a known way.

    Attributes:
        blind: While true, frames come but show nothing.
        frozen: While true, the last picture comes again and again, with new numbers and stamps.
    """

    def __init__(self) -> None:
        self.blind = False
        self._misplaced: dict[str, _Misplacement] = {}
        self._colors: dict[str, str | None] = {}
        self._scales: dict[str, tuple[float, float, float]] = {}
        self._turn: NDArray[np.float64] | None = None
        self.frozen = False
        self._last_rotation: NDArray[np.float64] | None = None

    def misplace(self, kind: str, offset_m: tuple[float, float, float], first_look_only: bool = True) -> None:
        """Tell everything of a kind, people left out, displaced along the world's axes.

        With ``first_look_only`` the error ends with the first look at it: a look begins with the first
        frame in which the camera is at rest and the object is detected, and ends when the camera has
        turned by more than two degrees or a second has passed. Frames before that look, taken while the
        head still moves, are wrong too.
        """
        self._misplaced[kind] = _Misplacement(np.array(offset_m, dtype=np.float64), first_look_only)

    def resize(self, kind: str, scale: tuple[float, float, float]) -> None:
        """Tell every object of a kind larger or smaller, by factors along its own axes."""
        self._scales[kind] = scale

    def turn_camera(self, vector_rad: tuple[float, float, float]) -> None:
        """Tell everything as by a camera that is mounted otherwise than is believed.

        Args:
            vector_rad: By this rotation vector in the camera's frame.
        """
        self._turn = poses.rotation_from_vector(np.array(vector_rad, dtype=np.float64))

    def recolor(self, kind: str, color: str | None) -> None:
        """Tell a wrong colour, or none, of every object of a kind."""
        self._colors[kind] = color

    def clear(self) -> None:
        """Back to the declared model alone."""
        self.blind = self.frozen = False
        self._turn = None
        self._scales.clear()
        self._misplaced.clear()
        self._colors.clear()

    def observe(self, stamp_s: float, world_T_camera: Transform) -> None:
        """Note where the camera is at the start of a frame; ends the looks that are over."""
        if not self._misplaced:
            return
        rotation = world_T_camera[:3, :3].copy()
        last, self._last_rotation = self._last_rotation, rotation
        at_rest = last is not None and poses.angle_between(last, rotation) < _REST_RAD
        for fault in self._misplaced.values():
            if fault.look_since_s is None or fault.look_from is None:
                # armed by the first detection at rest, see ``offset_m``
                fault.look_from = rotation if at_rest else None
            elif fault.first_look_only:
                turned = poses.angle_between(fault.look_from, rotation) > _LOOK_TURN_RAD
                fault.over = fault.over or turned or stamp_s - fault.look_since_s > _LOOK_S

    def offset_m(self, category: str, kind: str, stamp_s: float) -> NDArray[np.float64]:
        """The displacement of a detection of this kind in the present frame, shape (3,)."""
        fault = self._misplaced.get(kind) if category != "person" else None
        if fault is None or fault.over:
            return np.zeros(3)
        if fault.look_from is not None and fault.look_since_s is None:
            fault.look_since_s = stamp_s
        return fault.offset_m

    def scale_of(self, category: str, kind: str) -> tuple[float, float, float] | None:
        """By what factors a thing of this kind is told too large, or None."""
        return self._scales.get(kind) if category == "object" else None

    def turned(self, camera_T_object: NDArray[np.float64]) -> NDArray[np.float64]:
        """Poses in the camera's frame, shape (n, 4, 4), as a camera tells them that is mounted otherwise."""
        if self._turn is None:
            return camera_T_object
        turn = np.eye(4)
        turn[:3, :3] = self._turn
        return np.asarray(turn @ camera_T_object)

    def color_of(self, category: str, kind: str, color: str | None) -> str | None:
        """The colour that is told of a thing."""
        return self._colors.get(kind, color) if category == "object" else color
