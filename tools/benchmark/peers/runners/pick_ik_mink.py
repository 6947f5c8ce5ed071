"""The inverse kinematics of a pick with mink: trunk and one arm over legs that stay, or the whole body.

Settings: as for whole-body reaches; where the legs stay, feet and CoM need no task, and nine joints make
each step cheaper. From home to a grasp, then along a line from the posture before.
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
        self.whole = question["whole_body"]
        if self.whole:
            base.add_freejoint()
        base.pos, base.quat = question["base_position"], question["base_wxyz"]
        moving = [*joints, *question["legs"]] if self.whole else joints
        for joint in list(spec.joints):
            if joint.name in question["home"] and joint.name not in moving:
                _lock(spec, joint, question["home"].get(joint.name, 0.0))
        self.model = spec.compile()
        self.columns = [self.model.joint(name).qposadr[0] for name in joints]
        for name in moving:
            self.model.jnt_range[self.model.joint(name).id] = question["limits"][name]
        self.configuration = mink.Configuration(self.model)
        self.hand = mink.FrameTask(tcp, "body", position_cost=1.0, orientation_cost=0.5, lm_damping=1e-1)
        self.posture = mink.PostureTask(self.model, cost=1e-3)
        self.limits = [mink.ConfigurationLimit(self.model, gain=0.5)]
        self.home = self.model.qpos0.copy()
        for name in moving:
            self.home[self.model.joint(name).qposadr[0]] = question["home"][name]
        self.tasks = [self.hand, self.posture]
        if self.whole:
            self.tasks += _standing(question)

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
                    self.tasks,
                    DT_S,
                    solver="daqp",
                    damping=1e-9,
                    limits=self.limits,
                )
            except mink.exceptions.MinkError:
                return None
            configuration.integrate_inplace(velocity, DT_S)
        return None

    def point(self, q: Any) -> list[float]:
        """What is planned with: the pelvis's place and rotation vector, if it moves, and the joints."""
        pelvis = [*q[:3], *mink.SO3(q[3:7]).log()] if self.whole else []
        return [float(value) for value in (*pelvis, *q[self.columns])]


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
        """Bring the hand to one pose after another; what was reached in turn, and the state at each."""
        targets = [np.array(pose) for pose in question["targets"]]
        began_s = time.process_time()
        arm = self.arms[question["hand"]]
        q = arm.home if question["state"] is None else np.array(question["state"])
        points, states = [], []
        for target in targets:
            q = arm.descend(target, q, *self.tolerance)
            if q is None:
                break
            points.append(arm.point(q))
            states.append(q)
        seconds = time.process_time() - began_s
        answer = {"points": points, "states": [state.tolist() for state in states]}
        return {"answer": answer, "seconds": seconds}


def _standing(question: Document) -> list[Any]:
    """Tasks that keep the feet where they are and the CoM over them."""
    tasks: list[Any] = []
    for frame, pose in question["soles"]:
        foot = mink.FrameTask(frame, "body", position_cost=10.0, orientation_cost=10.0)
        foot.set_target(mink.SE3.from_matrix(np.array(pose)))
        tasks.append(foot)
    com = mink.ComTask(cost=[0.1, 0.1, 0.0])
    com.set_target(np.array(question["com"]))
    return [*tasks, com]


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
