"""The referee and the body that it plays, on a wire of this process: physics, delay, loss, every fault."""

import numpy as np
import pytest

from robots.clock import ManualClock
from robots.interface.robot import JointSetpoint
from robots.models.description import load_robot
from robots.unitree.watch import Trouble
from tools.unitree.over_the_wire import wired
from tools.unitree.referee import PERIOD_S, WireFault, empty_world

TAKE_UP_S = 0.3


def played(faults=(), **options):
    """A body and the referee that plays it, in a harness."""
    clock = ManualClock()
    world = empty_world(load_robot("g1"), 0)
    return wired(
        world,
        clock,
        take_up_s=TAKE_UP_S,
        on_wait=lambda: clock.advance(PERIOD_S),
        hung=True,
        faults=tuple(faults),
        **options,
    )


def hold(body, seconds, move=0.0, fingers=0.0):
    """Hold home, the left elbow bent and the fingers closed by so much; gives what was found on the way."""
    description = body.description
    q = np.array([description.home[name] for name in description.actuated])
    q[description.actuated.index("left_elbow_joint")] += move
    for hand in description.grippers.values():
        closed = np.array(hand.joints_at(1.0 - fingers))
        q[[description.actuated.index(name) for name in hand.joints]] = closed
    n, seen = len(q), []
    for k in range(round(seconds / PERIOD_S)):
        body.command(JointSetpoint(0.0, k, "hold", q, np.zeros(n), np.zeros(n)))
        body.advance(PERIOD_S)
        seen += [one.trouble for one in body.findings]
    return q, set(seen)


def test_the_motors_follow_what_is_commanded_over_the_wire():
    body, referee = played()

    q, seen = hold(body, 1.5, move=0.3)

    assert np.abs(referee.motors.q - q).max() < 0.02
    assert body.read().q == pytest.approx(referee.motors.q, abs=0.01)
    assert referee.refused == 0
    assert not seen


def test_the_hands_are_told_on_their_own_topics_and_close_to_where_they_are_told():
    body, referee = played()
    before = referee.motors.q

    q, seen = hold(body, 1.5, fingers=0.4)

    fingers = slice(len(body.description.joints), None)
    assert np.abs(referee.motors.q[fingers] - before[fingers]).max() > 0.5
    assert np.abs(referee.motors.q - q)[fingers].max() < 0.05
    assert body.read().q[fingers] == pytest.approx(referee.motors.q[fingers], abs=0.01)
    assert not seen


def test_a_delay_of_2_ms_and_a_lost_percent_change_nothing_but_noise():
    body, referee = played(delay_s=0.002, loss=0.01, seed=3)

    q, seen = hold(body, 1.5, move=0.3)

    assert np.abs(referee.motors.q - q).max() < 0.02
    assert not seen & {Trouble.SILENT, Trouble.LOST, Trouble.WRONG_MODE}


@pytest.mark.parametrize(
    ("fault", "trouble", "stiff_at_the_end"),
    [
        (WireFault("silent", 0.6, 0.03), Trouble.LATE, True),
        (WireFault("silent", 0.6, 0.15), Trouble.SILENT, True),
        (WireFault("silent", 0.6, 1.1), Trouble.LOST, False),
        (WireFault("garbled", 0.6, 0.01), Trouble.GARBLED, True),
        (WireFault("garbled", 0.6, 0.15), Trouble.SILENT, True),
        (WireFault("mode", 0.6, 0.01), Trouble.WRONG_MODE, False),
        (WireFault("motor", 0.6, 0.01), Trouble.MOTOR_ERROR, True),
        (WireFault("hand", 0.6, 0.15), Trouble.HAND_SILENT, True),
    ],
)
def test_every_failure_of_the_wire_is_told_has_its_consequence_and_makes_nothing_jump(
    fault, trouble, stiff_at_the_end
):
    body, referee = played([fault])

    _, seen = hold(body, 2.2, move=0.3)

    assert trouble in seen
    assert referee.stiff is stiff_at_the_end
    assert referee.jump_rad < 0.01
    assert np.abs(referee.motors.v).max() < 0.5


def test_a_fault_that_there_is_not_is_refused_with_those_that_there_are():
    with pytest.raises(ValueError, match="one of silent, garbled, mode, motor, hand, stop"):
        WireFault.parse("loud:1:2")
