"""What a user asks ``run`` for, as one value."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from executive.trust import OnQuestion, Trust
from robots.scenes.planned_fault import PlannedFault

if TYPE_CHECKING:
    from executive.front.front_model import FrontModel
    from executive.robot_settings import RobotSettings
    from executive.understanding.statement import Statement
    from robots.perception.labels.asking import AskAboutPictures

DEFAULT_ROBOT = "talos"


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
        panel: Whether the film shows tree and log beside the picture.
        keep_trajectories: Whether the recorded run holds the motions that were judged.
        on_question: What becomes of questions.
        trust: How far a model's output is trusted.
        in_real_time: Whether simulated time passes no faster than time does.
        script: The task script that the statements come from, or None.
        junit: Where to write a JUnit report, or None.
        faults: What goes wrong on purpose in the simulated world, for tests and evaluations.
        front: The language model in front, or None.
        perception: "stub" or "rgbd", whatever the scene says; None is what it says.
        seeing: Makes what asks a model what the camera's pictures show, where a user has set one up; called
            before anything moves, and only for a run with a camera. None asks nobody.
        settings: What the robot says of itself, and when its day begins; None is what the user's files say.
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
    panel: bool = False
    keep_trajectories: bool = False
    on_question: OnQuestion = "ask"
    trust: Trust = field(default_factory=Trust)
    in_real_time: bool = False
    script: Path | None = None
    junit: Path | None = None
    faults: tuple[PlannedFault, ...] = ()
    front: FrontModel | None = None
    settings: RobotSettings | None = None
    perception: str | None = None
    seeing: Callable[[], AskAboutPictures | None] | None = None
