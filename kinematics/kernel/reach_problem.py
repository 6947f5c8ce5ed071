"""What the compiled inverse kinematics is given, and its memory."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.kernel.tree import Tree

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

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
    """Memory of one search."""

    q: Array
    base_R: Array
    needed: Indices
    legs: Indices
    R: Array
    p: Array
    com: Array
    rest: Array
    tool_R: Array
    tool_p: Array
    rows: Array
    wanted: Array
    broken: Array
    probe: Array
    probe_q: Array
    probe_broken: Array
    system: Array
    right: Array
    freedom: Array
    step: Array
    mass: Array
    moment: Array


def scratch(tree: Tree, nq: int, coordinates: int) -> Scratch:
    """Memory for a robot with configurations of shape (nq,) and so many free coordinates."""
    bodies = len(tree.parent)
    edges = MOST_ROWS - 6
    return Scratch(
        q=np.zeros(nq),
        base_R=np.eye(3),
        needed=np.ones(bodies, np.int64),
        legs=np.zeros(bodies, np.int64),
        R=np.zeros((bodies, 3, 3)),
        p=np.zeros((bodies, 3)),
        com=np.zeros(3),
        rest=np.zeros(4),
        tool_R=np.eye(3),
        tool_p=np.zeros(3),
        rows=np.zeros((MOST_ROWS, coordinates)),
        wanted=np.zeros(MOST_ROWS),
        broken=np.zeros(edges),
        probe=np.zeros(coordinates),
        probe_q=np.zeros(nq),
        probe_broken=np.zeros(edges),
        system=np.zeros((MOST_ROWS, MOST_ROWS)),
        right=np.zeros(MOST_ROWS),
        freedom=np.zeros(coordinates),
        step=np.zeros(coordinates),
        mass=np.zeros(bodies),
        moment=np.zeros((bodies, 3)),
    )
