"""Places to stand for a pick, with a reachability map and without: which ones serve, by planning alone.

    python -m tools.robot_data.standing_places --episodes 60 --seed 500

Random tables of 0.4 to 1.1 m, some beside a wall, with up to six things on them, and open fridges with a
bottle on a board. Each place is asked about as ``choose where to stand`` does it: has a pick a plan there?
"""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.planning.pick_planner import PickPlanner
from kinematics.requests.pick import PickRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.scene.support_of import top_m
from kinematics.walking.route.path_planning import footprints
from kinematics.walking.route.room import WalkingRoom
from robots.models.description import load_description
from robots.scenes.scene_description import Furniture, MovingPart, SceneDescription
from robots.scenes.scene_solids import planning_scene
from trees.beliefs.grounding.destination import Place
from trees.skills.walking.reachable_standing import StandingRoom, places_about, sees, stance_of
from trees.skills.walking.standing_place import standing_place

THING = "thing"
KINDS = ("table", "beside a wall", "fridge")
MOST = 40
"""Places that are asked about in each order."""
_GAP_M = 0.05


@dataclass(slots=True)
class Count:
    """Of one kind of scene and one order.

    Attributes:
        scenes: In which there was a place with room and sight.
        asked: Places that were asked about, ``MOST`` at most in each.
        served: Those from which a pick had a plan.
        first: Scenes in which the first place served.
        found: Scenes in which one of them did.
    """

    scenes: int = 0
    asked: int = 0
    served: int = 0
    first: int = 0
    found: int = 0


def random_scene(kind: str, rng: np.random.Generator) -> PlanningScene:
    """Furniture 2 m ahead with the thing, and others, on it."""
    if kind == "fridge":
        return _fridge(rng)
    height, depth, width = (float(v) for v in rng.uniform((0.4, 0.3, 0.5), (1.1, 1.0, 1.6)))
    top = Box((depth, width, 0.04))
    items = [SceneObject("table", top, poses.translation(2.0, 0.0, height - 0.02), movable=False)]
    for k in range(int(rng.integers(1, 7))):
        radius, tall = (float(v) for v in rng.uniform((0.025, 0.08), (0.038, 0.20)))
        deep = float(rng.uniform(0.06, min(depth - 0.06, 0.6)))
        aside = float(rng.uniform(0.06 - 0.5 * width, 0.5 * width - 0.06))
        place = poses.translation(2.0 - 0.5 * depth + deep, aside, height + 0.5 * tall + 0.001)
        apart = all(math.dist(place[:2, 3], one.world_T_object[:2, 3]) > 0.1 for one in items[1:])
        if apart:
            items.append(SceneObject(f"other {k}" if k else THING, Cylinder(radius, tall), place))
    if kind == "beside a wall":
        side = (0.5 * width + float(rng.uniform(0.1, 0.7))) * (1.0 if rng.random() < 0.5 else -1.0)
        wall = Box((1.4, 0.1, 2.0))
        items.append(SceneObject("wall", wall, poses.translation(1.7, side, 1.0), movable=False))
    return PlanningScene().with_objects(items)


def _fridge(rng: np.random.Generator) -> PlanningScene:
    depth, width, height = (float(v) for v in rng.uniform((0.60, 0.56, 1.5), (0.68, 0.64, 1.8)))
    opening = math.radians(float(rng.uniform(65.0, 75.0)))
    door = MovingPart("left" if rng.random() < 0.5 else "right", 14.0, 2.0, 30.0, opening=opening)
    piece = Furniture("fridge", "fridge", (depth, width, height), (2.0, 0.0), 0.0, 0.7, door)
    scene = planning_scene(SceneDescription("fridge", furniture=(piece,)))
    boards = [item for name, item in scene.objects.items() if "shelf" in name]
    board = max(boards, key=top_m)
    tall = float(rng.uniform(0.15, 0.20))
    x, y, _ = board.world_T_object[:3, 3].tolist()
    size_x, size_y, _ = board.shape.size_m if isinstance(board.shape, Box) else (0.4, 0.4, 0.0)
    deep, aside = float(rng.uniform(0.06, 0.18)), float(rng.uniform(-0.5, 0.5)) * (size_y - 0.2)
    place = poses.translation(x - 0.5 * size_x + deep, y + aside, top_m(board) + 0.5 * tall + 0.001)
    thing = SceneObject(THING, Cylinder(float(rng.uniform(0.028, 0.036)), tall), place)
    return scene.with_objects([*scene.objects.values(), thing])


