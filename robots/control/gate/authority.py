"""Which owner holds which joints. An owner is an opaque id; nobody moves a joint that he does not hold."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

HOLD = "hold"
"""Owner of a setpoint that moves nothing."""
STOP = "stop"
"""Owner of everything while a stop profile runs."""
_JOIN = "+"


class Authority:
    """Keeps which motion holds which of the actuated joints; no joint has two holders."""

    def __init__(self, joints: Sequence[str]) -> None:
        """Begin with nobody holding anything.

        Args:
            joints: Actuated joints, in the order of a setpoint.
        """
        self._joints = tuple(joints)
        self._index = {name: i for i, name in enumerate(self._joints)}
        self._held: dict[str, NDArray[np.bool_]] = {STOP: np.ones(len(self._joints), dtype=np.bool_)}
        self._forbidden: dict[str, NDArray[np.bool_] | None] = {}

    def claim(self, owner: str, joints: Sequence[str]) -> tuple[str, str] | None:
        """Give joints to an owner, all of them or none.

        Returns:
            None when they are his now, else the first joint that is held and who holds it.
        """
        wanted = np.zeros(len(self._joints), dtype=np.bool_)
        wanted[[self._index[name] for name in joints]] = True
        for other, held in self._held.items():
            if other not in (owner, STOP) and (held & wanted).any():
                return self._joints[int(np.argmax(held & wanted))], other
        self._held[owner] = self._held.get(owner, np.zeros_like(wanted)) | wanted
        self._forbidden.clear()
        return None

    def release(self, owner: str) -> None:
        """Take everything from an owner; unknown owners hold nothing anyway."""
        if owner != STOP and self._held.pop(owner, None) is not None:
            self._forbidden.clear()

    def holder(self, joint: str) -> str | None:
        """Who holds a joint, or None."""
        index = self._index[joint]
        for owner, held in self._held.items():
            if owner != STOP and held[index]:
                return owner
        return None

    def forbidden(self, owner: str) -> NDArray[np.bool_] | None:
        """Joints that a setpoint of this owner must not move, shape (n,); None when it may move all.

        Several owners who act side by side are named together, see ``together``.
        """
        if owner not in self._forbidden:
            forbidden = np.ones(len(self._joints), dtype=np.bool_)
            for part in owner.split(_JOIN):
                if part in self._held:
                    forbidden &= ~self._held[part]
            self._forbidden[owner] = forbidden if forbidden.any() else None
        return self._forbidden[owner]


def together(owners: Sequence[str]) -> str:
    """Name several owners whose joints move in one setpoint; nobody at all is ``HOLD``."""
    return _JOIN.join(owners) if owners else HOLD
