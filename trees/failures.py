"""Why something failed: typed, placed in the tree, with numbers and the failure that caused it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from typing import Any


class FailureKind(Enum):
    """What sort of failure it is."""

    INFEASIBLE = "INFEASIBLE"
    UNSAFE = "UNSAFE"
    REFUSED = "REFUSED"
    EXECUTION = "EXECUTION"
    POSTCONDITION = "POSTCONDITION"
    TIMEOUT = "TIMEOUT"
    CANCELED = "CANCELED"
    ERROR = "ERROR"


Number = float | int | str | bool

CHOICES_JOINED_BY = " | "
"""Between the words of a failure's ``choices``."""


@dataclass(frozen=True, slots=True)
class Failure:
    """One link of a failure chain.

    Attributes:
        kind: What sort of failure.
        message: One sentence for people, without the numbers' names.
        numbers: What was measured and what it had to be; keys carry their unit.
        where: Place in the tree, names joined by "/"; the life cycle fills it in.
        cause: The failure that led to this one.
    """

    kind: FailureKind
    message: str
    numbers: Mapping[str, Number] = field(default_factory=dict)
    where: str = ""
    cause: Failure | None = None

    @classmethod
    def infeasible(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """No plan or no grasp exists, or none was found."""
        return cls(FailureKind.INFEASIBLE, message, numbers, cause=cause)

    @classmethod
    def unsafe(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """The trajectory checker said no."""
        return cls(FailureKind.UNSAFE, message, numbers, cause=cause)

    @classmethod
    def refused(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """The gate or the online checker stopped the motion."""
        return cls(FailureKind.REFUSED, message, numbers, cause=cause)

    @classmethod
    def execution(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """The motion did not end where it should."""
        return cls(FailureKind.EXECUTION, message, numbers, cause=cause)

    @classmethod
    def postcondition(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """What had to be true afterwards was measured not to be."""
        return cls(FailureKind.POSTCONDITION, message, numbers, cause=cause)

    @classmethod
    def timeout(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """It took longer than its deadline."""
        return cls(FailureKind.TIMEOUT, message, numbers, cause=cause)

    @classmethod
    def error(cls, message: str, cause: Failure | None = None, **numbers: Number) -> Failure:
        """A defect: an exception in a behavior."""
        return cls(FailureKind.ERROR, message, numbers, cause=cause)

    def at(self, where: str) -> Failure:
        """The same failure with its place in the tree."""
        return replace(self, where=where)

    def caused_by(self, cause: Failure | None) -> Failure:
        """The same failure with its cause."""
        return replace(self, cause=cause)

    @property
    def is_unseen(self) -> bool:
        """Whether no look showed what is meant: the root tells what was ``seen`` in its place."""
        root = self.root
        return root.kind is FailureKind.POSTCONDITION and isinstance(root.numbers.get("seen"), str)

    @property
    def is_no_grasp(self) -> bool:
        """Whether the planner found no way to grasp what was seen: the root tells ``grasps_considered``."""
        root = self.root
        return root.kind is FailureKind.INFEASIBLE and "grasps_considered" in root.numbers

    @property
    def wants_nearer(self) -> bool:
        """Whether somebody stands too far away for a hand-over: the root tells ``person_m``."""
        root = self.root
        return root.kind is FailureKind.INFEASIBLE and "person_m" in root.numbers

    @property
    def choices(self) -> tuple[str, ...]:
        """What a person has to choose from, when several things fit; at the root of the chain."""
        return self._listed("choices")

    @property
    def choice_names(self) -> tuple[str, ...]:
        """The names that the planning scene has for the ``choices``, in the same order."""
        return self._listed("objects")

    @property
    def choice_slot(self) -> str:
        """The task's slot that a choice fills in."""
        return str(self.root.numbers.get("slot", "object"))

    @property
    def root(self) -> Failure:
        """The failure that began the chain."""
        root = self
        while root.cause is not None:
            root = root.cause
        return root

    def _listed(self, key: str) -> tuple[str, ...]:
        told = self.root.numbers.get(key)
        return tuple(str(told).split(CHOICES_JOINED_BY)) if told is not None else ()

    def to_json(self) -> dict[str, Any]:
        """As the command-line contract writes a failure."""
        return {
            "kind": self.kind.value,
            "where": self.where,
            "message": self.message,
            "numbers": dict(self.numbers),
            "cause": None if self.cause is None else self.cause.to_json(),
        }
