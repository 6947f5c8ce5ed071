"""``executive list``: what there is to choose from."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from enum import StrEnum
from typing import Annotated

import typer

from executive.cli.commands.choices import SCENE_OF_THE_ROBOT
from executive.runs.run_request import DEFAULT_ROBOT
from robots.models.usual_scene import usual_scene

_TOLD = "*"
"""Marks what perception can tell."""


class What(StrEnum):
    """What can be listed."""

    ROBOTS = "robots"
    SCENES = "scenes"
    SKILLS = "skills"
    WORDS = "words"


def list_(
    what: Annotated[What, typer.Argument(help="What to list.")],
    scene: Annotated[
        str | None,
        typer.Option(
            metavar="NAME|FILE.toml",
            help="Of words: mark what the robot's perception can tell there.",
            show_default=SCENE_OF_THE_ROBOT,
        ),
    ] = None,
    robot: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="Of skills: tell which of them this robot lacks something for; of words: whose scene.",
        ),
    ] = None,
) -> None:
    """List robots, scenes, skills or words."""
    for line in _lines(what, scene, robot):
        typer.echo(line)


def _lines(what: What, scene: str | None = None, robot: str | None = None) -> Iterator[str]:
    match what:
        case What.ROBOTS:
            from robots.outside import known_robots

            yield from known_robots()
            yield from _left_out(_complaints_about("robots"))
        case What.SCENES:
            from robots.outside import known_scenes

            yield from known_scenes()
            yield from _left_out(_complaints_about("scenes"))
        case What.SKILLS:
            yield from _skills(robot)
        case What.WORDS:
            yield from _words(scene or usual_scene(robot or DEFAULT_ROBOT))


def _skills(robot: str | None) -> Iterator[str]:
    """Every skill with an example; of a robot, with what it lacks for those that it cannot do."""
    from trees.btcpp.judgement_names import outside_judgements
    from trees.btcpp.outside_leaves import outside_leaves
    from trees.extensions import extensions
    from trees.needs import lacks
    from trees.registry import skills

    description = None
    if robot is not None:
        from robots.models.description import load_robot_for_tasks

        description = load_robot_for_tasks(robot).description
    for action, skill in skills().items():
        lacking = [] if description is None else [f"needs {what}" for what in lacks(skill, description)]
        told = f"no: {', and '.join(lacking)}" if lacking else skill.example
        yield f"{action:<10} {told}"
    yield f"{'stop':<10} stop"
    yield from _left_out(extensions().complaints)
    yield from _left_out(outside_leaves().complaints)
    yield from _left_out(outside_judgements().complaints)


def _complaints_about(kind: str) -> Iterable[str]:
    from robots.outside import outside_folders

    return outside_folders(f"humanoid_executive.{kind}").complaints


def _left_out(complaints: Iterable[str]) -> Iterator[str]:
    """What other packages bring and nobody can use, with the reason."""
    for complaint in complaints:
        yield f"left out: {complaint}"


def _words(scene: str) -> Iterator[str]:
    """Canonical words with their synonyms; verb forms and plurals follow from them and are left out."""
    from executive.config import config_files
    from executive.errands.beyond_the_eyes import THINGS, is_told
    from executive.vocabulary import load_vocabulary
    from executive.vocabulary.word_lists import outside_words
    from robots.perception.told_labels import labels_in
    from robots.scenes.scene_file import load_scene

    labels = labels_in(load_scene(scene))
    classes = load_vocabulary(config_files()).classes
    usable = frozenset(name for name, word_class in classes.items() if not word_class.derived)
    yield from _left_out(outside_words(usable).complaints)
    yield f"{_TOLD} is what the robot's perception can tell in the scene {scene}"
    for name, word_class in sorted(classes.items()):
        if word_class.derived:
            continue
        note = " (understood, and refused)" if word_class.refusal else ""
        yield f"{name.lower()}{note}"
        for meaning, phrases in word_class.words.items():
            if ":" not in meaning:
                told = f" {_TOLD}" if name in THINGS and is_told(meaning, labels) else ""
                yield f"  {meaning}{told}: {', '.join(phrases)}"
