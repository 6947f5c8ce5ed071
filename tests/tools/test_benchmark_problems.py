"""The benchmark's problems: the same for the same seed, and each of them valid by the referee."""

import json

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import FLOOR, SceneObject
from tools.benchmark.problems.arm_judge import Arm, ArmJudge, path_length
from tools.benchmark.problems.families import FAMILIES
from tools.benchmark.problems.generator import LINE_STEP_RAD, READY, problems
from tools.benchmark.problems.panda_files import JOINTS, write_panda
from tools.benchmark.problems.problem import Problem


@pytest.fixture(scope="module")
def arm(tmp_path_factory):
    return Arm(write_panda(tmp_path_factory.mktemp("panda")))


def block(name, size, centre):
    return SceneObject(name, Box(size), poses.translation(*centre), movable=False)


def as_text(drawn):
    return [json.dumps(problem.to_json()) for problem in drawn]


def test_the_arm_has_its_seven_joints_and_fixed_fingers(arm):
    assert tuple(arm.model.names)[1:] == JOINTS


def test_every_mesh_became_a_convex_hull(arm):
    kinds = {type(item.geometry).__name__ for item in arm.geometry.geometryObjects}

    assert kinds == {"Convex", "Box"}


@pytest.mark.parametrize("family", FAMILIES)
def test_a_problem_is_the_same_for_the_same_seed_however_many_are_drawn(arm, family):
    assert as_text(problems(arm, family, 2, seed=3)) == as_text(problems(arm, family, 3, seed=3))[:2]


@pytest.mark.parametrize("family", FAMILIES)
def test_another_seed_gives_other_problems(arm, family):
    assert as_text(problems(arm, family, 1, seed=3)) != as_text(problems(arm, family, 1, seed=4))


@pytest.mark.parametrize("family", FAMILIES)
def test_start_and_goal_are_free_and_the_straight_line_between_them_is_not(arm, family):
    for problem in problems(arm, family, 3, seed=11):
        judge = ArmJudge(arm, problem.objects)

        for q in (problem.start, problem.goal):
            assert judge.within_limits(q)
            assert not judge.collides(q)
        assert not judge.edge_is_free(problem.start, problem.goal, LINE_STEP_RAD)


@pytest.mark.parametrize("family", FAMILIES)
def test_solids_have_names_of_their_own_and_there_is_one_floor(arm, family):
    (problem,) = problems(arm, family, 1, seed=5)
    names = [item.name for item in problem.objects]

    assert len(set(names)) == len(names)
    assert names.count(FLOOR) == 1


def test_a_problem_survives_being_written_down(arm):
    (problem,) = problems(arm, "kitchen", 1, seed=2)

    again = Problem.from_json(json.loads(json.dumps(problem.to_json())))

    assert again.name == "kitchen/0"
    assert np.array_equal(again.start, problem.start)
    assert np.array_equal(again.goal, problem.goal)
    for ours, theirs in zip(problem.objects, again.objects, strict=True):
        assert (ours.name, ours.shape) == (theirs.name, theirs.shape)
        assert np.allclose(ours.world_T_object, theirs.world_T_object, atol=1e-12)


def test_the_referee_sees_a_block_in_the_way_of_a_line_and_none_beside_it(arm):
    swung = READY + np.array([1.2, 0, 0, 0, 0, 0, 0])
    tcp = arm.tcp(READY + np.array([0.6, 0, 0, 0, 0, 0, 0]))[:3, 3]
    in_the_way = block("post", (0.02, 0.02, 1.0), (tcp[0], tcp[1], 0.5))
    beside = block("post", (0.02, 0.02, 1.0), (-tcp[0], tcp[1], 0.5))

    assert not ArmJudge(arm, [in_the_way]).edge_is_free(READY, swung)
    assert ArmJudge(arm, [beside]).edge_is_free(READY, swung)


def test_the_referee_sees_a_wire_that_a_coarse_look_would_miss(arm):
    swung = READY + np.array([1.2, 0, 0, 0, 0, 0, 0])
    tcp = arm.tcp(READY + np.array([0.61, 0, 0, 0, 0, 0, 0]))[:3, 3]
    wire = block("wire", (0.002, 0.002, 1.0), (tcp[0], tcp[1], 0.5))
    judge = ArmJudge(arm, [wire])

    assert not judge.edge_is_free(READY, swung)
    assert judge.edge_is_free(READY, swung, step_rad=1.2)


def test_a_clearance_makes_the_referee_stricter(arm):
    tcp = arm.tcp(READY)[:3, 3]
    near = block("plate", (0.4, 0.4, 0.02), (tcp[0], tcp[1], tcp[2] - 0.04))
    gap = next(c for c in np.arange(0.002, 0.06, 0.002) if ArmJudge(arm, [near], float(c)).collides(READY))

    assert not ArmJudge(arm, [near]).collides(READY)
    assert 0.004 < gap < 0.05


def test_a_path_outside_the_limits_is_not_free(arm):
    beyond = arm.upper + 0.1

    assert not ArmJudge(arm, []).path_is_free(np.array([READY, beyond]))


def test_the_length_of_a_path_is_that_of_its_pieces():
    path = np.array([np.zeros(7), [3.0, 4.0, 0, 0, 0, 0, 0], [3.0, 4.0, 0, 0, 0, 0, 2.0]])

    assert path_length(path) == pytest.approx(7.0)
