"""Which trajectories may be streamed: those that the control side's own checker let pass."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any, Protocol

from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from robots.live.wire.messages import write_message

MAX_ADMITTED = 16
"""The oldest is forgotten; a task has three or four at a time."""
MAX_WAITING = 8


class Asks(Protocol):
    """What judges documents of trajectories: the checker process, or a double in tests."""

    def ask(self, question: object) -> Future[Any]:
        """Judge one document."""
        ...


@dataclass(frozen=True, slots=True)
class Verdict:
    """The answer for one trajectory; ``answer`` is a text when it was not judged at all."""

    trajectory: int
    answer: CheckedTrajectory | Unsafe | str


class AdmissionDesk:
    """Sends documents to the checker, and keeps what passed until it is started."""

    def __init__(self, checker: Asks, tell: Callable[[Verdict], None]) -> None:
        """Use a checker; ``tell`` hears of each verdict."""
        self._checker, self._tell = checker, tell
        self._waiting: list[tuple[int, int, Future[Any]]] = []
        self._admitted: OrderedDict[int, tuple[CheckedTrajectory, int]] = OrderedDict()

    @property
    def waiting(self) -> int:
        """How many are being judged."""
        return len(self._waiting)

    def submit(self, trajectory: int, world_version: int, document: bytes) -> str | None:
        """Have a document judged; returns why not, or None."""
        if len(self._waiting) >= MAX_WAITING:
            return f"{MAX_WAITING} trajectories are being judged already"
        if trajectory in self._admitted or any(one[0] == trajectory for one in self._waiting):
            return f"trajectory {trajectory} is there already"
        self._waiting.append((trajectory, world_version, self._checker.ask(document)))
        return None

    def poll(self) -> None:
        """Take the answers that have come."""
        for entry in [entry for entry in self._waiting if entry[2].done()]:
            self._waiting.remove(entry)
            trajectory, world_version, future = entry
            raised = future.exception()
            answer = f"it was not judged: {raised}" if raised is not None else future.result()
            if isinstance(answer, CheckedTrajectory):
                self._admitted[trajectory] = answer, world_version
                while len(self._admitted) > MAX_ADMITTED:
                    self._admitted.popitem(last=False)
            self._tell(Verdict(trajectory, answer))

    def take(self, trajectory: int, world_version: int) -> CheckedTrajectory | str:
        """An admitted trajectory to be streamed, once; or why it may not be.

        Args:
            trajectory: Its number.
            world_version: The newest version of the commander's world model.
        """
        found = self._admitted.pop(trajectory, None)
        if found is None:
            return f"trajectory {trajectory} was not admitted by the checker"
        checked, made_for = found
        if made_for != world_version:
            return f"stale: made for version {made_for} of the scene, which is at {world_version} now"
        return checked

    def forget(self) -> None:
        """Drop everything: the commander is another one now."""
        for _, _, future in self._waiting:
            future.cancel()
        self._waiting.clear()
        self._admitted.clear()


def verdict_message(verdict: Verdict) -> bytes:
    """A verdict as the commander is told it."""
    match verdict.answer:
        case CheckedTrajectory():
            return write_message("admitted", trajectory=verdict.trajectory)
        case Unsafe(findings):
            plain = [
                [one.kind.value, one.t_s, list(one.subject), one.value, one.limit] for one in findings[:50]
            ]
            return write_message("unsafe", trajectory=verdict.trajectory, findings=plain)
        case reason:
            return write_message("rejected", trajectory=verdict.trajectory, reason=reason[:2000])
