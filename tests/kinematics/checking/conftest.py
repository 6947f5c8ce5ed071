"""Motions to be judged: one joint at a time, from the home posture."""

import functools

import numpy as np
import pytest

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory, Unsafe


class Motions:
    """Trajectories in which everything but what is named stays at home."""

    def __init__(self, model, stance):
        self.model = model
        self.stance = stance

    def still(self, duration_s=1.0, samples=101):
        t = np.linspace(0.0, duration_s, samples)
        q = np.tile(self.model.q_home, (samples, 1))
        return Trajectory(self.model.joints, self.stance, t, q, np.zeros((samples, self.model.nv)))

    def joint(self, name, change_rad, duration_s=1.5, samples=151, and_back=False):
        """One joint goes by a quintic, or there and back again."""
        motion = self.still(duration_s, samples)
        s = motion.t_s / duration_s
        if and_back:
            shape, rate = 64 * (s * (1 - s)) ** 3, 192 * (s * (1 - s)) ** 2 * (1 - 2 * s)
        else:
            shape, rate = 10 * s**3 - 15 * s**4 + 6 * s**5, 30 * s**2 * (1 - s) ** 2
        index = self.model.joint_index(name)
        q, v = motion.q.copy(), motion.v.copy()
        q[:, 7 + index] += change_rad * shape
        v[:, 6 + index] = change_rad * rate / duration_s
        return Trajectory(motion.joints, motion.stance, motion.t_s, q, v)


@pytest.fixture(scope="session")
def motions(talos, stance):
    return Motions(talos, stance)


@pytest.fixture(scope="session")
def checkers(talos):
    return functools.cache(lambda compiled: TrajectoryChecker(talos, compiled=compiled))


@pytest.fixture(scope="module", params=[True, False], ids=["compiled", "coal"])
def checker(checkers, request):
    """Either way of checking; of a module alone, else all modules run one way, then all the other way.

    What a module sets up would be set up twice.
    """
    return checkers(request.param)


def found(answer):
    """Kinds of findings by subject; nothing for a checked trajectory."""
    if isinstance(answer, CheckedTrajectory):
        return set()
    assert isinstance(answer, Unsafe)
    return {(finding.kind, *finding.subject) for finding in answer.findings}


@pytest.fixture(scope="session")
def findings_of():
    return found
