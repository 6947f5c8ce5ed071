"""What happened in a run of a tree, tick by tick, in a form that two engines can be compared by."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from tools.control_flow.random_trees import TICKS, RandomNode


@dataclass(slots=True)
class Trace:
    """Notes what leaves do; leaves answer by their scripts.

    Attributes:
        ticks: For each tick the leaves' doings in order, then the root's status: "0s 1r 0h=R" is leaf 0
            started, leaf 1 running on, leaf 0 halted, the root running.
    """

    tree: RandomNode
    ticks: list[str] = field(default_factory=list)
    _doings: list[str] = field(default_factory=list)
    _answered: dict[int, int] = field(default_factory=dict)

    def answer(self, number: int, started: bool) -> str:
        """The next answer of a leaf: R, S or F."""
        turn = self._answered.get(number, 0)
        self._answered[number] = turn + 1
        self._doings.append(f"{number}{'s' if started else 'r'}")
        script = next(leaf.script for leaf in self.tree.leaves() if leaf.number == number)
        return script[turn % len(script)]

    def halted(self, number: int) -> None:
        """A leaf was halted while it ran."""
        self._doings.append(f"{number}h")

    def run(self, tick: Callable[[], str]) -> list[str]:
        """Tick a tree, and tell the trace.

        Args:
            tick: Ticks once, and tells the root's status by its first letter.
        """
        for _ in range(TICKS):
            status = tick()
            self.ticks.append(f"{' '.join(self._in_order())}={status}")
            self._doings.clear()
        return self.ticks

    def _in_order(self) -> list[str]:
        """Neighbouring halts by number: which of them is first is no matter of control flow."""
        ordered: list[str] = []
        halts: list[str] = []
        for doing in [*self._doings, ""]:
            if doing.endswith("h"):
                halts.append(doing)
            else:
                ordered += [*sorted(halts), doing]
                halts = []
        return ordered[:-1]
