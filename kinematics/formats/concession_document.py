"""Concessions as parts of the JSON document of a trajectory."""

from __future__ import annotations

from kinematics.formats.json_reader import Node
from kinematics.formats.solid_document import MAX_SIZE_M, read_pair
from kinematics.scene.concessions import Concession, ConcessionReason

_REASONS = tuple(reason.value for reason in ConcessionReason)


def concession_json(one: Concession) -> dict[str, object]:
    """What ``read_concession`` reads."""
    found: dict[str, object] = {"pair": list(one.names), "reason": one.reason.value, "step": one.step}
    if one.distance_m is not None:
        found["distance_m"] = one.distance_m
    return found


def read_concession(node: Node) -> Concession:
    """A concession; what it may concede is the checker's to say.

    Raises:
        TrajectoryDocumentError: It is none; with its place.
    """
    node.only(("pair", "reason", "step"), ("distance_m",))
    distance_m = node.key("distance_m").number(MAX_SIZE_M) if node.has("distance_m") else None
    if distance_m is not None and distance_m < 0.0:
        raise node.key("distance_m").error(f"must be 0 or more, not {distance_m!r}")
    return Concession(
        pair=read_pair(node.key("pair")),
        reason=ConcessionReason(node.key("reason").choice(_REASONS)),
        step=node.key("step").text(),
        distance_m=distance_m,
    )
