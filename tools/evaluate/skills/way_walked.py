"""How far the robot really went."""

from __future__ import annotations

import math

from executive.session.assembly import Assembly
from kinematics.geometry.planar import PlanarPose

_EVERY = 50


def feet_of(assembly: Assembly) -> PlanarPose:
    """Where the middle between the feet truly is."""
    physics = assembly.world.physics
    soles = []
    for body in physics.sole_body:
        x, y = physics.data.xpos[body][:2]
        R = physics.data.xmat[body].reshape(3, 3)
        soles.append(PlanarPose(float(x), float(y), math.atan2(R[1, 0], R[0, 0])))
    return PlanarPose.between(*soles)


class WayWalked:
    """Adds up the way; ``on_period`` is called after each control period.

    Attributes:
        length_m: Of the way so far.
    """

    def __init__(self, assembly: Assembly) -> None:
        self._assembly, self._last, self._periods = assembly, feet_of(assembly), 0
        self.length_m = 0.0

    def on_period(self) -> None:
        """Measure from time to time: the middle between the feet sways with each step."""
        self._periods += 1
        if self._periods % _EVERY == 0:
            now = feet_of(self._assembly)
            self.length_m += now.distance_m(self._last)
            self._last = now
