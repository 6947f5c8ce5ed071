"""What a user's settings say of the robot itself: the table ``[robot]`` of a configuration file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import Any

from executive.errors import UserError
from robots.strict_table import StrictTable, Text, read_table
from robots.toml_text import TomlTextError, read_toml
from trees.self_knowledge import Identity

TABLE = "robot"


class RobotSettingsError(UserError):
    """A table ``[robot]`` that cannot be read."""

    def __init__(self, source: str, key: str, reason: str) -> None:
        super().__init__(f"{source}: {f'{TABLE}.{key}' if key else TABLE}: {reason}")


@dataclass(frozen=True, slots=True)
class RobotSettings:
    """What a user's settings say of the robot.

    Attributes:
        identity: What it says of itself.
        begins: Local date and time at which a simulated day begins; None is when the run begins.
    """

    identity: Identity = field(default_factory=Identity)
    begins: datetime | None = None

    def to_json(self) -> dict[str, str]:
        """As the record of a run keeps them."""
        told = {key: value for key, value in asdict(self.identity).items() if value}
        return told if self.begins is None else {**told, "begins": self.begins.isoformat()}


def settings_from_json(data: Mapping[str, str]) -> RobotSettings:
    """What ``to_json`` has made.

    Raises:
        ValueError, TypeError: It has not.
    """
    told = dict(data)
    begins = told.pop("begins", None)
    return RobotSettings(Identity(**told), None if begins is None else datetime.fromisoformat(begins))


class _RobotTable(StrictTable):
    """``[robot]``; what is absent is not known."""

    name: Text = ""
    team: Text = ""
    country: Text = ""
    affiliation: Text = ""
    about: Text = ""
    begins: datetime | None = None


def robot_settings(files: Sequence[Path]) -> RobotSettings:
    """Read what some files say of the robot; of two that say something of the same, the later one counts.

    Args:
        files: TOML files; those without the table say nothing.

    Raises:
        RobotSettingsError: File, key and reason.
    """
    told: dict[str, Any] = {}
    for file in files:
        table = _table(file)
        fail = partial(RobotSettingsError, str(file))
        read = read_table(_RobotTable, table, fail)
        if read.begins is not None and read.begins.tzinfo is not None:
            raise fail("begins", f"must be a local time without a zone, not {read.begins.isoformat()}")
        told |= {key: getattr(read, key) for key in table}
    begins = told.pop("begins", None)
    return RobotSettings(Identity(**told), begins)


def _table(file: Path) -> dict[str, Any]:
    try:
        table = read_toml(file.read_text("utf-8")).get(TABLE, {})
    except OSError as failed:
        raise RobotSettingsError(str(file), "", failed.strerror or "cannot be read") from failed
    except (TomlTextError, UnicodeDecodeError) as failed:
        raise RobotSettingsError(str(file), "", f"is no TOML: {failed}") from failed
    if not isinstance(table, dict):
        raise RobotSettingsError(str(file), "", f"must be a table, [{TABLE}], not {table!r}")
    return table
