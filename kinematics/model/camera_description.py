"""The camera that a robot goes by, and what aims it."""

from __future__ import annotations

import math
from dataclasses import dataclass

_WELL_INSIDE = 0.6
"""A way that is nearer to the picture's middle than this share of half of it needs no trunk to turn."""


@dataclass(frozen=True, slots=True)
class TrunkAim:
    """How a trunk aims a camera that sits on it and has no neck: only as far as the picture needs it to.

    Attributes:
        turn_joint: Turns the trunk to the left (positive).
        bow_joint: Bends it forward (positive).
        bow_rad: How far it may bend back and forward; farther the robot does not stand safely.
        down_rad: How far below the horizontal the camera looks while the trunk is upright.
    """

    turn_joint: str
    bow_joint: str
    bow_rad: tuple[float, float]
    down_rad: float


@dataclass(frozen=True, slots=True)
class CameraDescription:
    """The camera that the robot goes by: optical frame (z forward, x right, y down), view, what aims it.

    Attributes:
        frame: Its optical frame, on any link: of a head, or of a stand that the base is bolted to.
        horizontal_fov_rad, vertical_fov_rad: Angles of view.
        range_m: Nearest and farthest that it sees.
        pan_joint, tilt_joint: The joints of a neck that aim it; None of a camera that stays as it is.
        lean_joint: Bends the trunk forward (positive), for looking at what is close to the body; None when
            the robot has no such joint.
        trunk: How the trunk aims it in a neck's place; None where it does not.
    """

    frame: str
    horizontal_fov_rad: float
    vertical_fov_rad: float
    range_m: tuple[float, float]
    pan_joint: str | None = None
    tilt_joint: str | None = None
    lean_joint: str | None = None
    trunk: TrunkAim | None = None

    @property
    def neck(self) -> tuple[str, str] | None:
        """The joints that pan and tilt it; None where none do."""
        if self.pan_joint is None or self.tilt_joint is None:
            return None
        return self.pan_joint, self.tilt_joint

    def aimed(self, pan_rad: float, tilt_rad: float, lean_rad: float | None = None) -> dict[str, float]:
        """Positions of those joints that there are, by name, for a gaze.

        A trunk that aims turns until the picture holds the way of the gaze, and no farther; it does not lean
        besides.

        Args:
            pan_rad: To the left.
            tilt_rad: Down.
            lean_rad: Of the trunk, forward; None leaves the trunk out.
        """
        if self.trunk is not None:
            pan_rad = _beyond(pan_rad, _WELL_INSIDE * 0.5 * self.horizontal_fov_rad)
            bow_rad = _beyond(tilt_rad - self.trunk.down_rad, _WELL_INSIDE * 0.5 * self.vertical_fov_rad)
            least, most = self.trunk.bow_rad
            return {self.trunk.turn_joint: pan_rad, self.trunk.bow_joint: min(max(bow_rad, least), most)}
        joints = {} if self.neck is None else {self.neck[1]: tilt_rad, self.neck[0]: pan_rad}
        if self.lean_joint is not None and lean_rad is not None:
            joints[self.lean_joint] = lean_rad
        return joints

    @property
    def fixed(self) -> bool:
        """Whether no joint of a neck or a lean aims it: one look shows most of what there is to see."""
        return self.neck is None and self.lean_joint is None

    @property
    def aims(self) -> bool:
        """Whether a neck or the trunk turns it to what is meant."""
        return self.neck is not None or self.trunk is not None


def _beyond(angle_rad: float, held_rad: float) -> float:
    """What is left of an angle past what the picture holds, with its sign."""
    return math.copysign(max(abs(angle_rad) - held_rad, 0.0), angle_rad)
