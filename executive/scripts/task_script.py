"""Task scripts: TOML files with an ordered list of sentences and what to expect of them."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from executive.errors import ScriptError
from executive.trust import USUAL_TRUST, Trust
from executive.understanding.conversation import Conversation
from executive.understanding.spoken_in import spoken_in
from executive.understanding.statement import Statement
from executive.understanding.understanding import understand
from robots.models.usual_scene import usual_scene
from robots.toml_text import TomlTextError, read_toml

if TYPE_CHECKING:  # one sentence needs no script's layout
    from executive.scripts.script_document import TaskTable

MAX_BYTES = 1_000_000
MOST_TASKS = 1000
"""All are understood before the first one begins."""


@dataclass(frozen=True, slots=True)
class TaskScript:
    """A script: what is absent is for the command line to say."""

    statements: tuple[Statement, ...]
    scene: str | None = None
    robot: str | None = None
    seed: int | None = None


def is_script(argument: str) -> bool:
    """Tell whether an argument of the command line names a script rather than being a sentence."""
    if argument.endswith(".toml"):
        return True
    try:
        return Path(argument).is_file()
    except (OSError, ValueError):
        return False


def script_for(
    argument: str, trust: Trust = USUAL_TRUST, scene: str | None = None, robot: str | None = None
) -> TaskScript:
    """What an argument of the command line asks for: a script's statements, or one statement.

    Args:
        argument: A sentence, or the path of a script.
        trust: How far a model's output is trusted.
        scene: Where it is said; None where the script says, if anywhere.
        robot: Who hears a sentence that nobody said the place of.

    Raises:
        ScriptError: It names a script that cannot be one.
        SceneError: There is no such scene.
    """
    if not is_script(argument):
        with spoken_in(scene or (None if robot is None else usual_scene(robot))):
            return TaskScript((Statement.of(understand(argument, trust)),))
    return load_script(Path(argument), trust, lambda own: spoken_in(scene or own))


def load_script(
    path: Path,
    trust: Trust = USUAL_TRUST,
    said_in: Callable[[str | None], AbstractContextManager[None]] = lambda _scene: nullcontext(),
) -> TaskScript:
    """Read a script and understand all of its sentences, before anything moves.

    Args:
        path: The file.
        trust: How far a model's output is trusted.
        said_in: Of the scene that the script names, or None: what its sentences are understood within.

    Raises:
        ScriptError: File, key and reason.
    """
    from executive.scripts.script_document import ScriptDocument
    from robots.strict_table import read_table

    source = str(path)
    document = read_table(ScriptDocument, _read(path), partial(ScriptError, source))
    tasks = document.task
    if len(tasks) > MOST_TASKS:
        raise ScriptError(source, "task", f"has {len(tasks)} tasks; a script holds at most {MOST_TASKS}")
    scene = document.scene
    if scene is not None and scene.endswith(".toml") and not Path(scene).is_absolute():
        scene = str(path.parent / scene)
    before = Conversation()
    with said_in(scene):
        statements = tuple(_statement(task, trust, before) for task in tasks)
    return TaskScript(statements, scene, document.robot, document.seed)


def _read(path: Path) -> dict[str, Any]:
    try:
        if path.stat().st_size > MAX_BYTES:
            raise ScriptError(str(path), "", f"has more than {MAX_BYTES} bytes")
        return read_toml(path.read_text("utf-8"))
    except OSError as failed:
        raise ScriptError(str(path), "", failed.strerror or "cannot be read") from failed
    except UnicodeDecodeError as failed:
        raise ScriptError(str(path), "", "is not UTF-8 text") from failed
    except TomlTextError as failed:
        raise ScriptError(str(path), "", f"is not TOML: {failed}") from failed


def _statement(task: TaskTable, trust: Trust, before: Conversation) -> Statement:
    question = task.expect == "question"
    understood = understand(task.say, trust) if question else before.understand(task.say, trust)
    return Statement(understood.parsed, task.on_failure, task.expect, task.timeout_s).meaning(understood)
