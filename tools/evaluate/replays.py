"""Recorded runs, meddled with at random, and replayed: every event must come out the same.

A fifth of the runs is left alone, the others are cancelled, stopped by the emergency stop in the middle of a
control tick, asked a question that is answered, withdrawn or ignored, or given a script.
"""

from __future__ import annotations

import tempfile
import traceback
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from executive.attendant import Nobody, Stoppable
from executive.clarification import OpenQuestion
from executive.outputs.display import NoDisplay
from executive.performance import perform
from executive.replay import replay
from executive.run_log import recorded_run
from executive.run_request import RunRequest
from executive.task_script import script_for
from robots.scene_file import dump
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.questions import ambiguous_trial
from tools.evaluate.records import EpisodeRecord
from tools.evaluate.scenes import SENTENCE, episode_rng, pick_scene

MEDDLINGS = ("none", "cancel", "stop", "question", "script")
LATEST_S = 9.0
"""Meddled with before: a pick takes about so long."""


@dataclass
class _Meddler(Nobody):
    """Does one thing at one time."""

    what: str
    at_s: float
    reply: str | None

    def begin(self, session: Stoppable) -> None:
        """Have an eye on every control period."""
        session.watch_periods(lambda: self._stop(session))

    def answer(self, question: OpenQuestion) -> str | None:
        """Give the answer that was drawn."""
        return self.reply if not question.tried else None

    def attend(self, session: Stoppable) -> None:
        """Cancel when it is time."""
        if self.what == "cancel" and session.now_s >= self.at_s:
            self.what = ""
            session.cancel("at a random instant")

    def _stop(self, session: Stoppable) -> None:
        if self.what == "stop" and session.now_s >= self.at_s:
            self.what = ""
            session.emergency_stop("at a random instant")


def run_replay_episode(order: EpisodeOrder) -> EpisodeRecord:
    """Record a run, replay it, compare; whatever breaks becomes the record."""
    try:
        with tempfile.TemporaryDirectory() as folder:
            return _run(order, Path(folder))
    except Exception as broken:
        said = f"{type(broken).__name__}: {broken}"
        return EpisodeRecord(order.seed, "error", False, "ERROR", said, detail=traceback.format_exc())


def _run(order: EpisodeOrder, folder: Path) -> EpisodeRecord:
    rng = episode_rng(order.seed, 30)
    what = MEDDLINGS[order.seed % len(MEDDLINGS)]
    meddler = _Meddler(what, float(rng.uniform(0.1, LATEST_S)), _reply(rng))
    request = _request(order, folder, what)
    performance = perform(request, NoDisplay(), meddler)
    verdict = replay(recorded_run(request.record, performance.run_name))
    told = " ".join(verdict.lines()) if verdict.difference is not None else None
    simulated_s = sum(task.times.simulated_s for task in performance.report.tasks)
    return EpisodeRecord(
        seed=order.seed,
        outcome="done" if verdict.difference is None else "failed",
        truth=verdict.difference is None and verdict.events > 0,
        failure_kind=None if told is None else what,
        failure=told,
        attempts=verdict.events,
        simulated_s=simulated_s,
    )


def _reply(rng: np.random.Generator) -> str | None:
    return (None, "never mind", "1", "the second one")[int(rng.integers(4))]


def _request(order: EpisodeOrder, folder: Path, what: str) -> RunRequest:
    scene, script = folder / "scene.toml", folder / "script.toml"
    text = SENTENCE
    if what == "question":
        trial = ambiguous_trial(order.seed)
        scene.write_text(dump(trial.scene), "utf-8")
        text = trial.sentence
    else:
        scene.write_text(pick_scene(order.seed), "utf-8")
    if what == "script":
        script.write_text(
            '[[task]]\nsay = "go home"\n[[task]]\nsay = "fly away"\nexpect = "refused"\n'
            '[[task]]\nsay = "pick up the purple ball"\nexpect = "failed"\n',
            "utf-8",
        )
        text = str(script)
    return RunRequest(
        input=text,
        statements=script_for(text).statements,
        robot=order.robot,
        scene=str(scene),
        seed=order.seed,
        record=folder / "runs",
        script=script if what == "script" else None,
    )
