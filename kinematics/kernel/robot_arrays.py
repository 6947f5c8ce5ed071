"""What the kernel needs of a robot alone, prepared once: tree, solids, pairs and limbs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.errors import ModelError, UnknownNameError
from kinematics.kernel.coordinates import Coordinates
from kinematics.kernel.solids import Solid, flatten, link_solid
from kinematics.kernel.tree import WORLD, Tree, tree_of, welded_at
from kinematics.poses import Transform
from kinematics.robot_model import RobotModel

_BASE = 1
"""The body of the base joint in every model that ``RobotModel`` builds."""

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


class Chains(NamedTuple):
    """Which joints lie between a body and the world, and a ball about each body.

    A leg whose foot is planted hangs from the floor by its ankle, not from the base by its hip, as
    far as its thigh; the two small bodies in the hip hang from the base.

    Attributes:
        joint: Joints (by body) from a body outwards to the world, shape (n, depth).
        length: How many, shape (n,).
        limb: The limb that each body belongs to, shape (n,): a stretch of the tree without branches.
        limbs: How many limbs there are.
        centre, radius: Ball in the body's frame that holds its solids and its centre of mass, shapes
            (n, 3) and (n,), m.
    """

    joint: Indices
    length: Indices
    limb: Indices
    limbs: int
    centre: Array
    radius: Array


class RobotArrays:
    """A robot, flattened.

    Attributes:
        model: Pinocchio's model.
        tree: The kinematic tree.
        solids: One for each collision geometry.
        names: Links that they belong to.
        self_pairs: Pairs of solids that are judged, shape (n, 2).
        limb: The limb that each body belongs to, shape (bodies,).

    Raises:
        ModelError: A joint or a collision geometry is of a kind that the kernel does not know.
    """

    def __init__(
        self,
        model: pin.Model,
        geometry: pin.GeometryModel,
        names: Sequence[str],
        unjudged: Sequence[frozenset[int]] = (),
    ) -> None:
        """Flatten a model and its collision geometry.

        Args:
            model: The tree.
            geometry: Solids, and pairs that are judged.
            names: Link of each solid.
            unjudged: Sets of bodies that are not judged against each other.
        """
        self.model = model
        self.tree: Tree = tree_of(model)
        self.names = tuple(names)
        self.solids: list[Solid] = []
        for item in geometry.geometryObjects:
            try:
                pose = np.array(item.placement.homogeneous)
                self.solids.append(link_solid(int(item.parentJoint), pose, item.geometry))
            except ModelError as unknown:
                raise ModelError(f"{item.name!r}: {unknown}") from None
        body = [solid.body for solid in self.solids]
        pairs = [
            (int(pair.first), int(pair.second))
            for pair in geometry.collisionPairs
            if not any(body[pair.first] in apart and body[pair.second] in apart for apart in unjudged)
        ]
        self.self_pairs = np.array(pairs, np.int64).reshape(-1, 2)
        self.limb = _limbs(self.tree)
        self._rigid = self._rigid_distances()

    def always_apart(self, first: int, second: int, margin_m: float) -> bool:
        """Tell whether two solids are on one body and apart by more than a margin."""
        return self._rigid.get((first, second), 0.0) > margin_m

    def _rigid_distances(self) -> dict[tuple[int, int], float]:
        """Lower bounds of the distances of judged pairs that never move against each other, m."""
        # imported here: it brings the compiler
        from kinematics.kernel.separation import core_distance

        body = [solid.body for solid in self.solids]
        flat = flatten(self.solids)
        found: dict[tuple[int, int], float] = {}
        S, v = np.empty((4, 3)), np.empty(3)
        for i, j in self.self_pairs:
            if body[i] != body[j]:
                continue
            pose = np.linalg.inv(self.solids[i].pose) @ self.solids[j].pose
            R, p = np.ascontiguousarray(pose[:3, :3]), np.ascontiguousarray(pose[:3, 3])
            gap = core_distance(flat, i, j, 1, R, p, np.inf, -np.inf, np.zeros(3), S, v)
            found[int(i), int(j)] = float(gap - flat.round[i] - flat.round[j])
        return found

    def frame(self, name: str) -> tuple[int, Transform]:
        """The body that carries a frame, and the frame's pose in it.

        Raises:
            UnknownNameError: There is no such frame.
        """
        if not self.model.existFrame(name):
            raise UnknownNameError("frame", name, [frame.name for frame in self.model.frames])
        frame = self.model.frames[self.model.getFrameId(name)]
        return int(frame.parentJoint), np.array(frame.placement.homogeneous)

    def chains(self, space: Coordinates, solids: Sequence[Solid]) -> Chains:
        """Chains for free coordinates, and balls about all that the bodies carry."""
        n = len(self.tree.parent)
        chains: list[list[int]] = []
        for body in range(n):
            chain = []
            while body != WORLD:
                chain.append(body)
                body = int(self.tree.parent[body])
            chains.append(chain)
        for leg in space.leg_bodies:
            for k in range(2, 6):
                chains[leg[k]] = [int(joint) for joint in leg[k + 1 :]]
        joint = np.zeros((n, max(map(len, chains))), np.int64)
        for body, chain in enumerate(chains):
            joint[body, : len(chain)] = chain
        centre, radius = self.tree.lever.copy(), np.zeros(n)
        for solid in solids:
            if solid.body != WORLD:
                b = solid.body
                centre[b], radius[b] = _around(centre[b], radius[b], solid.centre, solid.radius_m)
        length = np.array([len(chain) for chain in chains], np.int64)
        return Chains(joint, length, self.limb, int(self.limb.max()) + 1, centre, radius)


def humanoid_arrays(model: RobotModel) -> RobotArrays:
    """A robot's arrays; pairs between legs are not judged, as in ``CollisionWorld``."""
    groups = model.description.groups
    legs = frozenset(
        int(model.pin.getJointId(joint))
        for group, joints in groups.items()
        if group.endswith("_leg")
        for joint in joints
    )
    geometry = model.geometry()
    names = [model.link_of(item) for item in geometry.geometryObjects]
    arrays = RobotArrays(model.pin, geometry, names, [legs])
    if model.description.welded:
        mount = model.mount
        arrays.tree = welded_at(arrays.tree, _BASE, mount[:3, :3], mount[:3, 3])
    return arrays


def _around(a: Array, ra: float, b: Array, rb: float) -> tuple[Array, float]:
    """The smallest ball about two balls."""
    apart = float(np.linalg.norm(b - a))
    if apart + rb <= ra:
        return a, ra
    if apart + ra <= rb:
        return b, rb
    radius = 0.5 * (apart + ra + rb)
    return a + (b - a) * ((radius - ra) / apart), radius * (1.0 + 1e-12)


def _limbs(tree: Tree) -> Indices:
    children = np.bincount(tree.parent[1:], minlength=len(tree.parent))
    limb = np.zeros(len(tree.parent), np.int64)
    count = 0
    for body in range(1, len(tree.parent)):
        parent = tree.parent[body]
        if parent == WORLD or children[parent] > 1:
            limb[body] = count
            count += 1
        else:
            limb[body] = limb[parent]
    return limb
