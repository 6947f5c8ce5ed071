import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from kinematics.geometry import poses

angles = st.floats(-3.1, 3.1)
vectors = st.tuples(angles, angles, angles)
places = st.tuples(*[st.floats(-5, 5)] * 3)


@given(vectors, places)
def test_a_transform_times_its_inverse_is_identity(turn, place):
    a_T_b = poses.transform(poses.rotation_from_vector(turn), place)

    assert poses.inverse(a_T_b) @ a_T_b == pytest.approx(np.eye(4), abs=1e-12)


@given(vectors)
def test_rotation_vectors_agree_with_scipy(turn):
    rotation = poses.rotation_from_vector(turn)

    assert rotation == pytest.approx(Rotation.from_rotvec(turn).as_matrix(), abs=1e-9)
    assert poses.rotation_from_vector(poses.vector_from_rotation(rotation)) == pytest.approx(
        rotation, abs=1e-7
    )


@given(vectors)
def test_quaternions_round_trip(turn):
    rotation = Rotation.from_rotvec(turn).as_matrix()

    quaternion = poses.quaternion_from_rotation(rotation)

    assert poses.rotation_from_quaternion(quaternion) == pytest.approx(rotation, abs=1e-12)


@given(st.lists(vectors, min_size=1, max_size=5))
def test_many_quaternions_are_those_of_one_at_a_time_but_for_the_sign(turns):
    rotations = Rotation.from_rotvec(turns).as_matrix()

    for rotation, quaternion in zip(rotations, poses.quaternions_from_rotations(rotations), strict=True):
        assert abs(quaternion @ poses.quaternion_from_rotation(rotation)) == pytest.approx(1.0, abs=1e-12)


@given(vectors, places, st.floats(0, 1))
def test_interpolation_moves_evenly(turn, place, fraction):
    start = np.eye(4)
    end = poses.transform(poses.rotation_from_vector(turn), place)

    between = poses.interpolate(start, end, fraction)

    whole = poses.angle_between(start[:3, :3], end[:3, :3])
    assert poses.angle_between(start[:3, :3], between[:3, :3]) == pytest.approx(fraction * whole, abs=1e-6)
    assert between[:3, 3] == pytest.approx(fraction * np.array(place), abs=1e-12)


def test_elementary_rotations_agree_with_scipy():
    for axis, function in (("x", poses.rotation_x), ("y", poses.rotation_y), ("z", poses.rotation_z)):
        assert function(0.7) == pytest.approx(Rotation.from_euler(axis, 0.7).as_matrix(), abs=1e-12)
    assert poses.yaw_of(poses.rotation_z(0.4)) == pytest.approx(0.4)
