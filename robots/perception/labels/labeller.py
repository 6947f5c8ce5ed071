"""The seam by which things get names: whoever can tell what boxes of a picture show."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64

Image = NDArray[np.uint8]


@dataclass(frozen=True, slots=True)
class Boxes(InFloat64):
    """Parts of a picture that show one thing each.

    Attributes:
        places: First column and row, and those after the last, shape (k, 4).
        pieces: Of each pixel the number of the box whose thing it shows, from 1 on; 0 is none; shape
            (height, width).
    """

    places: NDArray[np.int64]
    pieces: NDArray[np.int32]

    def __len__(self) -> int:
        return len(self.places)

    def mask(self, k: int) -> NDArray[np.bool_]:
        """Which pixels of a box show its thing."""
        left, top, right, bottom = self.places[k].tolist()
        return np.asarray(self.pieces[top:bottom, left:right] == k + 1)


class Labeller(Protocol):
    """Tells what boxes of a picture show."""

    @property
    def words(self) -> frozenset[str] | None:
        """The words that it can tell; None: any that it is asked for."""
        ...

    @property
    def trouble(self) -> str:
        """Why it could tell nothing when it was asked last; empty else."""
        ...

    def scores(self, image: Image, boxes: Boxes, words: Sequence[str]) -> Array:
        """How well each word fits what each box shows.

        Args:
            image: Red, green, blue as in daylight, shape (height, width, 3).
            boxes: Where the things are.
            words: What is asked for.

        Returns:
            In [0, 1], shape (k, number of words); of what gets 0.9, nine of ten are right. The scores of a
            box need not add up to 1.
        """
        ...
