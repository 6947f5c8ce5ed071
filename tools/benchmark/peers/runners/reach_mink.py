"""Whole-body inverse kinematics with mink, on a MuJoCo model of the same URDF.

Settings: as for pink, with daqp, the solver that it installs.
"""

from __future__ import annotations

import logging
import time
from pathlib import Path
from typing import Any

import mink
import mujoco
import numpy as np
from line_protocol import Document, serve
from reach_tolerance import Tolerance

STEPS = 40
DT_S = 1.0
COMPILER = '<mujoco><compiler fusestatic="false" balanceinertia="true" discardvisual="true"/></mujoco>'


class Peer:
    """One robot on one stance, with one hand to place."""

    def __init__(self) -> None:
        self.model: Any = None
        self.tasks: list[Any] = []
        self.tolerance: Any = None

    def load(self, question: Document) -> Document:
        """Read the robot and where it stands."""
        text = Path(question["urdf"]).read_text("utf-8")
        spec = mujoco.MjSpec.from_string(text.replace("</robot>", f"{COMPILER}</robot>"))
        base = spec.body(question["base"])
        base.add_freejoint()
        self.model = spec.compile()
        self.columns = [self.model.joint(name).qposadr[0] for name in question["joints"]]
        for name, lower, upper in zip(question["joints"], question["lower"], question["upper"], strict=True):
            self.model.jnt_range[self.model.joint(name).id] = (lower, upper)
        self.configuration = mink.Configuration(self.model)
        self.hand = mink.FrameTask(
            question["tcp"], "body", position_cost=1.0, orientation_cost=0.5, lm_damping=1e-1
        )
        self.feet = []
        for frame, pose in question["soles"]:
            foot = mink.FrameTask(frame, "body", position_cost=10.0, orientation_cost=10.0)
            foot.set_target(mink.SE3.from_matrix(np.array(pose)))
            self.feet.append(foot)
        com = mink.ComTask(cost=[0.1, 0.1, 0.0])
        com.set_target(np.array(question["com"]))
        posture = mink.PostureTask(self.model, cost=1e-3)
        posture.set_target(self._to_mujoco(np.array(question["home"])))
        self.tasks = [self.hand, *self.feet, com, posture]
        self.limits = [mink.ConfigurationLimit(self.model, gain=0.5)]
        self.tolerance = Tolerance(question)
        return {"joints": question["joints"]}

    def reach(self, question: Document) -> Document:
        """Bring the hand to a pose, from the first start that leads there."""
        target = mink.SE3.from_matrix(np.array(question["target"]))
        began_s = time.process_time()
        self.hand.set_target(target)
        q, steps = None, 0
        for start in question["starts"]:
            q, taken = self._descend(self._to_mujoco(np.array(start)))
            steps += taken
            if q is not None:
                break
        answer = None if q is None else self._from_mujoco(q).tolist()
        return {"q": answer, "steps": steps, "solve_s": time.process_time() - began_s}

    def _descend(self, start: Any) -> tuple[Any, int]:
        configuration = self.configuration
        configuration.update(start)
        for step in range(STEPS):
            errors = [task.compute_error(configuration) for task in (self.hand, *self.feet)]
            if self.tolerance.holds(errors, configuration.data.subtree_com[1]):
                return configuration.q.copy(), step
            try:
                velocity = mink.solve_ik(
                    configuration, self.tasks, DT_S, solver="daqp", damping=1e-9, limits=self.limits
                )
            except mink.exceptions.MinkError:
                return None, step
            configuration.integrate_inplace(velocity, DT_S)
        return None, STEPS

    def _to_mujoco(self, q: Any) -> Any:
        found = np.zeros(self.model.nq)
        found[:3], found[3:7] = q[:3], q[[6, 3, 4, 5]]
        found[self.columns] = q[7:]
        return found

    def _from_mujoco(self, q: Any) -> Any:
        return np.concatenate([q[:3], q[[4, 5, 6, 3]], q[self.columns]])


if __name__ == "__main__":
    logging.disable(logging.WARNING)  # a rounding beyond a limit is told at each step, and costs time
    peer = Peer()
    serve({"load": peer.load, "reach": peer.reach})
