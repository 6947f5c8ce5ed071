"""The state machine: only what the requirements allow, and it always agrees with the latch."""

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, rule, run_state_machine_as_test

from executive.session import lifecycle as lifecycle_module
from executive.session.lifecycle import (
    COMMANDS,
    TRANSITIONS,
    IllegalTransitionError,
    Lifecycle,
    LifecycleState,
    Trigger,
)
from executive.session.supervisor import Supervisor
from robots.clock import ManualClock
from robots.control.loop.emergency_stop import EmergencyLatch
from trees.failures import FailureKind

ALLOWED = {  # from the requirements, not from the table
    ("NORMAL", "ERROR"),
    ("ERROR", "RECOVERY"),
    ("RECOVERY", "NORMAL"),
    ("RECOVERY", "ERROR"),
    ("NORMAL", "EMERGENCY"),
    ("ERROR", "EMERGENCY"),
    ("RECOVERY", "EMERGENCY"),
    ("EMERGENCY", "RECOVERY"),
}


class Loop:
    """The latch of a control loop, and a robot that may be ill or on the move."""

    def __init__(self):
        self.latch, self.defects, self.still, self.resets = EmergencyLatch(), (), True, 0
        self.reservations = ()

    @property
    def emergency(self):
        return self.latch.engaged

    def emergency_stop(self, reason, category=1):
        self.latch.engage(0.0, category, reason)

    def reset(self, request):
        reason = self.latch.why_not_open(self.still, self.defects)
        if reason is None:
            self.latch.open()
            self.resets += 1
        return reason


class Supervised(RuleBasedStateMachine):
    """Whatever happens in whatever order."""

    made = []

    def __init__(self):
        super().__init__()
        Supervised.made.append(self)
        self.steps = 0
        self.loop, self.events = Loop(), []
        self.supervisor = Supervisor(self.loop, ManualClock(), self.events.append)
        self.asked_resets = 0

    @rule(category=st.sampled_from([1, 2]), direct=st.booleans())
    def stop(self, category, direct):
        if direct:  # the stop key of the control process
            self.loop.emergency_stop("key", category)
        else:
            self.supervisor.emergency_stop("a person", category)
            self.supervisor.before_period()
        self.supervisor.stopped()

    @rule()
    def person_resets(self):
        self.asked_resets += 1
        self.supervisor.reset("Ana")

    @rule()
    def defect(self):
        self.supervisor.note_defect("a leaf raised")

    @rule(ill=st.booleans(), still=st.booleans())
    def robot_changes(self, ill, still):
        self.loop.defects = ("encoder off",) if ill else ()
        self.loop.still = still

    @rule(stops_meanwhile=st.booleans())
    def command(self, stops_meanwhile):
        was = self.supervisor.lifecycle.state

        def let_pass(seconds):
            if stops_meanwhile:
                self.loop.emergency_stop("key")

        refusal = self.supervisor.admit(let_pass)
        state = self.supervisor.lifecycle.state
        assert (refusal is None) == (state is LifecycleState.NORMAL)
        assert refusal is not None or not self.loop.defects
        if was is LifecycleState.EMERGENCY:
            assert refusal is not None
            assert state is was
        if was is not LifecycleState.NORMAL and refusal is None:
            assert self.loop.still
            assert not self.loop.defects

    @invariant()
    def only_allowed_transitions(self):
        self.steps += 1
        assert {(event.before, event.after) for event in self.events} <= ALLOWED
        assert all(event.reason for event in self.events)

    @invariant()
    def events_are_a_chain_that_ends_in_the_state(self):
        states = ["NORMAL", *(event.after for event in self.events)]
        assert [event.before for event in self.events] == states[:-1]
        assert states[-1] == self.supervisor.lifecycle.state.value

    @invariant()
    def emergency_is_the_latch(self):
        engaged = self.loop.emergency is not None
        assert engaged == (self.supervisor.lifecycle.state is LifecycleState.EMERGENCY)

    @invariant()
    def only_persons_leave_an_emergency(self):
        left = sum(event.before == "EMERGENCY" for event in self.events)
        assert left == self.loop.resets <= self.asked_resets


STEPS = 10_000


@pytest.mark.requirement("S5", "S2")
def test_no_order_of_ten_thousand_events_leads_to_an_illegal_state():
    Supervised.made.clear()
    while sum(machine.steps - 1 for machine in Supervised.made) < STEPS:
        run_state_machine_as_test(
            Supervised, settings=settings(stateful_step_count=100, max_examples=150, deadline=None)
        )
    events = [event for machine in Supervised.made for event in machine.events]

    assert {(event.before, event.after) for event in events} == ALLOWED  # all of them were tried


