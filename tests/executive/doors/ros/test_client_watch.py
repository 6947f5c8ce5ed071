"""The watch over the client of an action's goal."""

import pytest

from executive.doors.ros.node.client_watch import GRACE_S, LEASE_S, ClientWatch

pytestmark = pytest.mark.requirement("S7")
A, B = b"a", b"b"  # each is its participant's id as well
STEP_S = 0.1


class Listeners:
    """Listeners of the feedback: some in the graph, some of them dead; time goes on by steps."""

    def __init__(self, *there):
        self.there, self.dead, self.silent, self.ended = set(there), set(), set(), set()
        self.now_s, self.sent = 100.0, 0

    def goal(self):
        return ClientWatch(
            lambda: frozenset(self.there),
            self._ask,
            lambda: not self.dead & self.there,
            self.silent,
            self.now_s,
            lambda one: one in self.ended,
        )

    def _ask(self):
        self.sent += 1

    def gone_after(self, watch, within_s, tell=lambda: False):
        """How long it takes until the client is said to be gone; None when it never is."""
        began_s = self.now_s
        while self.now_s - began_s < within_s:
            if tell():
                watch.told(self.now_s)
            if watch.is_gone(self.now_s):
                return self.now_s - began_s
            self.now_s += STEP_S
        return None


def test_a_client_that_acknowledges_stays():
    clients = Listeners(A)

    assert clients.gone_after(clients.goal(), 60.0) is None
    assert clients.sent > 50


def test_a_killed_client_is_gone_after_the_lease():
    clients = Listeners(A)
    watch = clients.goal()
    assert clients.gone_after(watch, 10.0) is None

    clients.dead = {A}

    assert clients.gone_after(watch, 60.0) <= LEASE_S + 2 * STEP_S


def test_a_client_that_leaves_the_graph_is_gone_at_once():
    clients = Listeners(A)
    watch = clients.goal()
    assert clients.gone_after(watch, GRACE_S + 1.0) is None

    clients.there = set()

    assert clients.gone_after(watch, 60.0) == 0.0


def test_a_client_that_the_graph_finds_late_is_the_goals():
    clients = Listeners()
    watch = clients.goal()
    assert clients.gone_after(watch, GRACE_S - 1.0) is None

    clients.there = {A}

    assert clients.gone_after(watch, 60.0) is None


def test_nobody_who_listens_is_a_client_that_is_gone():
    clients = Listeners()

    assert GRACE_S < clients.gone_after(clients.goal(), 60.0) <= GRACE_S + 2 * STEP_S


def test_a_stranger_that_dies_ends_nobodys_goal():
    clients = Listeners(A, B)
    watch = clients.goal()

    clients.dead = {B}
    assert clients.gone_after(watch, 20.0) is None
    clients.there, clients.dead = {A}, set()

    assert clients.gone_after(watch, 60.0) is None


def test_a_killed_client_beside_another_is_gone_when_the_graph_says_so():
    clients = Listeners(A)
    watch = clients.goal()
    clients.there, clients.dead = {A, B}, {A}
    assert clients.gone_after(watch, 20.0) is None

    clients.there, clients.dead = {B}, set()

    assert clients.gone_after(watch, 60.0) == 0.0


def test_a_killed_client_beside_another_is_gone_after_the_lease_where_its_process_has_ended():
    clients = Listeners(A)
    watch = clients.goal()
    clients.there = {A, B}
    assert clients.gone_after(watch, 20.0) is None

    clients.dead = clients.ended = {A}

    assert clients.gone_after(watch, 60.0) <= LEASE_S + 0.5 + 2 * STEP_S


def test_an_ended_process_is_none_while_everything_is_acknowledged():
    clients = Listeners(A, B)
    watch = clients.goal()

    clients.ended = {A, B}  # numbers of processes, misread

    assert clients.gone_after(watch, 60.0) is None


@pytest.mark.parametrize(("dies", "gone"), [(A, True), (B, False)])
def test_of_two_listeners_it_is_the_sender_whose_death_counts(dies, gone):
    clients = Listeners(A, B)
    watch = clients.goal()
    watch.sent_by(A)
    assert clients.gone_after(watch, 20.0) is None

    clients.dead = clients.ended = {dies}

    assert (clients.gone_after(watch, 19.0) is not None) is gone


def test_the_sender_that_the_graph_finds_late_is_the_client():
    clients = Listeners(B)
    watch = clients.goal()
    watch.sent_by(A)
    assert clients.gone_after(watch, GRACE_S - 1.0) is None

    clients.there = {A, B}
    assert clients.gone_after(watch, 20.0) is None
    clients.there = {B}

    assert clients.gone_after(watch, 60.0) == 0.0


def test_a_dead_client_that_lingers_in_the_graph_ends_not_the_next_ones_goal():
    clients = Listeners(A)
    clients.dead = {A}
    assert clients.gone_after(clients.goal(), 60.0) is not None

    clients.there = {A, B}
    watch = clients.goal()
    assert clients.gone_after(watch, 15.0) is None
    clients.there, clients.dead = {B}, {B}

    assert clients.gone_after(watch, 60.0) <= LEASE_S + 2 * STEP_S


def test_a_client_that_tells_its_goal_is_judged_by_that_alone():
    clients = Listeners(A, B)
    watch = clients.goal()
    clients.dead = {B}
    assert clients.gone_after(watch, 30.0, lambda: True) is None

    assert clients.gone_after(watch, 60.0) <= LEASE_S + 2 * STEP_S


def test_a_client_that_was_held_up_and_goes_on_has_its_next_goal_heard_out():
    clients = Listeners(A)
    clients.dead = {A}
    assert clients.gone_after(clients.goal(), 60.0) is not None

    clients.dead = set()

    assert clients.gone_after(clients.goal(), 60.0) is None
