"""A body behind Unitree's interface in one process: the wire is lists of messages, and time is the caller's.

Everything but DDS is as with a robot: messages are bytes with their sums, late and lost, each motor follows
its own servo, and the control loop knows nothing but what comes back.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from kinematics.model.robot_description import Hand
from robots.clock import ManualClock
from robots.interface.hardware import RobotData
from robots.simulated.world import SimulatedWorld
from robots.unitree.commands import TAKE_UP_S
from robots.unitree.layout import Record
from robots.unitree.robot import UnitreeRobot
from tools.unitree.referee import Referee

DELAY_S, LOSS = 0.002, 0.01
STANDING_TAKE_UP_S = 0.05
"""Of a robot that stands freely when its motors are taken up: nobody holds it for longer."""


class LocalEnd:
    """One end of a wire within a process.

    Attributes:
        inbox: What has come.
    """

    def __init__(self, waits: Callable[[], None] = lambda: None) -> None:
        """Make an end; ``waits`` lets time pass until the next message."""
        self.inbox: list[Record] = []
        self._other: LocalEnd | None = None
        self._waits = waits

    @classmethod
    def pair(cls, waits: Callable[[], None] = lambda: None) -> tuple[LocalEnd, LocalEnd]:
        """Both ends of a wire; the first one waits."""
        here, there = cls(waits), cls()
        here._other, there._other = there, here
        return here, there

    def send(self, message: Record) -> None:
        """Send a message; it is there at once."""
        if self._other is not None:
            self._other.inbox.append(message)

    def received(self) -> list[Record]:
        """What has come since the last call, oldest first."""
        come, self.inbox = self.inbox, []
        return come

    def wait(self, longest_s: float) -> None:  # noqa: ARG002
        """Let the robot's next period pass."""
        self._waits()


def wired(
    world: SimulatedWorld,
    clock: ManualClock,
    *,
    take_up_s: float = TAKE_UP_S,
    on_wait: Callable[[], None] = lambda: None,
    **played: Any,
) -> tuple[UnitreeRobot, Referee]:
    """A body and the referee that plays it.

    Args:
        world: Whose robot is played.
        clock: Time, as the body knows it.
        take_up_s: For so long motors are taken up.
        on_wait: Called after each period of the referee.
        played: Options of ``Referee``.
    """
    referees: list[Referee] = []

    def pass_period() -> None:
        referees[0].step()
        on_wait()

    data = RobotData(world.robot.description, world.robot.hardware)
    here, there = LocalEnd.pair(pass_period)
    pairs = {hand: LocalEnd.pair() for hand in data.description.grippers}
    ours: Mapping[Hand, LocalEnd] = {hand: near for hand, (near, _) in pairs.items()}
    theirs = {hand: far for hand, (_, far) in pairs.items()}
    referees.append(Referee(world, there, theirs, **played))
    return UnitreeRobot(data, here, clock, ours, take_up_s=take_up_s), referees[0]


def over_the_wire(world: SimulatedWorld, clock: ManualClock, seed: int = 0) -> UnitreeRobot:
    """The body of a robot that stands in a world, over a wire with a delay and losses."""
    body, _ = wired(world, clock, take_up_s=STANDING_TAKE_UP_S, delay_s=DELAY_S, loss=LOSS, seed=seed)
    return body
