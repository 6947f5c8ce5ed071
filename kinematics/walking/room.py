"""How much room a robot takes while it walks straight on, along a path, and turning on the spot.

It is wider where its hands are, and wherever what it holds stands out. Everyone who asks whether there is
room asks here.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.scene import PlanningScene
from kinematics.walking.load import Load
from kinematics.walking.path_planning import Footprint, clearance_m, footprints
from kinematics.walking.planar import PlanarPose
from kinematics.walking.settings import WalkingSettings

Array = NDArray[np.float64]

_SPARE_M = 0.02
"""Left beside the body, at the least, wherever it walks."""


@dataclass(frozen=True, slots=True)
class _Layer:
    """What of the robot meets only things that reach above a height; lengths in m, from between the feet.

    Attributes:
        part: What a person calls it.
        from_m: The height over the floor.
        front_m, back_m, half_width_m: Room that it takes while the robot walks straight on.
        around_m: Room that it takes to all sides while the robot walks along a path.
        turning_m: Radius of the circle in which it goes around when the robot turns on the spot, with sway.
    """

    part: str
    from_m: float
    front_m: float
    back_m: float
    half_width_m: float
    around_m: float
    turning_m: float


@dataclass(frozen=True, slots=True)
class TightSpot:
    """Where a robot that turns has least room.

    Attributes:
        part: What of it: "legs", "body", "hands" or "load".
        room_m: Distance from between the feet to the nearest thing that this meets.
        needed_m: The distance that turning takes.
    """

    part: str
    room_m: float
    needed_m: float

    @property
    def lack_m(self) -> float:
        """How much room is missing; negative where some is left."""
        return self.needed_m - self.room_m


class WalkingRoom:
    """The room that one robot takes, with what it holds just now.

    Attributes:
        widest_m: How much more room than the body the widest part takes to all sides along a path.
    """

    def __init__(self, settings: WalkingSettings, load: Load | None = None) -> None:
        self._body_m = settings.half_width_m
        ends = (settings.front_m, settings.back_m)
        sides = (settings.half_width_m, settings.hands_half_width_m)
        sway_m = settings.sway_m
        self._layers = [
            _Layer("legs", -math.inf, *ends, sides[0], sides[0], settings.legs_radius_m + sway_m),
            _Layer(
                "hands", settings.hands_from_m, *ends, sides[1], sides[1], settings.hands_radius_m + sway_m
            ),
        ]
        if load is not None:
            around_m, from_m = load.radius_m, load.from_m - sway_m
            straight = (load.front_m, load.back_m, load.half_width_m)
            self._layers.append(_Layer("load", from_m, *straight, around_m, around_m + sway_m))
        self._seen_m = self._body_m + _SPARE_M
        self.widest_m = max(layer.around_m for layer in self._layers) - self._body_m

    def free_way_m(self, points: Array, linear_m_s: float) -> float:
        """How far the robot can go straight on before it meets something; infinite if nothing is in its way.

        Args:
            points: What a range sensor sees, in a level frame at the base, x ahead, z up from the floor,
                shape (n, 3).
            linear_m_s: Its sign tells which way it goes.
        """
        forward = linear_m_s >= 0.0
        ahead = points[:, 0] if forward else -points[:, 0]
        free_m = math.inf
        for layer in self._layers:
            own_m = layer.front_m if forward else layer.back_m
            meets = (points[:, 2] >= layer.from_m) & (np.abs(points[:, 1]) <= layer.half_width_m)
            free_m = min(free_m, float(np.min(ahead[meets & (ahead > 0.0)] - own_m, initial=math.inf)))
        return free_m

    def footprints(self, scene: PlanningScene, more_m: float = 0.0) -> tuple[Footprint, ...]:
        """What things take of the floor for a path of the body: more where they meet a wider part of it.

        Args:
            scene: What is believed.
            more_m: Room that what meets the hands or the load takes besides.
        """
        wider = [(layer.from_m, layer.around_m - self._body_m + more_m) for layer in self._layers[1:]]
        return footprints(scene, wider)

    def tightest(self, scene: PlanningScene, body: PlanarPose, at_ease: bool = False) -> TightSpot:
        """Where there is least room to turn at a place.

        Args:
            scene: What is believed, low things included that a range sensor looks above.
            body: The place, in the scene's frame.
            at_ease: Keep from low things what a walk keeps from them, for whoever can choose a place
                with more room; else only what the legs need.
        """
        spots = []
        for layer in self._layers:
            needed_m = layer.turning_m
            if at_ease:
                needed_m = max(needed_m, self._seen_m)
            meets = footprints(scene, above_m=layer.from_m)
            spots.append(TightSpot(layer.part, clearance_m(meets, body), needed_m))
        return max(spots, key=lambda spot: spot.lack_m)

    def tightest_seen(self, points: Array) -> TightSpot:
        """Where there is least room to turn right here, by what is seen and may be known to nobody.

        Args:
            points: As for ``free_way_m``; what is seen low may reach up to the elbows.
        """
        away_m = np.hypot(points[:, 0], points[:, 1])
        spots = [TightSpot("body", float(away_m.min(initial=math.inf)), self._seen_m)]
        for layer in self._layers[1:]:
            meets = points[:, 2] >= layer.from_m
            spots.append(TightSpot(layer.part, float(away_m[meets].min(initial=math.inf)), layer.turning_m))
        return max(spots, key=lambda spot: spot.lack_m)
