"""What a leaf promises, in a form that documentation and generated tests can read."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Moves = Literal["nothing", "body", "gripper", "body and gripper"]


@dataclass(frozen=True, slots=True)
class Contract:
    """The promises of a leaf; its ports are declared beside it.

    Attributes:
        precondition: What must hold when it starts.
        postcondition: What was measured to hold when it succeeds.
        deadline_s: It has ended by then, counted from its first tick on the injected clock; a leaf
            whose motion takes longer adds the motion's own duration.
        moves: What it sets in motion. Whatever it moves is stopped and held when it fails or is
            cancelled; the other parts of the robot hold throughout.
        on_success: The state that it leaves behind.
        on_failure: The same, after a failure.
        on_cancel: The same, after a halt.
    """

    precondition: str
    postcondition: str
    deadline_s: float
    moves: Moves = "nothing"
    on_success: str = "the robot holds its posture"
    on_failure: str = "the robot holds its posture"
    on_cancel: str = "the robot holds its posture"
