"""Suite of walking to something: a goal some metres away, and things in the way."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import partial

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.geometry.planar import PlanarPose, wrapped
from kinematics.geometry.shapes import Cylinder
from kinematics.walking.route.path_planning import clearance_m, footprints, plan_path
from robots.errors import SceneError
from robots.scenes.articulated import ARTICULATED_KINDS, GAP_M, PANEL_M
from robots.scenes.furniture import floor_pose
from robots.scenes.scene_description import (
    Furniture,
    MovingPart,
    Person,
    RobotStart,
    SceneDescription,
    SceneItem,
)
from robots.scenes.scene_file import read_scene
from robots.scenes.scene_solids import planning_scene
from robots.scenes.scene_writer import dump
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import Figure, SkillSuite, Trial, Verdict
from tools.evaluate.skills.way_walked import WayWalked, feet_of
from trees.events import Measured
from trees.skills.walking.standing_place import PERSON_M, edge_m
from trees.tasks import ObjectDescription, WalkToTask

FAR_M = (1.0, 6.0)
"""From the start to where the robot is to stand."""
BEARING_RAD = math.radians(60.0)
OBSTACLES = 4
FREE_AT_START_M = 0.95
FREE_AT_GOAL_M = 0.95
WAY_M = 0.72
"""Obstacles leave a way that is so far from all of them."""
_TALL_M, _HANDS_M = 1.0, 0.20
"""Hands stand out farther than all else, by so much, above so much."""
OFF_M = 0.02
OFF_RAD = math.radians(2.0)
Sizes = Mapping[str, tuple[tuple[float, float], ...]]
"""Depths, widths and heights of pieces, by kind: the least and the most."""

_SIZES: Sizes = {
    "drawers": ((0.40, 0.50), (0.50, 0.80), (0.75, 0.95)),
    "fridge": ((0.60, 0.68), (0.56, 0.64), (1.50, 1.80)),
    "table": ((0.50, 0.80), (0.80, 1.50), (0.72, 0.95)),
}
_LOW_SIZES: Sizes = {
    **_SIZES,
    "drawers": ((0.40, 0.50), (0.50, 0.80), (0.60, 0.76)),
    "table": ((0.50, 0.80), (0.80, 1.50), (0.60, 0.76)),
}
"""For a humanoid of a child's size."""


