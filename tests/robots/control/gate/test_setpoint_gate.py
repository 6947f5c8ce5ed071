import dataclasses

import numpy as np
import pytest

from robots.clock import ManualClock
from robots.control.gate.authority import Authority
from robots.control.gate.refusal import Limit
from robots.control.gate.setpoint_gate import SetpointGate
from robots.interface.robot import JointSetpoint
from robots.models.description import load_robot

PERIOD_S = 0.002
ELBOW = "arm_right_4_joint"


class Recorder:
    def __init__(self, description):
        self.description = description
        self.hardware = load_robot(description.name).hardware
        self.commands = []

    def command(self, setpoint):
        self.commands.append(setpoint)


class Bench:
    def __init__(self, model):
        description = model.description
        self.robot, self.clock = Recorder(description), ManualClock()
        self.joints = description.actuated
        self.limits = description.limits
        self.rest = np.array([description.home[name] for name in self.joints])
        self.authority = Authority(self.joints)
        self.authority.claim("arm", [name for name in self.joints if name.startswith("arm_right")])
        self.gate = SetpointGate(self.robot, self.authority, self.clock, PERIOD_S, self.rest)

    def setpoint(self, q=None, v=None, tau=None, owner="arm", sequence=None, age_s=0.0):
        def of(values, base):
            array = base.copy()
            for joint, value in (values or {}).items():
                array[self.joints.index(joint)] = value
            return array

        zero = np.zeros_like(self.rest)
        return JointSetpoint(
            self.clock.now_s() - age_s,
            self.gate.last.sequence + 1 if sequence is None else sequence,
            owner,
            of(q, self.gate.last.q),
            of(v, zero),
            of(tau, zero),
        )

    def step(self, a):
        """A consistent setpoint that accelerates the elbow with ``a``."""
        last = self.gate.last
        i = self.joints.index(ELBOW)
        v = last.v[i] + a * PERIOD_S
        q = last.q[i] + 0.5 * (last.v[i] + v) * PERIOD_S
        return self.setpoint({ELBOW: q}, {ELBOW: v})


@pytest.fixture
def bench(talos):
    return Bench(talos)


def test_a_setpoint_within_all_limits_reaches_the_robot_unchanged(bench):
    setpoint = bench.step(7.9)

    assert bench.gate.submit(setpoint) is None
    assert bench.robot.commands == [setpoint]
    assert bench.gate.accepted == 1


@pytest.mark.requirement("S1")
def test_an_acceleration_one_percent_over_its_limit_is_refused_and_one_at_it_is_not(bench):
    limit = bench.limits[ELBOW].acceleration

    refusal = bench.gate.submit(bench.step(1.01 * limit))

    assert refusal.limit is Limit.ACCELERATION
    assert refusal.joint == ELBOW
    assert refusal.value == pytest.approx(1.01 * limit)
    assert refusal.bound == limit
    assert bench.robot.commands == []
    assert bench.gate.submit(bench.step(limit)) is None


@pytest.mark.requirement("S1")
def test_a_speed_over_its_limit_is_refused_however_slowly_it_was_reached(bench):
    limit = bench.limits[ELBOW].velocity
    start = bench.rest.copy()
    i = bench.joints.index(ELBOW)
    v = np.zeros_like(start)
    v[i] = limit - 0.005
    bench.gate.last = dataclasses.replace(bench.gate.last, v=v)

    refusal = None
    while refusal is None:
        refusal = bench.gate.submit(bench.step(2.0))
        bench.clock.advance(PERIOD_S)

    assert refusal.limit is Limit.VELOCITY
    assert limit < refusal.value < 1.01 * limit
    assert refusal.bound == limit
    assert max(setpoint.v[i] for setpoint in bench.robot.commands) < 1.0021 * limit


@pytest.mark.requirement("S1")
@pytest.mark.parametrize("side", [0, 1])
def test_a_position_beyond_either_limit_is_refused_with_joint_value_and_limit(bench, side):
    limit = bench.limits[ELBOW].position[side]
    beyond = limit + (1e-4 if side else -1e-4)
    i = bench.joints.index(ELBOW)
    bench.gate.last.q[i] = beyond

    refusal = bench.gate.submit(bench.setpoint())

    assert (refusal.limit, refusal.joint) == (Limit.POSITION, ELBOW)
    assert (refusal.value, refusal.bound) == (beyond, limit)


