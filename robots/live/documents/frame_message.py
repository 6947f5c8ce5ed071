"""A perception frame as a message, and back; poses cross number by number, bit by bit."""

from __future__ import annotations

import base64
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from kinematics.scene.known_part import KnownPart
from robots.live.wire.errors import ProtocolError
from robots.live.wire.messages import write_message
from robots.perception.detector import Detection, PerceptionFrame
from robots.perception.fusion.cameras import HEAD
from robots.perception.position_error import PositionError
from robots.scenes.meshes.object_model import NoModelError, read_model


def write_frame(frame: PerceptionFrame, source: str = HEAD) -> bytes:
    """The payload of a frame, with the camera that it is from."""
    seen = [
        {
            "category": item.category,
            "kind": item.kind,
            "color": item.color,
            "camera_T_object": item.camera_T_object.ravel().tolist(),
            "shape": _shape_json(item.shape),
            "confidence": item.confidence,
            "name": item.name,
            "names": item.names,
            "categories": item.categories,
            "traits": item.traits,
            "error": _error_json(item.error),
            "alike": item.alike,
            "picture": None if item.picture is None else base64.b64encode(item.picture).decode("ascii"),
            "cut": item.cut,
            "moves": _moves_json(item.moves),
        }
        for item in frame.detections
    ]
    return write_message(
        "frame",
        source=source,
        stamp_s=frame.stamp_s,
        sequence=frame.sequence,
        detections=seen,
        trouble=frame.trouble,
        tilt_rad=frame.tilt_rad,
        hindrance=frame.hindrance,
    )


def read_frame(document: Mapping[str, Any]) -> PerceptionFrame:
    """The frame of a message.

    Raises:
        ProtocolError: It is none.
    """
    try:
        seen = tuple(
            Detection(
                category=item["category"],
                kind=str(item["kind"]),
                color=item["color"],
                camera_T_object=_pose(item["camera_T_object"]),
                shape=_shape(item["shape"]),
                confidence=float(item["confidence"]),
                name=item["name"],
                names=tuple(map(str, item["names"])),
                categories=tuple(map(str, item["categories"])),
                traits=tuple(map(str, item["traits"])),
                error=_error(item.get("error")),
                alike=tuple(map(str, item["alike"])),
                picture=None if item["picture"] is None else base64.b64decode(item["picture"]),
                cut=bool(item["cut"]),
                moves=_moves(item["moves"]),
            )
            for item in document["detections"]
        )
        trouble, hindrance = document["trouble"], document["hindrance"]
        return PerceptionFrame(
            float(document["stamp_s"]),
            int(document["sequence"]),
            seen,
            None if trouble is None else str(trouble),
            float(document["tilt_rad"]),
            None if hindrance is None else str(hindrance),
        )
    except (KeyError, TypeError, ValueError) as wrong:
        raise ProtocolError(f"a frame that is none: {wrong!r}") from None


def _error_json(error: PositionError | None) -> list[Any] | None:
    if error is None:
        return None
    squares = (error.lasting_m2, error.noise_m2, error.shared_m2)
    lasting, noise, shared = (square.ravel().tolist() for square in squares)
    return [lasting, noise, error.size_share, shared]


def _error(values: Any) -> PositionError | None:
    if values is None:
        return None
    lasting, noise, size_share, shared = values
    return PositionError(_square(lasting), _square(noise), float(size_share), _square(shared))


def _square(numbers: Any) -> Array:
    return np.array(numbers, dtype=np.float64).reshape(3, 3)


def _moves_json(moves: KnownPart | None) -> dict[str, Any] | None:
    if moves is None:
        return None
    return {
        "shut": moves.shut.ravel().tolist(),
        "travel": moves.travel,
        "of": moves.of,
        "part": moves.part,
        "side": moves.side,
        "hinge_m": moves.hinge_m,
        "names": moves.names,
    }


def _moves(values: Any) -> KnownPart | None:
    if values is None:
        return None
    x, y = values["hinge_m"]
    return KnownPart(
        shut=_pose(values["shut"]),
        travel=float(values["travel"]),
        of=str(values["of"]),
        part=str(values["part"]),
        side=float(values["side"]),
        hinge_m=(float(x), float(y)),
        names=tuple(map(str, values["names"])),
    )


def _pose(numbers: Any) -> Transform:
    return np.array(numbers, dtype=np.float64).reshape(4, 4)


def _shape_json(shape: Shape) -> list[Any]:
    """A shape; of its parts, which never change, the file that both sides can read."""
    parts = [] if shape.parts is None or not shape.parts.file else [shape.parts.file]
    match shape:
        case Box(size_m=size):
            return ["box", *size, *parts]
        case Cylinder(radius_m=radius, height_m=height):
            return ["cylinder", radius, height, *parts]
        case Ball(radius_m=radius):
            return ["ball", radius, *parts]


def _shape(values: list[Any]) -> Shape:
    match values:
        case ["box", x, y, z, *file]:
            return _with_parts(Box((float(x), float(y), float(z))), file)
        case ["cylinder", radius, height, *file]:
            return _with_parts(Cylinder(float(radius), float(height)), file)
        case ["ball", radius, *file]:
            return _with_parts(Ball(float(radius)), file)
        case _:
            raise ValueError(f"no shape {values!r}")


def _with_parts(outline: Shape, file: list[Any]) -> Shape:
    """The outline with its parts, where they can be read: it holds them, and does for them where not."""
    if not file:
        return outline
    try:
        kept = read_model(Path(str(file[0])))
    except NoModelError:
        return outline
    return kept.scaled_to(outline)
