"""How wrong what a picture tells may be: what calibration leaves, and what each thing has for itself.

Measured on 80 random tables from two places each: a turn of the camera about the vertical and its shift
explain what things are off by together, the tilt being corrected by a level surface; what is left of each is
a fraction of the noise of depths where a thing is well seen, and centimetres where it was taken for something
else, which its confidence tells.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box
from robots.interface.depth_camera import DepthCamera
from robots.perception.position_error import PositionError
from robots.perception.rgbd.piece import Piece
from robots.perception.rgbd.shapes import Solid

_OF_DEPTH = 0.5
"""Share of the noise of a depth that is left in the place of a thing that is well seen."""
_OF_FIT = 2.0
"""Fits take neighbouring depths for independent."""
_DOUBTED_M, _DOUBT = 0.03, 1.5
"""A thing of no confidence may be so far off; the error falls with this power of what confidence lacks."""
_SIZES = 0.015
_DOUBTED_SIZES = 0.5
_MOST_SIZES = 0.5
_NOISE = 0.25
"""Share of the noise of a depth that is drawn anew in each picture."""
_EDGES_M, _ASSUMED_M, _TOP_M = 0.010, 0.030, 0.001
"""Of furniture: where its edges are seen, where they are assumed, and the height of its top."""
_PERSON_M = 0.03


class Errors:
    """The errors of what one picture tells, in the frame of its camera."""

    def __init__(self, camera: DepthCamera, odom_T_camera: Transform, levelled: bool) -> None:
        """Prepare.

        Args:
            camera: What took the picture.
            odom_T_camera: Where it is believed to be, shape (4, 4).
            levelled: Whether a level surface has shown the camera's tilt.
        """
        self._camera, self._pose, self._levelled = camera, odom_T_camera, levelled

    def of_thing(self, solid: Solid, confidence: float) -> PositionError:
        """Of a thing on a surface."""
        doubt = _DOUBTED_M * (1.0 - confidence) ** _DOUBT
        depth_m = self._depth_sigma_m(solid.place_m)
        x, y = (math.hypot(_OF_DEPTH * depth_m, _OF_FIT * sigma, doubt) for sigma in solid.sigma_m[:2])
        z = math.hypot(_OF_DEPTH * depth_m, 0.5 * doubt)
        sizes = math.hypot(_SIZES, _size_share(solid), _DOUBTED_SIZES * (1.0 - confidence) ** _DOUBT)
        return self._error(solid.place_m, (x, y, z), min(sizes, _MOST_SIZES))

    def of_furniture(self, piece: Piece) -> PositionError:
        """Of one solid of a piece of furniture; what was taken from the map is as wrong as that."""
        side = _ASSUMED_M if piece.assumed else _EDGES_M
        return self._error(piece.odom_T_solid[:3, 3], (side, side, _TOP_M), _SIZES)

    def of_person(self, place_m: Array) -> PositionError:
        """Of somebody."""
        return self._error(place_m, (_PERSON_M,) * 3, _SIZES)

    def _depth_sigma_m(self, place_m: Array) -> float:
        return self._camera.errors.depth_sigma_m(float(np.linalg.norm(place_m - self._pose[:3, 3])))

    def _error(self, place_m: Array, own_m: Sequence[float], size_share: float) -> PositionError:
        turn = self._pose[:3, :3].T
        shared = turn @ self._shared(place_m) @ turn.T
        own = turn @ np.diag(np.square(own_m)) @ turn.T
        noise = (_NOISE * self._depth_sigma_m(place_m)) ** 2 * np.eye(3)
        return PositionError(shared + own, noise, size_share, shared)

    def _shared(self, place_m: Array) -> Array:
        """What calibration leaves at a place, in the odometry frame."""
        errors = self._camera.errors
        arm = place_m - self._pose[:3, 3]
        if self._levelled:
            across = np.array([-arm[1], arm[0], 0.0])
            turned = np.outer(across, across)
        else:
            turned = float(arm @ arm) * np.eye(3) - np.outer(arm, arm)
        return np.asarray(errors.shift_m**2 * np.eye(3) + errors.turn_rad**2 * turned)


def _size_share(solid: Solid) -> float:
    """Of the sizes along the ground, as a fit leaves them."""
    shape = solid.shape
    sizes = shape.size_m[:2] if isinstance(shape, Box) else (shape.radius_m,)
    spread = solid.sigma_m[2 : 2 + len(sizes)]
    return max(_OF_FIT * sigma / size for sigma, size in zip(spread, sizes, strict=True))
