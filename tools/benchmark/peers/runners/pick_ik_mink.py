"""The inverse kinematics of a pick with mink: trunk and one arm, everything else as it stands.

Settings: as for whole-body reaches, without feet and CoM, which need no task when the legs stay: nine
joints instead of the whole body, so that each step is cheaper. From home to a grasp, then along a line
from the posture before.
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

STEPS = 20
DT_S = 1.0
COMPILER = '<mujoco><compiler fusestatic="false" balanceinertia="true" discardvisual="true"/></mujoco>'


class Arm:
    """One hand's joints."""

    def __init__(self, question: Document, joints: list[str], tcp: str) -> None:
        text = Path(question["urdf"]).read_text("utf-8")
        spec = mujoco.MjSpec.from_string(text.replace("</robot>", f"{COMPILER}</robot>"))
        base = spec.body(question["base"])
        base.pos, base.quat = question["base_position"], question["base_wxyz"]
        for joint in list(spec.joints):
            if joint.name not in joints:
                _lock(spec, joint, question["home"].get(joint.name, 0.0))
        self.model = spec.compile()
        self.columns = [self.model.joint(name).qposadr[0] for name in joints]
        for name in joints:
            self.model.jnt_range[self.model.joint(name).id] = question["limits"][name]
        self.configuration = mink.Configuration(self.model)
        self.hand = mink.FrameTask(tcp, "body", position_cost=1.0, orientation_cost=0.5, lm_damping=1e-1)
        self.posture = mink.PostureTask(self.model, cost=1e-3)
        self.limits = [mink.ConfigurationLimit(self.model, gain=0.5)]
        self.home = np.zeros(self.model.nq)
        self.home[self.columns] = [question["home"][name] for name in joints]

    def descend(self, target: Any, start: Any, position_m: float, orientation_rad: float) -> Any:
        """Configuration with the hand at a pose, or None."""
        configuration = self.configuration
        configuration.update(start)
        self.hand.set_target(mink.SE3.from_matrix(target))
        self.posture.set_target(start)
        for _ in range(STEPS):
            error = self.hand.compute_error(configuration)
            if error[:3] @ error[:3] <= position_m**2 and error[3:] @ error[3:] <= orientation_rad**2:
                return configuration.q.copy()
            try:
                velocity = mink.solve_ik(
                    configuration,
                    [self.hand, self.posture],
                    DT_S,
                    solver="daqp",
                    damping=1e-9,
                    limits=self.limits,
                )
            except mink.exceptions.MinkError:
                return None
            configuration.integrate_inplace(velocity, DT_S)
        return None


class Peer:
    """One robot with two hands."""

    def load(self, question: Document) -> Document:
        """Read the robot and where it stands."""
        self.arms = {
            hand: Arm(question, joints, question["tcp"][hand]) for hand, joints in question["joints"].items()
        }
        self.tolerance = question["position_m"], question["orientation_rad"]
        return {}

    def follow(self, question: Document) -> Document:
        """Bring the hand to one pose after another; as many points as were reached in turn."""
        targets = [np.array(pose) for pose in question["targets"]]
        began_s = time.process_time()
        arm = self.arms[question["hand"]]
        q = arm.home.copy()
        if question["start"] is not None:
            q[arm.columns] = question["start"]
        points = []
        for target in targets:
            q = arm.descend(target, q, *self.tolerance)
            if q is None:
                break
            points.append(q[arm.columns])
        seconds = time.process_time() - began_s
        return {"answer": [point.tolist() for point in points], "seconds": seconds}


def _lock(spec: Any, joint: Any, angle: float) -> None:
    """Turn a joint's body to where the joint stands, and take the joint away."""
    body, turn, placed = joint.parent, np.zeros(4), np.zeros(4)
    mujoco.mju_axisAngle2Quat(turn, np.array(joint.axis), angle)
    mujoco.mju_mulQuat(placed, np.array(body.quat), turn)
    body.quat = placed
    spec.delete(joint)


if __name__ == "__main__":
    logging.disable(logging.WARNING)  # a rounding beyond a limit is told at each step, and costs time
    peer = Peer()
    serve({"load": peer.load, "follow": peer.follow})
