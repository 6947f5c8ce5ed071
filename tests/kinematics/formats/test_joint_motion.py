"""Motions of some joints, as programs hand them in."""

import json

import numpy as np
import pytest

from kinematics.errors import TrajectoryDocumentError
from kinematics.formats.joint_motion import read_joint_motion, whole_motion
from kinematics.model.stance import stance_at

JOINT = "arm_left_4_joint"


def text(points, joints=(JOINT,)):
    return json.dumps({"joints": list(joints), "points": points})


def point(t_s, position, **more):
    return {"t_s": t_s, "positions": [position], **more}


def placed(talos, *points):
    return whole_motion(read_joint_motion(text(points)), talos, talos.q_home, stance_at(talos, talos.q_home))


def test_joints_that_are_not_named_and_the_base_stay(talos):
    here = float(talos.q_home[7 + talos.joint_index(JOINT)])

    whole = placed(talos, point(0.0, here), point(1.0, here + 0.1, velocities=[0.05]), point(2.0, here + 0.1))

    column = 7 + talos.joint_index(JOINT)
    others = np.delete(whole.q, column, axis=1)
    assert (others == others[0]).all()
    np.testing.assert_allclose(whole.q[:, column], [here, here + 0.1, here + 0.1])
    np.testing.assert_allclose(whole.v[:, column - 1], [0.0, 0.05, 0.0])


def test_a_first_point_that_is_later_is_gone_to_from_rest(talos):
    here = float(talos.q_home[7 + talos.joint_index(JOINT)])

    whole = placed(talos, point(1.5, here + 0.3))

    np.testing.assert_allclose(whole.t_s, [0.0, 1.5])
    np.testing.assert_array_equal(whole.q[0], talos.q_home)
    assert not whole.v.any()


def test_a_motion_that_begins_elsewhere_is_refused_with_both_places(talos):
    with pytest.raises(TrajectoryDocumentError, match=f"{JOINT} is at .* not at"):
        placed(talos, point(0.0, 0.4), point(1.0, 0.5))


def test_an_unknown_joint_is_refused_with_the_nearest(talos):
    motion = read_joint_motion(text([point(1.0, 0.0)], ["arm_left_9_joint"]))

    with pytest.raises(TrajectoryDocumentError, match=r"arm_left_9_joint.*did you mean"):
        whole_motion(motion, talos, talos.q_home, stance_at(talos, talos.q_home))


@pytest.mark.parametrize(
    ("points", "place"),
    [
        ([point(0.0, 0.0)], "points"),
        ([point(1.0, 0.0), point(1.0, 0.1)], r"points\[1\].t_s"),
        ([point(-1.0, 0.0)], r"points\[0\].t_s"),
        ([point(1.0, float("nan"))], "NaN"),
        ([{"t_s": 1.0, "positions": [0.0, 1.0]}], r"points\[0\].positions"),
        ([point(1.0, 0.0, effort=[1.0])], "effort"),
        ([], "points"),
    ],
)
def test_what_is_no_motion_is_refused_with_its_place(points, place):
    with pytest.raises(TrajectoryDocumentError, match=place):
        read_joint_motion(text(points))


def test_a_joint_that_is_named_twice_is_refused():
    with pytest.raises(TrajectoryDocumentError, match="joints"):
        read_joint_motion(text([{"t_s": 1.0, "positions": [0.0, 0.0]}], [JOINT, JOINT]))
