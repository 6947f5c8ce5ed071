"""What fingers that close on a palm do to a thing."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.model.palm_grip import held, released
from robots.models.description import load_description

ON_PALM = load_description("g1").grippers["right"]
ON_LEFT_PALM = load_description("g1").grippers["left"]
BETWEEN_PADS = load_description("talos").grippers["right"]
ANGLE = st.floats(-0.6, 0.6)


@given(ANGLE, ANGLE, st.floats(-3.0, 3.0))
@pytest.mark.requirement("U4")
def test_what_stood_aslant_in_a_hand_lies_along_its_fingers(roll, pitch, yaw):
    turn = poses.rotation_y(pitch) @ poses.rotation_x(roll) @ poses.rotation_z(yaw)
    before = poses.transform(turn, (0.01, -0.02, 0.03))

    after = held(ON_PALM, before)

    assert np.allclose(after[:3, 2], [0.0, 0.0, 1.0], atol=1e-9)
    assert np.linalg.norm(after[:3, 3]) == pytest.approx(np.linalg.norm(before[:3, 3]))
    assert np.allclose(after[:3, :3] @ after[:3, :3].T, np.eye(3), atol=1e-9)


def test_what_hangs_upside_down_along_the_fingers_stays_so():
    before = poses.transform(poses.rotation_x(np.pi - 0.3), (0.0, 0.0, 0.02))

    assert np.allclose(held(ON_PALM, before)[:3, 2], [0.0, 0.0, -1.0])


def test_fingers_that_meet_between_pads_turn_and_push_nothing():
    before = poses.transform(poses.rotation_y(0.3), (0.01, 0.0, 0.03))

    assert (held(BETWEEN_PADS, before) == before).all()
    assert (released(BETWEEN_PADS, Cylinder(0.03, 0.1), before) == before).all()


@pytest.mark.parametrize(
    ("shape", "from_m", "pushed_m", "aside_m"),
    [
        (Cylinder(0.01, 0.1), -0.02, 0.02, 0.0),
        (Cylinder(0.03, 0.1), -0.02, 0.03, -0.003),
        (Box((0.09, 0.06, 0.2)), 0.004, 0.006, -0.003),
        (Cylinder(0.05, 0.1), 0.05, 0.0, -0.006),
    ],
    ids=["narrower than was measured", "between two", "a box by its narrow side", "already farther out"],
)
def test_what_fingers_let_go_stands_at_least_where_they_leave_things_of_its_width(
    shape, from_m, pushed_m, aside_m
):
    hand = replace(ON_PALM, push_table=((0.04, 0.0), (0.08, 0.02)), aside_table=((0.04, 0.0), (0.08, -0.006)))
    before = poses.transform(poses.rotation_z(0.4), (from_m, 0.02, 0.0))

    way = released(hand, shape, before)[:3, 3] - before[:3, 3]

    assert way == pytest.approx([pushed_m, aside_m, 0.0])


def test_a_left_hand_leaves_things_where_the_mirror_shows_the_right_one():
    before = poses.translation(-0.02, 0.01, 0.0)
    mirrored = poses.translation(-0.02, -0.01, 0.0)

    right = released(ON_PALM, Cylinder(0.035, 0.1), before)
    left = released(ON_LEFT_PALM, Cylinder(0.035, 0.1), mirrored)

    assert right[1, 3] != before[1, 3]
    assert left[:3, 3] == pytest.approx(right[:3, 3] * [1.0, -1.0, 1.0])
