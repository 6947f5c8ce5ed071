"""What the executive's supervisor asks of a control loop that is in another process."""

from __future__ import annotations

from executive.live.control_client.control_link import ControlLink
from robots.control.loop.emergency_stop import EmergencyStop, PersonsReset


class LiveGuard:
    """The emergency stop of a served robot; satisfies ``executive.session.supervisor.Guarded``.

    The latch itself is in the control process.
    """

    def __init__(self, link: ControlLink) -> None:
        """Ask through a link."""
        self._link = link

    @property
    def emergency(self) -> EmergencyStop | None:
        """The emergency stop that is engaged."""
        return self._link.emergency

    @property
    def defects(self) -> tuple[str, ...]:
        """What is wrong with the robot now, for people."""
        return self._link.defects

    @property
    def reservations(self) -> tuple[str, ...]:
        """What is wrong so that no new task should be begun, for people."""
        return self._link.reservations

    @property
    def still(self) -> bool:
        """Whether nothing is commanded to move."""
        return self._link.report.resting

    def emergency_stop(self, reason: str, category: int = 1) -> None:
        """Stop and latch."""
        self._link.stop(category, reason)

    def reset(self, _request: PersonsReset) -> str | None:
        """Take note that a person has reset it; that is done at the control process alone."""
        return None if self._link.emergency is None else "a person resets it with `executive reset`"
