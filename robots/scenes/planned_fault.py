"""A fault of the body or of the world as a value: what goes wrong, with what, by how much, and when.

Plain numbers and names, so that the log of a run can hold it and a replay can bring it about again.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from types import MappingProxyType
from typing import Any

VALUES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "joint_stuck": (),
        "joint_offline": (),
        "joint_weak": ("share",),
        "encoder_offset": ("offset_rad",),
        "gyro_bias": ("x_rad_s", "y_rad_s", "z_rad_s"),
        "battery_low": ("share",),
        "object_gone": (),
        "object_moved": ("x_m", "y_m"),
        "object_knocked": ("heading_rad", "distance_m"),
        "object_tipped": ("heading_rad",),
        "object_slippery": ("friction",),
    }
)
"""The kinds of faults, and what the values of each are."""

_WITHOUT_TARGET = frozenset({"gyro_bias", "battery_low"})


@dataclass(frozen=True, slots=True)
class PlannedFault:
    """One thing that goes wrong on purpose.

    Attributes:
        name: Its kind, a key of ``VALUES``.
        t_s: Simulated time from which on it is there; it begins with the first control period then.
        target: The joint or the object, or "".
        values: As ``VALUES`` names them.

    Raises:
        ValueError: There is no such kind, or its values or its target do not go with it.
    """

    name: str
    t_s: float
    target: str = ""
    values: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        """Refuse what cannot be a fault."""
        if self.name not in VALUES:
            raise ValueError(f"no fault {self.name!r} among {', '.join(VALUES)}")
        if len(self.values) != len(VALUES[self.name]):
            raise ValueError(f"{self.name} needs the values {VALUES[self.name]}, not {self.values}")
        if bool(self.target) == (self.name in _WITHOUT_TARGET):
            raise ValueError(f"{self.name} of {self.target!r}: a joint or an object is missing or too much")
        if not all(math.isfinite(one) for one in (self.t_s, *self.values)) or self.t_s < 0.0:
            raise ValueError(f"{self.name}: {self.t_s} and {self.values} are no times and values")

    def to_json(self) -> dict[str, Any]:
        """As JSON values."""
        return {**asdict(self), "values": list(self.values)}


def fault_from_json(document: Any) -> PlannedFault:
    """The fault that ``to_json`` wrote.

    Raises:
        ValueError: It is none.
    """
    try:
        return PlannedFault(
            str(document["name"]),
            float(document["t_s"]),
            str(document.get("target", "")),
            tuple(float(one) for one in document.get("values", ())),
        )
    except (AttributeError, KeyError, TypeError) as wrong:
        raise ValueError(f"{document!r} is no fault: {wrong}") from wrong
