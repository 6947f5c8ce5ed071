"""A pick amid things of convex parts, as imported meshes are, beside the same amid their boxes."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.motion_planner import MotionPlanner
from kinematics.requests.pick import PickRequest
from robots.models.description import load_description
from tools.benchmark.figures import Figure, figure
from tools.benchmark.pick import solves
from tools.benchmark.problems.picks import TARGET, picks
from tools.benchmark.problems.things_of_parts import made_of, parts_of, prism, thing

PEER = "the same amid the boxes that hold them"


def meshes(quick: bool) -> list[Figure]:
    """Processor time of the same picks amid both, in turn, of those that were found amid both."""
    model = RobotModel(load_description("talos"))
    planner, checker = MotionPlanner(model), TrajectoryChecker(model)
    own_ms: list[float] = []
    boxes_ms: list[float] = []
    found = {True: 0, False: 0}
    for number, pair in enumerate(both(model, 8 if quick else 100, seed=0)):
        if number == 0:
            for request in pair:
                solves(planner, checker, request)
        took_s: dict[bool, float] = {}
        for of_parts in (True, False) if number % 2 else (False, True):
            began_s = time.process_time()
            solved = solves(planner, checker, pair[0 if of_parts else 1])
            found[of_parts] += solved
            if solved:
                took_s[of_parts] = time.process_time() - began_s
        if len(took_s) == 2:
            own_ms.append(1e3 * took_s[True])
            boxes_ms.append(1e3 * took_s[False])
    ratios = np.array(own_ms) / np.array(boxes_ms)
    return [
        figure("pick amid meshes that both planned, ms", own_ms, PEER, boxes_ms),
        figure("times slower, pick by pick", ratios.tolist()),
        Figure("picks found amid meshes", found[True], PEER, found[False], 1.0),
    ]


def both(model: RobotModel, count: int, seed: int) -> Iterator[tuple[PickRequest, PickRequest]]:
    """Picks amid 3 to 12 things, once of parts and once as boxes; the target is a can in both.

    Args:
        model: The robot.
        count: How many.
        seed: Of all that is drawn.
    """
    for number, request in enumerate(picks(model, count, seed)):
        rng = np.random.default_rng([seed, number, 1])
        of_parts, boxes = request.scene, request.scene
        for name, item in request.scene.objects.items():
            if not item.movable:
                continue
            if isinstance(item.shape, Cylinder) and name == TARGET:
                radius, half = item.shape.radius_m, 0.5 * item.shape.height_m
                can = made_of(*parts_of([prism(radius, -half, half)]))
                of_parts = of_parts.with_object(
                    replace(item, shape=Cylinder(radius, item.shape.height_m, can))
                )
                continue
            shape = thing(rng)
            foot_m = float(item.world_T_object[2, 3]) - 0.5 * item.shape.height_m
            place = (*item.world_T_object[:2, 3].tolist(), foot_m + 0.5 * shape.height_m)
            pose = poses.transform(poses.rotation_z(float(rng.uniform(-np.pi, np.pi))), place)
            of_parts = of_parts.with_object(replace(item, shape=shape, world_T_object=pose))
            boxes = boxes.with_object(replace(item, shape=Box(shape.size_m), world_T_object=pose))
        yield replace(request, scene=of_parts), replace(request, scene=boxes)
