"""Planning is answered at once, and counts only when its charged time has passed."""

import pytest

from executive.planning_jobs import PlanningJobs
from robots.clock import ManualClock


class Planner:
    def __init__(self, answer="plan"):
        self._answer = answer

    def answer(self, request):
        if isinstance(self._answer, Exception):
            raise self._answer
        return self._answer


def jobs(planner):
    clock, events = ManualClock(), []
    return PlanningJobs(planner, clock, events.append, charged_s=0.1), clock, events


def test_a_job_is_not_done_before_its_charged_time_has_passed():
    planning, clock, _ = jobs(Planner())
    job = planning.submit("request")

    clock.advance(0.098)
    assert not job.done
    clock.advance(0.002)
    assert job.done
    assert job.result() == "plan"


def test_what_the_planner_raises_comes_out_of_the_result_only():
    planning, clock, events = jobs(Planner(ZeroDivisionError("plan")))
    job = planning.submit("request")
    clock.advance(0.1)

    with pytest.raises(ZeroDivisionError):
        job.result()
    assert events[0].answer == "ZeroDivisionError"


def test_each_answer_is_told_with_the_simulated_times_only():
    planning, clock, events = jobs(Planner())
    clock.advance(2.0)
    planning.submit("request")

    assert (events[0].t_s, events[0].ready_s, events[0].request) == (2.0, 2.1, "str")
    assert planning.wall_s >= 0.0
