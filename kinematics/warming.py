"""Compile everything that plans and checks, before anybody waits for it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from kinematics.kernel import cache, readiness
from kinematics.robot_model import RobotModel
from kinematics.scene import PlanningScene
from kinematics.stance import stance_at


def warm(model: RobotModel, tell: Callable[[str], None] = lambda _: None) -> None:
    """Compile all that is not on disk yet, and note that it is there; a minute or two when nothing is.

    Args:
        model: A robot that stands on legs with a closed form, whose use brings all of the code.
        tell: Is told what is being done.
    """
    readiness.compile_judge(tell)
    # imported here: they bring the compiler
    from kinematics.balanced_timing import time_in_balance
    from kinematics.curves import PolynomialCurve
    from kinematics.free_coordinates import free_coordinates
    from kinematics.ik import along_line, inverse_kinematics
    from kinematics.timing import Pace
    from kinematics.trajectory_check import TrajectoryChecker
    from kinematics.trajectory_sampler import MotionSample
    from kinematics.zmp import compiled_loads

    tell("motion kernel: compiling reach, timing and checker (part 3 of 3)")
    stance = stance_at(model, model.q_home)
    hand = next(iter(model.description.grippers))
    tcp = model.frame_pose(model.q_home, model.description.grippers[hand].tcp_frame)
    along_line(inverse_kinematics(model, stance, hand), model.q_home, tcp, tcp, 2)
    inverse_kinematics(model, stance, hand).solve(tcp, model.q_home)
    space = free_coordinates(model, stance)
    ends = space.from_q(model.q_home)[None].repeat(2, axis=0)
    ends[1, space.index(model.description.groups[f"{hand}_arm"][-1])] += 0.1
    ends[1, :1] += 0.001
    trajectory = time_in_balance(model, space, stance, PolynomialCurve(ends), Pace(0.5, 0.5))
    rest = np.zeros((1, model.nv))
    compiled_loads(model, MotionSample(model.q_home[None], rest, rest))
    if trajectory is not None:
        TrajectoryChecker(model, compiled=True).check(trajectory, PlanningScene())
    cache.mark_complete()
