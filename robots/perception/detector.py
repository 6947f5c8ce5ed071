"""What perception tells: detections relative to the camera, with size, confidence and stamp; range scans."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Shape
from kinematics.scene.known_part import KnownPart
from robots.perception.position_error import PositionError

Category = Literal["object", "furniture", "person"]


@dataclass(frozen=True, slots=True)
class Detection(Sealed):
    """One thing seen in one frame.

    Attributes:
        category: "object" (may be grasped), "furniture" or "person".
        kind: Canonical kind: "cup", "box", "ball", "table", ...
        color: Canonical colour word, or None when it could not be told.
        camera_T_object: Pose in the camera's optical frame (z forward, x right, y down), shape (4, 4).
        shape: Estimated solid; its frame is ``camera_T_object``. A piece of furniture is one
            detection a solid (a table: its top, a Box). A person is one upright Cylinder, x ahead.
        confidence: In [0, 1].
        name: Of a person who was recognised, or of furniture that has one of its own ("side table"); None
            else.
        names: What an object or a piece of furniture is called besides, the usual name first: "tomato soup".
        categories: What sorts of things it belongs to: "food".
        traits: What is seen of a person, as far as it can be told: "sitting", "waving", "red shirt".
        error: Of place and size, in the camera's frame; None when the detector declares none.
        alike: Kinds and names that the thing may have as well, as far as can be seen.
        picture: A PNG file's bytes: the part of a picture that shows it, of what is so unsure that a person
            may be asked; None else.
        cut: Whether it goes on where nothing is measured, beyond the picture's edge: it is at least so large.
        moves: Of a solid of a door or drawer whose piece is recognised by a model of it; None else.
    """

    category: Category
    kind: str
    color: str | None
    camera_T_object: Transform
    shape: Shape
    confidence: float
    name: str | None = None
    names: tuple[str, ...] = ()
    categories: tuple[str, ...] = ()
    traits: tuple[str, ...] = ()
    error: PositionError | None = None
    alike: tuple[str, ...] = ()
    picture: bytes | None = None
    cut: bool = False
    moves: KnownPart | None = None


@dataclass(frozen=True, slots=True)
class PerceptionFrame:
    """Everything seen at one instant.

    Attributes:
        stamp_s: When the picture was taken (not when it was delivered).
        sequence: Rises by one from frame to frame.
        detections: In no promised order; the same thing has no identity from frame to frame.
        trouble: What is wrong with the picture, in words ("its picture is too dark"), when nothing could be
            looked for in it; None else.
        hindrance: What is wrong with a picture in which some things could be found, and others may be missed.
        tilt_rad: By how much what is level seemed to lean in the picture: what an IMU and a calibration leave
            of it, or more where the camera has been turned.
    """

    stamp_s: float
    sequence: int
    detections: tuple[Detection, ...]
    trouble: str | None = None
    tilt_rad: float = 0.0
    hindrance: str | None = None


class Detector(Protocol):
    """A camera with its detector: a source of perception frames."""

    @property
    def labels(self) -> frozenset[str] | None:
        """The words that it can tell: kinds, names and categories. None: any word, it is open."""
        ...

    @property
    def fronts(self) -> frozenset[str]:
        """The doors and drawers that it tells apart by the piece that they are of: "microwave door"."""
        ...

    def latest(self) -> PerceptionFrame | None:
        """The newest frame that has been delivered, or None before the first."""
        ...


class RangeSensor(Protocol):
    """A sensor that measures distances all around the robot, at several heights."""

    def scan(self) -> NDArray[np.float64] | None:
        """Points on what is around, in a level frame at the base, x ahead, z up from the floor, (n, 3).

        None while the sensor has nothing to say: before the first scan, or after a silence.
        """
        ...
