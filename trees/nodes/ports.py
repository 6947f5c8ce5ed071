"""Declare the ports of a leaf."""

from __future__ import annotations

from py_trees.ports import PortInformation


def ports(**declared: type | PortInformation) -> dict[str, PortInformation]:
    """Ports by name; a bare type is a required port of that type."""
    return {
        name: port if isinstance(port, PortInformation) else PortInformation(port)
        for name, port in declared.items()
    }


def optional(data_type: type) -> PortInformation:
    """An input port that may have no value yet."""
    return PortInformation(data_type, required=False)
