"""Arrays that compiled code finds again by address and shape alone are of the type that it takes them for."""

import numpy as np
import pytest

from kinematics.checking.certificate import Limbs
from kinematics.checking.contacts import ContactFinder
from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.compiled import readiness
from kinematics.compiled.loose_arrays import in_one_piece
from kinematics.model.stance import stance_at
from kinematics.motion.trajectory import Trajectory
from kinematics.scene.planning_scene import PlanningScene


def test_an_array_with_gaps_is_refused_wherever_it_is():
    whole = np.zeros((4, 3))

    in_one_piece(whole, (whole, (whole,)))
    with pytest.raises(ValueError, match=r"shape \(4,\) has gaps"):
        in_one_piece(whole, (whole, (whole[:, 1],)))


@pytest.mark.parametrize("dtype", ["f4", "f2", ">f8", "i8", "c16", "?"])
def test_an_array_of_another_type_is_refused_wherever_it_is(dtype):
    with pytest.raises(ValueError, match=r"shape \(4,\) holds .*, not float64"):
        in_one_piece((np.zeros(3), (np.zeros(4, dtype),)))


def test_integers_are_taken_where_they_are_declared_and_nowhere_else():
    length, reach = np.zeros(4, np.int64), np.zeros((4, 2))

    in_one_piece(Limbs(np.zeros((4, 2), np.int64), reach, length))
    with pytest.raises(ValueError, match=r"shape \(4,\) holds int32, not int64"):
        in_one_piece(Limbs(np.zeros((4, 2), np.int64), reach, length.astype(np.int32)))
    with pytest.raises(ValueError, match=r"shape \(4,\) holds float64, not int64"):
        in_one_piece(Limbs(np.zeros((4, 2), np.int64), reach, length.astype(np.float64)))


def test_a_read_only_array_is_refused_as_everything_would_be_compiled_anew_for_it():
    kept = np.zeros(4)
    kept.setflags(write=False)

    with pytest.raises(ValueError, match="read-only"):
        in_one_piece(kept)


@pytest.mark.requirement("S6")
def test_the_checker_judges_nothing_by_arrays_with_gaps(talos, monkeypatch):
    assert readiness.ready(), "executive doctor --warm compiles what is tried here"
    times_s, n = np.array([0.0, 1.0]), 2
    still = Trajectory(
        talos.joints,
        stance_at(talos, talos.q_home),
        times_s,
        np.tile(talos.q_home, (n, 1)),
        np.zeros((n, talos.nv)),
    )
    own = ContactFinder._arrays

    def with_gaps(finder, pairs):
        limbs, solids, listed = own(finder, pairs)
        return limbs, solids, listed._replace(clearance=np.repeat(listed.clearance, 2)[::2])

    monkeypatch.setattr(ContactFinder, "_arrays", with_gaps)

    with pytest.raises(ValueError, match="gaps"):
        TrajectoryChecker(talos).check(still, PlanningScene())
