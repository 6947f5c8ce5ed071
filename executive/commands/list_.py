"""``executive list``: what there is to choose from."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from typing import Annotated

import typer


class What(StrEnum):
    """What can be listed."""

    ROBOTS = "robots"
    SCENES = "scenes"
    SKILLS = "skills"
    WORDS = "words"


_SKILLS = (
    ("pick", "pick up the red cup on the table"),
    ("go_home", "go home"),
    ("stop", "stop"),
)


def list_(what: Annotated[What, typer.Argument(help="What to list.")]) -> None:
    """List robots, scenes, skills or words."""
    for line in _lines(what):
        typer.echo(line)


def _lines(what: What) -> Iterator[str]:
    match what:
        case What.ROBOTS:
            from robots.description import known_robots

            yield from known_robots()
        case What.SCENES:
            from robots.scene_file import known_scenes

            yield from known_scenes()
        case What.SKILLS:
            for action, example in _SKILLS:
                yield f"{action:<8} {example}"
        case What.WORDS:
            yield from _words()


def _words() -> Iterator[str]:
    """Canonical words with their synonyms; verb forms and plurals follow from them and are left out."""
    from executive.config import config_files
    from executive.vocabulary import load_vocabulary

    for name, word_class in sorted(load_vocabulary(config_files()).classes.items()):
        if word_class.derived:
            continue
        note = " (understood, and refused)" if word_class.refusal else ""
        yield f"{name.lower()}{note}"
        for meaning, phrases in word_class.words.items():
            if ":" not in meaning:
                yield f"  {meaning}: {', '.join(phrases)}"
