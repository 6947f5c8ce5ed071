"""Keeps the state machine true to the robot, and says whether a command may be carried out.

Neither a leaf nor the session decides about safety here: the latch is the control loop's, the health
is measured by the control loop, and this module only draws the conclusions for commands.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from executive.session.lifecycle import Lifecycle, LifecycleChanged, LifecycleState, Trigger
from robots.clock import Clock
from robots.control.loop.emergency_stop import EmergencyStop, PersonsReset
from trees.failures import Failure

RECOVERY_S = 0.5
"""Simulated time in which the robot must be found at rest and healthy before it is believed."""


class Guarded(Protocol):
    """What the supervisor asks of the control loop, or of a client of one."""

    @property
    def emergency(self) -> EmergencyStop | None:
        """The emergency stop that is engaged."""
        ...

    @property
    def defects(self) -> tuple[str, ...]:
        """What is wrong with the robot now, for people."""
        ...

    @property
    def reservations(self) -> tuple[str, ...]:
        """What is wrong so that no new task should be begun, for people."""
        ...

    @property
    def still(self) -> bool:
        """Whether nothing is commanded to move."""
        ...

    def emergency_stop(self, reason: str, category: int = 1) -> None:
        """Stop and latch."""
        ...

    def reset(self, request: PersonsReset) -> str | None:
        """Leave the emergency stop, or say why not."""
        ...


class Supervisor:
    """Says whether commands may be carried out, and keeps the state machine true to the robot.

    Attributes:
        lifecycle: The state machine.
    """

    def __init__(self, loop: Guarded, clock: Clock, sink: Callable[[LifecycleChanged], None]) -> None:
        self.lifecycle = Lifecycle(sink, clock.now_s)
        self._loop = loop
        self._wanted: list[tuple[str, int]] = []

    def emergency_stop(self, reason: str, category: int = 1) -> None:
        """Ask for the emergency stop before the next control period; safe to call from a signal handler."""
        self._wanted.append((reason, category))

    @property
    def stop_asked(self) -> bool:
        """Whether an emergency stop was asked for that waits for the next control period."""
        return bool(self._wanted)

    def before_period(self) -> None:
        """Carry out what was asked for; called before each control period.

        All of it, for the latch knows which category is the severest.
        """
        wanted, self._wanted = self._wanted, []
        for reason, category in wanted:
            self._loop.emergency_stop(reason, category)

    def stopped(self) -> str | None:
        """Why everything is stopped now, or None; brings the state machine up to the latch."""
        emergency = self._loop.emergency
        if emergency is None:
            return None
        if self.lifecycle.state is not LifecycleState.EMERGENCY:
            self.lifecycle.take(Trigger.STOP, emergency.reason)
        return str(emergency)

    def reset(self, person: str) -> str | None:
        """Leave the emergency stop on a person's behalf; returns what stands against it, or None.

        Without one, what the person has looked at counts as mended, and the next command recovers.
        """
        self.stopped()
        reason = self._loop.reset(PersonsReset(person))
        if reason is None:
            self.lifecycle.take(Trigger.RESET, f"reset by {person}")
        return reason

    def unwell(self) -> Failure | None:
        """Why the task under way cannot go on with this body, or None."""
        defects = self._loop.defects
        return Failure.execution(f"the robot is not well: {'; '.join(defects)}") if defects else None

    def note_defect(self, reason: str) -> None:
        """Something that must not happen has happened; an emergency is worse, and stays one."""
        if self.stopped() is None and self.lifecycle.allows(Trigger.DEFECT):
            self.lifecycle.take(Trigger.DEFECT, reason)

    def admit(self, let_pass: Callable[[float], None]) -> Failure | None:
        """Tell why a command must not be carried out now, or None; recovers first where that is needed.

        Args:
            let_pass: Lets so many seconds of simulated time pass while the robot holds.
        """
        stopped = self.stopped()
        if stopped is not None:
            return Failure.refused(f"{stopped}; a person has to reset it")
        unwell = self.unwell()
        if unwell is not None:  # noticed after the last task, or in its last moment
            self.note_defect(unwell.message)
        if self.lifecycle.state is LifecycleState.ERROR:
            self.lifecycle.take(Trigger.RECOVER, "a command came")
        if self.lifecycle.state is LifecycleState.RECOVERY:
            let_pass(RECOVERY_S)
            refusal = self._finish_recovery()
            if refusal is not None:
                return refusal
        reservations = self._loop.reservations
        return Failure.refused("; ".join(reservations)) if reservations else None

    def _finish_recovery(self) -> Failure | None:
        stopped = self.stopped()
        if stopped is not None:
            return Failure.refused(f"{stopped}; a person has to reset it")
        wrong = [*self._loop.defects, *([] if self._loop.still else ["the robot does not come to rest"])]
        if wrong:
            reason = "; ".join(wrong)
            self.lifecycle.take(Trigger.DEFECT, reason)
            return Failure.refused(f"the robot could not recover: {reason}")
        self.lifecycle.take(Trigger.HEALTHY, "at rest and healthy")
        return None
