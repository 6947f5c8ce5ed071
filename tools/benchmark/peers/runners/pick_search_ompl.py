"""A long, independent search for a pick: is there any way at all? With OMPL and Coal, for TALOS.

Twelve coordinates: the pelvis's place, the torso and one arm; the legs follow in closed form. Grasps are
drawn at random over heading, tilt and roll, goals by Gauss-Newton from random postures, and RRT-Connect
looks for a way to each; approach and lift are straight. It takes the robot's model and the leg geometry
from the product, and nothing of its grasps, goals, inverse kinematics, collision world or planner.
"""

from __future__ import annotations

import pickle
import sys
import time
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import coal_scene
import numpy as np
import ompl.base as ob
import ompl.geometric as og
import ompl.util as ou
import pinocchio as pin
from line_protocol import Document, serve

APPROACH_M = 0.10
# Spacing of the points of a straight line of the hand, and of an edge of the search.
LINE_STEP_M = 0.01
EDGE_STEP = 0.04
# How far the pelvis may go from where it is, m.
PELVIS_BOX = np.array([[-0.15, -0.12, -0.35], [0.15, 0.12, 0.03]])
# Longest search for the way to one goal, s.
GOAL_BUDGET_S = 6.0


class World:
    """The robot among solids, with margins, some pairs of which may touch."""

    def __init__(self, body: Any, objects: Sequence[Document], free: set[tuple[str, str]]) -> None:
        model = body.model
        geometry = model.geometry()
        names = [model.link_of(item) for item in geometry.geometryObjects]
        links = len(names)
        margins = [0.0] * len(geometry.collisionPairs)
        margin_of = {item["name"]: item["margin_m"] for item in objects}
        # what is held comes last: it may touch neither the robot nor what stands
        for item in sorted(objects, key=lambda item: "held_by" in item):
            solid = coal_scene.with_objects(pin.GeometryModel(), [item]).geometryObjects[0]
            held = item.get("held_by")
            if held is not None:
                frame = model.pin.frames[model.frame_id(held)]
                solid.parentJoint = frame.parentJoint
                solid.placement = frame.placement * pin.SE3(np.array(item["tcp_T_object"]))
            index = geometry.addGeometryObject(solid)
            for i, name in enumerate(names if held is not None else names[:links]):
                together = geometry.geometryObjects[i].parentJoint == solid.parentJoint
                if not together and (name, item["name"]) not in free and (item["name"], name) not in free:
                    geometry.addCollisionPair(pin.CollisionPair(i, index))
                    # what stands keeps its own margin from the robot, and from what is held
                    margins.append(item["margin_m"] if held is None else margin_of.get(name, 0.0))
            names.append(item["name"])
        self._model = model.pin
        self._data, self._geometry_data = model.pin.createData(), geometry.createData()
        for request, margin in zip(self._geometry_data.collisionRequests, margins, strict=True):
            request.security_margin = margin
        # made after the margins: it makes its boxes larger by them
        self._geometry = geometry
        self._tree = pin.BroadPhaseManager_DynamicAABBTreeCollisionManager(
            model.pin, geometry, self._geometry_data
        )

    def collides(self, q: Any) -> bool:
        """Tell whether any pair that may not touch is nearer than its margin."""
        return bool(pin.computeCollisions(self._model, self._data, self._tree, q, True))


class Body:
    """The robot, on its stance."""

    def load(self, question: Document) -> Document:
        """Read the robot from the product's own values."""
        sys.path.insert(0, question["root"])
        from kinematics.model.robot_model import RobotModel
        from kinematics.model.stance import stance_at
        from kinematics.model.standing_robot import StandingRobot
        from kinematics.model.support_polygon import SupportPolygon
        from kinematics.standing.free_coordinates import FreeCoordinates
        from kinematics.standing.leg_ik import LegIk

        ou.setLogLevel(ou.LogLevel.LOG_ERROR)
        ou.RNG.setSeed(1 + int(question["seed"]))
        self.model = RobotModel(pickle.loads(Path(question["description"]).read_bytes()))
        self.q_home = self.model.q_home
        stance = stance_at(self.model, self.q_home)
        standing = StandingRobot(self.model, stance)
        self.space = FreeCoordinates(standing)
        self.legs = LegIk(standing)
        self.columns = 7 + self.model.indices(self.space.joints)
        self.polygon = SupportPolygon(stance, self.model.description.soles)
        self.rng = np.random.default_rng(question["seed"])
        self.data = self.model.pin.createData()
        return {"joints": list(self.model.joints)}

    def search(self, question: Document) -> Document:
        """Search until a pick is found or the budget is used up."""
        began_s = time.process_time()
        counts: Counter[str] = Counter()
        solved = False
        hands = [Arm(self, hand, question) for hand in question["hands"]]
        while not solved and time.process_time() - began_s < question["budget_s"]:
            arm = hands[int(self.rng.integers(len(hands)))]
            answer = arm.attempt()
            counts[answer] += 1
            solved = answer == "solved"
        return {"solved": solved, "search_s": time.process_time() - began_s, "attempts": dict(counts)}

    def valid(self, world: World, q: Any, reached: bool) -> bool:
        """Legs, limits, balance, collision."""
        joints, description = q[7:], self.model.description
        if not reached or np.any(joints < self.model.lower_rad) or np.any(joints > self.model.upper_rad):
            return False
        if self.polygon.com_margin_m(self.model.com(q)) < description.com_margin_m:
            return False
        return not world.collides(q)