class GoalJudge:
    """Measures how far the robot stands from its place in front of what it was sent to."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._assembly, self._scene, self._aim = assembly, trial.scene, trial.aim
        self._start = feet_of(assembly)
        self._way = WayWalked(assembly)
        self._chosen = PlanarPose()

    def on_event(self, event: object) -> None:
        """Note the place beside the usual one that the robot has chosen for an object."""
        if isinstance(event, Measured) and event.where.endswith("choose where to stand"):
            x, y, yaw = (float(event.numbers[key]) for key in ("ahead_m", "aside_m", "turned_rad"))
            self._chosen = PlanarPose(x, y, yaw)

    def on_period(self) -> None:
        """Add up the way that was walked."""
        self._way.on_period()

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """Within two centimetres and two degrees of the nearest place that there is."""
        feet = feet_of(self._assembly)
        off = [place.to(feet) for place in self._places(feet)]
        left = min(off, key=lambda one: math.hypot(one.x_m, one.y_m))
        off_m, off_rad = math.hypot(left.x_m, left.y_m), abs(wrapped(left.yaw_rad))
        done = off_m <= OFF_M and off_rad <= OFF_RAD
        numbers: dict[str, Figure] = {
            "aim": self._aim,
            "off_m": off_m,
            "off_deg": math.degrees(off_rad),
            "goal_m": min(self._start.distance_m(place) for place in self._places(self._start)),
            "walked_m": self._way.length_m,
            "took_s": results[-1].times.simulated_s,
        }
        why = "" if done else f"{100 * off_m:.1f} cm and {math.degrees(off_rad):.1f} degrees from its place"
        return Verdict(done, numbers, why)

    def _places(self, feet: PlanarPose) -> list[PlanarPose]:
        """Where one may stand: at the middle of each side, level with a thing, or before a person."""
        scene = self._scene
        for person in scene.people:
            if person.name == self._aim:
                x, y = person.position_m
                heading = math.atan2(y - feet.y_m, x - feet.x_m)
                return [PlanarPose(x, y, heading) @ PlanarPose(-PERSON_M)]
        item = next((item for item in scene.objects if item.name == self._aim), None)
        pieces = {piece.name: piece for piece in scene.furniture}
        piece = pieces["table"] if item is not None else pieces[self._aim]
        middle = PlanarPose.of(floor_pose(piece))
        at = PlanarPose()
        if item is not None:
            at = middle.to(PlanarPose(*(float(value) for value in item.world_T_object[:2, 3])))
        half_x, half_y = 0.5 * piece.size_m[0], 0.5 * piece.size_m[1]
        away_m = edge_m(piece.size_m[2])
        door_m = PANEL_M + GAP_M if piece.kind == "fridge" else 0.0  # what it shuts is what is walked to
        usual = [
            middle @ PlanarPose(door_m - half_x - away_m, at.y_m, 0.0),
            middle @ PlanarPose(half_x + away_m, at.y_m, math.pi),
            middle @ PlanarPose(at.x_m, -half_y - away_m, 0.5 * math.pi),
            middle @ PlanarPose(at.x_m, half_y + away_m, -0.5 * math.pi),
        ]
        return [place @ self._chosen for place in usual]


def goal_trial(rng: np.random.Generator, sizes: Sizes = _SIZES) -> Trial:
    """Somewhere to go, with up to four things in the way."""
    count = int(rng.integers(0, OBSTACLES + 1))
    for _ in range(5000):
        found = _trial(rng, count, sizes)
        if found is not None:
            return found
    raise RuntimeError("no room could be made")


def _trial(rng: np.random.Generator, count: int, sizes: Sizes) -> Trial | None:
    x, y, yaw = (float(value) for value in rng.uniform((-1.0, -1.0, -math.pi), (1.0, 1.0, math.pi)))
    start = PlanarPose(x, y, yaw)
    bearing, far = float(rng.uniform(-BEARING_RAD, BEARING_RAD)), float(rng.uniform(*FAR_M))
    turn = float(rng.uniform(-0.9, 0.9))
    goal = start @ PlanarPose(yaw_rad=bearing) @ PlanarPose(far, 0.0, turn)
    kind = ("table", "thing", "person", "fridge", "drawers")[
        int(rng.choice(5, p=(0.3, 0.2, 0.2, 0.15, 0.15)))
    ]
    furniture: list[Furniture] = []
    people: list[Person] = []
    objects: list[SceneItem] = []
    aim = kind
    if kind == "person":
        aim = rooms.NAMES[0]
        at = goal @ PlanarPose(PERSON_M)
        people.append(Person(aim, (at.x_m, at.y_m), at.yaw_rad + math.pi))
    else:
        piece = _piece("table" if kind == "thing" else kind, goal, rng, sizes)
        furniture.append(piece)
        if kind == "thing":
            aim = "red cup"
            middle = PlanarPose.of(floor_pose(piece))
            across = 0.5 * piece.size_m[1] - 0.25
            spot = middle @ PlanarPose(0.1 - 0.5 * piece.size_m[0], float(rng.uniform(-across, across)))
            cup = Cylinder(0.03, 0.11)
            objects.append(rooms.item(aim, "cup", "red", cup, piece, (spot.x_m, spot.y_m), rng))
    others = [one for one in sizes if all(one != piece.kind for piece in furniture)]
    others += rooms.NAMES[1:]
    for one in (others[int(k)] for k in rng.permutation(len(others))[:count]):
        along, aside = float(rng.uniform(0.1, 1.2)), float(rng.normal(0.0, 0.8))
        at = (
            start
            @ PlanarPose(yaw_rad=bearing)
            @ PlanarPose(along * far, aside, float(rng.uniform(-3.1, 3.1)))
        )
        if one in sizes:
            furniture.append(_piece(one, at, rng, sizes))
        else:
            people.append(Person(one, (at.x_m, at.y_m), at.yaw_rad))
    robot = RobotStart(start.x_m, start.y_m, start.yaw_rad)
    scene = SceneDescription(
        "walk_to", robot, furniture=tuple(furniture), objects=tuple(objects), people=tuple(people)
    )
    try:
        scene = read_scene(dump(scene), "episode walk_to", "walk_to")
    except SceneError:
        return None
    if not _passable(scene, start, goal, 1 if kind == "person" else 0):
        return None
    if kind == "thing":
        to: str | ObjectDescription = ObjectDescription("cup", "red")
    else:
        to = aim
    return Trial(scene, (WalkToTask(f"walk to the {aim}", to),), aim)


def _piece(kind: str, before: PlanarPose, rng: np.random.Generator, sizes: Sizes) -> Furniture:
    """Furniture whose front's middle is in front of where the robot stands."""
    depth, width, height = (float(rng.uniform(*span)) for span in sizes[kind])
    middle = before @ PlanarPose(edge_m(height) + 0.5 * depth)
    opens = None
    if kind in ARTICULATED_KINDS:
        opens = MovingPart("left" if kind == "fridge" else None, 10.0, 2.0, handle_height_m=0.0)
        if kind == "fridge":
            opens = MovingPart("left", 14.0, 2.0, 30.0)
    return Furniture(kind, kind, (depth, width, height), (middle.x_m, middle.y_m), middle.yaw_rad, 0.7, opens)


def _passable(scene: SceneDescription, start: PlanarPose, goal: PlanarPose, people_aimed_at: int) -> bool:
    """Whether there is room at both ends, and a way between them."""
    everything = footprints(planning_scene(scene), [(_TALL_M, _HANDS_M)])
    if clearance_m(everything, start) < FREE_AT_START_M:
        return False
    aim_count = 1 - people_aimed_at
    rest = SceneDescription(
        scene.name, furniture=scene.furniture[aim_count:], people=scene.people[people_aimed_at:]
    )
    if clearance_m(footprints(planning_scene(rest), [(_TALL_M, _HANDS_M)]), goal) < FREE_AT_GOAL_M:
        return False
    before = goal @ PlanarPose(-0.5)
    return plan_path(start, before, everything, WAY_M) is not None


WALK_TO = SkillSuite(goal_trial, GoalJudge, stands=False, on_low=partial(goal_trial, sizes=_LOW_SIZES))
