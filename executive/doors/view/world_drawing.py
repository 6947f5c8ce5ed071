"""What the robot believes to be around it, in the page: solids, errors as translucent ellipsoids, labels."""

from __future__ import annotations

import colorsys
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import viser

from executive.doors.view.robot_drawing import REFUSED

_SIGMAS = 3.0
"""An ellipsoid has so many standard deviations for radius: a thing is outside once in a hundred."""
_LEAST_SHOWN_M = 0.004
_COLORS: Mapping[str, tuple[int, int, int]] = {
    "red": (206, 52, 48),
    "green": (58, 148, 72),
    "blue": (52, 96, 200),
    "yellow": (230, 196, 48),
    "orange": (232, 132, 40),
    "white": (238, 238, 234),
    "black": (44, 44, 48),
    "grey": (140, 140, 144),
    "gray": (140, 140, 144),
    "brown": (132, 92, 60),
    "pink": (232, 130, 170),
    "purple": (128, 72, 168),
}
_FURNITURE, _PERSON = (170, 150, 128), (96, 152, 176)


@dataclass(frozen=True, slots=True)
class DrawnThing:
    """One believed thing as it is drawn.

    Attributes:
        name: Its name.
        shape: "box", "cylinder" or "ball".
        size_m: Of a box its edges; radius and height of a cylinder; the radius of a ball.
        place_m, wxyz: Where it is, in the odometry frame or in the frame that carries it.
        rgb: Its colour.
        opacity: 1 for what is sure, less for furniture, which hides things, and for what is unsure.
        error_m: Radii of the ellipsoid in which it is, along the axes of the odometry frame.
        label: For people; none for the second board of a table and the like.
        held: The frame that carries it, or nothing.
    """

    name: str
    shape: str
    size_m: tuple[float, ...]
    place_m: tuple[float, float, float]
    wxyz: tuple[float, float, float, float]
    rgb: tuple[int, int, int]
    opacity: float
    error_m: tuple[float, float, float]
    label: str
    held: str = ""


def drawn(thing: Mapping[str, Any], marked: Collection[str] = ()) -> DrawnThing:
    """How a thing is drawn.

    Where no look of this task tells an error, the margin that motions keep stands for it.

    Args:
        thing: As the executive tells it (``world`` of docs/reference/live-protocol.md).
        marked: Names that are shown in red.
    """
    x, y, z, w = map(float, thing["quaternion"])
    a, b, c = map(float, thing["place_m"])
    confidence = thing.get("confidence")
    sort = str(thing["is"])
    errors = thing.get("error_m")
    ex, ey, ez = (
        [_SIGMAS * float(one) for one in errors] if errors else [float(thing.get("margin_m", 0.0))] * 3
    )
    sure = 1.0 if confidence is None else 0.35 + 0.65 * float(confidence)
    name = str(thing["name"])
    return DrawnThing(
        name,
        str(thing["shape"]),
        tuple(map(float, thing["size_m"])),
        (a, b, c),
        (w, x, y, z),
        REFUSED if name in marked else _rgb(sort, thing.get("color"), str(thing.get("kind", ""))),
        round(sure * (0.55 if sort == "furniture" else 1.0), 2),
        (ex, ey, ez),
        _label(name, sort, confidence),
        str(thing.get("held", "")),
    )


def _label(name: str, sort: str, confidence: float | None) -> str:
    if sort == "furniture" and name[-1:].isdigit():
        return ""
    return name if confidence is None else f"{name} {100.0 * confidence:.0f} %"


def _rgb(sort: str, color: object, kind: str) -> tuple[int, int, int]:
    if sort == "person":
        return _PERSON
    known = _COLORS.get(str(color))
    if known is not None:
        return known
    if sort == "furniture":
        return _FURNITURE
    hue = sum(kind.encode()) * 0.61803 % 1.0  # the same for each thing of a kind
    r, g, b = colorsys.hls_to_rgb(hue, 0.55, 0.4)
    return round(255 * r), round(255 * g), round(255 * b)


class _Handle(Protocol):
    def remove(self) -> None: ...


class WorldDrawing:
    """Draws what is believed; things that have not changed are left alone.

    Args:
        scene: Of the page.
    """

    def __init__(self, scene: viser.SceneApi) -> None:
        self._scene = scene
        self._shown: dict[str, tuple[DrawnThing, str, list[_Handle]]] = {}

    def show(self, things: Sequence[DrawnThing], frames: Mapping[str, str]) -> None:
        """Draw these and no others.

        Args:
            things: What is believed.
            frames: The page's name of the frame that carries each thing that is held.
        """
        wanted = {one.name: (one, frames.get(one.held, "")) for one in things}
        for name in [
            name for name, (one, frame, _) in self._shown.items() if wanted.get(name) != (one, frame)
        ]:
            for handle in self._shown.pop(name)[2]:
                handle.remove()
        for name, (one, frame) in wanted.items():
            if name not in self._shown:
                self._shown[name] = (one, frame, self._draw(one, frame))

    def _draw(self, one: DrawnThing, frame: str) -> list[_Handle]:
        path = f"{frame}/believed/{one.name.replace('/', ' ')}"
        root = self._scene.add_frame(path, show_axes=False, position=one.place_m, wxyz=one.wxyz)
        self._solid(f"{path}/solid", one)
        if not one.label:
            return [root, *self._error(one, frame)]
        height = {"box": one.size_m[-1], "cylinder": one.size_m[-1], "ball": 2.0 * one.size_m[0]}[one.shape]
        self._scene.add_label(
            f"{path}/label", one.label, position=(0.0, 0.0, 0.5 * height + 0.03), anchor="bottom-center"
        )
        return [root, *self._error(one, frame)]

    def _error(self, one: DrawnThing, frame: str) -> list[_Handle]:
        """The ellipsoid of an error; none where it would not be seen, or the thing moves with a hand."""
        if max(one.error_m) < _LEAST_SHOWN_M or frame:
            return []
        error = self._scene.add_icosphere(
            f"/errors/{one.name.replace('/', ' ')}",
            1.0,
            one.rgb,
            subdivisions=2,
            scale=one.error_m,
            opacity=0.25,
            position=one.place_m,
            cast_shadow=False,
            receive_shadow=False,
        )
        return [error]

    def _solid(self, path: str, one: DrawnThing) -> None:
        opacity = None if one.opacity >= 1.0 else one.opacity
        if one.shape == "box":
            x, y, z = one.size_m
            self._scene.add_box(path, one.rgb, (x, y, z), opacity=opacity)
        elif one.shape == "cylinder":
            radius, height = one.size_m
            self._scene.add_cylinder(path, radius, height, one.rgb, opacity=opacity)
        else:
            self._scene.add_icosphere(path, one.size_m[0], one.rgb, opacity=opacity)
