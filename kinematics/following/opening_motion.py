"""How a door or drawer is moved: speeds, forces, and the scene at each of its openings."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.model.handle_settings import PADS_ON_A_BAR
from kinematics.model.robot_description import Hand, RobotDescription
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.opening_path import DoorArc, OpeningPath
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.reserves import BRAKING_RESERVE_M, COM_RESERVE_M

GRAVITY_M_S2 = 9.81


_COM_ROOM_M = 0.01
"""A CoM that is shifted stays by so much inside what is asked of it: the shift overshoots."""
_OF_TIPPING, _GIVES_M = 0.8, 0.04
"""Of the pull that tips a robot at rest, for the estimate may overshoot by some newtons; and how far its CoM
comes forward at such a pull, for its ankles give: at 31 N a robot of 34 kg fell slowly at a locked door."""
_LEAST_HEIGHT_M = 0.1
"""What is pulled at lower than this tips nobody sooner."""
BREAK_FREE_N, MOVING_N = 25.0, 6.0
"""Pull for which the CoM is shifted before a door gives way, and while it moves."""


DOOR_SPEED_RAD_S, DRAWER_SPEED_M_S = math.radians(15.0), 0.12


HELD_SPIN = 0.3
"""Weight of the hand's turn about the bar, on a drawer: nearly kept. On a door the hand's own counts."""


SPIN_FADES = 0.93
"""From one weight to the other, by this factor a tick: a jump of weights is a jump of speeds."""


GATHERING = 2.0
"""A hand gathers speed along its path by this share of it a second."""


def com_shift_m(robot: StandingRobot, outward: Array, at_z_m: float, force_n: float) -> Array:
    """How far back the CoM has to be for a pull, m, shape (2,); no farther than the checker lets it.

    Args:
        robot: Where it stands; the pull tips it about the plane of the soles.
        outward: Unit vector of the pull, shape (3,).
        at_z_m: Height of the pull in the odometry frame.
        force_n: How hard it pulls.
    """
    height_m = at_z_m - robot.stance.height_m
    shift_m = np.asarray(outward[:2] * force_n * height_m / (robot.model.mass_kg * GRAVITY_M_S2))
    far_m = float(np.linalg.norm(shift_m))
    kept_m = robot.model.description.com_margin_m + COM_RESERVE_M + _COM_ROOM_M
    most_m = max(0.0, robot.polygon.com_margin_m(robot.polygon.middle_m) - kept_m)
    return shift_m * (most_m / far_m) if far_m > most_m else shift_m


def most_pull_n(robot: StandingRobot, outward: Array, at_z_m: float) -> float:
    """How hard a robot may pull or push at what does not give way, N; without bound for a welded one.

    Args:
        robot: Where it stands; it tips about the edge of its soles. Its CoM counts as shifted away from that,
            which is done for pulls alone: a push has less to spare than this tells.
        outward: Unit vector of the pull or push, shape (3,).
        at_z_m: Height of the pull in the odometry frame.
    """
    corners, height_m = robot.polygon.vertices_m, at_z_m - robot.stance.height_m
    if not len(corners):
        return math.inf
    com_m = robot.polygon.middle_m + com_shift_m(robot, outward, at_z_m, BREAK_FREE_N)
    room_m = max(0.0, float(((com_m - corners) @ outward[:2]).max()) - _GIVES_M)
    tips_n = robot.model.mass_kg * GRAVITY_M_S2 * room_m / max(height_m, _LEAST_HEIGHT_M)
    return _OF_TIPPING * tips_n


def speed_along(path: OpeningPath) -> float:
    """How fast a path is followed, in its own unit a second."""
    return DOOR_SPEED_RAD_S if isinstance(path, DoorArc) else DRAWER_SPEED_M_S


@dataclass(frozen=True, slots=True)
class HandTurn:
    """How a hand turns about the bar while a path is followed.

    Attributes:
        weight: How much its turn matters.
        taken_along: Whether it turns as the door does; else it keeps its heading.
    """

    weight: float
    taken_along: bool = True

    def rotation(self, path: OpeningPath, start: Array, s_from: float, s_to: float) -> Array:
        """A rotation, shape (3, 3), at another opening than the one at which it was ``start``."""
        if not self.taken_along:
            return start
        pose = poses.transform(start, (0.0, 0.0, 0.0))
        return np.asarray(path.part_moved(pose, s_from, s_to)[:3, :3])


def turn_along(path: OpeningPath, robot: RobotDescription, hand: Hand, holding: bool) -> HandTurn:
    """How a robot's hand turns along a path, on which it holds a handle or pushes."""
    if not isinstance(path, DoorArc):
        return HandTurn(HELD_SPIN)
    if holding:
        return HandTurn(robot.grippers[hand].bar.spin)
    kept = robot.pushing.heading_weight
    return HandTurn(PADS_ON_A_BAR.spin) if kept is None else HandTurn(kept, taken_along=False)


def scene_at(
    scene: PlanningScene, parts: tuple[str, ...], path: OpeningPath, s_from: float, s_to: float
) -> PlanningScene:
    """The scene with a door or drawer moved from one opening to another."""
    for name in dict.fromkeys(parts):  # each once: a front may be its own handle
        item = scene.objects[name]
        moved = path.part_moved(item.world_T_object, s_from, s_to)
        scene = scene.with_object(replace(item, world_T_object=moved))
    return scene


def guarded_scene(scene: PlanningScene) -> PlanningScene:
    """The scene with the margins of motions that are made as they go.

    They keep no more than a brake needs: what was perceived is known no better, but a held handle is.
    """
    near = [
        replace(item, margin_m=min(item.margin_m, BRAKING_RESERVE_M)) if not item.movable else item
        for item in scene.objects.values()
    ]
    return scene.with_objects(near)
