"""A keeper of several motors, told what its fingers feel: where it has them while it presses, and after."""

from types import SimpleNamespace

import numpy as np
import pytest

from robots.control.grip.grip_keeper import GripKeeper
from robots.models.description import load_robot

G1 = load_robot("g1")
PERIOD_S = 0.002
JOINTS = len(G1.description.actuated)


def commanded(keeper, fingers, seconds=1.0):
    """Where the motors are told to be in the end, while the fingers are somewhere."""
    q, v = np.zeros(JOINTS), np.zeros(JOINTS)
    q[keeper.joints.indices] = fingers
    state = SimpleNamespace(q=q.copy(), effort=np.zeros(JOINTS))
    for _ in range(round(seconds / PERIOD_S)):
        keeper.sense(state)
        keeper.propose()
        keeper.commit()
    keeper.write(q, v)
    return q[keeper.joints.indices]


def test_setpoints_come_back_to_what_is_pressed_and_go_back_before_the_hand_opens():
    keeper = GripKeeper(G1, "right", 0.0, PERIOD_S)
    ends, fingers = (keeper.joints.setpoint(at, 0.0)[0] for at in (0.0, 0.5))
    assert commanded(keeper, fingers) == pytest.approx(ends)

    keeper.pressing = True
    pressing = commanded(keeper, fingers)
    bent = keeper.joints.inwards * (pressing - fingers)
    moves = keeper.joints.inwards != 0.0
    assert keeper.shifted
    assert np.all(bent[moves] > 0.0)
    assert np.all(bent[moves] < (keeper.joints.inwards * (ends - fingers))[moves])

    keeper.pressing = False
    assert commanded(keeper, fingers) == pytest.approx(ends, abs=1e-6)
    assert not keeper.shifted
