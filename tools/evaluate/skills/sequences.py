"""Suite of sequences: five different skills, one after the other, at dinner."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from executive.session.assembly import Assembly
from executive.session.events import TaskAccepted, TaskEnded
from executive.session.task_result import TaskResult, TaskTimes
from robots.scenes.scene_description import SceneDescription, SceneItem
from robots.scenes.scene_file import load_scene
from tools.evaluate.skills import rooms
from tools.evaluate.skills.gestures import LookJudge, PointJudge, WaveJudge
from tools.evaluate.skills.handing_over import TakingJudge
from tools.evaluate.skills.placing import PlaceJudge
from tools.evaluate.skills.putting_in import PutInJudge
from tools.evaluate.skills.suite import SkillJudge, SkillSuite, Trial, Verdict
from tools.evaluate.skills.telling import AnswerJudge
from trees.tasks import (
    FindTask,
    HandOverTask,
    LookAtTask,
    ObjectDescription,
    PickTask,
    PlaceTask,
    PointAtTask,
    PutInTask,
    Task,
    WaveTask,
)

LENGTH = 5
SKILLS = ("pick", "place", "put_in", "hand_over", "wave", "point_at", "look_at", "find")
SEQUENCE_BAR = 0.90
HELD_M = 0.05
# From where the scene has it.
MOVED_M = 0.03

MakeJudge = Callable[[Assembly, Trial, np.random.Generator], SkillJudge]


class PickJudge:
    """The object is off the table, between the fingers."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._name = assembly.world.truth, trial.aim

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """Only the end counts."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Lifted and touched by pads."""
        lift_m = self._truth.lift_m(self._name)
        held = lift_m >= HELD_M and bool(self._truth.contacts.of_pads(self._name))
        return Verdict(held, {"lift_m": lift_m}, "" if held else f"{self._name} is not held")


_JUDGES: Mapping[str, MakeJudge] = {
    "pick": PickJudge,
    "place": PlaceJudge,
    "put_in": PutInJudge,
    "hand_over": TakingJudge,
    "wave": WaveJudge,
    "point_at": PointJudge,
    "look_at": LookJudge,
    "find": AnswerJudge,
}


class SequenceJudge:
    """Has each task judged by its own skill's judge, when it ends.

    What a judge needs to know about the start is measured when its task begins; gestures are measured
    against the posture at the very start, because a look may leave the trunk turned.
    """

    def __init__(self, assembly: Assembly, trial: Trial, rng: np.random.Generator) -> None:
        self._assembly, self._rng = assembly, rng
        self._trials = one_by_one(trial)
        self._judges: list[SkillJudge | None] = [
            self._make(one) if one.tasks[0].action in ("wave", "point_at", "look_at") else None
            for one in self._trials
        ]
        self._at = -1
        self._done, self._why = 0, ""

    def on_event(self, event: object) -> None:
        """Tasks come one after the other."""
        if isinstance(event, TaskAccepted):
            self._at += 1
            if self._judges[self._at] is None:
                self._judges[self._at] = self._make(self._trials[self._at])
        for judge in self._made():
            judge.on_event(event)
        if isinstance(event, TaskEnded):
            self._judge_task(event)

    def on_period(self) -> None:
        """All go on watching: a person who has something keeps hold of it."""
        for judge in self._made():
            judge.on_period()

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Every one of them."""
        skills = ", ".join(one.tasks[0].action for one in self._trials)
        return Verdict(self._done == LENGTH, {"skills": skills, "tasks_done": self._done}, self._why)

    def _judge_task(self, event: TaskEnded) -> None:
        task, judge = self._trials[self._at].tasks[0], self._judges[self._at]
        assert judge is not None
        result = TaskResult(
            event.text,
            task.action,
            "done" if event.outcome == "done" else "failed",
            event.attempts,
            event.failure,
            event.evidence,
            TaskTimes(0.0, 0.0, 0.0),
        )
        verdict = judge.verdict([result])
        if verdict.done and event.outcome == "done":
            self._done += 1
        elif not verdict.done:
            self._why = self._why or f"{event.text}: {verdict.why}"

    def _make(self, trial: Trial) -> SkillJudge:
        return _JUDGES[trial.tasks[0].action](self._assembly, trial, self._rng)

    def _made(self) -> list[SkillJudge]:
        return [judge for judge in self._judges if judge is not None]


def one_by_one(trial: Trial) -> list[Trial]:
    """A trial for each of a sequence's tasks: what a person was given before moves with her hand."""
    trials: list[Trial] = []
    given: tuple[str, ...] = ()
    for task, aim in zip(trial.tasks, trial.aim.split(", "), strict=True):
        trials.append(Trial(trial.scene, (task,), aim, given=given))
        if isinstance(task, HandOverTask):
            given = (*given, aim)
    return trials


