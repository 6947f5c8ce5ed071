"""A contest puts the same problems to everybody, judges every answer, and compares like with like."""

import numpy as np
import pytest

from tools.benchmark.contest import Answer, run_contest, standings
from tools.benchmark.problems.problem import Problem
from tools.benchmark.report import contest_figures


def problem(number, family="box"):
    return Problem(family, number, (), np.zeros(7), np.ones(7))


class Planner:
    """Solves every problem in a fixed time, but those that it cannot."""

    def __init__(self, name, seconds, order, unsolved=()):
        self.name, self.seconds, self.order, self.unsolved = name, seconds, order, unsolved

    def plan(self, problem, seed):
        self.order.append((self.name, problem.number))
        solved = problem.number not in self.unsolved
        path = np.array([problem.start, problem.goal]) if solved else None
        return Answer(path, 0.001, self.seconds / 2, self.seconds / 2)


def always(problem, path):
    return True


def test_planners_take_turns_and_each_begins_in_its_turn():
    order = []
    planners = [Planner("a", 0.1, order), Planner("b", 0.1, order)]

    run_contest(planners, [problem(0), problem(1)], always)

    warmed_up, counted = order[:2], order[2:]
    assert warmed_up == [("a", 0), ("b", 0)]
    assert counted == [("a", 0), ("b", 0), ("b", 1), ("a", 1)]


def test_the_warm_up_is_not_counted():
    results = run_contest([Planner("a", 0.1, [])], [problem(0)], always)

    assert len(results) == 1


def test_times_are_compared_on_problems_that_both_solved():
    ours, peer = Planner("ours", 0.010, []), Planner("peer", 0.050, [], unsolved={1})

    first, second = standings(run_contest([ours, peer], [problem(0), problem(1)], always))

    assert (first.planner, first.solved, first.times_slower) == ("ours", 1.0, None)
    assert second.solved == pytest.approx(0.5)
    assert second.times_slower == pytest.approx(5.0)
    assert second.times_longer == pytest.approx(1.0)


def test_an_answer_that_the_referee_refuses_is_told():
    results = run_contest([Planner("a", 0.1, [])], [problem(0), problem(1)], lambda p, path: p.number == 0)

    (standing,) = standings(results)

    assert standing.solved == 1.0
    assert standing.valid == pytest.approx(0.5)


def test_the_length_of_a_path_that_is_not_valid_does_not_count():
    ours, peer = Planner("ours", 0.01, []), Planner("peer", 0.01, [])

    def fair(problem, path):
        return problem.number == 0

    _, second = standings(run_contest([ours, peer], [problem(0), problem(1)], fair))

    assert second.length_rad == pytest.approx(np.sqrt(7.0))
    assert second.times_longer == pytest.approx(1.0)


def test_no_valid_path_has_no_length():
    (standing,) = standings(run_contest([Planner("a", 0.1, [])], [problem(0)], lambda p, path: False))

    assert standing.length_rad is None


def test_several_families_are_summed_up_in_the_end():
    planner = Planner("a", 0.1, [])

    found = standings(run_contest([planner], [problem(0), problem(0, "cage")], always))

    assert [item.family for item in found] == ["box", "cage", "all"]
    assert found[-1].problems == 2


def test_a_planner_that_solves_nothing_stands_with_nothing():
    (standing,) = standings(run_contest([Planner("a", 0.1, [], unsolved={0})], [problem(0)], always))

    assert (standing.solved, standing.valid, standing.median_ms) == (0.0, 0.0, None)
    assert contest_figures("plan, ms", [standing]) == []


def test_figures_set_the_first_planner_beside_each_of_the_others():
    planners = [Planner(name, seconds, []) for name, seconds in (("ours", 0.01), ("x", 0.02), ("y", 0.03))]

    figures = contest_figures("plan, ms", standings(run_contest(planners, [problem(0)], always)))

    assert [(f.peer, f.ours, f.peer_value) for f in figures] == [
        ("x", pytest.approx(10.0), pytest.approx(20.0)),
        ("y", pytest.approx(10.0), pytest.approx(30.0)),
    ]
    assert figures[0].ratio == pytest.approx(0.5)
