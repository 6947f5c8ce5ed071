"""Instants are drawn as wanted, branches deliver, and every broken demand is named."""

import numpy as np
import pytest

from tools.evaluate.ailing.fault_record import FaultRecord, FaultSummary
from tools.evaluate.stopping.branch import Branches
from tools.evaluate.stopping.courses import CYCLE, MOVING_PHASES, STILL_PHASES, phase_of
from tools.evaluate.stopping.stop_episode import stop_orders
from tools.evaluate.stopping.stop_record import StopRecord, StopSummary
from tools.evaluate.stopping.timeline import Moment, choose

GOOD = StopRecord(1, "pick", 3.0, "reach", 0.5, 1, refused=True)


def moments():
    phases = ["search", "reach", "approach", "close", "lift", "recover", "hold"]
    return [
        Moment(10.0 * k + 0.01 * i, phase, 0.5 if phase in ("reach", "lift") and i > 100 else 0.0)
        for k, phase in enumerate(phases)
        for i in range(300)
    ]


def test_instants_lie_in_the_wanted_phases_and_in_motion_where_there_is_any():
    chosen = choose(moments(), ("lift", "search", "reach"), np.random.default_rng(1))

    assert [moment.phase for moment in chosen] == ["search", "reach", "lift"]
    assert all(moment.arm_rad_s > 0.1 for moment in chosen[1:])


def test_where_a_phase_never_comes_an_instant_of_motion_is_drawn():
    chosen = choose([m for m in moments() if m.phase != "recover"], ("recover",), np.random.default_rng(1))

    assert chosen[0].arm_rad_s > 0.1


@pytest.mark.parametrize(
    ("where", "phase"),
    [
        ("pick/search/look ahead/look", "search"),
        ("pick/reach/stream reach", "reach"),
        ("pick/grasp/close gripper", "close"),
        ("pick/attempts/recover/look again/search/look", "recover"),
        ("go home/move home", "recover"),
        ("pick/plan/plan pick", "plan"),
        ("place/set down/transfer", "place"),
        ("wave/swing hand", "gesture"),
        ("open or close/move/lead handle", "open"),
        ("move/walk", "walk"),
    ],
)
def test_a_place_in_the_tree_belongs_to_a_phase(where, phase):
    assert phase_of(where) == phase


def test_the_courses_stop_a_moving_arm_often_enough_and_come_to_every_phase():
    orders = stop_orders("stop", 300, 0, "talos")
    wanted = [phase for order in orders for phase in order.wanted]

    assert sum(phase in MOVING_PHASES for phase in wanted) >= 0.7 * len(wanted)
    assert set(wanted) == {*MOVING_PHASES, *STILL_PHASES} == {p for course in CYCLE for p in course.wanted}
    assert min(wanted.count(phase) for phase in set(wanted)) >= 20


def test_orders_hold_as_many_instants_as_asked_for():
    assert sum(len(order.wanted) for order in stop_orders("stop", 30, 5, "talos")) == 30


def test_a_branch_delivers_what_it_found_and_changes_nothing_here():
    branches, here = Branches(), []
    if branches.split():
        here.append("only in the copy")
        branches.deliver(GOOD)

    assert here == []
    assert branches.results == [GOOD]


def test_a_branch_that_breaks_delivers_its_traceback():
    branches = Branches()
    if branches.split():
        try:
            raise ValueError("broken on purpose")
        except ValueError:
            branches.break_off()

    assert "broken on purpose" in branches.results[0]


BROKEN = [
    ({"late_rad_s": 0.021}, "still moving"),
    ({"acceleration": 1.01}, "acceleration"),
    ({"jerk": 1.01}, "jerk"),
    ({"fell": True}, "fell"),
    ({"dropped": ("cup",)}, "dropped"),
    ({"foreign": ("motion-3",)}, "foreign setpoints"),
    ({"bypassed": 1}, "foreign setpoints"),
    ({"moved": True}, "moved before the reset"),
    ({"refused": False}, "command not refused"),
    ({"reset": "not at rest"}, "reset refused"),
    ({"next_task": "go home", "next_outcome": "failed"}, "next task"),
    ({"error": "Traceback"}, "broken"),
]


@pytest.mark.parametrize(("change", "name"), BROKEN)
def test_every_broken_demand_is_named_and_misses_its_bar(change, name):
    from dataclasses import replace

    assert GOOD.faults == ()
    bad = replace(GOOD, **change)
    suite = "cancel" if name == "next task" else "stop"

    assert bad.faults == (name,)
    missed = [bar for bar in StopSummary(suite, 0, [GOOD, bad]).bars() if not bar.met]
    assert len(missed) == 1
    assert StopSummary(suite, 0, [GOOD, bad]).to_json()["failed_seeds"] == [1]


def test_a_fault_counts_as_unnoticed_only_when_the_joint_was_asked_for_something():
    quiet = FaultRecord(1, "joint_stuck", part="arm", asked_rad=0.001)
    asked = FaultRecord(2, "joint_stuck", part="arm", asked_rad=0.3)
    of_an_arm = FaultRecord(3, "joint_stuck", part="arm", asked_rad=0.008, shown_rad=0.006)

    assert quiet.faults == ()
    assert of_an_arm.faults == ("not noticed",)
    assert asked.faults == ("not noticed",)
    assert FaultSummary("joint_stuck", 0, [quiet, asked]).figures()["never asked for anything"] == 1.0


def test_a_weak_motor_that_gave_what_was_asked_for_has_shown_nothing():
    followed = FaultRecord(1, "joint_weak", part="knee", asked_rad=0.3, off_rad=0.001, of_a_motor=True)
    lagged = FaultRecord(2, "joint_weak", part="knee", asked_rad=0.3, off_rad=0.02, of_a_motor=True)

    assert followed.faults == ()
    assert lagged.faults == ("not noticed",)


def test_a_fall_is_excused_only_where_the_fault_fells_a_standing_robot_too():
    base = {"part": "knee", "noticed_s": 0.1, "typed": True, "refused": True, "fell": True}

    assert FaultRecord(1, "joint_offline", **base, fells_standing=True).faults == ()
    assert FaultRecord(1, "joint_offline", **base, fells_standing=False).faults == ("fell",)
