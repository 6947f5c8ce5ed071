"""Recorded runs, meddled with at random, and replayed: every event must come out the same.

A seventh of the runs is left alone, the others are cancelled, stopped by the emergency stop in the middle of
a control tick, asked a question that is answered, withdrawn or ignored, given a script, or have a part of the
body or something in the world go wrong at a random instant.
"""

from __future__ import annotations

import tempfile
import traceback
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from executive.dialogue.attendant import Nobody, Stoppable
from executive.dialogue.clarification import OpenQuestion
from executive.runs.replay import replay
from executive.runs.run import perform
from executive.runs.run_log import recorded_run
from executive.runs.run_request import RunRequest
from executive.screens.display import NoDisplay
from executive.scripts.task_script import script_for
from robots.scenes.planned_fault import PlannedFault
from robots.scenes.scene_writer import dump
from robots.simulated.frugal_memory import make_room
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.questions import ambiguous_trial
from tools.evaluate.records import EpisodeRecord
from tools.evaluate.scenes import SENTENCE, TARGET, episode_rng, pick_scene

MEDDLINGS = ("none", "cancel", "stop", "question", "script", "body", "world")
_JOINTS = ("arm_left_2_joint", "arm_left_4_joint", "arm_right_2_joint", "arm_right_4_joint", "torso_1_joint")
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
    request = _request(order, folder, what, rng)
    run_name, simulated_s = _performed(request, meddler)
    make_room()
    verdict = replay(recorded_run(request.record, run_name))
    told = " ".join(verdict.lines()) if verdict.difference is not None else None
    return EpisodeRecord(
        seed=order.seed,
        outcome="done" if verdict.difference is None else "failed",
        truth=verdict.difference is None and verdict.events > 0,
        failure_kind=None if told is None else what,
        failure=told,
        attempts=verdict.events,
        simulated_s=simulated_s,
    )


def _performed(request: RunRequest, meddler: _Meddler) -> tuple[str, float]:
    """The name of the recorded run, and how long it took on the robot: nothing that would keep its world."""
    performance = perform(request, NoDisplay(), meddler)
    return performance.run_name, sum(task.times.simulated_s for task in performance.report.tasks)


def _reply(rng: np.random.Generator) -> str | None:
    return (None, "never mind", "1", "the second one")[int(rng.integers(4))]


def _request(order: EpisodeOrder, folder: Path, what: str, rng: np.random.Generator) -> RunRequest:
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
        faults=(_fault(rng, what),) if what in ("body", "world") else (),
    )


def _fault(rng: np.random.Generator, what: str) -> PlannedFault:
    """Something that goes wrong with a joint, the gyro, the battery or the thing that is picked up."""
    t_s, joint = round(float(rng.uniform(0.3, LATEST_S)), 4), str(rng.choice(_JOINTS))
    heading = float(rng.uniform(-np.pi, np.pi))
    choices = {
        "body": (
            PlannedFault("joint_stuck", t_s, joint),
            PlannedFault("joint_offline", t_s, joint),
            PlannedFault("joint_weak", t_s, joint, (0.1,)),
            PlannedFault("encoder_offset", t_s, joint, (float(rng.uniform(0.03, 0.07)),)),
            PlannedFault("gyro_bias", t_s, "", (0.02, -0.02, 0.01)),
            PlannedFault("battery_low", t_s, "", (0.1,)),
        ),
        "world": (
            PlannedFault("object_gone", t_s, TARGET),
            PlannedFault("object_moved", t_s, TARGET, (0.04, -0.05)),
            PlannedFault("object_knocked", t_s, TARGET, (heading, 0.05)),
            PlannedFault("object_tipped", t_s, TARGET, (heading,)),
            PlannedFault("object_slippery", t_s, TARGET, (0.02,)),
        ),
    }[what]
    return choices[int(rng.integers(len(choices)))]
