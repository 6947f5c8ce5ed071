"""What was checked cannot be changed any more, by nobody."""

import copy
import pickle

import numpy as np
import pytest

from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.scene.planning_scene import PlanningScene

pytestmark = pytest.mark.requirement("S6")


def arrays_of(checked):
    motion = checked.trajectory
    return {"t_s": motion.t_s, "q": motion.q, "v": motion.v, "sole": motion.stance.soles[0][1]}


@pytest.fixture
def checked(checker, motions):
    answer = checker.check(motions.still(), PlanningScene())
    assert isinstance(answer, CheckedTrajectory)
    return answer


@pytest.mark.parametrize("name", ["t_s", "q", "v", "sole"])
def test_a_checked_motion_cannot_be_written(checked, name):
    array = arrays_of(checked)[name]

    with pytest.raises(ValueError, match="read-only"):
        array[-1] += 0.1
    with pytest.raises(ValueError, match="WRITEABLE"):
        array.setflags(write=True)
    assert isinstance(array.base, bytes)


def test_who_gave_the_arrays_cannot_change_what_was_checked(checker, motions):
    still = motions.still()
    t_s, q, v = still.t_s.copy(), still.q.copy(), still.v.copy()
    soles = tuple((frame, pose.copy()) for frame, pose in still.stance.soles)
    motion = Trajectory(still.joints, type(still.stance)(soles), t_s, q, v)
    answer = checker.check(motion, PlanningScene())

    for array in (t_s, q, v, *(pose for _, pose in soles)):
        array += 0.1

    for name, array in arrays_of(answer).items():
        assert np.array_equal(array, {"t_s": still.t_s, "q": still.q, "v": still.v}.get(
            name, still.stance.soles[0][1])), name  # fmt: skip


@pytest.mark.parametrize("again", [copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value))])
def test_what_is_sent_to_another_process_arrives_sealed(checked, again):
    arrived = again(checked)

    for name, array in arrays_of(arrived).items():
        assert isinstance(array.base, bytes), name
        assert np.array_equal(array, arrays_of(checked)[name])
