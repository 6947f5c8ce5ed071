"""The executive's state machine: NORMAL, ERROR, RECOVERY, EMERGENCY, and nothing between.

One table says what leads from where to where; the documentation is rendered from it. The emergency
stop's latch in the control loop is the authority on EMERGENCY, and this machine follows it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum
from types import MappingProxyType


class LifecycleState(Enum):
    """What the executive may do."""

    NORMAL = "NORMAL"
    ERROR = "ERROR"
    RECOVERY = "RECOVERY"
    EMERGENCY = "EMERGENCY"


class Trigger(Enum):
    """What leads from one state to another."""

    DEFECT = "a defect, a lost part, an inconsistent state"
    RECOVER = "the next command, or a person"
    HEALTHY = "health checked: at rest, and nothing is found to be wrong"
    STOP = "the emergency stop"
    RESET = "a person's reset"


@dataclass(frozen=True, slots=True)
class LifecycleChanged:
    """The executive went from one state to another."""

    t_s: float
    before: str
    after: str
    trigger: str
    reason: str


class IllegalTransitionError(RuntimeError):
    """A trigger that leads nowhere from the present state: a defect of whoever gave it."""

    def __init__(self, state: LifecycleState, trigger: Trigger) -> None:
        known = ", ".join(sorted(name.name for (where, name) in TRANSITIONS if where is state))
        super().__init__(f"{trigger.name} leads nowhere from {state.value}; there are {known}")


_S, _T = LifecycleState, Trigger

TRANSITIONS: Mapping[tuple[LifecycleState, Trigger], LifecycleState] = MappingProxyType(
    {
        (_S.NORMAL, _T.DEFECT): _S.ERROR,
        (_S.NORMAL, _T.STOP): _S.EMERGENCY,
        (_S.ERROR, _T.RECOVER): _S.RECOVERY,
        (_S.ERROR, _T.STOP): _S.EMERGENCY,
        (_S.RECOVERY, _T.HEALTHY): _S.NORMAL,
        (_S.RECOVERY, _T.DEFECT): _S.ERROR,
        (_S.RECOVERY, _T.STOP): _S.EMERGENCY,
        (_S.EMERGENCY, _T.RESET): _S.RECOVERY,
    }
)
"""Everything that is allowed."""

COMMANDS: Mapping[LifecycleState, str] = MappingProxyType(
    {
        _S.NORMAL: "carried out",
        _S.ERROR: "start the recovery, and are carried out when it succeeds",
        _S.RECOVERY: "wait for the recovery",
        _S.EMERGENCY: "refused: a person's reset is needed",
    }
)
"""What becomes of a command in each state."""


class Lifecycle:
    """The executive's state machine: its present state, and the only way to change it.

    Attributes:
        state: The present one.
        reason: Why it was entered, for people; empty at first.
    """

    def __init__(self, sink: Callable[[LifecycleChanged], None], now_s: Callable[[], float]) -> None:
        """Begin in NORMAL.

        Args:
            sink: Takes an event for every transition.
            now_s: For the events' stamps.
        """
        self.state = LifecycleState.NORMAL
        self.reason = ""
        self._sink, self._now_s = sink, now_s

    def allows(self, trigger: Trigger) -> bool:
        """Tell whether a trigger leads anywhere from here."""
        return (self.state, trigger) in TRANSITIONS

    def take(self, trigger: Trigger, reason: str) -> LifecycleState:
        """Make a transition.

        Args:
            trigger: What happened.
            reason: Why, for people and the log.

        Raises:
            IllegalTransitionError: It leads nowhere from here; the state stays as it is.
        """
        after = TRANSITIONS.get((self.state, trigger))
        if after is None:
            raise IllegalTransitionError(self.state, trigger)
        before, self.state, self.reason = self.state, after, reason
        self._sink(LifecycleChanged(self._now_s(), before.value, after.value, trigger.name, reason))
        return after
