"""The timing of a pick with toppra.

Settings: a spline through the waypoints, velocity and acceleration limits, a grid of 51 points and
constant accelerations between: twice as fast here as the default grid and spline, and 1 % longer.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np
import toppra
from line_protocol import Document, serve
from toppra.algorithm import TOPPRA
from toppra.constraint import JointAccelerationConstraint, JointVelocityConstraint

GRID_POINTS = 51


def parameterise(question: Document) -> Document:
    """Time a path, shape (n, dof).

    The answer holds what it passes through: ``by_way``, no joint going farther than ``step_rad`` from one
    to the next, and ``by_time``, every ``step_s``.
    """
    points = np.array(question["points"])
    velocity, acceleration = np.array(question["velocity"]), np.array(question["acceleration"])
    began_s = time.process_time()
    gone = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    path = toppra.SplineInterpolator(gone, points)
    limits = [
        JointVelocityConstraint(np.stack([-velocity, velocity], axis=1)),
        JointAccelerationConstraint(np.stack([-acceleration, acceleration], axis=1)),
    ]
    grid = np.linspace(0.0, gone[-1], GRID_POINTS)
    solver = TOPPRA(limits, path, gridpoints=grid, parametrizer="ParametrizeConstAccel")
    motion = solver.compute_trajectory()
    seconds = time.process_time() - began_s
    if motion is None:
        return {"answer": None, "seconds": seconds}
    instants = np.linspace(0.0, motion.duration, int(np.ceil(motion.duration / question["step_s"])) + 1)
    answer = {"by_way": _by_way(path, gone[-1], question["step_rad"]), "by_time": motion(instants).tolist()}
    return {"answer": answer, "seconds": seconds}


def _by_way(path: Any, length: float, step: float) -> list[list[float]]:
    fine = path(np.linspace(0.0, length, 4 * int(np.ceil(length / step)) + 2))
    travelled = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(fine, axis=0)).max(axis=1))])
    at = np.linspace(0.0, travelled[-1], int(np.ceil(travelled[-1] / step)) + 1)
    points: list[list[float]] = np.stack([np.interp(at, travelled, line) for line in fine.T], axis=1).tolist()
    return points


if __name__ == "__main__":
    toppra.setup_logging("ERROR")
    serve({"time": parameterise})