class Arm:
    """One hand's side of one problem."""

    def __init__(self, body: Body, hand: Any, question: Document) -> None:
        self.body, self.question = body, question
        model = body.model
        groups = model.description.groups
        gripper = model.description.grippers[hand]
        joints = [*groups["torso"], *groups[f"{hand}_arm"]]
        self.columns = np.array([0, 1, 2, *(body.space.index(joint) for joint in joints)])
        self.velocities = 6 + model.indices(joints)
        self.frame, self.frame_id = gripper.tcp_frame, model.frame_id(gripper.tcp_frame)
        self.x_start = body.space.from_q(np.array(question["q_start"]))
        place = body.space.from_q(body.q_home)[:3]
        index = model.indices(joints)
        self.lower = np.concatenate([place + PELVIS_BOX[0], model.lower_rad[index]])
        self.upper = np.concatenate([place + PELVIS_BOX[1], model.upper_rad[index]])
        target = next(item for item in question["objects"] if item["name"] == question["target"])
        self.target = target
        touching = {(link, target["name"]) for link in gripper.touch_links}
        allowed = {(first, second) for first, second in question["allowed"]}
        self.touching = touching | allowed
        self.reach = World(body, question["objects"], allowed)
        self.grasp = World(body, question["objects"], self.touching)

    def attempt(self) -> str:
        """One random grasp and posture; "solved", or what failed."""
        world_T_tcp = self._random_grasp()
        x = self._solve(world_T_tcp, self._random_posture())
        if x is None:
            return "no inverse kinematics"
        if not self._free(self.grasp, x):
            return "not valid at the grasp"
        back = world_T_tcp.copy()
        back[:3, 3] -= APPROACH_M * world_T_tcp[:3, 0]
        pregrasp = self._along(world_T_tcp, back, x, self.grasp)
        if pregrasp is None:
            return "no straight approach"
        if not self._free(self.reach, pregrasp):
            return "not valid before the approach"
        lifted = world_T_tcp.copy()
        lifted[2, 3] += self.question["lift_m"]
        if self._along(world_T_tcp, lifted, x, self._held(world_T_tcp)) is None:
            return "no straight lift"
        return "solved" if self._way_to(pregrasp) else "no way found"

    def _random_grasp(self) -> Any:
        """The pads around the target, from any side that is not from below."""
        rng = self.body.rng
        # mostly from the robot's side, sometimes from anywhere
        ahead = np.arctan2(self.target["position"][1], self.target["position"][0])
        heading = ahead + rng.normal(0.0, 0.8) if rng.uniform() < 0.8 else rng.uniform(-np.pi, np.pi)
        tilt = rng.uniform(0.0, 0.5 * np.pi)
        c, s, ct, st = np.cos(heading), np.sin(heading), np.cos(tilt), np.sin(tilt)
        turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ np.array([[ct, 0, st], [0, 1, 0], [-st, 0, ct]])
        if rng.uniform() < 0.5:
            turn = turn @ np.diag([1.0, -1.0, -1.0])
        height = self.target["size"][-1] * (2.0 if self.target["kind"] == "ball" else 1.0)
        world_T_tcp = np.eye(4)
        world_T_tcp[:3, :3] = turn
        world_T_tcp[:3, 3] = self.target["position"]
        world_T_tcp[2, 3] += rng.uniform(-0.1, 0.5) * height
        return world_T_tcp

    def _random_posture(self) -> Any:
        """Anywhere between the start and a random posture."""
        anywhere = self.body.rng.uniform(self.lower, self.upper)
        start = np.clip(self.x_start[self.columns], self.lower, self.upper)
        return start + self.body.rng.uniform(0.0, 1.0) * (anywhere - start)

    def _solve(self, world_T_tcp: Any, start: Any, steps: int = 40) -> Any:
        """Damped Gauss-Newton in the twelve coordinates, clamped to their ranges."""
        model, data = self.body.model.pin, self.body.data
        goal = pin.SE3(world_T_tcp)
        x = start.copy()
        for _ in range(steps):
            q, _ = self._q(x)
            pin.computeJointJacobians(model, data, q)
            frame = pin.updateFramePlacement(model, data, self.frame_id)
            error = np.concatenate(
                [goal.translation - frame.translation, pin.log3(goal.rotation @ frame.rotation.T)]
            )
            if np.linalg.norm(error[:3]) < 2e-4 and np.linalg.norm(error[3:]) < 1e-3:
                return x
            turned = pin.getFrameJacobian(model, data, self.frame_id, pin.LOCAL_WORLD_ALIGNED)
            J = np.hstack([np.eye(6)[:, :3], turned[:, self.velocities]])
            step = J.T @ np.linalg.solve(J @ J.T + 1e-4 * np.eye(6), error)
            x = np.clip(x + np.clip(step, -0.4, 0.4), self.lower, self.upper)
        return None

    def _along(self, begin: Any, end: Any, x: Any, world: World) -> Any:
        """Follow a straight line of the hand; the last point, or None."""
        count = int(np.ceil(np.linalg.norm(end[:3, 3] - begin[:3, 3]) / LINE_STEP_M))
        for fraction in np.linspace(0.0, 1.0, count + 1)[1:]:
            pose = begin.copy()
            pose[:3, 3] += fraction * (end[:3, 3] - begin[:3, 3])
            x = self._solve(pose, x, steps=10)
            if x is None or not self._free(world, x):
                return None
        return x

    def _held(self, world_T_tcp: Any) -> World:
        """The world with the target in the hand; what it stands on may touch it."""
        target = np.eye(4)
        x, y, z, w = self.target["quaternion"]
        target[:3, :3] = pin.Quaternion(w, x, y, z).toRotationMatrix()
        target[:3, 3] = self.target["position"]
        carried = {
            **self.target,
            "held_by": self.frame,
            "tcp_T_object": (np.linalg.inv(world_T_tcp) @ target).tolist(),
        }
        others = [item for item in self.question["objects"] if item["name"] != self.target["name"]]
        free = self.touching | {(self.target["name"], name) for name in self.question["supports"]}
        return World(self.body, [*others, carried], free)

    def _way_to(self, goal: Any) -> bool:
        space = ob.RealVectorStateSpace(len(goal))
        bounds = ob.RealVectorBounds(len(goal))
        for i, (low, high) in enumerate(zip(self.lower, self.upper, strict=True)):
            bounds.setLow(i, float(low))
            bounds.setHigh(i, float(high))
        space.setBounds(bounds)
        setup = og.SimpleSetup(space)
        x = np.zeros(len(goal))

        def valid(state: Any) -> bool:
            for i in range(len(x)):
                x[i] = state[i]
            return self._free(self.reach, x)

        setup.setStateValidityChecker(valid)
        space.setLongestValidSegmentFraction(EDGE_STEP / space.getMaximumExtent())
        first, last = space.allocState(), space.allocState()
        start = np.clip(self.x_start[self.columns], self.lower, self.upper)
        for i in range(len(goal)):
            first[i], last[i] = float(start[i]), float(goal[i])
        setup.setStartAndGoalStates(first, last)
        setup.setPlanner(og.RRTConnect(setup.getSpaceInformation()))
        return bool(setup.solve(GOAL_BUDGET_S)) and bool(setup.haveExactSolutionPath())

    def _q(self, x: Any) -> tuple[Any, bool]:
        """The configuration; not by the product's compiled code, which this environment has not."""
        full = self.x_start.copy()
        full[self.columns] = x
        q = np.zeros((1, self.body.model.nq))
        q[0, :3] = full[:3]
        q[0, 3:7] = pin.Quaternion(pin.exp3(full[3:6])).coeffs()
        q[0, self.body.columns] = full[6:]
        reached = self.body.legs.fill(q)
        return q[0], bool(reached[0])

    def _free(self, world: World, x: Any) -> bool:
        return self.body.valid(world, *self._q(x))


if __name__ == "__main__":
    body = Body()
    serve({"load": body.load, "search": body.search})
