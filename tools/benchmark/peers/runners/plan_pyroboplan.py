"""Plans and shortens with pyroboplan.

Settings: RRT-Connect from both ends, a step of 0.05 (its default), connections of up to 5 rad, and its
shortcutter as it comes. That one forgets the first of the two points that it joins: of 19 paths 18 were free
before and 1 after it, by pyroboplan's own test. So a shortened path that fails that test is given up for the
first one.
"""

from __future__ import annotations

import itertools
import time
from typing import Any

import coal_scene
import numpy as np
from line_protocol import Document, serve
from pyroboplan.planning.path_shortcutting import shortcut_path
from pyroboplan.planning.rrt import RRTPlanner, RRTPlannerOptions
from pyroboplan.planning.utils import has_collision_free_path


class Peer:
    """One robot and, for each question, the solids around it."""

    def __init__(self) -> None:
        self.model: Any = None
        self.geometry: Any = None

    def load(self, question: Document) -> Document:
        """Read the robot."""
        self.model, self.geometry = coal_scene.load(question["urdf"], question["srdf"])
        return {"joints": list(self.model.names)[1:]}

    def plan(self, question: Document) -> Document:
        """RRT-Connect from both ends, then shortcuts."""
        problem = question["problem"]
        began_s = time.process_time()
        geometry = coal_scene.with_objects(self.geometry, problem["objects"])
        options = RRTPlannerOptions(
            max_step_size=question["step_rad"],
            max_connection_dist=5.0,
            rrt_connect=True,
            bidirectional_rrt=True,
            max_planning_time=question["budget_s"],
            rng_seed=question["seed"],
        )
        planner = RRTPlanner(self.model, geometry, options=options)
        set_up_s = time.process_time()
        path = planner.plan(np.array(problem["start"]), np.array(problem["goal"]))
        planned_s = time.process_time()
        # a search that ran out of time gives one end of the path, or nothing
        if path is not None and (len(path) < 2 or not np.allclose(path[-1], problem["goal"])):
            path = None
        if path is not None:
            shortened = shortcut_path(self.model, geometry, list(path), max_step_size=question["step_rad"])
            path = shortened if self._free(geometry, shortened, question["step_rad"]) else path
        ended_s = time.process_time()
        return {
            "path": None if path is None else [np.asarray(q).tolist() for q in path],
            "set_up_s": set_up_s - began_s,
            "plan_s": planned_s - set_up_s,
            "shorten_s": ended_s - planned_s,
        }

    def _free(self, geometry: Any, path: Any, step_rad: float) -> bool:
        return all(
            has_collision_free_path(a, b, step_rad, self.model, geometry) for a, b in itertools.pairwise(path)
        )


if __name__ == "__main__":
    peer = Peer()
    serve({"load": peer.load, "plan": peer.plan})
