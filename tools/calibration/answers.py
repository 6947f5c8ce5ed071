"""Answers to "how many" and "what is there" in random scenes, with what was stated and what was right."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any, cast

from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description
from robots.scenes.scene_description import PerceptionModel
from tools.calibration.quick_robot import QuickRobot
from tools.evaluate.scenes import episode_rng
from tools.evaluate.skills.episode import trial_of
from tools.evaluate.skills.telling import AnswerJudge

SKILLS = ("count", "describe")


@dataclass(frozen=True, slots=True)
class Answer:
    """One answer.

    Attributes:
        seed: Of the scene.
        skill: Of which skill.
        stated: The confidence that was said, in [0, 1].
        raw: From how surely things were seen; the stated one is made from it.
        right: Whether the truth agrees.
        why: What was wrong; empty when nothing was.
    """

    seed: int
    skill: str
    stated: float
    raw: float
    right: bool
    why: str = ""


def answers(skill: str, seeds: range, noise: PerceptionModel) -> Iterator[Answer]:
    """One answer for each seed; the scenes are those of the skill's evaluation, all with this noise."""
    model = RobotModel(load_description("talos"))
    for seed in seeds:
        trial = trial_of(skill, seed)
        trial = replace(trial, scene=replace(trial.scene, perception=noise))
        robot = QuickRobot(model, trial.scene, seed)
        tree = robot.do(trial.tasks[-1])
        if tree.status != "success":
            yield Answer(seed, skill, 0.0, 0.0, False, str(tree.failure and tree.failure.message))
            continue
        truth = cast(Any, SimpleNamespace(world=robot.world))
        verdict = AnswerJudge(truth, trial, episode_rng(seed, 11)).verdict([cast(Any, tree)])
        stated = float(tree.evidence["confidence"])
        raw = float(tree.evidence["seen_confidence"])
        yield Answer(seed, skill, stated, raw, verdict.done, verdict.why)