class Comparison:
    """Asks a planner about the places of both orders."""

    def __init__(self, robot: str) -> None:
        """Load a robot that walks and has a map.

        Raises:
            ValueError: It does not, or it has none.
        """
        self._model = RobotModel(load_description(robot))
        description = self._model.description
        if description.walking is None or description.reachability is None:
            raise ValueError(f"{robot} does not walk, or has no reachability map")
        self._settings, self._known = description.walking, description.reachability
        self._planner = PickPlanner(self._model)
        self._stance = stance_at(self._model, self._model.q_home)
        soles = [PlanarPose.of(sole) for _, sole in self._stance.soles]
        self._here = PlanarPose.between(soles[0], soles[-1])
        self._eye_m = float(self._model.frame_pose(self._model.q_home, description.camera.frame)[2, 3])

    def count(self, scene: PlanningScene, seed: int, counts: dict[bool, Count]) -> None:
        """Ask about the places in both orders; ``counts`` are those with the map and without."""
        answers: dict[PlanarPose, bool] = {}
        for mapped, count in counts.items():
            places = list(islice(self._places(scene, mapped), MOST))
            for place in places:
                if place not in answers:
                    answers[place] = self._serves(place, scene, seed)
            served = [answers[place] for place in places]
            count.scenes += bool(places)
            count.asked += len(places)
            count.served += sum(served)
            count.first += any(served[:1])
            count.found += any(served)

    def _places(self, scene: PlanningScene, mapped: bool) -> Iterator[PlanarPose]:
        thing, known = scene.objects[THING], self._known
        x, y, z = (float(value) for value in thing.world_T_object[:3, 3])
        place = Place(THING, "object", thing.shape, thing.world_T_object, z)
        usual = standing_place(place, scene, PlanarPose(), _GAP_M, WalkingRoom(self._settings))
        others = scene.without_object(THING)
        about, above = footprints(others), footprints(others, above_m=self._settings.hands_from_m)
        hands = tuple(self._model.description.grippers)

        def reach(body: PlanarPose) -> float:
            return known.best_from(body, hands, (x, y, z))

        places = places_about(usual, (x, y), reach=reach if mapped else None)
        stands = filter(StandingRoom(usual, about, above, self._settings).has, places)
        return (stand for stand in stands if sees(stand, self._eye_m, thing, scene))

    def _serves(self, body: PlanarPose, scene: PlanningScene, seed: int) -> bool:
        stance = stance_of(self._stance, self._here, body)
        q_start = StandingRobot(self._model, stance).q_home
        return not isinstance(
            self._planner.plan(PickRequest(q_start, stance, scene, THING, seed=seed)), NoPlan
        )


def main() -> None:
    """Print the counts of both orders."""
    parser = argparse.ArgumentParser(
        prog="tools.robot_data.standing_places", description=__doc__.split("\n")[0]
    )
    parser.add_argument("--robot", default="talos")
    parser.add_argument("--episodes", type=int, default=60)
    parser.add_argument("--seed", type=int, default=500)
    chosen = parser.parse_args()
    began, comparison = time.process_time(), Comparison(chosen.robot)
    counts = {kind: {False: Count(), True: Count()} for kind in KINDS}
    for seed in range(chosen.seed, chosen.seed + chosen.episodes):
        kind = KINDS[seed % len(KINDS)]
        comparison.count(random_scene(kind, np.random.default_rng([41, seed])), seed, counts[kind])
    for kind, both in counts.items():
        for mapped, count in both.items():
            print(
                f"{kind}, {'by the map' if mapped else 'nearest to the usual first'}: "
                f"first place served {count.first} of {count.scenes}, any {count.found}; "
                f"of the places asked about {count.served} of {count.asked}"
            )
    print(f"{time.process_time() - began:.0f} s of processor time")


if __name__ == "__main__":
    main()
