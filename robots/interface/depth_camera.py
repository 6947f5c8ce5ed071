"""A camera that sees colour and depth: where it sits, its lens, and how it errs."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class CameraErrors:
    """How a depth camera errs. Lengths in m, angles in rad, colours in [0, 1].

    Attributes:
        depth_noise_m, depth_noise_per_m2, sharp_m: Standard deviation of a depth z: the first, and the second
            times the square of what z has beyond the third.
        correlated_px: The noise of neighbouring pixels is alike over so many.
        depth_step_m: Depths are told in steps of this.
        edge_jump: Where depth jumps by this share of itself, returns are missing on both sides,
        edge_loss: with this chance,
        edge_px: as far as this from the jump.
        grazing_rad: Surfaces that are seen under a flatter angle than this return nothing, mostly.
        dark_below: Surfaces darker than this return nothing now and then,
        dark_loss: with this chance.
        color_noise: Standard deviation of each colour channel in usual light; it grows with the exposure.
        most_exposure: How many times a dark picture can be brightened.
        turn_rad, shift_m: Standard deviation, each axis, of an error of the camera's place that is drawn once
            an episode: what calibration leaves.
    """

    depth_noise_m: float = 0.0012
    depth_noise_per_m2: float = 0.0019
    sharp_m: float = 0.4
    correlated_px: float = 1.5
    depth_step_m: float = 0.001
    edge_jump: float = 0.02
    edge_loss: float = 0.7
    edge_px: int = 1
    grazing_rad: float = math.radians(8.0)
    dark_below: float = 0.12
    dark_loss: float = 0.15
    color_noise: float = 0.01
    most_exposure: float = 12.0
    turn_rad: float = 0.003
    shift_m: float = 0.002

    def depth_sigma_m(self, depth_m: float) -> float:
        """Standard deviation of a depth."""
        return self.depth_noise_m + self.depth_noise_per_m2 * max(depth_m - self.sharp_m, 0.0) ** 2


@dataclass(frozen=True, slots=True)
class DepthCamera:
    """One camera of a robot; colour and depth have the same pixels.

    Attributes:
        name: "head".
        frame: Its optical frame (z forward, x right, y down), a frame of the robot's model.
        width_px, height_px: Of a picture.
        focal_px: Focal length; pixels are square, and the axis goes through the middle.
        range_m: Nearest and farthest depth that is told.
        rate_hz: Pictures a second, at most.
        latency_s: From the picture to what was found in it.
        errors: How it errs.
    """

    name: str
    frame: str
    focal_px: float
    width_px: int = 640
    height_px: int = 480
    range_m: tuple[float, float] = (0.3, 8.0)
    rate_hz: float = 15.0
    latency_s: float = 0.08
    errors: CameraErrors = CameraErrors()
