"""What a scene adds to a robot: what it holds, what is around, and which of them may touch."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from kinematics.kernel.pairs import Array, Indices, OwnPair
from kinematics.kernel.robot_arrays import RobotArrays
from kinematics.kernel.solids import Solid, Solids, half_extents_m, plain_solid, plain_solids
from kinematics.kernel.tree import WORLD
from kinematics.scene import PlanningScene


class SceneSolids(NamedTuple):
    """A scene around a robot.

    Attributes:
        names: Link or object of each solid: the robot's, what it holds, then the objects.
        held: What it holds.
        pairs: Pairs of the held solids among what moves.
        around: The objects.
        object_margin: What everything keeps from each object, shape (objects,), m.
        judged: 1 where a moving solid is judged against an object, shape (objects, moving).
        object_box: Lower and upper corners of boxes along the world's axes that hold the objects, shape
            (2, 3, objects), m.
    """

    names: tuple[str, ...]
    held: list[Solid]
    pairs: list[OwnPair]
    around: Solids
    object_margin: Array
    judged: Indices
    object_box: Array


# By so much a box is larger than it has to be: rounding in coordinates of some metres.
_ROUNDING_M = 1e-9


def scene_solids(robot: RobotArrays, scene: PlanningScene, extra_margin_m: float) -> SceneSolids:
    """Solids and pairs of a scene, with the margins of ``CollisionWorld``.

    Raises:
        UnknownNameError: A body is attached to a frame that the robot does not have.
    """
    names, body = list(robot.names), [solid.body for solid in robot.solids]
    held, pairs = [], []
    touch: dict[str, frozenset[str]] = {}
    solids_of = {name: list(numbers) for name, numbers in robot.solids_of.items()}
    for name, item in scene.attached.items():
        carrier, carrier_T_frame = robot.frame(item.frame)
        pairs += [
            OwnPair(i, len(names), extra_margin_m)
            for i in range(len(names))
            if body[i] != carrier
            and names[i] not in item.touch_links
            and not scene.is_allowed(names[i], name)
        ]
        touch[name] = frozenset(item.touch_links)
        solids_of.setdefault(name, []).append(len(names))
        names.append(name)
        body.append(carrier)
        held.append(plain_solid(carrier, carrier_T_frame @ item.frame_T_object, item.body.shape))
    objects = list(scene.objects.values())
    row_of = {item.name: row for row, item in enumerate(objects)}
    judged = np.ones((len(objects), len(names)), np.int64)
    for pair in scene.allowed:
        for thing in pair:
            for other in pair:
                if thing in row_of and other != thing and other in solids_of:
                    judged[row_of[thing], solids_of[other]] = 0
    for name, links in touch.items():
        for thing in links & row_of.keys():
            judged[row_of[thing], solids_of[name]] = 0
    poses = np.array([item.world_T_object for item in objects], np.float64).reshape(-1, 4, 4)
    around = plain_solids(WORLD, poses, [item.shape for item in objects])
    centre, half = around.centre, half_extents_m(around) + _ROUNDING_M
    return SceneSolids(
        names=(*names, *row_of),
        held=held,
        pairs=pairs,
        around=around,
        object_margin=np.array([item.margin_m + extra_margin_m for item in objects], np.float64),
        judged=judged,
        object_box=np.ascontiguousarray(np.stack([(centre - half).T, (centre + half).T])),
    )
