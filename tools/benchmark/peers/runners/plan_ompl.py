"""Plans and shortens with OMPL over Coal, through OMPL's own Python interface.

Settings: RRT-Connect with its default range and ``simplifySolution`` as the tutorials show it; edges are
looked at every 0.05 rad as the other peers do, unless a finer step is said (the default, 1 % of the space's
extent, is 0.13 rad). Coal is asked through that broad phase of Pinocchio's that tries all boxes: twice as
fast here as its tree.
"""

from __future__ import annotations

import time
from typing import Any

import coal_scene
import numpy as np
import ompl.base as ob
import ompl.geometric as og
import ompl.util as ou
from line_protocol import Document, serve


class Peer:
    """One robot and, for each question, the solids around it."""

    def __init__(self) -> None:
        ou.setLogLevel(ou.LogLevel.LOG_ERROR)
        self.model: Any = None
        self.geometry: Any = None

    def load(self, question: Document) -> Document:
        """Read the robot; the seed can be set once in a process."""
        ou.RNG.setSeed(1 + int(question.get("seed", 0)))
        self.model, self.geometry = coal_scene.load(question["urdf"], question["srdf"])
        return {"joints": list(self.model.names)[1:]}

    def plan(self, question: Document) -> Document:
        """RRT-Connect, then OMPL's simplification."""
        began_s = time.process_time()
        setup = self._set_up(question["problem"], question["step_rad"])
        set_up_s = time.process_time()
        status = setup.solve(question["budget_s"])
        planned_s = time.process_time()
        solved = bool(status) and setup.haveExactSolutionPath()
        if solved:
            setup.simplifySolution()
        ended_s = time.process_time()
        return {
            "path": _states(setup.getSolutionPath()) if solved else None,
            "set_up_s": set_up_s - began_s,
            "plan_s": planned_s - set_up_s,
            "shorten_s": ended_s - planned_s,
        }

    def _set_up(self, problem: Document, step_rad: float) -> Any:
        model, size = self.model, self.model.nq
        scene = coal_scene.BroadPhase(model, coal_scene.with_objects(self.geometry, problem["objects"]))
        q = np.zeros(size)

        def valid(state: Any) -> bool:
            for i in range(size):
                q[i] = state[i]
            return not scene.collides(q)

        space = ob.RealVectorStateSpace(size)
        bounds = ob.RealVectorBounds(size)
        for i in range(size):
            bounds.setLow(i, float(model.lowerPositionLimit[i]))
            bounds.setHigh(i, float(model.upperPositionLimit[i]))
        space.setBounds(bounds)
        setup = og.SimpleSetup(space)
        setup.setStateValidityChecker(valid)
        space.setLongestValidSegmentFraction(step_rad / space.getMaximumExtent())
        start, goal = space.allocState(), space.allocState()
        for i in range(size):
            start[i], goal[i] = problem["start"][i], problem["goal"][i]
        setup.setStartAndGoalStates(start, goal)
        setup.setPlanner(og.RRTConnect(setup.getSpaceInformation()))
        setup.setup()
        return setup


def _states(path: Any) -> list[list[float]]:
    return [[float(state[i]) for i in range(7)] for state in path.getStates()]


if __name__ == "__main__":
    peer = Peer()
    serve({"load": peer.load, "plan": peer.plan})
