"""Numbers of coming near to a person; each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class MeetingSettings:
    """Numbers of coming near to a person.

    Attributes:
        near_m: Who is no farther away is spoken to from here: people talk to those whom they do not know from
            1.2 m to 2 m away (Hall 1966, the near phase of social distance).
        faced_rad: What is farther to a side than this is turned to with the feet; trunk and hand do the rest.
        attempts: How often the robot goes after somebody who has walked on.
    """

    near_m: float = 1.8
    faced_rad: float = 0.2
    attempts: int = 4
