"""Robot, held objects and scene as solids of Pinocchio and Coal: the referee's, not the product's."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry.shapes import Box, Cylinder, Shape
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene, SceneObject


class SolidWorld:
    """Every pair of solids that is judged, in one Pinocchio geometry model.

    Args:
        model: The robot.
        scene: What it holds, what is around, and which pairs may touch.
        only: Judge pairs with these alone.

    Attributes:
        names: Of each judged pair.
        kinds: "self", "scene" or "held", of each pair.
        margins: Distance that each pair has to keep, shape (p,).
    """

    def __init__(self, model: RobotModel, scene: PlanningScene, only: frozenset[str] | None = None) -> None:
        self._model = model
        self.geometry = model.derived(_pristine_hulls).copy()
        links = [model.link_of(item) for item in self.geometry.geometryObjects]
        own = [(pair.first, pair.second) for pair in self.geometry.collisionPairs]
        self.geometry.removeAllCollisionPairs()
        owner, role = list(links), ["robot"] * len(links)
        touch: dict[int, frozenset[str]] = {}
        for body in scene.attached.values():
            frame = model.pin.frames[model.frame_id(body.frame)]
            place = frame.placement * pin.SE3(body.frame_T_object)
            for index in self._add(body.body, int(frame.parentJoint), place):
                owner.append(body.body.name)
                role.append("held")
                touch[index] = body.touch_links
        margin = {}
        for item in scene.objects.values():
            for index in self._add(item, 0, pin.SE3(item.world_T_object)):
                owner.append(item.name)
                role.append("scene")
                margin[index] = item.margin_m
        self.names: list[tuple[str, str]] = []
        self.kinds: list[str] = []
        margins: list[float] = []
        pairs = [] if only is not None else list(own)
        for i in range(len(links), len(owner)):
            for j in range(i):
                if role[i] == role[j] and (role[i] == "scene" or owner[i] == owner[j]):
                    continue
                if only is not None and owner[i] not in only:
                    continue
                if role[i] == "held" and owner[j] in touch[i]:
                    continue
                pairs.append((j, i))
        for j, i in pairs:
            if scene.is_allowed(owner[j], owner[i]):
                continue
            self.geometry.addCollisionPair(pin.CollisionPair(j, i))
            self.names.append((owner[j], owner[i]))
            roles = {role[i], role[j]}
            self.kinds.append("held" if "held" in roles else "scene" if "scene" in roles else "self")
            margins.append(margin.get(i, 0.0))
        self.margins = np.array(margins)
        self._data = model.pin.createData()
        self._placed = self.geometry.createData()

    def gaps(self, q: Array, pairs: NDArray[np.intp] | None = None) -> Array:
        """Signed distances beyond the margins of all pairs, or of some, at one configuration."""
        pin.updateGeometryPlacements(self._model.pin, self._data, self.geometry, self._placed, q)
        which = range(len(self.names)) if pairs is None else pairs.tolist()
        compute, geometry, placed = pin.computeDistance, self.geometry, self._placed
        found = np.array([compute(geometry, placed, k).min_distance for k in which])
        return np.asarray(found - (self.margins if pairs is None else self.margins[pairs]))

    def nearer_than(self, q: Array, gap_m: float) -> bool:
        """Tell whether any pair has this gap or less; asked are those alone whose enclosing balls have."""
        pin.updateGeometryPlacements(self._model.pin, self._data, self.geometry, self._placed, q)
        compute, geometry, placed = pin.computeDistance, self.geometry, self._placed
        least = self._balls.gaps_m(placed) - self.margins
        candidates = np.flatnonzero(least <= gap_m)
        for k in candidates[np.argsort(least[candidates])].tolist():
            if compute(geometry, placed, k).min_distance - self.margins[k] <= gap_m:
                return True
        return False

    @cached_property
    def _balls(self) -> EnclosingBalls:
        return EnclosingBalls(self.geometry)

    def solids_of(self, name: str) -> list[int]:
        """Which solids of the geometry an object of the scene, or a held one, is."""
        objects = self.geometry.geometryObjects
        return [k for k, item in enumerate(objects) if item.name.split("#", 1)[0] == name]

    def _add(self, item: SceneObject, joint: int, place: pin.SE3) -> list[int]:
        """Add the solids of one thing: its parts, where it is made of such."""
        added = []
        for k, solid in enumerate(_solids(item.shape)):
            solid.computeLocalAABB()
            named = pin.GeometryObject(f"{item.name}#{k}", joint, place, solid)
            added.append(int(self.geometry.addGeometryObject(named)))
        return added


def _solids(shape: Shape) -> Iterator[coal.CollisionGeometry]:
    """Coal's solids of a shape, made here and not by the product."""
    if shape.parts is not None:
        for hull in shape.parts.hulls:
            corners = coal.StdVec_Vec3s()
            for corner in hull:
                corners.append(corner)
            yield coal.ConvexBase.convexHull(corners, True, "Qt")
    elif isinstance(shape, Box):
        yield coal.Box(*shape.size_m)
    elif isinstance(shape, Cylinder):
        yield coal.Cylinder(shape.radius_m, shape.height_m)
    else:
        yield coal.Sphere(shape.radius_m)


def _pristine_hulls(model: RobotModel) -> pin.GeometryModel:
    """The robot's links as hulls of their meshes, made here and not by the product."""
    geometry = pin.buildGeomFromUrdfString(
        model.pin, model.description.planning_urdf, pin.GeometryType.COLLISION
    )
    for item in geometry.geometryObjects:
        if isinstance(item.geometry, coal.BVHModelBase):
            item.geometry.buildConvexHull(True, "Qt")
            item.geometry = item.geometry.convex
        item.geometry.computeLocalAABB()
    for pair in model.geometry().collisionPairs:
        geometry.addCollisionPair(pair)
    return geometry


class EnclosingBalls:
    """A ball about each solid, in its own frame.

    Args:
        geometry: Solids whose local boxes were computed, and the pairs that are asked about.

    Attributes:
        local_m: Their centres in the frames of their solids, shape (n, 3).
        enough_m: Distance of the centres of each pair at which the balls just touch, shape (p,).
    """

    def __init__(self, geometry: pin.GeometryModel) -> None:
        solids = [item.geometry for item in geometry.geometryObjects]
        self.local_m = np.array([solid.aabb_center for solid in solids])
        self._radii = np.array([solid.aabb_radius for solid in solids])
        pairs = np.array([(pair.first, pair.second) for pair in geometry.collisionPairs], np.intp)
        self._first, self._second = pairs.reshape(-1, 2).T
        self.enough_m = self._radii[self._first] + self._radii[self._second]

    def centres_m(self, placed: pin.GeometryData) -> Array:
        """Where they are, shape (n, 3)."""
        at = np.array([place.homogeneous for place in placed.oMg])
        return np.asarray(np.einsum("nij,nj->ni", at[:, :3, :3], self.local_m) + at[:, :3, 3])

    def gaps_m(self, placed: pin.GeometryData) -> Array:
        """Gap between the balls of each pair, negative where they overlap, shape (p,)."""
        centres = self.centres_m(placed)
        apart = np.linalg.norm(centres[self._first] - centres[self._second], axis=1)
        return np.asarray(apart - self.enough_m)
