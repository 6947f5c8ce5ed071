"""Task scripts: TOML files with an ordered list of sentences and what to expect of them."""

from __future__ import annotations

import difflib
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, get_args

from executive.errors import ScriptError
from executive.trust import USUAL_TRUST, Trust
from executive.understanding.conversation import Conversation
from executive.understanding.statement import Expectation, OnFailure, Statement
from executive.understanding.understanding import understand
from robots.toml_text import TomlTextError, read_toml

MAX_BYTES = 1_000_000
MOST_TASKS = 1000
"""All are understood before the first one begins."""
_TOP_KEYS = ("scene", "robot", "seed", "task")
_TASK_KEYS = ("say", "on_failure", "timeout_s", "expect")


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


def script_for(argument: str, trust: Trust = USUAL_TRUST) -> TaskScript:
    """What an argument of the command line asks for: a script's statements, or one statement.

    Raises:
        ScriptError: It names a script that cannot be one.
    """
    if is_script(argument):
        return load_script(Path(argument), trust)
    return TaskScript((Statement.of(understand(argument, trust)),))


def load_script(path: Path, trust: Trust = USUAL_TRUST) -> TaskScript:
    """Read a script and understand all of its sentences, before anything moves.

    Raises:
        ScriptError: File, key and reason.
    """
    source = str(path)
    data = _read(path)
    _known_keys(source, "", data, _TOP_KEYS)
    for key in ("scene", "robot"):
        if key in data and not isinstance(data[key], str):
            raise ScriptError(source, key, "must be a string")
    seed = data.get("seed")
    if seed is not None and (not isinstance(seed, int) or isinstance(seed, bool) or seed < 0):
        raise ScriptError(source, "seed", "must be a whole number, 0 or more")
    tasks = data.get("task")
    if not isinstance(tasks, list) or not tasks or not all(isinstance(item, dict) for item in tasks):
        raise ScriptError(source, "task", "must be a list of [[task]] tables")
    if len(tasks) > MOST_TASKS:
        raise ScriptError(source, "task", f"has {len(tasks)} tasks; a script holds at most {MOST_TASKS}")
    before = Conversation()
    statements = tuple(
        _statement(source, f"task[{index}]", item, trust, before) for index, item in enumerate(tasks)
    )
    scene = data.get("scene")
    if scene is not None and scene.endswith(".toml") and not Path(scene).is_absolute():
        scene = str(path.parent / scene)
    return TaskScript(statements, scene, data.get("robot"), seed)


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


def _statement(
    source: str, place: str, item: Mapping[str, Any], trust: Trust, before: Conversation
) -> Statement:
    _known_keys(source, place, item, _TASK_KEYS)
    say = item.get("say")
    if not isinstance(say, str):
        raise ScriptError(source, f"{place}.say", "must be a sentence in quotes")
    on_failure = _choice(source, f"{place}.on_failure", item.get("on_failure", "stop"), get_args(OnFailure))
    expect = _choice(source, f"{place}.expect", item.get("expect", "done"), get_args(Expectation))
    timeout_s = item.get("timeout_s")
    if timeout_s is not None:
        is_number = isinstance(timeout_s, (int, float)) and not isinstance(timeout_s, bool)
        if not is_number or not math.isfinite(timeout_s) or timeout_s <= 0.0:
            raise ScriptError(source, f"{place}.timeout_s", "must be a number of seconds above 0")
    understood = understand(say, trust) if expect == "question" else before.understand(say, trust)
    return Statement(understood.parsed, on_failure, expect, timeout_s).meaning(understood)


def _known_keys(source: str, place: str, table: Mapping[str, Any], known: Sequence[str]) -> None:
    for key in table:
        if key not in known:
            nearest = difflib.get_close_matches(key, known, n=1, cutoff=0.0)[0]
            raise ScriptError(
                source, f"{place}.{key}".lstrip("."), f"unknown key; the nearest is {nearest!r}"
            )


def _choice(source: str, key: str, value: object, choices: tuple[Any, ...]) -> Any:
    if value not in choices:
        close = difflib.get_close_matches(str(value), choices, n=1)
        hint = f"; did you mean {close[0]!r}?" if close else ""
        raise ScriptError(source, key, f"{value!r} is not one of {', '.join(choices)}{hint}")
    return value
