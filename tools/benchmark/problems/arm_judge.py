"""The referee of the Panda problems: Coal on convex hulls, asked point by point.

It shares no code with the planners that it judges.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.distance.link_solids import coal_shape
from kinematics.geometry.poses import Transform
from kinematics.scene.planning_scene import SceneObject
from tools.benchmark.problems.panda_files import TCP_FRAME, RobotFiles

# Distance of two points at which the referee looks, in the largest joint's motion.
REFEREE_STEP_RAD = 1.0 / 256.0


class Arm:
    """The kinematic tree and the solids of the Panda."""

    def __init__(self, files: RobotFiles) -> None:
        self.model = pin.buildModelFromUrdf(str(files.urdf))
        self.geometry = pin.buildGeomFromUrdf(self.model, str(files.urdf), pin.GeometryType.COLLISION)
        self.geometry.addAllCollisionPairs()
        pin.removeCollisionPairs(self.model, self.geometry, str(files.srdf))
        self.lower = np.array(self.model.lowerPositionLimit)
        self.upper = np.array(self.model.upperPositionLimit)
        self._data = self.model.createData()
        self._tcp = self.model.getFrameId(TCP_FRAME)

    def tcp(self, q: Array) -> Transform:
        """Pose of the tool centre point, shape (4, 4)."""
        pin.framesForwardKinematics(self.model, self._data, q)
        return np.array(self._data.oMf[self._tcp].homogeneous)

    def reach(self, world_T_tcp: Transform, seed: Array, iterations: int = 60) -> Array | None:
        """Configuration with the TCP at a pose to 1e-5, by damped Gauss-Newton within the limits."""
        q, target = seed.copy(), pin.SE3(world_T_tcp[:3, :3], world_T_tcp[:3, 3])
        for _ in range(iterations):
            pin.framesForwardKinematics(self.model, self._data, q)
            error = pin.log6(self._data.oMf[self._tcp].actInv(target)).vector
            if float(np.linalg.norm(error)) < 1e-5:
                return q
            J = pin.computeFrameJacobian(self.model, self._data, q, self._tcp, pin.LOCAL)
            step = J.T @ np.linalg.solve(J @ J.T + 1e-6 * np.eye(6), error)
            q = np.clip(q + np.clip(step, -0.5, 0.5), self.lower + 0.02, self.upper - 0.02)
        return None


class ArmJudge:
    """Tells whether configurations and paths of the arm among solids are free.

    Args:
        arm: The arm.
        objects: The solids around.
        clearance_m: Distance that every part of the arm keeps from them.
    """

    def __init__(self, arm: Arm, objects: Sequence[SceneObject], clearance_m: float = 0.0) -> None:
        self._arm = arm
        self._geometry = arm.geometry.copy()
        own = self._geometry.ngeoms
        margins = [0.0] * len(self._geometry.collisionPairs)
        for item in objects:
            pose = pin.SE3(item.world_T_object[:3, :3], item.world_T_object[:3, 3])
            index = self._geometry.addGeometryObject(
                pin.GeometryObject(item.name, 0, pose, coal_shape(item.shape))
            )
            for link in range(own):
                self._geometry.addCollisionPair(pin.CollisionPair(link, index))
                margins.append(clearance_m)
        self._data = arm.model.createData()
        self._geometry_data = self._geometry.createData()
        for request, margin in zip(self._geometry_data.collisionRequests, margins, strict=True):
            request.security_margin = margin
        self._tree = None
        if clearance_m == 0.0:  # boxes around the solids know nothing of margins
            manager = pin.BroadPhaseManager_DynamicAABBTreeCollisionManager
            self._tree = manager(arm.model, self._geometry, self._geometry_data)

    def collides(self, q: Array) -> bool:
        """Tell whether any pair touches at one configuration, shape (7,)."""
        model, data = self._arm.model, self._data
        if self._tree is not None:
            return bool(pin.computeCollisions(model, data, self._tree, q, True))
        return bool(pin.computeCollisions(model, data, self._geometry, self._geometry_data, q, True))

    def within_limits(self, q: Array) -> bool:
        """Tell whether every joint is inside its range."""
        return bool(np.all(q >= self._arm.lower - 1e-9) and np.all(q <= self._arm.upper + 1e-9))

    def edge_is_free(self, a: Array, b: Array, step_rad: float = REFEREE_STEP_RAD) -> bool:
        """Judge a straight line at points no farther apart than ``step_rad`` in any joint."""
        count = max(2, int(np.ceil(float(np.max(np.abs(b - a))) / step_rad)) + 1)
        points = a + (b - a) * np.linspace(0.0, 1.0, count)[:, None]
        # a coarse pass first: most colliding lines are found out early
        stride = max(1, count // 16)
        order = [*range(0, count, stride), *(k for k in range(count) if k % stride)]
        return not any(self.collides(points[k]) for k in order)

    def path_is_free(self, path: Array, step_rad: float = REFEREE_STEP_RAD) -> bool:
        """Judge a polyline, shape (n, 7), its limits included."""
        return all(self.within_limits(q) for q in path) and all(
            self.edge_is_free(a, b, step_rad) for a, b in itertools.pairwise(path)
        )


def path_length(path: Array) -> float:
    """Length of a polyline, shape (n, 7), in joint space, rad."""
    return float(np.sum(np.linalg.norm(np.diff(path, axis=0), axis=1)))
