"""The peers' pick is put together as the product's: cheap filters first, and an end with the first plan."""

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from kinematics.planning.grasps import ABOVE_MIDDLE
from kinematics.planning.pick_task import PickTask
from robots.models.description import load_description
from tools.benchmark.peers.picks import PeerPick, PeerPicker, natural_grasps
from tools.benchmark.pick import Trial, peer_figures, peer_notes
from tools.benchmark.problems.picks import picks

# Processor time that every answer of the fakes says, s.
EACH_S = 0.001


class Fakes:
    """All three peers: they agree to everything but what a test says otherwise."""

    def __init__(self, size=9, **answers):
        self.asked, self._size, self._answers = [], size, answers

    def ask(self, question, **values):
        self.asked.append((question, values))
        answer = self._answers.get(question, self._usual(question, values))
        return {"answer": answer(values) if callable(answer) else answer, "seconds": EACH_S}

    def _usual(self, question, values):
        if question == "follow":
            targets = values["targets"]
            return {"points": [[0.0] * self._size for _ in targets], "states": [[] for _ in targets]}
        if question == "time":
            return {"by_way": values["points"], "by_time": values["points"]}
        return None if question == "detour" else True

    def questions(self):
        return [question for question, _ in self.asked if question not in ("load", "scene")]


@pytest.fixture(scope="module")
def talos():
    return RobotModel(load_description("talos"))


@pytest.fixture
def plan(talos, tmp_path):
    def plan(fakes):
        picker = PeerPicker(talos, dict.fromkeys(("mink", "ompl", "toppra"), fakes), tmp_path, False)
        return picker.pick(next(picks(talos, 1, seed=0)))

    return plan


def test_the_first_grasp_whose_motions_hold_ends_the_pick(plan):
    fakes = Fakes()

    answer = plan(fakes)

    assert answer.solved
    assert fakes.questions().count("has_room") == 1
    assert fakes.questions().count("time") == 3


def test_judging_by_time_does_not_count_beside_judging_by_way(plan):
    answer = plan(Fakes())

    others = sum(answer.seconds.values()) - 6 * EACH_S
    assert answer.by_way_s == pytest.approx(others + 3 * EACH_S)
    assert answer.by_time_s == pytest.approx(others + 3 * EACH_S)
    assert answer.seconds["judgement"] == pytest.approx(3 * EACH_S)


def test_a_hand_without_room_costs_no_inverse_kinematics(plan):
    fakes = Fakes(has_room=False)

    answer = plan(fakes)

    assert not answer.solved
    assert set(fakes.questions()) == {"has_room"}


def test_blocked_straight_reaches_get_detours_at_last(plan):
    fakes = Fakes(straight=False, detour=[[0.0] * 9, [0.1] * 9])

    assert plan(fakes).solved
    first = fakes.questions().index("detour")
    assert fakes.questions()[:first].count("straight") == 8


def test_a_plan_that_the_judgement_refuses_is_none(plan):
    assert not plan(Fakes(free=lambda values: len(values["points"]) < 3)).solved


def test_a_peer_that_moves_the_whole_body_starts_from_the_pelvis_where_it_is(talos, tmp_path):
    fakes = Fakes(size=15)
    picker = PeerPicker(talos, dict.fromkeys(("mink", "ompl", "toppra"), fakes), tmp_path, True)

    assert picker.pick(next(picks(talos, 1, seed=0))).solved

    start = next(values["start"] for question, values in fakes.asked if question == "straight")
    assert start[:3] == pytest.approx(talos.q_home[:3])
    assert len(start) == 15


def trial(own_ms, by_way_ms, by_time_ms, solved=True):
    seconds = {"ik": 0.0, "judgement": 1e-3 * by_way_ms, "judgement by time": 1e-3 * by_time_ms}
    return Trial(None, solved, 1e-3 * own_ms, {"whole body": PeerPick(True, seconds)})


def test_picks_that_one_side_did_not_plan_are_in_no_ratio():
    trials = [trial(10.0, 20.0, 70.0), trial(20.0, 40.0, 140.0), trial(1.0, 999.0, 999.0, solved=False)]

    by_way, by_time = peer_figures(trials)

    assert by_way.peer_value / by_way.ours == pytest.approx(2.0)
    assert by_time.peer_value / by_time.ours == pytest.approx(7.0)


def test_the_notes_tell_how_many_were_planned_and_the_spread():
    trials = [trial(10.0, factor * 10.0, factor * 30.0) for factor in np.linspace(1.0, 5.0, 5)]

    (text,) = peer_notes(trials)

    assert "5 of 5 picks planned" in text
    assert "2.0–4.0 and at the p95 4.8 (every 1/256 rad)" in text
    assert "6.0–12.0 and at the p95 14.4 (every 0.5 ms)" in text


def test_without_peers_there_is_nothing_to_compare():
    trials = [Trial(None, True, 0.01, {})]

    assert peer_figures(trials) == []
    assert peer_notes(trials) == []


def test_the_peers_get_the_products_grasps_in_its_order(talos):
    request = next(picks(talos, 1, seed=0))
    task = PickTask(talos, request, (ABOVE_MIDDLE,), 0.0, upright=True)

    grasps = natural_grasps(talos, request, (ABOVE_MIDDLE,))

    fitting = [(item.grasp.hand, item.grasp.label) for item in task.candidates()]
    given = [(item.grasp.hand, item.grasp.label) for item in grasps]
    assert len(fitting) > 10
    assert [name for name in given if name in fitting] == fitting
