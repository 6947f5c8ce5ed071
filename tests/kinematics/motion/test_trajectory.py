import dataclasses
import pickle
import re

import numpy as np
import pytest

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.errors import InvalidMotionError
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.scene.planning_scene import PlanningScene


def still(talos, stance, t=(0.0, 1.0)):
    n = len(t)
    return Trajectory(
        talos.joints, stance, np.array(t), np.tile(talos.q_home, (n, 1)), np.zeros((n, talos.nv))
    )


def test_times_must_rise_from_zero(talos, stance):
    for times in ((0.0, 0.0), (0.1, 1.0), (0.0, 1.0, 0.5)):
        with pytest.raises(InvalidMotionError, match="rise"):
            still(talos, stance, times)


def test_shapes_must_agree_and_values_be_finite(talos, stance):
    good = still(talos, stance)

    with pytest.raises(InvalidMotionError, match="need q"):
        dataclasses.replace(good, q=good.q[:, :-1])
    with pytest.raises(InvalidMotionError, match="finite"):
        dataclasses.replace(good, v=good.v + np.nan)


@pytest.mark.requirement("S6")
def test_nobody_but_the_checker_can_make_a_checked_trajectory(talos, stance):
    with pytest.raises(InvalidMotionError, match="only the trajectory checker"):
        CheckedTrajectory(still(talos, stance), 0.1, 0.1, seal=object())


@pytest.mark.requirement("S6")
def test_a_checked_trajectory_is_made_into_no_other_one(talos, stance):
    checked = TrajectoryChecker(talos).check(still(talos, stance), PlanningScene())

    with pytest.raises(InvalidMotionError, match="only the trajectory checker"):
        dataclasses.replace(checked, trajectory=still(talos, stance, (0.0, 0.2)))
    sent_home = pickle.loads(pickle.dumps(checked))
    assert sent_home.trajectory.duration_s == checked.trajectory.duration_s


def test_a_checked_trajectory_is_printed_as_its_margins_not_as_its_samples(talos, stance):
    checked = TrajectoryChecker(talos).check(still(talos, stance), PlanningScene())

    assert re.fullmatch(
        r"Safe trajectory: nearest measured distance 0\.\d{4} m, CoM margin 0\.\d{4} m", str(checked)
    )
