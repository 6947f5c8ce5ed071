"""Sequences ask for what can be done: each skill once, nothing that was given away, one thing in a hand."""

import numpy as np
import pytest

from tools.evaluate.skills.sequences import LENGTH, one_by_one, sequence_trial

GONE_AFTER = ("put_in", "hand_over")


@pytest.fixture(scope="module")
def trials():
    return [sequence_trial(np.random.default_rng(seed)) for seed in range(40)]


def require_possible(trial):
    aims = trial.aim.split(", ")
    gone, held = set(), None
    for task, aim in zip(trial.tasks, aims, strict=True):
        assert aim not in gone
        if task.action == "pick":
            held = aim
        elif task.action in ("place", *GONE_AFTER):
            assert held in (None, aim)
            held = None
        elif task.action in ("point_at", "look_at", "find"):
            assert aim != held
        if task.action == "put_in":
            assert "bottle" not in aim
        if task.action in GONE_AFTER:
            gone.add(aim)


def test_a_sequence_can_be_carried_out(trials):
    for trial in trials:
        require_possible(trial)


def test_all_skills_come_up_and_none_twice(trials):
    for trial in trials:
        assert len({task.action for task in trial.tasks}) == LENGTH
    assert len({task.action for trial in trials for task in trial.tasks}) == 8


def test_what_was_given_away_may_move_with_the_hand_that_has_it(trials):
    for trial in trials:
        actions = [task.action for task in trial.tasks]
        given_at = actions.index("hand_over") if "hand_over" in actions else LENGTH
        for place, one in enumerate(one_by_one(trial)):
            assert bool(one.given) is (place > given_at)
            assert one.aim not in one.given
