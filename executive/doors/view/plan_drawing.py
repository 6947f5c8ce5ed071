"""What the robot is going to do, in the page: ways of hands, next footsteps, and what was refused where."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, Protocol

import numpy as np
import viser
from numpy.typing import NDArray

from executive.doors.view.robot_drawing import REFUSED
from kinematics.model.robot_description import RobotDescription

_PATH = (32, 150, 200)
_FEET = {1: (52, 110, 210), -1: (210, 120, 40)}
"""Of landings of the left foot and the right one."""
_STEP_HEIGHT_M, _ABOVE_M = 0.004, 0.003
_PLACE_M = 0.03
_STILL_M = 0.002

Floats = NDArray[np.float64]
Place = tuple[float, float, float]


class _Handle(Protocol):
    def remove(self) -> None: ...


class PlanDrawing:
    """Draws what is planned; what has not changed is left alone.

    Args:
        scene: Of the page.
        description: The robot.
    """

    def __init__(self, scene: viser.SceneApi, description: RobotDescription) -> None:
        self._scene = scene
        self._soles = {1 if sole.side == "left" else -1: sole for sole in description.soles}
        self._paths: Sequence[Mapping[str, Any]] = ()
        self._landings = np.zeros((0, 4))
        self._place: Place | None = None
        self._drawn: dict[str, list[_Handle]] = {}

    def paths(self, paths: Sequence[Mapping[str, Any]]) -> None:
        """Draw the ways of hands, each ``points_m`` in the odometry frame, and no others."""
        if paths == self._paths:
            return
        self._paths = paths
        made = self._anew("paths")
        for one in paths:
            points = np.array(one["points_m"], dtype=np.float32)
            ends = np.stack([points[:-1], points[1:]], axis=1)
            name = f"/plan/path_{one['hand']}"
            made.append(self._scene.add_line_segments(name, ends, _PATH, thickness=0.006))

    def landings(self, landings: Floats) -> None:
        """Draw the next footsteps, as a report has them, and no others."""
        same = landings.shape == self._landings.shape
        if same and np.allclose(landings, self._landings, atol=_STILL_M):
            return
        self._landings = landings
        made = self._anew("landings")
        for number, (side, x, y, yaw) in enumerate(landings.tolist()):
            sole = self._soles[round(side)]
            made.append(
                self._scene.add_box(
                    f"/plan/step_{number}",
                    _FEET[round(side)],
                    (sole.x_m[1] - sole.x_m[0], sole.y_m[1] - sole.y_m[0], _STEP_HEIGHT_M),
                    opacity=0.75,
                    position=(x, y, _ABOVE_M),
                    wxyz=(math.cos(0.5 * yaw), 0.0, 0.0, math.sin(0.5 * yaw)),
                    cast_shadow=False,
                )
            )

    def refused_at(self, place: Place | None) -> None:
        """Mark where a refused motion would have touched something."""
        if place == self._place:
            return
        self._place = place
        made = self._anew("refused")
        if place is not None:
            marks = (("inside", _PLACE_M, None), ("around", 2.5 * _PLACE_M, 0.3))
            for name, radius_m, opacity in marks:
                made.append(
                    self._scene.add_icosphere(
                        f"/plan/refused_{name}",
                        radius_m,
                        REFUSED,
                        opacity=opacity,
                        position=place,
                        cast_shadow=False,
                    )
                )

    def _anew(self, what: str) -> list[_Handle]:
        """Take away what was drawn of something; the list for what is drawn now."""
        for handle in self._drawn.get(what, []):
            handle.remove()
        self._drawn[what] = made = list[_Handle]()
        return made
