"""Memory that problems of one robot are laid out in, one after the other.

The robot's hulls are most of a problem. They stay in memory that was used before, and neither they nor the
rest of a megabyte are fetched anew for each scene that is judged.
"""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array, Indices

# Sizes are rounded up to multiples of this, so that a scene with one thing more fits as well.
_ROUND = 16384
# A plan has a few judges at a time.
_KEPT = 8


class Buffers:
    """Hands out memory that begins with the robot's hulls, and takes it back.

    Args:
        hulls: What all memory for floats begins with.
    """

    def __init__(self, hulls: Array) -> None:
        self._hulls = hulls
        self._spare: list[tuple[Array, Indices]] = []
        self._most = _KEPT  # asked for when the interpreter has given up its modules, too

    def take(self, floats: int, ints: int) -> tuple[Array, Indices]:
        """Memory for as many numbers at least; behind the hulls it holds anything."""
        if self._spare:
            found = self._spare.pop()
            if len(found[0]) >= floats and len(found[1]) >= ints:
                return found
        memory = np.empty(_rounded(floats)), np.empty(_rounded(ints), np.int64)
        memory[0][: len(self._hulls)] = self._hulls
        return memory

    def give_back(self, floats: Array, ints: Indices) -> None:
        """Nobody uses it any longer."""
        if len(self._spare) < self._most:
            self._spare.append((floats, ints))


def _rounded(count: int) -> int:
    return -(-count // _ROUND) * _ROUND
