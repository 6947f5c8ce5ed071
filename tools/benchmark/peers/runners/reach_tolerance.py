"""When a whole-body reach is reached: the same residuals for every peer."""

from __future__ import annotations

from typing import Any

import numpy as np
from line_protocol import Document


class Tolerance:
    """Residuals that an answer may have, from the question that loads the robot."""

    def __init__(self, question: Document) -> None:
        self._position_m = question["position_m"]
        self._orientation_rad = question["orientation_rad"]
        normals_and_offsets = np.array(question["support"])
        self._normals, self._offsets = normals_and_offsets[:, :2], normals_and_offsets[:, 2]

    def holds(self, errors: list[Any], com: Any) -> bool:
        """Judge frame errors, each (6,) with the translation first, and the CoM over the support polygon."""
        for error in errors:
            moved, turned = float(np.linalg.norm(error[:3])), float(np.linalg.norm(error[3:]))
            if moved > self._position_m or turned > self._orientation_rad:
                return False
        return bool(np.all(self._normals @ com[:2] <= self._offsets))
