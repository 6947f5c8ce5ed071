"""What is said to a served executive's desk: sentences, scripts, answers, cancels, pauses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields

from robots.live.wire.messages import GetStatus, write_message

MAX_STATEMENTS = 1000
"""Of one script."""


@dataclass(frozen=True, slots=True)
class Say:
    """A sentence; ``timeout_s`` of 0 is the usual one, velocities count when ``text`` is empty."""

    text: str
    timeout_s: float = 0.0
    linear_m_s: float = 0.0
    angular_rad_s: float = 0.0


@dataclass(frozen=True, slots=True)
class ScriptLine:
    """A statement of a script, as the script's file says it; the script is begun when ``last`` has come."""

    script: str
    text: str
    on_failure: str = "stop"
    expect: str = "done"
    timeout_s: float = 0.0
    last: bool = False


@dataclass(frozen=True, slots=True)
class Script:
    """Statements that are one order: all are understood before the first one is carried out."""

    lines: tuple[ScriptLine, ...]

    @property
    def text(self) -> str:
        """What the order is called: the script's name."""
        return self.lines[0].script


@dataclass(frozen=True, slots=True)
class Cancel:
    """Halt what is under way, and hold."""

    reason: str


@dataclass(frozen=True, slots=True)
class Answer:
    """The answer to the question that is open."""

    text: str


@dataclass(frozen=True, slots=True)
class PauseTask:
    """Hold what is under way where it is."""

    reason: str


@dataclass(frozen=True, slots=True)
class ResumeTask:
    """Go on with what was paused."""


@dataclass(frozen=True, slots=True)
class Velocity:
    """A velocity of the base, one of many; the robot walks at the newest while they come."""

    linear_m_s: float
    angular_rad_s: float


@dataclass(frozen=True, slots=True)
class FollowTrajectory:
    """Move joints as a file says (``kinematics.formats.joint_motion``), where the checker agrees."""

    path: str


@dataclass(frozen=True, slots=True)
class TakeOver:
    """A person wants the robot in hand: the task under way, or the one that failed last, or none."""


@dataclass(frozen=True, slots=True)
class Jog:
    """A word of the person who has taken over; good for a moment, and one of many.

    ``move`` is "hand", "joint", "base", "grip" or "brake"; ``part`` the hand or the joint. ``x`` to ``rz``
    are the velocities of a hand along and about the axes of ``frame``, m/s and rad/s; of a joint ``x``,
    rad/s; of the base ``x`` and ``rz``; of a grip ``x`` above 0 opens. Fingers that ``may_touch`` may come
    near to what can be picked up.
    """

    move: str
    part: str = ""
    frame: str = "world"
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    rx: float = 0.0
    ry: float = 0.0
    rz: float = 0.0
    may_touch: bool = False


@dataclass(frozen=True, slots=True)
class HandBack:
    """The person gives the robot back, and says what is so: "held_left", "held_right", "go_on", "give_up"."""

    ending: str


@dataclass(frozen=True, slots=True)
class Listen:
    """From now on hear what everybody else is told of their orders."""


@dataclass(frozen=True, slots=True)
class Watch:
    """From now on hear of each event, and of the tree as it changes."""


@dataclass(frozen=True, slots=True)
class GetWorld:
    """What is believed of the world, solids with their poses and errors?"""


@dataclass(frozen=True, slots=True)
class GetTree:
    """Write the tree under way down, as a document of BehaviorTree.CPP 4."""


@dataclass(frozen=True, slots=True)
class GetScene:
    """What does the robot believe to be around it?"""


DeskMessage = (
    Say
    | ScriptLine
    | Cancel
    | Answer
    | PauseTask
    | ResumeTask
    | GetStatus
    | GetScene
    | GetWorld
    | GetTree
    | Listen
    | Watch
    | Velocity
    | FollowTrajectory
    | TakeOver
    | Jog
    | HandBack
)


_MESSAGES: Mapping[str, type] = {
    "say": Say,
    "statement": ScriptLine,
    "cancel": Cancel,
    "answer": Answer,
    "pause": PauseTask,
    "resume": ResumeTask,
    "status": GetStatus,
    "scene": GetScene,
    "world": GetWorld,
    "tree_document": GetTree,
    "listen": Listen,
    "watch": Watch,
    "velocity": Velocity,
    "follow_trajectory": FollowTrajectory,
    "take_over": TakeOver,
    "jog": Jog,
    "hand_back": HandBack,
}


_NAMES = {kind: name for name, kind in _MESSAGES.items()}


def write_desk_message(message: DeskMessage) -> bytes:
    """The payload of a message to the executive."""
    values = {field.name: getattr(message, field.name) for field in fields(message)}
    return write_message(_NAMES[type(message)], **values)
