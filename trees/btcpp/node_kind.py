"""A kind of node as BehaviorTree.CPP knows it: its ID, its ports, and how nodes of it are made and told."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from py_trees.behaviour import Behaviour

from trees.toolbox import Toolbox

Category = Literal["Control", "Decorator", "Action"]


@dataclass(frozen=True, slots=True)
class Port:
    """An attribute of a node.

    Attributes:
        name: Of the attribute.
        direction: Whether the node reads it, or writes what the attribute refers to.
        type: What it holds, in words.
        hint: The type of a literal; None where the attribute is a reference, as "{checked}".
        default: The literal of an attribute that is left out; None when it must be there.
        description: For people.
    """

    name: str
    direction: Literal["input", "output"]
    type: str
    hint: Any = None
    default: str | None = None
    description: str = ""


@dataclass(frozen=True, slots=True)
class Parts:
    """What a node is made of.

    Attributes:
        name: Its name.
        toolbox: What leaves may call.
        children: The nodes below it.
        settings: Values of its literal ports; all that were given or have a default.
    """

    name: str
    toolbox: Toolbox
    children: list[Behaviour]
    settings: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class NodeKind:
    """One kind.

    Attributes:
        id: Its ID, the tag of its elements.
        category: What sort of node.
        make: Makes a node; its references are connected by whoever calls this.
        settings: Tells the values of a node's literal ports; those at their default may be left out.
        ports: Its attributes beside the name.
        children: How many nodes may be below it, least and most.
        description: For people.
        builtin: Whether BehaviorTree.CPP brings it along; others are in the document's model of nodes.
        transparent: Whether such nodes are left out of places in the tree unless their attribute says so.
    """

    id: str
    category: Category
    make: Callable[[Parts], Behaviour]
    settings: Callable[[Any], Mapping[str, Any]] = field(default=lambda _node: {})
    ports: tuple[Port, ...] = ()
    children: tuple[int, int] = (0, 0)
    description: str = ""
    builtin: bool = False
    transparent: bool = False
