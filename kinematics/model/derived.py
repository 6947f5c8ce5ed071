"""What was made of a value, kept by that value: each thing is made once, and goes when the value goes."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Any, Generic, Self, TypeVar, TypeVarTuple, cast

K = TypeVar("K", bound=Hashable)
T = TypeVar("T")
Ts = TypeVarTuple("Ts")


class Derivable:
    """Base of values that never change, of which others make tables, solvers and judges at some cost.

    Who makes them asks the value for what was made before, so that no module keeps a table of its own. A
    subclass has a dict ``_derived``, empty at first, that no copy with other contents may share.
    """

    __slots__ = ()

    _derived: dict[Hashable, Any]

    def derived(self, make: Callable[[Self, *Ts], T], *more: *Ts) -> T:
        """What ``make(self, *more)`` returned when it was asked for first.

        Args:
            make: A function or class of a module, never one made on the spot: it tells what is asked for.
            more: What else it depends on; hashable, and few values in all, for they are kept.
        """
        known = self._derived
        key = make, more
        if key not in known:
            known[key] = make(self, *more)
        return cast(T, known[key])


class Recent(Generic[K, T]):
    """What was made for the keys that were asked for last; the others are forgotten."""

    def __init__(self, kept: int) -> None:
        """Keep so many at most."""
        self._kept = kept
        self._known: dict[K, T] = {}

    def of(self, key: K, make: Callable[[], T]) -> T:
        """What belongs to a key; made where it is not known."""
        known = self._known
        if key in known:
            found = known.pop(key)
        else:
            found = make()
            while len(known) >= self._kept:
                known.pop(next(iter(known)))
        known[key] = found
        return found
