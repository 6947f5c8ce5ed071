"""What a user asks ``run`` for, as one value."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from executive.statement import Statement

DEFAULT_ROBOT = "talos"
DEFAULT_SCENE = "tabletop"


@dataclass(frozen=True, slots=True)
class RunRequest:
    """What to do, where, and what to keep of it.

    Attributes:
        input: The sentence, or the script's name.
        statements: What was said, understood.
        robot: Name of the robot.
        scene: Name of a scene or path of a scene file.
        seed: Of everything random.
        record: Folder of the recorded runs.
        report: Where to write the report, or None.
        snapshot: Where to write a picture of the end, or None.
        video: Where to write a film, or None.
        keep_trajectories: Whether the recorded run holds the motions that were judged.
    """

    input: str
    statements: tuple[Statement, ...]
    robot: str
    scene: str
    seed: int
    record: Path
    report: Path | None = None
    snapshot: Path | None = None
    video: Path | None = None
    keep_trajectories: bool = False
