"""How much room a robot takes while it walks straight on, along a path, and turning on the spot.

It is wider where its hands are, and wherever what it holds stands out. Everyone who asks whether there is
room asks here; so does who asks how far a robot that is told to stop goes on.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.planar import PlanarPose
from kinematics.model.walking_settings import WalkingSettings
from kinematics.scene.planning_scene import PlanningScene
from kinematics.walking.route.load import Load
from kinematics.walking.route.path_planning import Footprint, clearance_m, footprints

_SPARE_M = 0.02
"""Left beside the body, at the least, wherever it walks."""
BESIDE_HANDS_M = 0.06
"""Left beside an empty hand on a walk, where there is a choice."""
_TURNED_RAD = 0.05
"""Between two headings of a turn: less than a hand's breadth for the farthest hand."""
_OUTLINE_M = 0.02
"""Between two points of an outline: no edge of a door fits between them."""


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
        tucked: Whether the arms that hold nothing are drawn in.
        can_tuck: Whether they are not, and can be.
    """

    def __init__(self, settings: WalkingSettings, load: Load | None = None, tucked: bool = False) -> None:
        """Take the room of a robot.

        Args:
            settings: Its sizes.
            load: What it holds, with the hands that hold it.
            tucked: Whether the arms that hold nothing are drawn in.
        """
        self._settings, self._load = settings, load
        self._body_m = body_m = settings.half_width_m
        ends, sway_m = (settings.front_m, settings.back_m), settings.sway_m
        sides = settings.hands_half_width_m
        hands = _Layer("hands", settings.hands_from_m, *ends, sides, sides, settings.hands_radius_m + sway_m)
        arms = settings.tucked
        self.tucked, self.can_tuck = tucked, arms is not None and not tucked
        self._seen_m = body_m + _SPARE_M
        if tucked and arms is not None:
            straight_m = (arms.front_m, settings.back_m, arms.half_width_m)
            hands = _Layer("hands", arms.from_m, *straight_m, body_m, arms.radius_m + sway_m)
            self._seen_m = arms.radius_m + sway_m + _SPARE_M
        legs = _Layer("legs", -math.inf, *ends, body_m, body_m, settings.legs_radius_m + sway_m)
        self._layers = [legs, hands]
        self._hands = hands
        self._load_layer: _Layer | None = None
        if load is not None:
            around_m, from_m = load.radius_m, load.from_m - sway_m
            straight = (load.front_m, load.back_m, load.half_width_m)
            self._load_layer = _Layer("load", from_m, *straight, around_m, around_m + sway_m)
            self._layers.append(self._load_layer)
        self.widest_m = max(layer.around_m for layer in self._layers) - self._body_m

    def either_way(self) -> tuple[WalkingRoom, WalkingRoom]:
        """The room that it takes with its empty hands at home, and with its arms drawn in."""
        return WalkingRoom(self._settings, self._load), WalkingRoom(self._settings, self._load, tucked=True)

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

    def hands_meet(
        self, scene: PlanningScene, way: Sequence[PlanarPose], spare_m: float = BESIDE_HANDS_M
    ) -> bool:
        """Whether an empty hand comes to something where the body goes and turns.

        Args:
            scene: What is believed.
            way: Where the body comes by, in the scene's frame, a hand's breadth apart.
            spare_m: Left beside the hands.
        """
        return self._meets(self._hands, scene, way, spare_m)

    def hands_meet_seen(self, points: Array, way: Sequence[PlanarPose], spare_m: float) -> bool:
        """The same of what was seen and may be known to nobody.

        Args:
            points: Where something as tall as the hands was seen, in the scene's frame, shape (n, 2).
            way, spare_m: As for ``hands_meet``.
        """
        hands, around_m = self._hands, self._hands.turning_m - self._settings.sway_m + spare_m
        middles = np.array([(body.x_m, body.y_m) for body in way])
        if not len(points):
            return False
        apart = points[None, :, :] - middles[:, None, :]
        near = np.hypot(apart[..., 0], apart[..., 1]) <= around_m
        which, _ = np.nonzero(near)
        yaw = np.array([body.yaw_rad for body in way])[which]
        east, north = apart[near].T
        ahead, aside = np.cos(yaw) * east + np.sin(yaw) * north, np.cos(yaw) * north - np.sin(yaw) * east
        inside = (ahead <= hands.front_m + spare_m) & (ahead >= -hands.back_m - spare_m)
        return bool(np.any(inside & (np.abs(aside) <= hands.half_width_m + spare_m)))

    def load_meets(self, scene: PlanningScene, way: Sequence[PlanarPose], spare_m: float = 0.0) -> bool:
        """Whether what is held comes to furniture that stands higher, where the body goes and turns.

        What stands on furniture is left to who puts something down there. Arguments as for ``hands_meet``.
        """
        if self._load_layer is None:
            return False
        furniture = scene.with_objects(item for item in scene.objects.values() if not item.movable)
        return self._meets(self._load_layer, furniture, way, spare_m)

    def _meets(self, layer: _Layer, scene: PlanningScene, way: Sequence[PlanarPose], spare_m: float) -> bool:
        around_m = math.hypot(max(layer.front_m, layer.back_m), layer.half_width_m) + spare_m
        middles = np.array([(body.x_m, body.y_m) for body in way])
        beside = [
            obstacle
            for obstacle in footprints(scene, above_m=layer.from_m)
            if float(obstacle.distance_m(middles).min()) <= around_m
        ]
        if not beside:
            return False
        outline = _outline(layer, layer.turning_m - self._settings.sway_m)
        c, s = np.cos([body.yaw_rad for body in way]), np.sin([body.yaw_rad for body in way])
        x = middles[:, :1] + np.outer(c, outline[:, 0]) - np.outer(s, outline[:, 1])
        y = middles[:, 1:] + np.outer(s, outline[:, 0]) + np.outer(c, outline[:, 1])
        points = np.column_stack([x.ravel(), y.ravel()])
        return any(float(obstacle.distance_m(points).min()) <= spare_m for obstacle in beside)

    def hands_turn(self, scene: PlanningScene, body: PlanarPose, spare_m: float = 0.0) -> bool:
        """Whether the hands have room to turn on the spot at a place.

        Args:
            scene: What is believed.
            body: The place, in the scene's frame.
            spare_m: Left beside them besides the sway of a walk; less than that where it is negative.
        """
        tall = footprints(scene, above_m=self._hands.from_m)
        return clearance_m(tall, body) >= self._hands.turning_m + spare_m

    def turn_meets(self, points: Array, turn_rad: float, spare_m: float = _SPARE_M) -> str | None:
        """What of the robot comes to something as it turns on the spot; None where all of it has room.

        Args:
            points: As for ``free_way_m``.
            turn_rad: How far it turns, positive to the left.
            spare_m: Left beside it, besides its sway.
        """
        away_m = np.hypot(points[:, 0], points[:, 1])
        count = 1 + math.ceil(abs(turn_rad) / _TURNED_RAD)
        turned = np.arctan2(points[:, 1], points[:, 0])[:, None] - np.linspace(0.0, turn_rad, count)
        for layer in self._layers[1:]:
            near = (points[:, 2] >= layer.from_m) & (away_m <= layer.turning_m + spare_m)
            x, y = away_m[near, None] * np.cos(turned[near]), away_m[near, None] * np.sin(turned[near])
            beside_m = self._settings.sway_m + spare_m
            ahead = (x <= layer.front_m + beside_m) & (x >= -layer.back_m - beside_m)
            if bool(np.any(ahead & (np.abs(y) <= layer.half_width_m + beside_m))):
                return layer.part
        return None

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


def _outline(layer: _Layer, radius_m: float) -> Array:
    """Points around what a layer takes, a rectangle without what is outside of a circle; (n, 2), x ahead."""
    ahead = np.linspace(-layer.back_m, layer.front_m, _count(layer.back_m + layer.front_m))
    aside = np.linspace(-layer.half_width_m, layer.half_width_m, _count(2.0 * layer.half_width_m))
    ends = [np.column_stack([np.full_like(aside, x), aside]) for x in (-layer.back_m, layer.front_m)]
    out_m = layer.half_width_m
    sides = [np.column_stack([ahead, np.full_like(ahead, y)]) for y in (-out_m, out_m)]
    points: Array = np.concatenate(ends + sides)
    inside: Array = np.minimum(1.0, radius_m / np.hypot(points[:, 0], points[:, 1]))
    return points * inside[:, None]


def _count(length_m: float) -> int:
    return math.ceil(length_m / _OUTLINE_M) + 1


_REACTION_S = 0.2
"""From a reading to the stop: readings are a tenth of a second apart, the tree ticks at 50 Hz."""
_ROOM_M = 0.05


def stopping_distance_m(settings: WalkingSettings, linear_m_s: float) -> float:
    """How far a robot at this speed may still go after it was told to stop, with some room.

    Two steps at most: the one that is under way and the one that closes the feet, which brings the body on
    by half as much again.
    """
    return abs(linear_m_s) * (_REACTION_S + 1.5 * settings.step_s) + _ROOM_M


def stopping_turn_rad(settings: WalkingSettings, angular_rad_s: float) -> float:
    """How far a robot at this turning speed may still turn after it was told to stop, with some room."""
    return abs(angular_rad_s) * (_REACTION_S + 1.5 * settings.step_s) + _TURNED_RAD
