"""What the robot can say of itself, and how it knows what day and what time it is."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime, timedelta

USUAL_START = datetime(2026, 1, 5, 9, 0)
"""When a simulated day begins that nobody says the beginning of: a Monday, at nine in the morning."""


@dataclass(frozen=True, slots=True)
class Identity:
    """What the robot says when it is asked about itself; what is empty it does not know.

    Attributes:
        name: What it is called; of an empty one the model's name is said.
        team: Whom it works for, or competes for.
        country: Where it comes from.
        affiliation: The university, company or club behind the team.
        about: A sentence or two about itself.
    """

    name: str = ""
    team: str = ""
    country: str = ""
    affiliation: str = ""
    about: str = ""


@dataclass(frozen=True, slots=True)
class Calendar:
    """Tells date and time of day from a clock that only counts seconds.

    Attributes:
        began: Local date and time at one instant.
        began_s: The same instant on the clock.
    """

    began: datetime = USUAL_START
    began_s: float = 0.0

    def at(self, now_s: float) -> datetime:
        """Local date and time.

        Args:
            now_s: What the clock says.
        """
        return self.began + timedelta(seconds=now_s - self.began_s)
