"""Values that are known before a tree begins."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from trees.nodes.ports import WithPorts, ports


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
