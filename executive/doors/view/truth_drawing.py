"""The simulator's truth beside what is believed: only of a robot that is served for evaluations."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import viser
from numpy.typing import NDArray

from executive.live.caller.caller import Caller
from kinematics.geometry import poses
from robots.clock import WallClock
from robots.live.wire.errors import LiveError
from robots.live.wire.messages import write_message

_TRUTH = (170, 60, 200)
_RADIUS_M = 0.03
_EVERY_S = 0.1

Floats = NDArray[np.float64]


class TruthDrawing:
    """Draws where things truly are while that is wanted, as seen from the robot as it is drawn.

    Args:
        scene: Of the page.
        socket: Where evaluations are answered.

    Attributes:
        wanted: Whether it is shown.
    """

    def __init__(self, scene: viser.SceneApi, socket: Path) -> None:
        self._scene, self._socket, self._wall = scene, socket, WallClock()
        self._caller: Caller | None = None
        self._asked_s = float("-inf")
        self._handles: dict[str, Any] = {}
        self.wanted = False

    def show(self, base: Floats) -> None:
        """Bring it up to date; nothing waits for an answer.

        Args:
            base: Pose of the base as it is drawn, xyz and quaternion (x, y, z, w), shape (7,).
        """
        if not self.wanted:
            self._clear()
            return
        try:
            if self._caller is None:
                self._caller = Caller(self._socket)
            if self._wall.now_s() - self._asked_s > _EVERY_S:
                self._asked_s = self._wall.now_s()
                self._caller.send(write_message("truth"))
            for told in self._caller.poll():
                self._draw(told, base)
        except LiveError:
            self._caller = None

    def _draw(self, told: Mapping[str, Any], base: Floats) -> None:
        if told["type"] != "truth":
            return
        for name, place_m in true_places(told, base).items():
            if name not in self._handles:
                self._handles[name] = self._scene.add_icosphere(
                    f"/truth/{name}", _RADIUS_M, _TRUTH, opacity=0.5, cast_shadow=False
                )
                self._scene.add_label(f"/truth/{name}/label", f"{name}, in truth", anchor="top-center")
            self._handles[name].position = tuple(map(float, place_m))

    def _clear(self) -> None:
        for handle in self._handles.values():
            handle.remove()
        self._handles.clear()


def true_places(told: Mapping[str, Any], base: Floats) -> Mapping[str, Floats]:
    """Where objects truly are from the robot, in the frame in which it is drawn, m, by their names.

    Args:
        told: The answer of the evaluation's socket.
        base: Pose of the base as it is drawn, xyz and quaternion (x, y, z, w), shape (7,).
    """
    turn = poses.rotation_from_quaternion(base[3:])
    odom_T_world = poses.transform(turn, base[:3]) @ np.linalg.inv(np.array(told["base"]))
    return {name: (odom_T_world @ [*place, 1.0])[:3] for name, place in told["places_m"].items()}


Switch = Callable[[bool], None]
"""What a checkbox calls when it is set or cleared."""