@pytest.mark.requirement("S1")
def test_a_feed_forward_beyond_the_effort_limit_is_refused(bench):
    limit = bench.limits[ELBOW].effort

    refusal = bench.gate.submit(bench.setpoint(tau={ELBOW: -1.001 * limit}))

    assert (refusal.limit, refusal.joint, refusal.bound) == (Limit.EFFORT, ELBOW, -limit)


def test_a_position_that_the_speeds_do_not_lead_to_is_a_jump(bench):
    i = bench.joints.index(ELBOW)

    refusal = bench.gate.submit(bench.setpoint({ELBOW: bench.rest[i] + 5e-5}))

    assert (refusal.limit, refusal.joint) == (Limit.JUMP, ELBOW)
    assert refusal.value == pytest.approx(5e-5)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("part", ["q", "v", "tau"])
def test_a_value_that_is_no_number_is_refused(bench, part, value):
    refusal = bench.gate.submit(bench.setpoint(**{part: {ELBOW: value}}))

    assert (refusal.limit, refusal.joint) == (Limit.NOT_FINITE, ELBOW)
    assert bench.robot.commands == []


@pytest.mark.parametrize("step", [-1, 0, 1, 7])
def test_a_setpoint_out_of_sequence_is_refused(bench, step):
    refusal = bench.gate.submit(bench.setpoint(sequence=bench.gate.last.sequence + 1 + step))

    assert (refusal is None) == (step == 0)
    assert step == 0 or refusal.limit is Limit.SEQUENCE


@pytest.mark.parametrize("age_s", [0.0041, 1.0, -0.001])
def test_a_stale_setpoint_or_one_from_the_future_is_refused(bench, age_s):
    bench.clock.advance(2.0)

    refusal = bench.gate.submit(bench.setpoint(age_s=age_s))

    assert refusal.limit is Limit.AGE
    assert refusal.value == pytest.approx(age_s)


def test_two_setpoints_with_one_stamp_are_refused(bench):
    bench.gate.submit(bench.setpoint())

    assert bench.gate.submit(bench.setpoint()).limit is Limit.AGE


@pytest.mark.parametrize("owner", ["hold", "somebody else", "legs"])
def test_nobody_moves_a_joint_that_he_does_not_hold(bench, owner):
    bench.authority.claim("legs", [name for name in bench.joints if name.startswith("leg")])
    setpoint = dataclasses.replace(bench.step(1.0), owner=owner)

    refusal = bench.gate.submit(setpoint)

    assert refusal.limit is Limit.OWNER
    assert ELBOW in refusal.joint


def test_owners_side_by_side_move_what_they_hold_together(bench):
    bench.authority.claim("legs", [name for name in bench.joints if name.startswith("leg")])

    assert bench.gate.submit(dataclasses.replace(bench.step(1.0), owner="legs+arm")) is None


def test_arrays_of_another_size_are_refused(bench):
    setpoint = bench.setpoint()

    refusal = bench.gate.submit(dataclasses.replace(setpoint, q=setpoint.q[:-1]))

    assert (refusal.limit, refusal.value) == (Limit.SHAPE, len(bench.joints) - 1)


def test_a_refusal_changes_nothing_so_that_the_next_good_one_passes(bench):
    before = bench.gate.last

    bench.gate.submit(bench.step(100.0))

    assert bench.gate.last is before
    assert bench.gate.refused == 1
    assert bench.gate.submit(bench.step(1.0)) is None


def test_repeating_commands_the_last_position_at_rest(bench):
    bench.gate.submit(bench.step(8.0))
    bench.clock.advance(PERIOD_S)

    bench.gate.repeat()

    np.testing.assert_array_equal(bench.robot.commands[-1].q, bench.robot.commands[0].q)
    assert not bench.robot.commands[-1].v.any()


def test_a_refusal_reads_as_one_line_with_its_numbers(bench):
    refusal = bench.gate.submit(bench.step(9.0))

    assert str(refusal) == f"acceleration limit of {ELBOW}: 9 rad/s^2, allowed 8 rad/s^2"
