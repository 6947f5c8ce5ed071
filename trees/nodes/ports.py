"""Ports of nodes: how they are declared, and the nodes that have them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.ports import PortInformation, PortsMixin


def ports(**declared: type | PortInformation) -> dict[str, PortInformation]:
    """Ports by name; a bare type is a required port of that type."""
    return {
        name: port if isinstance(port, PortInformation) else PortInformation(port)
        for name, port in declared.items()
    }


def optional(data_type: type) -> PortInformation:
    """An input port that may have no value yet."""
    return PortInformation(data_type, required=False)


class WithPorts(PortsMixin):
    """The mixin of nodes with typed ports: py_trees' own, without its search for abstract methods.

    py_trees looks through all attributes of the class whenever it makes a node with ports, to refuse one of a
    class that is still abstract. Whether it is never changes, and Python itself refuses what has abstract
    methods; with the search, building the 120 leaves of a pick takes four times as long. So this class asks
    for the ports alone, and begins a node with the same attributes as py_trees does.
    """

    def __init__(self, *arguments: Any, **named: Any) -> None:
        """Make the node; the arguments are those of the class that follows in the order of resolution.

        Raises:
            TypeError: The class of the node declares no ports.
        """
        cls = type(self)
        if not (hasattr(cls, "INPUT_PORTS") and hasattr(cls, "OUTPUT_PORTS")):
            raise TypeError(f"{cls.__name__} cannot be made: it has to declare INPUT_PORTS and OUTPUT_PORTS")
        super(PortsMixin, self).__init__(*arguments, **named)
        self._blackboard_client = None
        self._subtree_namespace = None
        self._ports_logger = None
        self._behaviour_class_name = cls.__name__


class WritePort(WithPorts, Behaviour):
    """Writes a value that is known before the tree begins to its output port, and succeeds."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports(value=object)

    def __init__(self, name: str, key: str, value: Any) -> None:
        """Make the node.

        Args:
            name: Its name.
            key: Where the value goes.
            value: What goes there.
        """
        super().__init__(name)
        self.wiring: Mapping[str, str] = {"value": key}
        self._value = value

    def wire(self, namespace: str) -> None:
        """Connect the port inside a tree's namespace."""
        self.setup_ports({"value": self.wiring["value"]}, namespace)

    def update(self) -> Status:
        """Write it."""
        self._set_output("value", self._value)
        return Status.SUCCESS
