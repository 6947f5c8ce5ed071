"""Planning is answered at once, and counts only when its charged time has passed."""

from concurrent.futures import Executor, Future

import pytest

from executive.session.planning_jobs import PlanningJobs
from kinematics.motion.verdict import Unsafe
from kinematics.requests.check import CheckRequest
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
    return PlanningJobs(planner, None, clock, events.append, charged_s=0.1), clock, events


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


class Later(Executor):
    """Answers when it is told to, as a worker does."""

    def submit(self, fn, /, *args, **kwargs):
        self.future, self._work = Waiting(), lambda: fn(*args, **kwargs)
        return self.future

    def work(self):
        self.future.set_result(self._work())


class Waiting(Future):
    """A future that nobody may wait for."""

    def exception(self, timeout=None):
        assert self.done(), "the tick waits for the planner"
        return super().exception(timeout)


@pytest.fixture
def later():
    clock, events, executor = ManualClock(), [], Later()
    return (
        PlanningJobs(Planner(), None, clock, events.append, executor, charged_s=0.1),
        clock,
        events,
        executor,
    )


def test_nobody_waits_for_a_planner_that_works_elsewhere(later):
    planning, clock, events, executor = later
    job = planning.submit("request")
    clock.advance(0.2)

    assert not job.done
    assert not events
    executor.work()
    assert job.done
    assert job.result() == "plan"


def test_a_late_answer_is_told_once_when_it_is_there(later):
    planning, clock, events, executor = later
    job = planning.submit("request")
    executor.work()
    clock.advance(0.2)

    assert (job.done, job.done) == (True, True)
    assert [(event.t_s, event.ready_s, event.answer) for event in events] == [(0.2, 0.1, "str")]


def test_nothing_is_told_of_what_was_cancelled(later):
    planning, clock, events, _ = later
    job = planning.submit("request")
    job.cancel()
    clock.advance(0.2)

    assert job.done
    assert not events


class Checker:
    """Says to everything what it was told to say."""

    def __init__(self, verdict):
        self._verdict = verdict

    def check(self, trajectory, scene, concessions):
        self.asked = trajectory, scene, concessions
        return self._verdict


@pytest.fixture
def question():
    return CheckRequest("trajectory", "scene", ("concession",))


def test_a_check_goes_to_the_checker_and_never_to_the_planner(question):
    clock, checker = ManualClock(), Checker(Unsafe(()))
    planning = PlanningJobs(Planner(AssertionError("asked")), checker, clock, lambda _event: None)

    job = planning.check(question)

    assert job.result() is checker._verdict
    assert checker.asked == ("trajectory", "scene", ("concession",))


def test_each_verdict_is_told_with_its_question(question):
    heard, verdict = [], Unsafe(())
    planning = PlanningJobs(
        None, Checker(verdict), ManualClock(), lambda _event: None, on_judged=lambda *told: heard.append(told)
    )

    planning.check(question)

    assert heard == [(question, verdict)]


def test_a_check_is_told_of_and_charged_as_planning_is(question):
    clock, events = ManualClock(), []
    planning = PlanningJobs(None, Checker(Unsafe(())), clock, events.append, charged_s=0.1)

    job = planning.check(question)

    assert not job.done
    assert [(event.request, event.answer) for event in events] == [("CheckRequest", "Unsafe")]
