"""The body behind the wire: what goes out, what is read, and what a failing wire leads to."""

import numpy as np
import pytest

from robots.clock import ManualClock
from robots.errors import SetpointRefusedError
from robots.interface.robot import JointSetpoint
from robots.unitree.layout import is_whole
from robots.unitree.motors import ARM_WEIGHT, motors_of
from robots.unitree.robot import SilentRobotError, UnitreeRobot
from robots.unitree.watch import Trouble


def kinds(body):
    return [one.trouble for one in body.findings]


def run(body, wire, setpoint, periods, q=0.0, states=True, hand_q=0.0, silent=(), **changes):
    """So many periods of 2 ms, each with a state or without."""
    for _ in range(periods):
        body.command(setpoint)
        if states:
            wire.put(q, **changes)
            for name, hand in wire.hands.items():
                if name not in silent:
                    hand.put_hand(hand_q)
        body.advance(0.002)


def stiff(message):
    return float(message["motor"]["kp"].max())


def test_the_first_command_is_where_the_joints_are_without_stiffness_and_full_after_the_take_up(
    g1, wire, body, setpoint
):
    run(body, wire, setpoint(), 60)
    first, last = wire.sent[0], wire.sent[-1]
    motors = motors_of(g1.description.joints)

    assert np.abs(first["motor"]["q"][motors]).max() < 0.001
    assert stiff(first) < 0.01 * stiff(last)
    assert last["motor"]["q"][motors] == pytest.approx(0.2)
    assert last["motor"]["tau"][motors] == pytest.approx(1.0)
    gains = [g1.hardware.gains[name] for name in g1.description.joints]
    assert last["motor"]["kp"][motors] == pytest.approx([gain.stiffness for gain in gains])
    assert last["motor"]["kd"][motors] == pytest.approx([gain.damping for gain in gains])


def test_every_command_is_whole_enabled_and_carries_the_robots_own_mode(wire, body, setpoint):
    run(body, wire, setpoint(), 3)

    for message in wire.sent:
        assert is_whole(message)
        assert int(message["mode_machine"]) == 5
        assert message["motor"]["mode"].tolist() == [1] * 29 + [0] * 6


def test_what_the_motors_tell_is_read_in_the_joints_own_order(g1, wire, body):
    told = np.arange(29) * 0.01
    wire.put(told)

    body.advance(0.002)

    assert body.read().q[:29] == pytest.approx(told[motors_of(g1.description.joints)])
    assert body.read().foot_wrench.shape == (0, 6)
    assert body.read().temperature_c.shape == (43,)


@pytest.mark.parametrize(
    ("silent_s", "trouble", "damped"),
    [
        (0.01, None, False),
        (0.03, Trouble.LATE, False),
        (0.2, Trouble.SILENT, True),
        (1.2, Trouble.LOST, True),
    ],
)
def test_a_silent_wire_is_told_by_its_age_and_damped_from_a_tenth_of_a_second_on(
    wire, body, setpoint, silent_s, trouble, damped
):
    run(body, wire, setpoint(), 60)

    run(body, wire, setpoint(), round(silent_s / 0.002) + 1, states=False)

    assert kinds(body) == ([] if trouble is None else [trouble])
    assert (stiff(wire.sent[-1]) == 0.0) is damped
    assert bool(body.read().alarm) is damped


def test_after_a_silence_the_motors_are_taken_up_where_they_are_without_a_jump(wire, body, setpoint):
    run(body, wire, setpoint(), 60)
    run(body, wire, setpoint(), 150, states=False)
    before = len(wire.sent)

    run(body, wire, setpoint(), 80, q=-0.4)

    went = wire.sent[before + 1 :]
    q = np.array([message["motor"]["q"][:29] for message in went])
    assert q[0] == pytest.approx(-0.4, abs=0.002)
    assert np.abs(np.diff(q, axis=0)).max() < 0.02
    assert stiff(went[0]) < 0.01 * stiff(went[-1])
    assert q[-1] == pytest.approx(0.2)


def test_a_wire_that_was_lost_stays_damped_until_a_person_resets(wire, body, setpoint):
    run(body, wire, setpoint(), 60)
    run(body, wire, setpoint(), 520, states=False)
    assert "no state for more than 1 s" in body.reset()

    run(body, wire, setpoint(), 30)
    assert stiff(wire.sent[-1]) == 0.0

    assert body.reset() is None
    run(body, wire, setpoint(), 30)
    assert stiff(wire.sent[-1]) > 0.0
    assert body.read().alarm == ""


