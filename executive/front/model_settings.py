"""Which language models a user has set up: the tables ``[models.NAME]`` of a configuration file.

[models.house]
url = "http://127.0.0.1:8080/v1"
model = "qwen3-8b"
key_env = "HOUSE_KEY"
when = "if_not_understood"
timeout_s = 20.0
attempts = 2
sees = false
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import AfterValidator

from executive.errors import UserError
from robots.strict_table import StrictTable, Text, read_table, said
from robots.toml_text import TomlTextError, read_toml

TABLE = "models"
MOST_ATTEMPTS = 10
LONGEST_TIMEOUT_S = 600.0

When = Literal["if_not_understood", "always"]

_URL = re.compile(r"https?://[^\s/?#@]+(/[^\s?#]*)?")
_VARIABLE = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


class ModelSettingsError(UserError):
    """A table ``[models.NAME]`` that cannot be used, or a name that there is no table for."""


@dataclass(frozen=True, slots=True)
class ModelSettings:
    """One language model that sentences may be sent to.

    Attributes:
        name: What ``--model`` calls it.
        url: Base address of its server, as clients of OpenAI's interface take it: ".../v1".
        model: What the server calls it.
        key_env: Name of the environment variable with the key; empty where the server wants none.
        when: Whether every sentence is sent to it, or only those that the parser does not understand.
        timeout_s: Wall time that one answer may take.
        attempts: How often it may propose something else after what it proposed has failed.
        sees: Whether it is asked what the camera's pictures show.
    """

    name: str
    url: str
    model: str
    key_env: str = ""
    when: When = "if_not_understood"
    timeout_s: float = 30.0
    attempts: int = 2
    sees: bool = False


def _an_address(text: str) -> str:
    if _URL.fullmatch(text) is None:
        raise said(f'must be an address such as "http://127.0.0.1:8080/v1", without a key, not {text!r}')
    return text.rstrip("/")


def _a_variable(text: str) -> str:
    if _VARIABLE.fullmatch(text) is None:
        raise said("must be the name of an environment variable; the key itself does not belong here")
    return text


def _a_timeout(seconds: float) -> float:
    if not 0.0 < seconds <= LONGEST_TIMEOUT_S:
        raise said(f"must be above 0 and at most {LONGEST_TIMEOUT_S:g}, not {seconds!r}")
    return seconds


def _a_count(count: int) -> int:
    if not 0 <= count <= MOST_ATTEMPTS:
        raise said(f"must be a whole number from 0 to {MOST_ATTEMPTS}, not {count!r}")
    return count


class _ModelTable(StrictTable):
    """``[models.NAME]``."""

    url: Annotated[Text, AfterValidator(_an_address)]
    model: Text
    key_env: Annotated[Text, AfterValidator(_a_variable)] = ""
    when: When = "if_not_understood"
    timeout_s: Annotated[float, AfterValidator(_a_timeout)] = 30.0
    attempts: Annotated[int, AfterValidator(_a_count)] = 2
    sees: bool = False


def model_settings(files: Sequence[Path]) -> Mapping[str, ModelSettings]:
    """Read what some files say of models; of two tables of one name, the later one counts.

    Args:
        files: TOML files; those without such a table say nothing.

    Raises:
        ModelSettingsError: File, key and reason.
    """
    found: dict[str, ModelSettings] = {}
    for file in files:
        for name, table in _tables(file).items():
            read = read_table(_ModelTable, table, partial(_wrong, file, name))
            found[name] = ModelSettings(name, **{key: getattr(read, key) for key in _ModelTable.model_fields})
    return found


def model_called(name: str, files: Sequence[Path]) -> ModelSettings:
    """The settings of one model.

    Args:
        name: As ``--model`` has it.
        files: The user's configuration files.

    Raises:
        ModelSettingsError: There is no such model, or a file is wrong.
    """
    known = model_settings(files)
    if name in known:
        return known[name]
    close = difflib.get_close_matches(name, known, n=1, cutoff=0.0)
    hint = f"the nearest is {close[0]!r}" if close else "no file of settings has a table [models.NAME]"
    raise ModelSettingsError(f"no model {name!r}; {hint}: docs/guides/models.md tells how one is set up")


def model_that_sees(files: Sequence[Path]) -> ModelSettings | None:
    """The settings of the model that is asked what pictures show; None where none is.

    Args:
        files: The user's configuration files.

    Raises:
        ModelSettingsError: There are several, or a file is wrong.
    """
    seeing = [one for one in model_settings(files).values() if one.sees]
    if len(seeing) > 1:
        names = " and ".join(repr(one.name) for one in seeing)
        raise ModelSettingsError(f"{TABLE}: {names} have sees = true; one model alone is asked of pictures")
    return seeing[0] if seeing else None


def _wrong(file: Path, name: str, key: str, reason: str) -> ModelSettingsError:
    place = ".".join(filter(None, (TABLE, name, key)))
    return ModelSettingsError(f"{file}: {place}: {reason}")


def _tables(file: Path) -> dict[str, dict[str, Any]]:
    try:
        tables = read_toml(file.read_text("utf-8")).get(TABLE, {})
    except OSError as failed:
        raise _wrong(file, "", "", failed.strerror or "cannot be read") from failed
    except (TomlTextError, UnicodeDecodeError) as failed:
        raise _wrong(file, "", "", f"is no TOML: {failed}") from failed
    if not isinstance(tables, dict):
        raise _wrong(file, "", "", f"must be tables, [{TABLE}.NAME], not {tables!r}")
    for name, table in tables.items():
        if not isinstance(table, dict):
            raise _wrong(file, name, "", f"must be a table, [{TABLE}.NAME], not {table!r}")
    return tables
