"""The arm's contest runs with whoever is there, and its referee asks for more than free points."""

import numpy as np
import pytest

from tools.benchmark.arm import Referee, arm_contest
from tools.benchmark.collision import LENGTH_RAD, OwnEdgeJudge, _edges
from tools.benchmark.contest import Answer
from tools.benchmark.own_arm_planner import OwnArmPlanner
from tools.benchmark.problems.arm_judge import Arm, ArmJudge
from tools.benchmark.problems.generator import problems
from tools.benchmark.problems.panda_files import write_panda


@pytest.fixture(scope="module")
def arm(tmp_path_factory):
    return Arm(write_panda(tmp_path_factory.mktemp("panda")))


class Straight:
    """Always takes the straight line, which is never free."""

    name = "straight"

    def plan(self, problem, seed):
        return Answer(np.array([problem.start, problem.goal]), 0.0, 0.001, 0.0)


def test_without_any_peer_the_own_planners_are_judged_alone(tmp_path):
    results = arm_contest(1, 0, tmp_path, ours=[Straight()], families=("box", "table_pick"))

    assert [(r.planner, r.family, r.solved, r.valid) for r in results] == [
        ("straight", "box", True, False),
        ("straight", "table_pick", True, False),
    ]


def test_the_products_planner_solves_a_problem_to_the_referees_content(arm):
    (problem,) = problems(arm, "box", 1, seed=0)

    answer = OwnArmPlanner().plan(problem, 0)

    assert answer.path is not None
    assert Referee(arm)(problem, answer.path)


def test_the_referee_refuses_a_path_that_does_not_end_at_the_goal(arm):
    (problem,) = problems(arm, "box", 1, seed=0)
    path = OwnArmPlanner().plan(problem, 0).path

    assert not Referee(arm)(problem, path[:-20])


def test_edges_begin_free_and_have_their_length(arm):
    objects, edges = next(_edges(arm, 1))
    judge = ArmJudge(arm, objects)

    assert not any(judge.collides(a) for a, _ in edges)
    assert np.allclose(np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1), LENGTH_RAD)


def test_the_products_judge_of_edges_agrees_with_the_referee(arm):
    objects, edges = next(_edges(arm, 1))
    referee = ArmJudge(arm, objects)

    free, seconds = OwnEdgeJudge().judge(objects, edges[:6])

    assert free == [referee.edge_is_free(a, b) for a, b in edges[:6]]
    assert seconds > 0.0
