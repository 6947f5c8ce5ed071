"""What a scene must be like to be a world: nothing impossible, nothing inside anything else."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from robots.errors import SceneError
from robots.scenes import fixed_camera, furniture, light
from robots.scenes.articulated import ARTICULATED_KINDS, DRAWER_FRONT_HEIGHT_M, WALL_M, opens_to
from robots.scenes.fixed_camera import FixedCamera
from robots.scenes.fixture import fixture_defect
from robots.scenes.furniture_names import FIXTURE, kind_that_name_contradicts
from robots.scenes.hollow import hollow_parts
from robots.scenes.moving_parts import moving_parts
from robots.scenes.named_region import region_defect
from robots.scenes.opening import openings_defect
from robots.scenes.person_solid import PERSON_HEIGHT_M, person_solid
from robots.scenes.placed_solid import TOUCH_TOLERANCE_M, PlacedSolid, fall_m, lowest_m, overlap, top_m
from robots.scenes.scene_description import (
    GESTURES,
    PERCEPTION_KINDS,
    Furniture,
    PerceptionModel,
    Person,
    Region,
    SceneDescription,
    SceneItem,
)
from robots.scenes.scene_words import COLORS, LONGEST_LABEL, nearest_word

LARGEST_BAR_RADIUS_M = 0.03
"""Thicker bars do not fit into a hand."""


def part_defect(piece: Furniture) -> tuple[str, str] | None:
    """The key and the reason of the first rule that the moving part breaks, or None."""
    part = piece.opens
    if piece.kind not in ARTICULATED_KINDS:
        return None if part is None else ("kind", f"a {piece.kind} does not open")
    if part is None:
        return "kind", f"a {piece.kind} needs the part that opens"
    door = piece.kind == "fridge"
    if (part.hinge is None) == door:
        return "hinge", "a door has a hinge, a drawer has none"
    _, width, height = piece.size_m
    least = {"fridge": (0.3, 0.3, 0.5), "drawers": (0.3, 0.25, DRAWER_FRONT_HEIGHT_M + 0.1)}[piece.kind]
    for axis, value, smallest in zip(("depth", "width", "height"), piece.size_m, least, strict=True):
        if value < smallest:
            return "size_m", f"{axis} must be at least {smallest:g} m, not {value:g}"
    middle = 0.5 * DRAWER_FRONT_HEIGHT_M
    high = (0.1 + part.handle_radius_m, height) if door else (-middle, middle)
    longest = height if door else width - 2.0 * WALL_M
    ranges = (
        ("mass_kg", part.mass_kg, 0.1, 100.0),
        ("friction_nm" if door else "friction_n", part.friction, 0.0, 100.0),
        ("seal_n", part.seal_n, 0.0, 500.0),
        ("open_rad" if door else "open_m", part.opening, 0.0, opens_to(piece)),
        ("handle_radius_m", part.handle_radius_m, 0.003, LARGEST_BAR_RADIUS_M),
        ("handle_length_m", part.handle_length_m, 0.05, longest),
        ("handle_height_m", part.handle_height_m, *high),
        ("handle_inset_m", part.handle_inset_m, 0.0, 0.5 * width),
        ("handle_friction", part.handle_friction, 0.01, 5.0),
    )
    for key, value, lowest, highest in ranges:
        if not (math.isfinite(value) and lowest <= value <= highest):
            return key, f"must be from {lowest:g} to {highest:g}, not {value:g}"
    if part.locked and part.opening > 0.0:
        return "locked", "what is open is not locked"
    return None


SMALLEST_SIZE_M = 0.001
SMALLEST_MASS_KG = 0.001
SMALLEST_WALL_M = 0.003
"""Below these a contact simulation at 1 ms has no meaning."""
GAP_TOLERANCE_M = 0.002
"""An object that would fall further than this hangs in the air."""
START_HALF_WIDTH_M = 0.30
START_REACH_M = (-0.15, 0.215)
"""Floor that a standing humanoid covers around the middle of its feet: behind, ahead to the knees."""
_SMALLEST_TABLE_M = (2.0 * furniture.TABLE_LEG_M, 2.0 * furniture.TABLE_LEG_M, 2.0 * furniture.TABLE_TOP_M)
_SMALLEST_M = {
    FIXTURE: (0.01, 0.01, 0.005),
    "counter": (0.2, 0.2, 0.3),
    "shelf": (0.1, 0.2, 0.2),
    "wall": (0.02, 0.05, 0.2),
}
_SMALLEST_PLACE_M = 1.0
"""A robot needs so much room to stand and turn."""
PERSON_RADIUS_M = 0.22
FASTEST_PERSON_M_S = 2.0


def validate(scene: SceneDescription, source: str) -> None:
    """Check that a scene can be a world.

    Args:
        scene: Any scene, read from a file or made by a program.
        source: Where it comes from, for the message (a file name).

    Raises:
        SceneError: With the key (``object[0].mass_kg``, counted from 0) and the reason of the first
            rule that it breaks.
    """
    _check_perception(scene.perception, source)
    if (dark := light.defect(scene.light)) is not None:
        raise SceneError(source, f"light.{dark[0]}", dark[1])
    for i, camera in enumerate(scene.cameras):
        if (wrong := fixed_camera.defect(camera)) is not None:
            raise SceneError(source, f"camera[{i}].{wrong[0]}", wrong[1])
    start = scene.robot_start
    for key, value in (("x_m", start.x_m), ("y_m", start.y_m), ("yaw_rad", start.yaw_rad)):
        _require(math.isfinite(value), source, f"robot_start.{key}", f"must be finite, not {value}")
    for i, piece in enumerate(scene.furniture):
        _check_furniture(piece, source, f"furniture[{i}]")
    for i, item in enumerate(scene.objects):
        _check_item(item, source, f"object[{i}]")
    for i, person in enumerate(scene.people):
        numbers = (*person.position_m, person.yaw_rad)
        _require(all(map(math.isfinite, numbers)), source, f"person[{i}].position_m", "must be finite")
        _check_person(person, source, f"person[{i}]")
    for i, region in enumerate(scene.places):
        _check_region(region, source, f"place[{i}]")
    _check_names(scene, source)
    _check_places(scene, source)


def _require(condition: bool, source: str, key: str, reason: str) -> None:
    if not condition:
        raise SceneError(source, key, reason)


def _check_person(person: Person, source: str, key: str) -> None:
    for one in person.clothes:
        color, _, garment = one.partition(" ")
        near = nearest_word(color, COLORS)
        reason = f"{one!r} must be a colour and a piece of clothing, {near + ' shirt'!r}"
        _require(bool(garment) and color in COLORS, source, f"{key}.clothes", reason)
    if person.gesture is not None and person.gesture not in GESTURES:
        near = nearest_word(person.gesture, GESTURES)
        reason = f"unknown gesture {person.gesture!r}; the nearest is {near!r}"
        raise SceneError(source, f"{key}.gesture", reason)
    ok = 0.0 < person.speed_m_s <= FASTEST_PERSON_M_S
    reason = f"must be above 0 and at most {FASTEST_PERSON_M_S:g} m/s, not {person.speed_m_s:g}"
    _require(ok, source, f"{key}.speed_m_s", reason)
    ok = not person.walks or (person.posture == "standing" and not person.takes)
    said = "way_m" if person.way_m else "follows"
    _require(ok, source, f"{key}.{said}", "who walks neither sits nor lies, and takes nothing")
    ok = not (person.way_m and person.follows)
    _require(ok, source, f"{key}.follows", "who goes a way_m does not walk behind the robot; say one of both")


def _check_perception(model: PerceptionModel, source: str) -> None:
    if model.kind not in PERCEPTION_KINDS:
        reason = f"unknown kind {model.kind!r}; the nearest is {nearest_word(model.kind, PERCEPTION_KINDS)!r}"
        raise SceneError(source, "perception.kind", reason)
    for key in (
        "bias_m", "noise_m", "orientation_noise_rad", "size_noise", "latency_s", "false_rate",
        "merge_distance_m", "rate_hz", "dropout", "merge_chance", "min_visible", "trait_dropout",
        "calibration_m",
    ):  # fmt: skip
        value = getattr(model, key)
        _require(
            math.isfinite(value) and value >= 0.0,
            source,
            f"perception.{key}",
            f"must be 0 or more, not {value}",
        )
    for key in ("dropout", "merge_chance", "min_visible", "trait_dropout"):
        value = getattr(model, key)
        _require(value <= 1.0, source, f"perception.{key}", f"must be at most 1, not {value}")
    _require(model.rate_hz > 0.0, source, "perception.rate_hz", "must be above 0")


def _check_furniture(piece: Furniture, source: str, key: str) -> None:
    if piece.kind not in furniture.FURNITURE_KINDS:
        near = nearest_word(piece.kind, furniture.FURNITURE_KINDS)
        raise SceneError(source, f"{key}.kind", f"unknown kind {piece.kind!r}; the nearest is {near!r}")
    told = kind_that_name_contradicts(piece.name, piece.kind)
    reason = f"{piece.name!r} is a name for the kind {told!r}, but the kind is {piece.kind!r}"
    _require(told is None, source, f"{key}.name", reason)
    _check_words(source, key, names=piece.names, categories=piece.categories)
    smallest = _SMALLEST_M.get(piece.kind, _SMALLEST_TABLE_M)
    for axis, value, least in zip(("depth", "width", "height"), piece.size_m, smallest, strict=True):
        ok = math.isfinite(value) and value >= least
        reason = f"{piece.name!r}: {axis} must be at least {least:g} m, not {value:g}"
        _require(ok, source, f"{key}.size_m", reason)
    finite = all(map(math.isfinite, (*piece.position_m, piece.yaw_rad)))
    _require(finite, source, f"{key}.position_m", f"{piece.name!r}: must be finite")
    _check_friction(piece.friction, piece.name, source, key)
    defect = part_defect(piece)
    if piece.kind == FIXTURE:
        defect = defect or fixture_defect(piece.size_m, piece.foot_m, piece.boxes, piece.controls)
        defect = defect or openings_defect(piece.openings, tuple(one.name for one in piece.controls))
    defect = defect or region_defect(piece.regions)
    if defect is not None:
        raise SceneError(source, f"{key}.{defect[0]}", f"{piece.name!r}: {defect[1]}")


def _check_friction(value: float, name: str, source: str, key: str) -> None:
    ok = math.isfinite(value) and value > 0.0
    _require(ok, source, f"{key}.friction", f"{name!r}: must be above 0, not {value:g}")


def _check_item(item: SceneItem, source: str, key: str) -> None:
    _check_words(source, key, kind=(item.kind,), names=item.names, categories=item.categories)
    if item.color is not None and item.color not in COLORS:
        near = nearest_word(item.color, COLORS)
        raise SceneError(source, f"{key}.color", f"unknown colour {item.color!r}; the nearest is {near!r}")
    for name, value in _sizes(item.shape):
        ok = math.isfinite(value) and value >= SMALLEST_SIZE_M
        reason = f"{item.name!r}: must be at least {SMALLEST_SIZE_M:g} m, not {value:g}"
        _require(ok, source, f"{key}.{name}", reason)
    if item.wall_m is not None:
        thinnest = min(value for _, value in _sizes(item.shape))
        ok = SMALLEST_WALL_M <= item.wall_m < 0.4 * thinnest
        reason = f"{item.name!r}: must be from {SMALLEST_WALL_M:g} m to 0.4 of its size, not {item.wall_m:g}"
        _require(ok, source, f"{key}.wall_m", reason)
    ok = math.isfinite(item.mass_kg) and item.mass_kg >= SMALLEST_MASS_KG
    reason = f"{item.name!r}: must be at least {SMALLEST_MASS_KG:g} kg, not {item.mass_kg:g}"
    _require(ok, source, f"{key}.mass_kg", reason)
    _check_friction(item.friction, item.name, source, key)
    finite = bool(np.all(np.isfinite(item.world_T_object)))
    _require(finite, source, f"{key}.position_m", f"{item.name!r}: must be finite")


def _check_words(source: str, key: str, **slots: tuple[str, ...]) -> None:
    for slot, words in slots.items():
        long = next((word for word in words if not 0 < len(word) <= LONGEST_LABEL), None)
        reason = f"must have from 1 to {LONGEST_LABEL} letters, not {len(long or '')}"
        _require(long is None, source, f"{key}.{slot}", reason)


def _sizes(shape: Shape) -> Iterator[tuple[str, float]]:
    match shape:
        case Box(size_m=size):
            for value in size:
                yield "size_m", value
        case Cylinder(radius_m=radius, height_m=height):
            yield "radius_m", radius
            yield "height_m", height
        case Ball(radius_m=radius):
            yield "radius_m", radius


def _check_region(region: Region, source: str, key: str) -> None:
    finite = all(map(math.isfinite, (*region.position_m, region.yaw_rad)))
    _require(finite, source, f"{key}.position_m", f"{region.name!r}: must be finite")
    for value in region.size_m:
        ok = math.isfinite(value) and value >= _SMALLEST_PLACE_M
        reason = f"{region.name!r}: must be at least {_SMALLEST_PLACE_M:g} m, not {value:g}"
        _require(ok, source, f"{key}.size_m", reason)


def _check_names(scene: SceneDescription, source: str) -> None:
    seen: dict[str, str] = {}
    groups: tuple[tuple[str, Sequence[Furniture | SceneItem | Person | Region | FixedCamera]], ...] = (
        ("furniture", scene.furniture),
        ("object", scene.objects),
        ("person", scene.people),
        ("place", scene.places),
        ("camera", scene.cameras),
    )
    for group, named in groups:
        for i, item in enumerate(named):
            key = f"{group}[{i}].name"
            _require(bool(item.name.strip()), source, key, "must not be empty")
            _require("/" not in item.name, source, key, f"{item.name!r} must not contain '/'")
            _require(item.name not in seen, source, key, f"{item.name!r} is also {seen.get(item.name)}")
            seen[item.name] = key


def _check_places(scene: SceneDescription, source: str) -> None:
    pieces = [
        (f"furniture[{i}]", _outline(piece))
        for i, piece in enumerate(scene.furniture)
        if piece.kind != FIXTURE
    ]
    people = [(f"person[{i}]", _mannequin(person)) for i, person in enumerate(scene.people)]
    items = [(f"object[{i}]", _whole(item)) for i, item in enumerate(scene.objects)]
    start = scene.robot_start
    world_T_start = poses.transform(poses.rotation_z(start.yaw_rad), (start.x_m, start.y_m, 0.0))
    back, ahead = START_REACH_M
    body = PlacedSolid(
        "the robot's start",
        Box((ahead - back, 2.0 * START_HALF_WIDTH_M, PERSON_HEIGHT_M)),
        world_T_start @ poses.translation(0.5 * (ahead + back), 0.0, 0.5 * PERSON_HEIGHT_M),
    )
    large = [*pieces, *people]
    for key, solid in large:
        _require(
            not overlap(body, solid), source, "robot_start",
            f"stands inside {solid.label} ({key}.position_m)",
        )  # fmt: skip
    for i, piece in enumerate(scene.furniture):
        for part in furniture.solids(piece) if piece.kind == FIXTURE else ():
            stands = overlap(body, PlacedSolid("", part.shape, part.world_T_solid))
            reason = f"stands inside furniture {piece.name!r} (furniture[{i}].position_m)"
            _require(not stands, source, "robot_start", reason)
    for i, (key, solid) in enumerate(large):
        for _, other in large[:i]:
            _require(not overlap(solid, other), source, f"{key}.position_m", f"overlaps {other.label}")
    parts = [
        PlacedSolid(f"furniture {piece.name!r}", part.shape, part.world_T_solid)
        for piece in scene.furniture
        for part in furniture.solids(piece)
    ]
    parts += [
        PlacedSolid(
            f"furniture {piece.name!r}",
            solid.shape,
            moving.world_T_solid(furniture.floor_pose(piece), solid),
        )
        for piece in scene.furniture
        for moving in moving_parts(piece)
        for solid in moving.solids
    ]
    fixed = [*parts, *(solid for _, solid in people), body]
    for i, (key, solid) in enumerate(items):
        key = f"{key}.position_m"
        low = lowest_m(solid)
        _require(low >= -TOUCH_TOLERANCE_M, source, key, f"{solid.label} is {-low:.4f} m deep in the floor")
        for other in fixed:
            _require(not overlap(solid, other), source, key, f"{solid.label} overlaps {other.label}")
        for former in scene.objects[:i]:
            reason = f"{solid.label} overlaps object {former.name!r}"
            _require(not _items_overlap(scene.objects[i], former), source, key, reason)
        others = [other for item in scene.objects if item is not scene.objects[i]
                  for other in _carriers(solid, item)]  # fmt: skip
        gap = fall_m(solid, [*parts, *others])
        _require(gap <= GAP_TOLERANCE_M, source, key, f"{solid.label} hangs {gap:.4f} m in the air")


def _outline(piece: Furniture) -> PlacedSolid:
    """The whole room that a piece of furniture takes, the space between its legs too."""
    lift = poses.translation(0.0, 0.0, 0.5 * piece.size_m[2])
    return PlacedSolid(f"furniture {piece.name!r}", Box(piece.size_m), furniture.floor_pose(piece) @ lift)


def _whole(item: SceneItem) -> PlacedSolid:
    """An object with the room inside it."""
    return PlacedSolid(f"object {item.name!r}", item.shape, item.world_T_object)


def _walls(item: SceneItem) -> list[PlacedSolid]:
    """What an object is made of: bottom and walls of a hollow one."""
    label = f"object {item.name!r}"
    parts = [
        PlacedSolid(label, shape, item.world_T_object @ pose) for _, shape, pose, _ in hollow_parts(item)
    ]
    return parts or [_whole(item)]


def _items_overlap(a: SceneItem, b: SceneItem) -> bool:
    """Tell whether two objects share room; what stands inside a hollow one, clear of its walls, does not."""
    if not overlap(_whole(a), _whole(b)):
        return False
    if a.wall_m is None and b.wall_m is None:
        return True
    return any(overlap(one, other) for one in _walls(a) for other in _walls(b))


def _carriers(solid: PlacedSolid, item: SceneItem) -> list[PlacedSolid]:
    """What of an object something may stand on; on the rim of a hollow one only if it cannot sink into it."""
    walls, whole = _walls(item), _whole(item)
    above_m = lowest_m(solid) - top_m(whole)
    if item.wall_m is None or abs(above_m) > GAP_TOLERANCE_M:
        return walls
    sunk = poses.translation(0.0, 0.0, -above_m - 2.0 * TOUCH_TOLERANCE_M) @ solid.world_T_solid
    rests = any(overlap(PlacedSolid(solid.label, solid.shape, sunk), wall) for wall in walls)
    return [*walls, whole] if rests else walls


def _mannequin(person: Person) -> PlacedSolid:
    shape, world_T_solid = person_solid(person, PERSON_RADIUS_M)
    return PlacedSolid(f"person {person.name!r}", shape, world_T_solid)
