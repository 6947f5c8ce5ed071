"""A camera that stands in a room: where it is, where it looks, its lens, and how it errs."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from robots.interface.depth_camera import CameraErrors, DepthCamera

HEAD_CAMERA = "head camera"
"""What the robot's own camera is called; no other one is."""
USUAL_ERRORS = CameraErrors()
_LEAST_AWAY_M = 0.1
_STEEP = 0.9999
"""Cosine of the angle to the vertical beyond which a camera looks straight down or up."""


@dataclass(frozen=True, slots=True)
class FixedCamera:
    """One camera of a room; it takes the same pictures as a robot's own.

    Attributes:
        name: What people call it: "ceiling camera".
        position_m: Where it is.
        looks_at_m: A place in the middle of its pictures; their upper edge is up, or, straight down, ahead.
        focal_px, width_px, height_px, range_m, rate_hz, latency_s, errors: As of ``DepthCamera``. Of
            ``errors``, ``turn_rad`` and ``shift_m`` are what its calibration to the room leaves.
    """

    name: str
    position_m: tuple[float, float, float]
    looks_at_m: tuple[float, float, float]
    focal_px: float = 523.3
    width_px: int = 640
    height_px: int = 480
    range_m: tuple[float, float] = (0.3, 8.0)
    rate_hz: float = 15.0
    latency_s: float = 0.08
    errors: CameraErrors = USUAL_ERRORS

    @property
    def lens(self) -> DepthCamera:
        """What takes its pictures; its frame is its own."""
        return DepthCamera(
            name=self.name,
            frame=self.name,
            focal_px=self.focal_px,
            width_px=self.width_px,
            height_px=self.height_px,
            range_m=self.range_m,
            rate_hz=self.rate_hz,
            latency_s=self.latency_s,
            errors=self.errors,
        )

    @property
    def field_of_view_rad(self) -> tuple[float, float]:
        """Across and down."""
        across, down = (2.0 * math.atan(0.5 * px / self.focal_px) for px in (self.width_px, self.height_px))
        return across, down

    @property
    def world_T_camera(self) -> Transform:
        """Its optical frame (z forward, x right, y down), shape (4, 4), as its calibration has it."""
        eye = np.array(self.position_m)
        ahead = np.array(self.looks_at_m) - eye
        ahead /= np.linalg.norm(ahead)
        up = np.array([1.0, 0.0, 0.0]) if abs(ahead[2]) > _STEEP else np.array([0.0, 0.0, 1.0])
        right = np.cross(ahead, up)
        right /= np.linalg.norm(right)
        return poses.transform(np.column_stack([right, np.cross(ahead, right), ahead]), eye)


def defect(camera: FixedCamera) -> tuple[str, str] | None:
    """The key and the reason of the first rule that a camera breaks, or None."""
    if camera.name == HEAD_CAMERA:
        return "name", f"{HEAD_CAMERA!r} is the robot's own"
    for key in ("position_m", "looks_at_m"):
        if not all(map(math.isfinite, getattr(camera, key))):
            return key, "must be finite"
    if math.dist(camera.position_m, camera.looks_at_m) < _LEAST_AWAY_M:
        return "looks_at_m", f"must be {_LEAST_AWAY_M:g} m or farther from position_m: it says where to"
    near, far = camera.range_m
    if not (0.0 < near < far and math.isfinite(far)):
        return "range_m", f"must be the nearest and the farthest depth, [0.3, 8.0], not [{near:g}, {far:g}]"
    ranges = (
        ("focal_px", camera.focal_px, 50.0, 5000.0),
        ("width_px", camera.width_px, 64, 1920),
        ("height_px", camera.height_px, 48, 1920),
        ("rate_hz", camera.rate_hz, 0.1, 60.0),
        ("latency_s", camera.latency_s, 0.0, 2.0),
    )
    for key, value, low, high in ranges:
        if not low <= value <= high:
            return key, f"must be from {low:g} to {high:g}, not {value:g}"
    for item in fields(CameraErrors):
        value = getattr(camera.errors, item.name)
        if not (math.isfinite(value) and value >= 0.0):
            return f"errors.{item.name}", f"must be 0 or more, not {value:g}"
    return None
