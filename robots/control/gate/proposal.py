"""What is meant to be commanded next, before it has been judged."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Array
from kinematics.motion.sampler import MotionSample
from robots.control.gate.refusal import Refusal


@dataclass(frozen=True, slots=True)
class Proposal:
    """What the streamer wants the robot to follow next.

    Attributes:
        owner: Who moves something in it.
        q, v: Setpoint of the actuated joints, shape (n,).
        body: The same with base and accelerations, for the feed-forward.
        refusal: The online checker's, when a guarded motion broke its promise; then the rest is
            not to be used.
        efforts: Feed-forward of the body joints, Nm, shape (bodies,), where whoever moves them
            balances as well; None leaves it to the standing robot's balance.
    """

    owner: str
    q: Array
    v: Array
    body: MotionSample
    refusal: Refusal | None = None
    efforts: Array | None = None
