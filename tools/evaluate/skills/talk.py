"""Suites of say and wait."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from trees.events import Said
from trees.tasks import SayTask, WaitTask

LATE_S = 0.1
STILL_RAD = 0.01
_WORDS = ("hello", "good morning, Ana", "dinner is ready", "ça va ?", "the cup is on the table")


class SayJudge:
    """Listens."""

    def __init__(self, _assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._task = trial.tasks[-1]
        self._heard: list[str] = []

    def on_event(self, event: object) -> None:
        """Hear what is said."""
        if isinstance(event, Said):
            self._heard.append(event.text)

    def on_period(self) -> None:
        """Nothing to see."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Said once, word for word."""
        done = self._heard == [getattr(self._task, "words", "")]
        return Verdict(done, {"heard": len(self._heard)}, "" if done else f"heard {self._heard}")


class WaitJudge:
    """Measures the time, and whether the robot kept still."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._task = assembly.world.truth, trial.tasks[-1]
        self._start = self._truth.joint_positions()
        self._moved = 0.0

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """See whether joints move, once the body has found its weight."""
        now_s = self._truth.time_s
        if now_s < 0.2:
            self._start = self._truth.joint_positions()
        self._moved = max(self._moved, float(np.abs(self._truth.joint_positions() - self._start).max()))

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """As long as asked, and still."""
        wanted = getattr(self._task, "duration_s", 0.0)
        late = results[-1].times.simulated_s - wanted
        done = -1e-6 <= late <= LATE_S and self._moved <= STILL_RAD
        return Verdict(done, {"late_s": late, "moved_rad": self._moved}, "" if done else "not as asked")


def say_trial(rng: np.random.Generator) -> Trial:
    """Any words."""
    words = _WORDS[int(rng.integers(len(_WORDS)))]
    return Trial(rooms.room("say", rng), (SayTask(f"say {words}", words),))


def wait_trial(rng: np.random.Generator) -> Trial:
    """Any time up to five seconds."""
    duration_s = round(float(rng.uniform(0.1, 5.0)), 2)
    return Trial(rooms.room("wait", rng), (WaitTask(f"wait {duration_s} s", duration_s),))


SAY = SkillSuite(say_trial, SayJudge)
WAIT = SkillSuite(wait_trial, WaitJudge)
