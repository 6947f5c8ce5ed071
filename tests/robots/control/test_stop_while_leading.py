"""A whole-body motion that leads a handle is stopped and cancelled: at rest at once, and standing."""

import numpy as np
import pytest

from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.opening_path import DrawerLine
from kinematics.scene.planning_scene import PlanningScene
from robots.control.events import SetpointRefused
from robots.control.hands.yielding_hand import YieldingHand
from robots.control.motion_handle import MotionStatus
from robots.models.description import load_robot

HARDWARE = load_robot("talos").hardware

REST_WITHIN_S = 0.5
LED_M = 0.08
FEET_M = 1e-4


def led(rig):
    """A hand that is leading something which gives way, with a third of its way made."""
    q = rig.loop.motion.reference()
    place = rig.model.frame_pose(q, "tcp_left")[:3, 3]
    line, stance = DrawerLine(place, 0.0), stance_at(rig.model, q)
    motion = YieldingHand(
        StandingRobot(rig.model, stance),
        "left",
        q,
        PlanningScene(),
        (),
        line,
        0.0,
        0.25,
        grip=HARDWARE.grips["left"],
        holding=False,
    )
    handle = rig.loop.motion.start(motion)
    rig.run_until(lambda: motion.report.s >= LED_M, within_s=6.0)
    assert handle.status is MotionStatus.RUNNING, handle.reason
    assert abs(rig.robot.commands[-1].v).max() > 0.05
    return handle


def require_rest(rig):
    """Nothing moves any more, nothing was refused on the way there, and the soles are where they stood."""
    rig.run(REST_WITHIN_S)
    assert rig.loop.still
    assert not rig.of_kind(SetpointRefused)
    np.testing.assert_array_equal(rig.robot.commands[-1].v, 0.0)
    at_rest = rig.loop.motion.reference()
    stance = stance_at(rig.model, at_rest)
    for (_, sole), (_, before) in zip(stance.soles, rig.loop.motion.stance().soles, strict=True):
        np.testing.assert_allclose(sole[:3, 3], before[:3, 3], atol=FEET_M)
    rig.run(0.1)
    np.testing.assert_array_equal(rig.loop.motion.reference(), at_rest)


@pytest.mark.requirement("S7")
def test_a_cancelled_lead_comes_to_rest_and_the_next_motion_is_taken(rig):
    handle = led(rig)

    rig.loop.motion.cancel(handle, "by the test")
    require_rest(rig)

    assert handle.status is MotionStatus.CANCELED
    assert led_again(rig).status is MotionStatus.RUNNING


def led_again(rig):
    q = rig.loop.motion.reference()
    place = rig.model.frame_pose(q, "tcp_left")[:3, 3]
    stance = rig.loop.motion.stance()
    motion = YieldingHand(
        StandingRobot(rig.model, stance),
        "left",
        q,
        PlanningScene(),
        (),
        DrawerLine(place, 0.0),
        0.0,
        0.05,
        grip=HARDWARE.grips["left"],
        holding=False,
    )
    handle = rig.loop.motion.start(motion)
    rig.run(0.1)
    return handle


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("category", [1, 2])
def test_an_emergency_stop_while_leading_ends_in_standing_and_refuses_what_comes(rig, category):
    handle = led(rig)

    rig.loop.emergency_stop("by the test", category)
    require_rest(rig)

    assert handle.status is MotionStatus.CANCELED
    assert led_again(rig).status is MotionStatus.REFUSED
