"""A wire that holds what a test puts on it, and a clock that the test moves."""

import numpy as np
import pytest

from robots.clock import ManualClock
from robots.interface.robot import JointSetpoint
from robots.models.description import load_robot
from robots.unitree.layout import HAND_STATE, LOW_STATE, empty, seal
from robots.unitree.motors import G1
from robots.unitree.robot import UnitreeRobot


class HeldWire:
    """Whoever tests puts states on it and looks at what was sent; waiting lets time pass."""

    def __init__(self, clock):
        self.clock, self.sent, self.coming, self.tick = clock, [], [], 0

    def put_hand(self, q=0.0):
        """One more state, of a hand."""
        state = empty(HAND_STATE)
        state["motor"]["q"] = q
        self.coming.append(state)
        return state

    def put(self, q=None, *, whole=True, **changes):
        """One more state."""
        state = empty(LOW_STATE)
        self.tick += 1
        state["tick"], state["mode_machine"] = self.tick, 5
        state["motor"]["q"][: len(G1)] = 0.0 if q is None else q
        for key, value in changes.items():
            state[key] = value
        seal(state)
        if not whole:
            state["tick"] += 1
        self.coming.append(state)
        return state

    def send(self, message):
        self.sent.append(message)

    def received(self):
        come, self.coming = self.coming, []
        return come

    def wait(self, longest_s):
        self.clock.advance(longest_s)


@pytest.fixture(scope="session")
def g1():
    return load_robot("g1")


@pytest.fixture
def clock():
    return ManualClock()


@pytest.fixture
def wire(clock):
    """The body's, with a wire for each hand; all are heard."""
    held = HeldWire(clock)
    held.put()
    held.hands = {hand: HeldWire(clock) for hand in ("left", "right")}
    for one in held.hands.values():
        one.put_hand()
    return held


@pytest.fixture
def body(g1, wire, clock):
    return UnitreeRobot(g1, wire, clock, wire.hands, take_up_s=0.1)


@pytest.fixture
def setpoint(g1):
    """A setpoint that has all joints at one angle."""

    def make(q=0.2, tau=1.0):
        n = len(g1.description.actuated)
        return JointSetpoint(0.0, 1, "hold", np.full(n, q), np.zeros(n), np.full(n, tau))

    return make
