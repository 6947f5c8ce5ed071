"""Whole-body inverse kinematics with pink.

Settings: frame tasks for feet and hand, CoM and posture, Gauss-Newton steps with configuration limits
(velocity limits are for control, and would only slow it down); daqp, as fast as quadprog here and faster
than proxqp. The damping is the best of those tried.
"""

from __future__ import annotations

import logging
import time
from pathlib import Path
from typing import Any

import numpy as np
import pink
import pinocchio as pin
from line_protocol import Document, serve
from pink.limits import ConfigurationLimit
from pink.tasks import ComTask, FrameTask, PostureTask
from reach_tolerance import Tolerance

STEPS = 40
DT_S = 1.0


class Peer:
    """One robot on one stance, with one hand to place."""

    def __init__(self) -> None:
        self.model: Any = None
        self.tasks: list[Any] = []
        self.tolerance: Any = None
        self.solver = "daqp"

    def load(self, question: Document) -> Document:
        """Read the robot and where it stands."""
        text = Path(question["urdf"]).read_text("utf-8")
        self.model = pin.buildModelFromXML(text, pin.JointModelFreeFlyer())
        self.data = self.model.createData()
        self.model.lowerPositionLimit[7:] = question["lower"]
        self.model.upperPositionLimit[7:] = question["upper"]
        self.hand = FrameTask(question["tcp"], position_cost=1.0, orientation_cost=0.5, lm_damping=1e-1)
        self.feet = []
        for frame, pose in question["soles"]:
            foot = FrameTask(frame, position_cost=10.0, orientation_cost=10.0)
            foot.set_target(_se3(pose))
            self.feet.append(foot)
        com = ComTask(cost=[0.1, 0.1, 0.0])
        com.set_target(np.array(question["com"]))
        posture = PostureTask(cost=1e-3)
        posture.set_target(np.array(question["home"]))
        self.tasks = [self.hand, *self.feet, com, posture]
        self.limits = [ConfigurationLimit(self.model, config_limit_gain=0.5)]
        self.tolerance = Tolerance(question)
        self.solver = question.get("solver", self.solver)
        return {"joints": list(self.model.names)[2:]}

    def reach(self, question: Document) -> Document:
        """Bring the hand to a pose, from the first start that leads there."""
        target = _se3(question["target"])
        began_s = time.process_time()
        self.hand.set_target(target)
        q, steps = None, 0
        for start in question["starts"]:
            q, taken = self._descend(np.array(start))
            steps += taken
            if q is not None:
                break
        return {
            "q": None if q is None else q.tolist(), "steps": steps, "solve_s": time.process_time() - began_s
        }  # fmt: skip

    def _descend(self, start: Any) -> tuple[Any, int]:
        configuration = pink.Configuration(self.model, self.data, start)
        for step in range(STEPS):
            errors = [task.compute_error(configuration) for task in (self.hand, *self.feet)]
            com = pin.centerOfMass(self.model, configuration.data, configuration.q, False)
            if self.tolerance.holds(errors, com):
                return configuration.q, step
            try:
                velocity = pink.solve_ik(
                    configuration,
                    self.tasks,
                    DT_S,
                    solver=self.solver,
                    limits=self.limits,
                    safety_break=False,
                )
            except pink.exceptions.PinkError:
                return None, step
            configuration.integrate_inplace(velocity, DT_S)
        return None, STEPS


def _se3(pose: Any) -> Any:
    matrix = np.array(pose)
    return pin.SE3(matrix[:3, :3], matrix[:3, 3])


if __name__ == "__main__":
    logging.disable(logging.WARNING)  # a rounding beyond a limit is told at each step, and costs time
    peer = Peer()
    serve({"load": peer.load, "reach": peer.reach})