def test_readings_tell_whether_the_motors_follow_with_all_their_stiffness(wire, body, setpoint):
    run(body, wire, setpoint(), 20)
    assert not body.read().following

    run(body, wire, setpoint(), 40)
    assert body.read().following

    run(body, wire, setpoint(), 60, states=False)
    assert not body.read().following


def test_garbled_states_count_as_none_and_are_told(wire, body, setpoint):
    run(body, wire, setpoint(), 60)

    for _ in range(60):
        body.command(setpoint())
        wire.put(9.9, whole=False)
        wire.hands["left"].put_hand()
        body.advance(0.002)

    assert kinds(body) == [Trouble.GARBLED, Trouble.SILENT]
    assert body.read().q[:29] == pytest.approx(0.0)
    assert stiff(wire.sent[-1]) == 0.0


def test_the_same_state_over_and_over_is_no_sign_of_life(wire, body, setpoint):
    state = wire.put()

    for _ in range(60):
        body.command(setpoint())
        wire.coming.append(state)
        body.advance(0.002)

    assert Trouble.SILENT in kinds(body)


@pytest.mark.parametrize(
    ("field", "told"), [("mode_machine", "mode_machine is 6, and was 5"), ("mode_pr", "mode_pr is 6")]
)
def test_a_mode_that_is_not_the_robots_damps_until_a_person_resets(wire, body, setpoint, field, told):
    run(body, wire, setpoint(), 60)

    run(body, wire, setpoint(), 2, **{field: 6})
    run(body, wire, setpoint(), 5)

    assert kinds(body) == [Trouble.WRONG_MODE]
    assert told in body.read().alarm
    assert stiff(wire.sent[-1]) == 0.0


def test_an_error_of_a_motor_is_told_with_its_joint_and_the_robot_stands_on(wire, body, setpoint):
    run(body, wire, setpoint(), 60)
    state = wire.put()
    state["motor"]["motorstate"][3] = 17
    wire.coming.pop()
    run(body, wire, setpoint(), 2, motor=state["motor"])

    assert body.read().alarm == "wire motor error: left_knee_joint, code 17"
    assert stiff(wire.sent[-1]) > 0.0


def test_the_remotes_stop_asks_for_the_emergency_stop(wire, body):
    remote = np.zeros(40, dtype=np.uint8)
    remote[2:4] = np.frombuffer(np.uint16(1 << 5 | 1 << 9).tobytes(), dtype=np.uint8)
    wire.put(wireless_remote=remote)

    body.advance(0.002)

    assert body.read().alarm == "the remote's stop (L2 and B)"


def test_arms_alone_are_commanded_with_a_weight_that_rises(g1, wire, clock, setpoint):
    body = UnitreeRobot(g1, wire, clock, wire.hands, arms_only=True, take_up_s=0.1)

    run(body, wire, setpoint(), 60)

    weights = [float(message["motor"]["q"][ARM_WEIGHT]) for message in wire.sent]
    assert weights == sorted(weights)
    assert weights[-1] == 1.0
    assert not wire.sent[-1]["motor"]["kp"][:12].any()
    assert not wire.sent[-1]["motor"]["mode"][:12].any()
    assert (wire.sent[-1]["motor"]["kp"][12:29] > 0.0).all()


def test_a_robot_that_says_nothing_is_told_with_what_to_look_at(g1):
    class Nothing:
        def __init__(self, clock):
            self.clock = clock

        def received(self):
            return []

        def wait(self, longest_s):
            self.clock.advance(longest_s)

    clock = ManualClock()
    nobody = Nothing(clock)
    with pytest.raises(SilentRobotError, match=r"no state on rt/lowstate within 0.5 s .*network interface"):
        UnitreeRobot(g1, nobody, clock, {"left": nobody, "right": nobody}, first_within_s=0.5)


def test_a_setpoint_that_is_not_finite_is_refused_and_nothing_is_sent(wire, body, setpoint):
    bad = setpoint()

    with pytest.raises(SetpointRefusedError):
        body.command(JointSetpoint(0.0, 7, "hold", bad.q * np.nan, bad.v, bad.tau))

    assert wire.sent == []
