"""Toppra's answer to timing problems: runs in an environment that has toppra, one JSON line for each.

A problem holds the waypoints ``q`` of a dense, smooth path at the parameters ``s``, the joints' limits
``velocity`` and ``acceleration``, and ``grid``. The answer holds ``bound_s``, the least time under these
limits by toppra's collocation on that grid, which is the shortest that any of its settings found, and
``solve_s``, the processor time of its documented use: constraints and path, everything else by default.
"""

from __future__ import annotations

import importlib
import json
import sys
import time
from typing import Any

import numpy as np


def answer(problem: dict[str, Any]) -> dict[str, float]:
    """Solve one problem."""
    # not an import statement: what is nowhere in the project's own environment has no types there
    toppra: Any = importlib.import_module("toppra")
    toppra.setup_logging("ERROR")
    path = toppra.SplineInterpolator(np.array(problem["s"]), np.array(problem["q"]))
    velocity, acceleration = np.array(problem["velocity"]), np.array(problem["acceleration"])
    limit = toppra.constraint.JointVelocityConstraint(np.stack([-velocity, velocity], axis=1))
    bounds = np.stack([-acceleration, acceleration], axis=1)
    began_s = time.process_time()
    usual = toppra.constraint.JointAccelerationConstraint(bounds)
    toppra.algorithm.TOPPRA([limit, usual], path).compute_trajectory()
    solve_s = time.process_time() - began_s
    exact = toppra.constraint.JointAccelerationConstraint(
        bounds, discretization_scheme=toppra.constraint.DiscretizationType.Collocation
    )
    grid = np.array(problem["grid"])
    solver = toppra.algorithm.TOPPRA([limit, exact], path, gridpoints=grid, solver_wrapper="seidel")
    _, rates, _ = solver.compute_parameterization(0.0, 0.0)
    bound_s = float(np.sum(2.0 * np.diff(grid) / (rates[1:] + rates[:-1])))
    return {"bound_s": bound_s, "solve_s": solve_s}


if __name__ == "__main__":
    for line in sys.stdin:
        sys.stdout.write(json.dumps(answer(json.loads(line))) + "\n")
        sys.stdout.flush()
