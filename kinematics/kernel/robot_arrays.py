"""What the kernel needs of a robot alone, prepared once: tree, solids, pairs and limbs."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
import pinocchio as pin

from kinematics.arrays import Indices
from kinematics.distance.link_solids import link_solid
from kinematics.distance.solids import Solid, Solids, flatten
from kinematics.errors import ModelError, UnknownNameError
from kinematics.geometry.poses import Transform
from kinematics.kernel.buffers import Buffers
from kinematics.kernel.chains import Chains, chains_of, limbs_of
from kinematics.kernel.packing import CARRIED_ROWS, FIXED_ROWS, HULL_ROWS, Block, block
from kinematics.kernel.pairs import Carriers, OwnPair, OwnPairs, carriers_of, grouped, meeting
from kinematics.kernel.tuning import Tuning
from kinematics.model.robot_model import RobotModel
from kinematics.model.tree import Tree, tree_of, welded_at
from kinematics.standing.flat_coordinates import Coordinates, Limits, joint_limits, plain_coordinates

_BASE = 1
"""The body of the base joint in every model that ``RobotModel`` builds."""


class RobotAlone(NamedTuple):
    """All that the collision judge knows of a robot before there is a scene, in free coordinates.

    Attributes:
        chains: The joints between each body and the world, with balls about the solids.
        own: Pairs of its own solids, by group.
        carriers: The body that carries each solid.
        laid_out: All of them, ready for the compiled code.
        levels: Answers that ``levels_of`` gave so far.
        holding: The same robot with each load that it held lately.
    """

    chains: Chains
    own: OwnPairs
    carriers: Carriers
    laid_out: Block
    levels: dict[tuple[int, int], tuple[int, int]]
    holding: dict[Hashable, RobotAlone]

    def levels_of(self, first: int, second: int) -> tuple[int, int]:
        """How many joints two bodies are away from the body that carries both."""
        found = self.levels.get((first, second))
        if found is None:
            found = self.levels[first, second] = meeting(self.chains, first, second)
        return found


def carried(chains: Chains, own: OwnPairs, carriers: Carriers) -> Block:
    """What moves, ready for the compiled code."""
    return block([*chains, *own, *carriers], CARRIED_ROWS)


class _Fixed(NamedTuple):
    """What depends on a robot, its coordinates and its limits alone, with these."""

    space: Coordinates
    limits: Limits
    tuning: Tuning
    laid_out: Block


# Stances that a robot is on at a time; coordinates and limits of the last ones are kept laid out.
_KEPT = 8


class RobotArrays:
    """A robot's kinematic tree and collision geometry as arrays, made once for all scenes.

    Attributes:
        model: Pinocchio's model.
        tree: The kinematic tree.
        solids: One for each collision geometry.
        names: Links that they belong to.
        self_pairs: Pairs of solids that are judged, shape (n, 2).
        limb: Number of the limb that each body belongs to, shape (bodies,).

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
        self.limb: Indices = limbs_of(self.tree)
        self._rigid = self._rigid_distances()
        self._alone: dict[tuple[float, bytes], RobotAlone] = {}
        self._fixed: list[_Fixed] = []
        self._carriers = carriers_of(self.limb, body)

    @cached_property
    def flat(self) -> Solids:
        """Its solids as arrays."""
        return flatten(self.solids)

    @cached_property
    def hulls(self) -> Block:
        """The vertices of its solids, ready for the compiled code."""
        return block([self.flat.points], HULL_ROWS)

    @cached_property
    def buffers(self) -> Buffers:
        """Memory for problems of this robot."""
        return Buffers(self.hulls.floats)

    @cached_property
    def solids_of(self) -> dict[str, list[int]]:
        """Numbers of the solids of each link."""
        found: dict[str, list[int]] = {}
        for number, name in enumerate(self.names):
            found.setdefault(name, []).append(number)
        return found

    def alone(self, space: Coordinates, self_margin_m: float) -> RobotAlone:
        """Chains and pairs in free coordinates, made once for each margin and choice of planted legs."""
        key = self_margin_m, space.leg_bodies.tobytes()
        found = self._alone.get(key)
        if found is None:
            chains = chains_of(self.tree, space, self.solids)
            pairs = [
                OwnPair(int(i), int(j), self_margin_m)
                for i, j in self.self_pairs
                if not self._rigid.get((int(i), int(j)), 0.0) > self_margin_m
            ]
            own = grouped(pairs, [solid.body for solid in self.solids], chains)
            laid_out = carried(chains, own, self._carriers)
            found = self._alone[key] = RobotAlone(chains, own, self._carriers, laid_out, {}, {})
        return found

    def fixed(self, space: Coordinates, limits: Limits, tuning: Tuning) -> Block:
        """Tree, coordinates, limits and tuning ready for the compiled code; kept for the same ones."""
        for known in self._fixed:
            if known.space is space and known.limits is limits and known.tuning is tuning:
                return known.laid_out
        laid_out = block([*self.tree, *space, *limits, *tuning], FIXED_ROWS)
        self._fixed = [*self._fixed[1 - _KEPT :], _Fixed(space, limits, tuning, laid_out)]
        return laid_out

    @cached_property
    def every_joint(self) -> tuple[Coordinates, Limits]:
        """Each joint on its own, without limits."""
        space = plain_coordinates(self.tree)
        free = np.full(len(space.columns), np.inf)
        return space, joint_limits(-free, free, bool(space.floating))

    @cached_property
    def body_of(self) -> Indices:
        """Body of each solid."""
        return np.array([solid.body for solid in self.solids], np.int64)

    def _rigid_distances(self) -> dict[tuple[int, int], float]:
        """Lower bounds of the distances of judged pairs that never move against each other, m."""
        # imported here: it brings the compiler
        from kinematics.distance.separation import core_distance

        body = [solid.body for solid in self.solids]
        flat = self.flat
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
