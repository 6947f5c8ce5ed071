"""What the compiled inverse kinematics is given, and its memory."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.model.tree import WORLD, Tree

MOST_ROWS = 40
"""The frame's six, edges of the support polygon, limits of the legs."""


class ReachSettings(NamedTuple):
    """How the search goes.

    Attributes:
        position_m, turn_rad: The frame is there when both errors are smaller.
        damping: Added to the diagonal of the system.
        pull: Share of the way to the reference posture that a step takes in the null space.
        most_steps: For one start.
    """

    position_m: float
    turn_rad: float
    damping: float
    pull: float
    most_steps: int


class ReachGoal(NamedTuple):
    """What is to be reached.

    Attributes:
        body: Body that carries the frame.
        offset_R, offset_p: The frame in the body, shapes (3, 3) and (3,).
        target_R, target_p: The frame's wanted pose in the world.
    """

    body: int
    offset_R: Array
    offset_p: Array
    target_R: Array
    target_p: Array


class ReachSpace(NamedTuple):
    """Where it is searched.

    Attributes:
        lower, upper: Bounds of the coordinates, shape (n,).
        freedom: How willingly each one moves; 0 holds it, shape (n,).
        reference: Posture that is preferred, shape (n,).
        column: Coordinate of each body's joint, or -1, shape (bodies,).
    """

    lower: Array
    upper: Array
    freedom: Array
    reference: Array
    column: Indices


class Scratch(NamedTuple):
    """Memory of one search.

    Some of its fields:
        needed: Whether a body moves in the search: base, legs, and what leads to the frame; the rest
            hangs on these as it does at the start, shape (bodies,).
        everything: All of them, shape (bodies,).
        weight, lever: Mass and centre of mass of the needed bodies with what hangs on them, shapes
            (bodies,) and (bodies, 3), kg and m.
        moving: Coordinates that are free to move, then what is not used, shape (n,).
        noted: Of the last search: whether the CoM's margin was ever broken, and whether the base was ever
            at its lowest, shape (2,).
    """

    q: Array
    base_R: Array
    needed: Indices
    everything: Indices
    weight: Array
    lever: Array
    moving: Indices
    noted: Indices
    R: Array
    p: Array
    com: Array
    tool_R: Array
    tool_p: Array
    rows: Array
    wanted: Array
    broken: Array
    leg_system: Array
    leg_rates: Array
    system: Array
    right: Array
    freedom: Array
    step: Array
    mass: Array
    moment: Array


def scratch(tree: Tree, nq: int, coordinates: int, legs: Indices, frame: int) -> Scratch:
    """Memory.

    Args:
        tree: The robot.
        nq: Length of its configurations.
        coordinates: How many free coordinates it has.
        legs: Bodies of the legs, shape (legs, 6).
        frame: The body that carries the frame.
    """
    bodies = len(tree.parent)
    edges = MOST_ROWS - 6
    needed = np.zeros(bodies, np.int64)
    needed[legs.ravel()] = 1
    while frame != WORLD:
        needed[frame] = 1
        frame = int(tree.parent[frame])
    return Scratch(
        q=np.zeros(nq),
        base_R=np.eye(3),
        needed=needed,
        everything=np.ones(bodies, np.int64),
        weight=np.zeros(bodies),
        lever=np.zeros((bodies, 3)),
        moving=np.zeros(coordinates, np.int64),
        noted=np.zeros(2, np.int64),
        R=np.zeros((bodies, 3, 3)),
        p=np.zeros((bodies, 3)),
        com=np.zeros(3),
        tool_R=np.eye(3),
        tool_p=np.zeros(3),
        rows=np.zeros((MOST_ROWS, coordinates)),
        wanted=np.zeros(MOST_ROWS),
        broken=np.zeros(edges),
        leg_system=np.zeros((6, 12)),
        leg_rates=np.zeros((len(legs), 6, 6)),
        system=np.zeros((MOST_ROWS, MOST_ROWS)),
        right=np.zeros(MOST_ROWS),
        freedom=np.zeros(coordinates),
        step=np.zeros(coordinates),
        mass=np.zeros(bodies),
        moment=np.zeros((bodies, 3)),
    )
