"""Turns an exact picture into what a real camera would have given."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from robots.interface.depth_camera import CameraErrors, DepthCamera
from robots.scenes.light import LightKind
from robots.simulated.camera.orders import LensFaults

LEVEL: dict[LightKind, float] = {"bright": 1.0, "dim": 0.1, "warm": 0.8, "side": 0.9}
"""Of usual light."""
TINT: dict[LightKind, tuple[float, float, float]] = {
    "bright": (1.0, 1.0, 1.0),
    "dim": (1.0, 1.0, 1.0),
    "warm": (1.0, 0.76, 0.48),
    "side": (1.0, 1.0, 1.0),
}
"""A filament lamp of 2700 K beside daylight, in red, green and blue."""
_WANTED = 0.85
"""Where exposure puts the brightest hundredth of a picture."""
_LEAST_EXPOSURE = 0.7
_SPARE_PX = 192
_CLUMP_PX = 2.0


class Lens:
    """The errors of one camera in one episode."""

    def __init__(self, camera: DepthCamera, seed: tuple[int, ...]) -> None:
        """Draw the error of calibration.

        Args:
            camera: Whose errors.
            seed: Of this camera in this episode; each picture has a generator of its own.
        """
        rng = np.random.default_rng([*seed, 0])
        errors = camera.errors
        turn = rng.normal(0.0, errors.turn_rad, 3)
        shift = rng.normal(0.0, errors.shift_m, 3)
        self._camera, self._seed = camera, seed
        self._stain_at = rng.uniform(0.3, 0.7, 2)
        self._grain = _Grain(camera, rng)
        self.camera_error: Transform = poses.transform(poses.rotation_from_vector(turn), shift)

    def place_error(self, faults: LensFaults) -> Transform:
        """``told_T_real``: where the camera really is, in the frame where it is believed to be."""
        turn = poses.rotation_y(faults.turn_rad[0]) @ poses.rotation_x(faults.turn_rad[1])
        return self.camera_error @ poses.transform(turn, (0.0, 0.0, 0.0))

    def spoil(
        self,
        color: NDArray[np.uint8],
        depth_m: NDArray[np.float32],
        light: LightKind,
        sequence: int,
        faults: LensFaults,
    ) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
        """Colour and depth as they come out of the camera."""
        rng = np.random.default_rng([*self._seed, 1, sequence])
        errors = self._camera.errors
        if faults.covered:
            return np.zeros_like(color), np.zeros_like(depth_m)
        spoiled = self._depth(depth_m, color, rng, errors, faults)
        seen = self._color(color, light, rng, errors, faults)
        if faults.stain > 0.0:
            self._smear(seen, spoiled, faults.stain)
        return seen, spoiled

    def _color(
        self,
        color: NDArray[np.uint8],
        light: LightKind,
        rng: np.random.Generator,
        errors: CameraErrors,
        faults: LensFaults,
    ) -> NDArray[np.uint8]:
        lit = LEVEL[light] * faults.light
        tint = np.array(TINT[light], dtype=np.float32) * np.float32(lit / 255.0)
        shown = color.astype(np.float32) * tint
        bright = float(np.percentile(shown[::8, ::8].max(axis=2), 99.0))
        exposure = float(np.clip(_WANTED / max(bright, 1e-4), _LEAST_EXPOSURE, errors.most_exposure))
        if faults.flicker > 0.0:
            exposure *= float(np.exp(rng.normal(0.0, faults.flicker)))
        noise = self._grain.color(rng)
        shown += np.float32(errors.color_noise / max(1.0, exposure) ** 0.5) * noise
        shown *= np.float32(exposure)
        if faults.glare > 0.0:
            rows = np.linspace(0.0, 1.0, shown.shape[0], dtype=np.float32)[:, None, None]
            shown += np.clip((np.float32(faults.glare) - rows) / np.float32(0.15), 0.0, 1.0)
        return np.asarray(np.clip(shown * 255.0 + 0.5, 0.0, 255.0), dtype=np.uint8)

    def _depth(
        self,
        depth_m: NDArray[np.float32],
        color: NDArray[np.uint8],
        rng: np.random.Generator,
        errors: CameraErrors,
        faults: LensFaults,
    ) -> NDArray[np.float32]:
        z = depth_m
        noise = self._grain.depth(rng)
        beyond = np.maximum(z - np.float32(errors.sharp_m), 0.0)
        told = z + noise * (errors.depth_noise_m + np.float32(errors.depth_noise_per_m2) * beyond * beyond)
        if errors.depth_step_m > 0.0:
            told = np.round(told / np.float32(errors.depth_step_m)) * np.float32(errors.depth_step_m)
        chance = self._grain.chance(rng)
        edges = self._edges(z, errors)
        lost = np.where(edges, chance < errors.edge_loss, self._grazing(z, errors))
        dark = color.max(axis=2) < np.float32(255.0 * errors.dark_below)
        clumps = self._grain.clumps(rng)
        lost |= dark & (clumps > np.float32(_normal_quantile(1.0 - min(max(errors.dark_loss, 1e-6), 0.999))))
        if faults.no_depth > 0.0:
            field = cv2.GaussianBlur(rng.standard_normal(z.shape, dtype=np.float32), (0, 0), 12.0)
            lost |= field > np.quantile(field[::8, ::8], 1.0 - faults.no_depth)
        low, high = self._camera.range_m
        lost |= (z < low) | (z > high)
        told[lost] = 0.0
        return np.asarray(told, dtype=np.float32)

    @staticmethod
    def _edges(z: NDArray[np.float32], errors: CameraErrors) -> NDArray[np.bool_]:
        size = 2 * errors.edge_px + 1
        kernel = np.ones((size, size), np.uint8)
        far = np.where(z > 0.0, z, np.float32(20.0))
        spread = cv2.dilate(far, kernel) - cv2.erode(far, kernel)
        # a slanted surface changes steadily: what counts is more than its own slope makes
        slope = cv2.erode(spread, np.ones((5, 5), np.uint8))
        return np.asarray(spread - slope > np.float32(errors.edge_jump) * far, dtype=np.bool_)

    def _grazing(self, z: NDArray[np.float32], errors: CameraErrors) -> NDArray[np.bool_]:
        """Where a ray meets a surface under less than the least angle."""
        focal = np.float32(self._camera.focal_px)
        dx = cv2.Sobel(z, cv2.CV_32F, 1, 0, ksize=3) * np.float32(0.125)
        dy = cv2.Sobel(z, cv2.CV_32F, 0, 1, ksize=3) * np.float32(0.125)
        # a surface at depth z, seen under an angle a, changes by z / (focal tan a) from pixel to pixel
        steep = np.hypot(dx, dy) * focal > np.maximum(z, np.float32(0.1)) / np.float32(
            np.tan(errors.grazing_rad)
        )
        return np.asarray(steep, dtype=np.bool_)

    def _smear(self, color: NDArray[np.uint8], depth_m: NDArray[np.float32], share: float) -> None:
        height, width = depth_m.shape
        radius = (share * height * width / np.pi) ** 0.5
        v, u = np.ogrid[:height, :width]
        at_u, at_v = self._stain_at * (width, height)
        under = (u - at_u) ** 2 + (v - at_v) ** 2 < radius**2
        blurred = cv2.GaussianBlur(color, (0, 0), 15.0)
        color[under] = blurred[under]
        depth_m[under] = 0.0


class _Grain:
    """Noise for pictures: drawn once, larger than a picture, of which each picture takes another part.

    Drawing it anew took two thirds of the time that a picture's errors take.
    """

    def __init__(self, camera: DepthCamera, rng: np.random.Generator) -> None:
        self._size = camera.height_px, camera.width_px
        whole = camera.height_px + _SPARE_PX, camera.width_px + _SPARE_PX
        self._color = rng.standard_normal((*whole, 3), dtype=np.float32)
        self._depth = _blurred(rng.standard_normal(whole, dtype=np.float32), camera.errors.correlated_px)
        self._clumps = _blurred(rng.standard_normal(whole, dtype=np.float32), _CLUMP_PX)
        self._chance = rng.random(whole, dtype=np.float32)

    def color(self, rng: np.random.Generator) -> NDArray[np.float32]:
        """White, of deviation 1, shape (height, width, 3)."""
        return self._part(self._color, rng)

    def depth(self, rng: np.random.Generator) -> NDArray[np.float32]:
        """Correlated as depths err, of deviation 1, of either sign."""
        sign = np.float32(1.0 if rng.random() < 0.5 else -1.0)
        return self._part(self._depth, rng) * sign

    def clumps(self, rng: np.random.Generator) -> NDArray[np.float32]:
        """Correlated as gaps in dark surfaces are, of deviation 1."""
        return self._part(self._clumps, rng)

    def chance(self, rng: np.random.Generator) -> NDArray[np.float32]:
        """Even, in [0, 1)."""
        return self._part(self._chance, rng)

    def _part(self, whole: NDArray[np.float32], rng: np.random.Generator) -> NDArray[np.float32]:
        v, u = rng.integers(_SPARE_PX, size=2)
        part = whole[v : v + self._size[0], u : u + self._size[1]]
        # turned by half a turn or mirrored, it does not come again for thousands of pictures
        flips = rng.integers(2, size=2)
        return part[:: 1 - 2 * int(flips[0]), :: 1 - 2 * int(flips[1])]


def _blurred(noise: NDArray[np.float32], sigma_px: float) -> NDArray[np.float32]:
    if sigma_px <= 0.0:
        return noise
    # blurring by sigma leaves 1 / (2 sqrt(pi) sigma) of white noise's deviation
    blurred = cv2.GaussianBlur(noise, (0, 0), sigma_px) * np.float32(2.0 * np.pi**0.5 * sigma_px)
    return np.asarray(blurred, dtype=np.float32)


def _normal_quantile(share: float) -> float:
    """Of the standard normal distribution, to 5e-4 (Abramowitz and Stegun 26.2.23)."""
    tail = min(share, 1.0 - share)
    t = (-2.0 * np.log(tail)) ** 0.5
    top = 2.515517 + t * (0.802853 + 0.010328 * t)
    value = t - top / (1.0 + t * (1.432788 + t * (0.189269 + 0.001308 * t)))
    return float(value if share > 0.5 else -value)
