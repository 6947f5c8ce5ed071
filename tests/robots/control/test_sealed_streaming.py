"""A sealed motion streams as it was sealed, and nothing is compiled for it."""

import gc
from dataclasses import replace

import numpy as np
import pytest
from numba.core.dispatcher import Dispatcher

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.compiled import readiness
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.scene.planning_scene import PlanningScene

ELBOW = "arm_left_2_joint"


def compiled_so_far():
    """How many types of arguments code has been compiled for, by function."""
    # not isinstance: it asks whatever stands behind a weak proxy, which may be gone
    found = (item for item in gc.get_objects() if issubclass(type(item), Dispatcher))
    return {id(item): len(item.overloads) for item in found}


@pytest.mark.requirement("S6")
def test_changing_what_was_given_to_be_sealed_changes_nothing_that_streams(new_rig, motions):
    plain, changed = new_rig(), new_rig()
    reference = plain.loop.motion.reference()
    motion = motions.arms(reference, amount=0.1, duration_s=0.4)
    own = motion.trajectory.q.copy()
    given = replace(motion.trajectory, q=own)
    again = replace(motion, trajectory=given, seal=type(motion.seal)(given))
    own[5] += 0.1
    plain.loop.motion.start(motion)
    changed.loop.motion.start(again)
    plain.run(0.2)
    changed.run(0.1)
    own[20:] += 0.1

    changed.run(0.1)

    np.testing.assert_array_equal(changed.commanded(ELBOW), plain.commanded(ELBOW))


def test_checking_and_streaming_a_sealed_motion_compiles_nothing(talos, new_rig, motions):
    assert readiness.ready(), "executive doctor --warm compiles what is tried here"
    checker, rig = TrajectoryChecker(talos), new_rig()
    reference = rig.loop.motion.reference()

    def streamed(shift):
        motion = motions.arms(rig.loop.motion.reference(), amount=shift, duration_s=0.6).trajectory
        answer = checker.check(motion, PlanningScene())
        assert isinstance(answer, CheckedTrajectory), answer
        assert not answer.trajectory.q.flags.writeable
        rig.loop.motion.start(answer)
        rig.run(0.7)

    streamed(0.02)
    before = compiled_so_far()

    streamed(-0.02)

    assert compiled_so_far() == before
    np.testing.assert_allclose(rig.loop.motion.reference(), reference, atol=1e-12)
