"""Pictures as they are on packages, made by rule from a seed: bands, shapes, and letters."""

from __future__ import annotations

import cv2
import numpy as np

from robots.perception.rgbd.picture import Colors

WIDTH_PX, HEIGHT_PX = 384, 320
_FONTS = (
    cv2.FONT_HERSHEY_SIMPLEX,
    cv2.FONT_HERSHEY_DUPLEX,
    cv2.FONT_HERSHEY_TRIPLEX,
    cv2.FONT_HERSHEY_SCRIPT_COMPLEX,
)
_LETTERS = "ABCDEFGHIKLMNOPRSTUVWXYZ"


def made_picture(seed: int) -> Colors:
    """The picture of a seed, shape (HEIGHT_PX, WIDTH_PX, 3)."""
    rng = np.random.default_rng([seed, 4711])
    ground, band, ink, accent = _palette(rng)
    image = np.empty((HEIGHT_PX, WIDTH_PX, 3), np.uint8)
    image[:] = ground
    top, bottom = sorted((rng.uniform(0.05, 0.95, 2) * HEIGHT_PX).astype(int).tolist())
    if bottom - top > 30:
        image[top:bottom] = band
    _shapes(image, rng, (ink, accent))
    _words(image, rng, (ink, accent, band))
    return image


def _palette(rng: np.random.Generator) -> list[tuple[int, int, int]]:
    """Four colours that are apart in brightness or hue; some packages share their main colour."""
    hues = (rng.uniform(0, 180) + np.array([0.0, rng.uniform(15, 90), 90.0, rng.uniform(100, 165)])) % 180
    saturation, value = rng.uniform(60, 240, 4), rng.uniform(50, 250, 4)
    if rng.random() < 0.3:
        saturation[0], value[0] = 15.0, 240.0
    hsv = np.column_stack([hues, saturation, value]).astype(np.uint8)[None]
    rgb = cv2.cvtColor(hsv, cv2.COLOR_HSV2RGB)[0]
    return [(int(r), int(g), int(b)) for r, g, b in rgb]


def _shapes(image: Colors, rng: np.random.Generator, colors: tuple[tuple[int, int, int], ...]) -> None:
    for _ in range(int(rng.integers(4, 10))):
        x, y = (rng.uniform(0.05, 0.95, 2) * (WIDTH_PX, HEIGHT_PX)).astype(int).tolist()
        size = int(rng.integers(18, 60))
        color = colors[int(rng.integers(len(colors)))]
        match int(rng.integers(4)):
            case 0:
                cv2.circle(image, (x, y), size // 2, color, -1 if rng.random() < 0.6 else 6, cv2.LINE_AA)
            case 1:
                cv2.rectangle(image, (x, y), (x + size, y + int(rng.integers(12, 60))), color, -1)
            case 2:
                corners = (np.array([x, y]) + rng.uniform(-size, size, (3, 2))).astype(np.int32)
                cv2.fillConvexPoly(image, corners, color, cv2.LINE_AA)
            case _:
                turn, half = float(rng.uniform(0, 180)), (size, max(6, size // 3))
                cv2.ellipse(image, (x, y), half, turn, 0, 360, color, -1, cv2.LINE_AA)


def _words(image: Colors, rng: np.random.Generator, colors: tuple[tuple[int, int, int], ...]) -> None:
    for _ in range(int(rng.integers(2, 5))):
        word = "".join(_LETTERS[int(i)] for i in rng.integers(0, len(_LETTERS), int(rng.integers(2, 7))))
        font = _FONTS[int(rng.integers(len(_FONTS)))]
        place = int(rng.uniform(0.0, 0.6) * WIDTH_PX), int(rng.uniform(0.15, 0.95) * HEIGHT_PX)
        color = colors[int(rng.integers(len(colors)))]
        cv2.putText(
            image,
            word,
            place,
            font,
            float(rng.uniform(1.0, 2.6)),
            color,
            int(rng.integers(2, 7)),
            cv2.LINE_AA,
        )