@pytest.mark.requirement("S5")
@pytest.mark.parametrize(
    "planted",
    [
        {(LifecycleState.NORMAL, Trigger.DEFECT): LifecycleState.RECOVERY},
        {(LifecycleState.EMERGENCY, Trigger.RESET): LifecycleState.NORMAL},
        {(LifecycleState.EMERGENCY, Trigger.DEFECT): LifecycleState.ERROR},
        {(LifecycleState.RECOVERY, Trigger.STOP): LifecycleState.RECOVERY},
    ],
    ids=str,
)
def test_a_planted_transition_is_found(planted, monkeypatch):
    monkeypatch.setattr(lifecycle_module, "TRANSITIONS", {**TRANSITIONS, **planted})
    monkeypatch.setattr(Supervisor, "note_defect", _careless_defect)

    with pytest.raises(AssertionError):
        run_state_machine_as_test(Supervised, settings=settings(stateful_step_count=20))


def _careless_defect(self, reason):
    if self.lifecycle.allows(Trigger.DEFECT):
        self.lifecycle.take(Trigger.DEFECT, reason)


@pytest.mark.requirement("S5")
def test_the_table_holds_exactly_what_is_allowed():
    assert {(a.value, b.value) for (a, _), b in TRANSITIONS.items()} == ALLOWED
    assert set(COMMANDS) == set(LifecycleState)


def test_an_illegal_transition_is_refused_with_what_there_is():
    lifecycle = Lifecycle(lambda event: None, lambda: 0.0)

    with pytest.raises(
        IllegalTransitionError, match="RESET leads nowhere from NORMAL; there are DEFECT, STOP"
    ):
        lifecycle.take(Trigger.RESET, "why not")
    assert lifecycle.state is LifecycleState.NORMAL


@pytest.fixture
def supervised():
    loop, events = Loop(), []
    return loop, Supervisor(loop, ManualClock(), events.append), events


@pytest.mark.requirement("S2", "S5")
def test_a_command_in_an_emergency_is_refused_with_a_message(supervised):
    loop, supervisor, _ = supervised
    loop.emergency_stop("smoke")

    refusal = supervisor.admit(lambda seconds: None)

    assert refusal.kind is FailureKind.REFUSED
    assert "smoke" in refusal.message
    assert "a person has to reset it" in refusal.message


@pytest.mark.requirement("S5")
def test_a_command_after_a_defect_waits_for_the_recovery(supervised):
    _, supervisor, events = supervised
    supervisor.note_defect("a leaf raised")
    waited = []

    assert supervisor.admit(waited.append) is None

    assert waited == [0.5]
    assert [event.after for event in events] == ["ERROR", "RECOVERY", "NORMAL"]


@pytest.mark.requirement("S5")
def test_a_robot_that_stays_ill_stays_in_error(supervised):
    loop, supervisor, _ = supervised
    supervisor.note_defect("a leaf raised")
    loop.defects = ("gyro biased",)

    refusal = supervisor.admit(lambda seconds: None)

    assert "gyro biased" in refusal.message
    assert supervisor.lifecycle.state is LifecycleState.ERROR


@pytest.mark.requirement("S4", "S5")
def test_after_a_persons_reset_the_next_command_recovers_first(supervised):
    loop, supervisor, events = supervised
    loop.emergency_stop("smoke")
    supervisor.stopped()

    assert supervisor.reset("Ana") is None
    assert supervisor.lifecycle.state is LifecycleState.RECOVERY
    assert supervisor.admit(lambda seconds: None) is None

    assert [event.after for event in events] == ["EMERGENCY", "RECOVERY", "NORMAL"]


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("categories", [(0, 1), (1, 0), (0, 2), (2, 1, 0, 1)])
def test_of_stops_within_one_period_the_severest_counts(supervised, categories):
    loop, supervisor, _ = supervised
    for category in categories:
        supervisor.emergency_stop(f"category {category}", category)

    supervisor.before_period()

    assert loop.emergency.category == 0
    assert loop.emergency.reason == "category 0"


@pytest.mark.requirement("F5", "S5")
def test_a_command_to_a_robot_that_fell_ill_meanwhile_is_refused_with_the_reason(supervised):
    loop, supervisor, events = supervised
    loop.defects = ("motor offline: arm_left_2_joint",)

    refusal = supervisor.admit(lambda seconds: None)

    assert "motor offline: arm_left_2_joint" in refusal.message
    assert [event.after for event in events] == ["ERROR", "RECOVERY", "ERROR"]


@pytest.mark.requirement("F7")
def test_with_a_low_battery_no_new_task_is_begun(supervised):
    loop, supervisor, _ = supervised
    loop.reservations = ("battery low: battery (0.1, bound 0.15)",)

    refusal = supervisor.admit(lambda seconds: None)

    assert refusal.kind is FailureKind.REFUSED
    assert "battery low" in refusal.message
    assert supervisor.lifecycle.state is LifecycleState.NORMAL