def sequence_trial(rng: np.random.Generator) -> Trial:
    """Dinner, with everything on its table a little elsewhere, and five different skills."""
    dinner = load_scene("dinner")
    table = next(piece for piece in dinner.furniture if piece.kind == "table")
    on_table, elsewhere = [], []
    for item in dinner.objects:
        if np.all(np.abs(item.world_T_object[:2, 3] - table.position_m) <= 0.5 * np.array(table.size_m[:2])):
            moved = item.world_T_object.copy()
            moved[:2, 3] += rng.uniform(-MOVED_M, MOVED_M, 2)
            on_table.append(replace(item, world_T_object=moved))
        else:
            elsewhere.append(item)
    container = next(item for item in on_table if item.wall_m is not None)
    things = [item for item in on_table if item is not container]
    people = rooms.played(dinner.people)
    scene = rooms.room("sequence", rng, dinner.furniture, [*on_table, *elsewhere], people)
    skills = [SKILLS[i] for i in rng.permutation(len(SKILLS))[:LENGTH]]
    tasks, aims = _tasks(skills, scene, container, things, rng)
    return Trial(scene, tasks, ", ".join(aims))


def _tasks(
    skills: Sequence[str],
    scene: SceneDescription,
    container: SceneItem,
    things: Sequence[SceneItem],
    rng: np.random.Generator,
) -> tuple[tuple[Task, ...], list[str]]:
    """What is asked, and the aim of each: nobody asks for what was given away or put into something."""
    free, held = list(things), ""
    people = [person.name for person in scene.people]
    tasks: list[Task] = []
    aims: list[str] = []
    for skill in skills:
        person = people[int(rng.integers(len(people)))]
        others = [one for one in free if one.name != held and fits(skill, one)] or [container]
        thing = others[int(rng.integers(len(others)))]
        if held and skill in ("place", "put_in", "hand_over"):
            thing = next(one for one in free if one.name == held)
        tasks.append(_task(skill, thing, container, person))
        aims.append(person if skill == "wave" else thing.name)
        if skill == "pick":
            held = thing.name
        elif skill in ("place", "put_in", "hand_over"):
            held = ""
            if skill != "place":
                free = [one for one in free if one is not thing]
    return tuple(tasks), aims


def fits(skill: str, thing: SceneItem) -> bool:
    """Whether one would ask for that: nobody puts a bottle into a bowl."""
    return thing.kind != "bottle" or skill not in ("pick", "put_in")


def _task(skill: str, thing: SceneItem, container: SceneItem, person: str) -> Task:
    meant = ObjectDescription(thing.kind, thing.color)
    name = thing.name
    makers: Mapping[str, Callable[[], Task]] = {
        "pick": lambda: PickTask(f"pick up the {name}", meant),
        "place": lambda: PlaceTask(f"put the {name} on the table", meant, on="table"),
        "put_in": lambda: PutInTask(
            f"put the {name} into the {container.name}",
            meant,
            ObjectDescription(container.kind, container.color),
        ),
        "hand_over": lambda: HandOverTask(f"give the {name} to {person}", meant, person),
        "wave": lambda: WaveTask(f"wave at {person}", person),
        "point_at": lambda: PointAtTask(f"point at the {name}", meant),
        "look_at": lambda: LookAtTask(f"look at the {name}", meant),
        "find": lambda: FindTask(f"find the {name}", meant),
    }
    return makers[skill]()


SEQUENCE = SkillSuite(sequence_trial, SequenceJudge, bar=SEQUENCE_BAR)
