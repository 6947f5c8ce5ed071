"""Pictures made by rule, and boxes in them."""

import cv2
import numpy as np
import pytest

from robots.perception.labels.labeller import Boxes
from robots.perception.labels.views import view_of

PLACES = ((20, 20, 80, 140), (120, 30, 180, 150), (220, 25, 280, 145))


def package(seed):
    """The front of a package, 120 high and 60 wide."""
    rng = np.random.default_rng(seed)
    image = np.empty((120, 60, 3), np.uint8)
    image[:] = rng.integers(30, 240, 3)
    image[40:80] = rng.integers(30, 240, 3)
    for _ in range(8):
        x, y = rng.integers(5, 55), rng.integers(5, 115)
        cv2.circle(image, (int(x), int(y)), int(rng.integers(4, 12)), rng.integers(0, 255, 3).tolist(), -1)
    return image


def table(*packages, noise=0.0, seed=0):
    """A picture with packages side by side, and the boxes around them."""
    image = np.full((200, 300, 3), 150, np.uint8)
    pieces = np.zeros((200, 300), np.int32)
    for k, front in enumerate(packages):
        left, top, right, bottom = PLACES[k]
        image[top:bottom, left:right] = front
        pieces[top:bottom, left:right] = k + 1
    rough = np.random.default_rng(seed).normal(0.0, 1.0, image.shape) * noise
    spoiled = np.clip(image + rough, 0, 255).astype(np.uint8)
    return spoiled, Boxes(np.array(PLACES[: len(packages)]), pieces)


def views(*packages):
    return [view_of(*table(front), 0) for front in packages]


@pytest.fixture
def gallery():
    return {name: views(package(k)) for k, name in enumerate(("beans", "soup", "tea"))}
