"""Ambiguous scenes: a question in each, its choices the candidates, no motion before, the right object after.

The one who answers knows the truth: it picks one of the candidates beforehand, and answers with its number,
its place in the row, or the words of the choice.
"""

from __future__ import annotations

import traceback
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from executive.dialogue.attendant import Nobody
from executive.dialogue.clarification import OpenQuestion
from executive.errands.errand import Errand
from executive.session.assembly import Assembly, assemble
from executive.session.driver import driven
from executive.understanding.command_parser import parse
from robots.scenes.scene_description import SceneDescription, SceneItem
from tools.evaluate.judge import HELD_S, Judge
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import EpisodeRecord
from tools.evaluate.scenes import episode_rng
from tools.evaluate.skills import rooms
from trees.beliefs.scene.labels import split_words

STILL_RAD = 0.02
"""Arms that move less are only carried by the balance."""

IN_VIEW_M = 0.5
"""What stands nearer than this is not in view from the home posture: a question is about what is."""

_ROW_M = 0.05
"""Candidates are so far apart from left to right that their order is beyond doubt."""

_ORDINALS = ("the first one", "the second one", "the third one", "the fourth one")


@dataclass(frozen=True, slots=True)
class AmbiguousTrial:
    """A scene, a sentence that fits several of its objects, and the one that is meant."""

    scene: SceneDescription
    sentence: str
    candidates: tuple[SceneItem, ...]
    meant: SceneItem
    answer: str


def ambiguous_trial(seed: int) -> AmbiguousTrial:
    """The episode of a seed: two to four cups, some of them alike, and other things."""
    rng = episode_rng(seed, 20)
    table = rooms.table(rng)
    twins = bool(rng.random() < 0.5)
    color = str(rng.choice(rooms.COLORS))
    cups: list[SceneItem] = []
    while len(cups) < 2:
        cups = []
        for number in range(int(rng.integers(2, 5))):
            place = rooms.spot(rng, table, cups)
            if (
                place is None
                or place[0] < IN_VIEW_M
                or any(abs(place[1] - cup.world_T_object[1, 3]) < _ROW_M for cup in cups)
            ):
                continue
            own = color if twins else str(rng.choice(rooms.COLORS))
            cups.append(
                rooms.item(f"cup {number}", "cup", own, rooms.shape_of("cup", rng), table, place, rng)
            )
    place = rooms.spot(rng, table, cups)
    others = []
    if place is not None:
        others = [rooms.item("bottle", "bottle", "green", rooms.shape_of("bottle", rng), table, place, rng)]
    row = tuple(sorted(cups, key=lambda cup: -float(cup.world_T_object[1, 3])))
    index = int(rng.integers(len(row)))
    forms = [str(index + 1), _ORDINALS[index]]
    if index in (0, len(row) - 1):
        forms.append("the leftmost one" if index == 0 else "the rightmost one")
    scene = rooms.room(f"question-{seed}", rng, [table], [*cups, *others])
    sentence = f"pick up the {color} cup" if twins else "pick up the cup"
    answer = str(rng.choice([*forms, "words"]))
    return AmbiguousTrial(scene, sentence, row, row[index], answer)


@dataclass
class _Answerer(Nobody):
    """Looks at the truth when it is asked, and answers."""

    assembly: Assembly
    trial: AmbiguousTrial
    faults: list[str] = field(default_factory=list)
    questions: int = 0

    def __post_init__(self) -> None:
        self._arms = [i for i, name in enumerate(self.assembly.model.joints) if name.startswith("arm_")]
        self._q_start = self._q()
        truth = self.assembly.world.truth
        self._places = {name: truth.world_T_object(name)[:3, 3].copy() for name in truth.objects()}

    def answer(self, question: OpenQuestion) -> str | None:
        """Judge the question and what went before it, then say which one is meant."""
        self.questions += 1
        if self.questions > 1:
            self.faults.append(f"asked again: {question.tried}")
            return None
        moved = float(np.abs(self._q() - self._q_start)[self._arms].max())
        if moved > STILL_RAD:
            self.faults.append(f"an arm moved by {moved:.3f} rad before the answer")
        truth = self.assembly.world.truth
        for name, place in self._places.items():
            if float(np.linalg.norm(truth.world_T_object(name)[:3, 3] - place)) > 0.005:
                self.faults.append(f"{name} moved before the answer")
        row = self.trial.candidates
        told = [split_words(choice)[1] or "" for choice in question.choices]
        if len(told) != len(row) or not all(
            str(cup.color) in color for cup, color in zip(row, told, strict=False)
        ):
            self.faults.append(f"choices {question.choices} instead of {[cup.color for cup in row]}")
            return None
        index = row.index(self.trial.meant)
        return question.choices[index] if self.trial.answer == "words" else self.trial.answer

    def _q(self) -> NDArray[np.float64]:
        return np.array(self.assembly.loop.sensing.state().readings.q, dtype=np.float64)


def run_question_episode(order: EpisodeOrder) -> EpisodeRecord:
    """Run one episode; whatever breaks becomes its record."""
    try:
        return _run(order)
    except Exception as broken:
        said = f"{type(broken).__name__}: {broken}"
        return EpisodeRecord(order.seed, "error", False, "ERROR", said, detail=traceback.format_exc())


def _run(order: EpisodeOrder) -> EpisodeRecord:
    trial = ambiguous_trial(order.seed)
    assembly = assemble(order.robot, trial.scene, order.seed, drawn=False)
    session, truth = assembly.session, assembly.world.truth
    session.hold(0.2)
    answerer = _Answerer(assembly, trial)
    judge = Judge(truth, trial.meant.name)
    session.watch_periods(judge.on_period)
    results = driven(Errand(session, parse(trial.sentence).commands).steps(), answerer.answer)
    judge.begin_hold()
    session.hold(HELD_S)
    last = results[-1]
    if answerer.questions == 0:
        answerer.faults.append("nothing was asked")
    faults = "; ".join(answerer.faults)
    failure = last.failure.root if last.failure is not None else None
    moving_wall_s = last.times.wall_s - last.times.planning_wall_s
    return EpisodeRecord(
        seed=order.seed,
        outcome=last.outcome,
        truth=judge.truly_held and not answerer.faults,
        failure_kind=None if failure is None else failure.kind.value,
        failure=faults or (None if failure is None else failure.message),
        attempts=last.attempts,
        lift_m=judge.held_lift_m,
        fell=judge.fell,
        furniture_contacts=tuple(sorted(judge.furniture_contacts)),
        com_margin_m=judge.com_margin_m,
        planning_ms=1e3 * last.times.planning_wall_s / max(last.attempts, 1),
        simulated_s=last.times.simulated_s,
        wall_s=last.times.wall_s,
        realtime_factor=last.times.simulated_s / moving_wall_s if moving_wall_s > 0.0 else 0.0,
    )
