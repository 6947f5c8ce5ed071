"""A start that is nearer to something than it should be, because that something moved.

No plan can begin where the robot already breaks a margin. What is nearer than its margin at the start
keeps most of the distance that it has there; a movable object that is believed to touch a link, or what a
hand holds, may be touched by that. Everything else is judged as before.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import coal
import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.distance.link_solids import coal_solids
from kinematics.geometry.shapes import Box, Shape
from kinematics.model.derived import Recent
from kinematics.model.robot_model import RobotModel
from kinematics.scene.concessions import Concession, ConcessionReason, touching
from kinematics.scene.planning_scene import PlanningScene, SceneObject

# Kept between the distance at the start and the margin that is asked instead, for rounding.
SLACK_M = 0.001
# Of the distance at the start that has to be kept: hardly any motion leads straight away from a thing.
KEPT_SHARE = 0.6
# A start that keeps its margin by less than this is stuck as well: a way is judged in pieces, and the first
# of them counts as too near whichever way it leads.
ROOM_M = 0.002
# Parts this far beyond the margin of what the start is too near to may come as near to it as that start.
AROUND_M = 0.05
# Links whose poses differ by less than this stay where they are.
_AT_REST = 1e-9


def relaxed_at(model: RobotModel, scene: PlanningScene, q: Array, reserve_m: float = 0.0) -> PlanningScene:
    """Lower the margins that a configuration breaks, or just keeps.

    Args:
        model: The robot.
        scene: What is around.
        q: Where the robot is, shape (nq,).
        reserve_m: What the caller adds to every margin.

    Returns:
        The same scene when nothing is too near; else one in which ``q`` is free, unless a link is in
        furniture or in another link.
    """
    items, held = list(scene.objects.values()), _held_at(model, scene, q)
    nearby = model.derived(_Parts).nearby(_Start(q, items))
    links, relaxed = nearby.parts.links, scene
    near = nearby.within([item.margin_m + reserve_m + ROOM_M for item in items])
    for row, item in enumerate(items):
        distances = {
            links[k]: nearby.distance_m(row, k)
            for k in near.get(row, ())
            if not scene.is_allowed(links[k], item.name)
        }
        if item.movable:  # that a look took for a second one, where the hand has it
            distances |= {
                name: _nearest(solids, at, item)
                for name, (solids, at) in held.items()
                if not scene.is_allowed(name, item.name)
            }
        nearest = min(distances.values(), default=np.inf)
        if nearest >= item.margin_m + reserve_m + ROOM_M:
            continue
        if nearest >= item.margin_m:  # the reserve alone is broken: it changes nothing about what is kept
            relaxed = relaxed.with_object(replace(item, margin_m=max(0.0, nearest - ROOM_M - reserve_m)))
            continue
        margin = max(0.0, KEPT_SHARE * nearest - reserve_m - SLACK_M)
        relaxed = relaxed.with_object(replace(item, margin_m=margin))
        if item.movable:
            touching = [
                name
                for name, distance in distances.items()
                if distance < SLACK_M + (0.0 if name in held else reserve_m)
            ]
            relaxed = relaxed.allowing((name, item.name) for name in touching)
    return relaxed


def start_concessions(
    model: RobotModel, scene: PlanningScene, relaxed: PlanningScene, q: Array, step: str
) -> tuple[Concession, ...]:
    """What ``relaxed_at`` has changed, to be asked of the judge, who judges in the scene as it was.

    Args:
        model: The robot.
        scene: What is around.
        relaxed: The scene that ``relaxed_at`` made of it.
        q: Where the robot is, shape (nq,).
        step: Name of the step that starts there.
    """
    if relaxed is scene:
        return ()
    found = [
        Concession(pair, ConcessionReason.STARTS_IN_CONTACT, step)
        for pair in sorted(relaxed.allowed - scene.allowed, key=sorted)
    ]
    items = list(scene.objects.values())
    lowered = {
        row: relaxed.objects[item.name].margin_m
        for row, item in enumerate(items)
        if relaxed.objects[item.name].margin_m < item.margin_m
    }
    nearby = model.derived(_Parts).nearby(_Start(q, items))
    near = nearby.within([item.margin_m + AROUND_M for item in items]) if lowered else {}
    held = _held_at(model, scene, q)
    for row, margin_m in lowered.items():
        item, links = items[row], nearby.parts.links
        reach_m = item.margin_m + AROUND_M
        names = {links[k] for k in near.get(row, ()) if nearby.distance_m(row, k) < reach_m}
        names |= {name for name, (solids, at) in held.items() if _nearest(solids, at, item) < reach_m}
        for name in sorted(names):
            pair = frozenset((name, item.name))
            if pair not in relaxed.allowed:
                found.append(Concession(pair, ConcessionReason.STARTS_NEAR, step, margin_m))
    return tuple(found)


def rest_concessions(scene: PlanningScene, resting: PlanningScene, step: str) -> tuple[Concession, ...]:
    """What ``touching_at_rest`` has added, to be asked of the judge."""
    added = sorted(sorted(pair) for pair in resting.allowed - scene.allowed)
    return tuple(one for a, b in added for one in touching([a], [b], ConcessionReason.AT_REST, step))


def touching_at_rest(model: RobotModel, scene: PlanningScene, q_start: Array, q_goal: Array) -> PlanningScene:
    """Let links that stay where they are be as near to things as they are.

    A hand that is believed to be inside a door is believed so wrongly, or holds it; either way the head
    may turn to look again.

    Args:
        model: The robot.
        scene: What is around.
        q_start, q_goal: Ends of a straight line between configurations, shape (nq,).

    Returns:
        The same scene when no link that rests is too near to anything.
    """
    parts = model.derived(_Parts)
    there = [pin.SE3(at) for at in parts.at(q_goal).oMg]
    resting = {k for k, at in enumerate(parts.at(q_start).oMg) if at.isApprox(there[k], _AT_REST)}
    items = list(scene.objects.values())
    nearby = parts.nearby(_Start(q_start, items))
    pairs = [
        (parts.links[k], items[row].name)
        for row, near in nearby.within([item.margin_m + ROOM_M for item in items]).items()
        for k in resting.intersection(near)
        if nearby.distance_m(row, k) < items[row].margin_m + ROOM_M
    ]
    return scene.allowing(pairs) if pairs else scene


class _Parts:
    """A robot's collision geometries with a ball about each, in its own frame.

    With Pinocchio's memory for where they are: to make it takes longer than all that is done with it.

    Attributes:
        links: Of each geometry.
        shapes: For Coal.
    """

    def __init__(self, model: RobotModel) -> None:
        self._model, self._geometry = model.pin, model.geometry()
        self._data, self._placed = model.pin.createData(), self._geometry.createData()
        self._q = b""
        items = list(self._geometry.geometryObjects)
        self.links = tuple(model.link_of(item) for item in items)
        self.shapes = tuple(item.geometry for item in items)
        self._centres_m = tuple(np.array(item.geometry.aabb_center) for item in items)
        self._radii_m = np.array([item.geometry.aabb_radius for item in items])
        # a plan asks about one start with several margins
        self._lately: Recent[_Start, _Nearby] = Recent(2)

    def nearby(self, start: _Start) -> _Nearby:
        """How far they are from what is around a start."""
        return self._lately.of(start, lambda: _Nearby(self, start))

    def at(self, q: Array) -> pin.GeometryData:
        """Where they are at a configuration, until the next one is asked about."""
        if q.tobytes() != self._q:
            pin.updateGeometryPlacements(self._model, self._data, self._geometry, self._placed, q)
            self._q = q.tobytes()
        return self._placed

    def gaps_m(self, q: Array, items: Sequence[SceneObject]) -> Array:
        """At least how far each is from each object, shape (objects, parts): from ball to box."""
        places = zip(self.at(q).oMg, self._centres_m, strict=True)
        centres_m = np.array([at.act(centre) for at, centre in places])
        poses = np.array([item.world_T_object for item in items]).reshape(-1, 4, 4)
        half = np.array([_half_extents_m(item.shape) for item in items]).reshape(-1, 1, 3)
        local = (centres_m - poses[:, None, :3, 3]) @ poses[:, :3, :3]
        outside = np.maximum(np.abs(local) - half, 0.0)
        return np.asarray(np.sqrt(np.sum(outside**2, axis=2)) - self._radii_m)


class _Start:
    """A configuration among objects, known by identity: other margins change neither poses nor shapes."""

    def __init__(self, q: Array, items: Sequence[SceneObject]) -> None:
        self.q, self.items = q, items
        self._key = (q.tobytes(), *((id(item.world_T_object), id(item.shape)) for item in items))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Start) and self._key == other._key

    def __hash__(self) -> int:
        return hash(self._key)


class _Nearby:
    """How far the robot is from what is around; exactly where that is asked."""

    def __init__(self, parts: _Parts, start: _Start) -> None:
        self.parts, self._start = parts, start
        self._gaps_m = parts.gaps_m(start.q, start.items)
        self._exact_m: dict[tuple[int, int], float] = {}

    def within(self, reaches_m: Sequence[float]) -> dict[int, list[int]]:
        """Parts that may be nearer to an object than its reach, by the object's row, if there are any."""
        near = self._gaps_m < np.array(reaches_m)[:, None]
        return {int(row): np.flatnonzero(near[row]).tolist() for row in np.flatnonzero(near.any(axis=1))}

    def distance_m(self, row: int, part: int) -> float:
        """Between an object and a part."""
        if (row, part) not in self._exact_m:
            at = self.parts.at(self._start.q).oMg[part]
            self._exact_m[row, part] = _nearest([self.parts.shapes[part]], at, self._start.items[row])
        return self._exact_m[row, part]


def _held_at(
    model: RobotModel, scene: PlanningScene, q: Array
) -> dict[str, tuple[tuple[coal.CollisionGeometry, ...], pin.SE3]]:
    """What hands hold by its name, and where it is at a configuration."""
    return {
        name: (coal_solids(held.body.shape), pin.SE3(model.frame_pose(q, held.frame) @ held.frame_T_object))
        for name, held in scene.attached.items()
    }


def _half_extents_m(shape: Shape) -> tuple[float, float, float]:
    if isinstance(shape, Box):
        x, y, z = shape.size_m
        return 0.5 * x, 0.5 * y, 0.5 * z
    return shape.radius_m, shape.radius_m, 0.5 * shape.height_m


def _nearest(solids: Sequence[coal.CollisionGeometry], at: pin.SE3, item: SceneObject) -> float:
    """Distance of some solids of one body to an object."""
    pose = item.world_T_object
    here, there = coal.Transform3s(at.rotation, at.translation), coal.Transform3s(pose[:3, :3], pose[:3, 3])
    request = coal.DistanceRequest()
    return min(
        float(coal.distance(solid, here, part, there, request, coal.DistanceResult()))
        for solid in solids
        for part in coal_solids(item.shape)
    )
