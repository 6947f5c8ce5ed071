"""Random trees of the nodes that BehaviorTree.CPP brings along, with leaves that follow a script."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

TICKS = 14
_CONTROLS = (
    "Sequence", "Fallback", "ReactiveSequence", "ReactiveFallback", "SequenceWithMemory",
    "Parallel", "ParallelAll", "IfThenElse", "WhileDoElse",
)  # fmt: skip
_DECORATORS = (
    "Inverter", "ForceSuccess", "ForceFailure", "RetryUntilSuccessful", "Repeat", "KeepRunningUntilFailure",
)  # fmt: skip
_DEEPEST = 4
_OUTCOMES = "RRSSF"


@dataclass(frozen=True, slots=True)
class RandomNode:
    """One node.

    Attributes:
        kind: Its kind, "" for a leaf.
        ports: Its attributes.
        condition: Whether a leaf only asks: it answers at once.
        script: What a leaf answers, tick by tick, over and over: R(unning), S(uccess), F(ailure).
        number: Of a leaf, from 0 on; -1 for others.
        children: In order.
    """

    kind: str
    ports: dict[str, int] = field(default_factory=dict)
    condition: bool = False
    script: str = ""
    number: int = -1
    children: tuple[RandomNode, ...] = ()

    def leaves(self) -> list[RandomNode]:
        """All leaves below it, or itself, in order."""
        if not self.children:
            return [self]
        return [leaf for child in self.children for leaf in child.leaves()]


def random_tree(seed: int) -> RandomNode:
    """The tree of a seed, the same on every machine: only ``random()`` is drawn."""
    generator = np.random.default_rng(seed)
    numbers = iter(range(1000))
    return _node(lambda among: among[int(generator.random() * len(among))], numbers.__next__, 0)


def document(tree: RandomNode, leaf: Callable[[RandomNode], str]) -> str:
    """A tree as a document; ``leaf`` writes the element of a leaf."""
    body = _element(tree, leaf)
    return f'<root BTCPP_format="4"><BehaviorTree ID="Random">{body}</BehaviorTree></root>'


def _element(node: RandomNode, leaf: Callable[[RandomNode], str]) -> str:
    if not node.kind:
        return leaf(node)
    ports = "".join(f' {name}="{value}"' for name, value in node.ports.items())
    return f"<{node.kind}{ports}>{''.join(_element(child, leaf) for child in node.children)}</{node.kind}>"


def _node(draw: Callable[[Sequence[object]], object], number: Callable[[], int], depth: int) -> RandomNode:
    def pick(*among: int) -> int:
        return int(str(draw(among)))

    if depth == _DEEPEST or (depth > 0 and pick(0, 0, 1)):
        script = "".join(str(draw(_OUTCOMES)) for _ in range(pick(1, 2, 3, 5, 7)))
        return RandomNode("", script=script, number=number())
    kind = str(draw(_CONTROLS if depth == 0 or pick(0, 0, 1) == 0 else _DECORATORS))
    many = {"IfThenElse": (2, 3), "WhileDoElse": (2, 3)}.get(kind, (1, 2, 3, 4))
    count = 1 if kind in _DECORATORS else pick(*many)
    first: tuple[RandomNode, ...] = ()
    if kind in ("IfThenElse", "WhileDoElse"):
        asked = "".join(str(draw("SSF")) for _ in range(pick(1, 2, 3, 5, 7)))
        first, count = (RandomNode("", condition=True, script=asked, number=number()),), count - 1
    children = (*first, *(_node(draw, number, depth + 1) for _ in range(count)))
    ports = {}
    if kind == "Parallel":
        enough = (-1, *range(1, count + 1))
        ports = {"success_count": pick(*enough), "failure_count": pick(*enough)}
    elif kind == "ParallelAll":
        ports = {"max_failures": pick(-1, *range(1, count + 1))}
    elif kind == "RetryUntilSuccessful":
        ports = {"num_attempts": pick(1, 2, 3, 5)}
    elif kind == "Repeat":
        ports = {"num_cycles": pick(1, 2, 3, 5)}
    return RandomNode(kind, ports, children=children)
