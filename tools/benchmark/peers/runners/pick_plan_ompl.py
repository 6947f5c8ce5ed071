"""The part of a pick by OMPL and Coal: room for the hand, what is valid, ways, and the last judgement.

Joints that stay are taken out by Pinocchio's reduced model: fewer pairs. Coal is asked through Pinocchio's
broad phase that tries all boxes: 2.3 times as fast for these sixty solids as its tree, with the same
answers. One scene serves reach, approach and lift, whose pairs are switched. A straight way is looked at
every 0.05 rad of a joint; where it is blocked, RRT-Connect with its default range and ``simplifySolution``.
"""

from __future__ import annotations

import pickle
import sys
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import coal_scene
import numpy as np
import ompl.base as ob
import ompl.geometric as og
import ompl.util as ou
import pinocchio as pin
from line_protocol import Document, serve
from pick_coordinates import TrunkAndArm, WholeBody

STEP_RAD = 0.05
BroadPhase = pin.BroadPhaseManager_NaiveCollisionManager


class Body:
    """The robot with both its arms."""

    def load(self, question: Document) -> Document:
        """Read the robot from the product's own values."""
        sys.path.insert(0, question["root"])
        from kinematics.model.robot_model import RobotModel
        from kinematics.model.stance import stance_at
        from kinematics.model.support_polygon import SupportPolygon

        ou.setLogLevel(ou.LogLevel.LOG_ERROR)
        ou.RNG.setSeed(1)
        model = RobotModel(pickle.loads(Path(question["description"]).read_bytes()))
        stance = stance_at(model, model.q_home)
        polygon = SupportPolygon(stance, model.description.soles)
        self.arms = {
            hand: Arm(
                model,
                polygon,
                hand,
                WholeBody(model, joints, stance) if question["whole_body"] else TrunkAndArm(model, joints),
            )
            for hand, joints in question["joints"].items()
        }
        return {}

    def scene(self, question: Document) -> Document:
        """Take a scene in; each arm's pairs are made when it is first asked about."""
        for arm in self.arms.values():
            arm.forget(question)
        return {"seconds": 0.0}

    def asked(self, what: str) -> Callable[[Document], Document]:
        """What an arm answers, with the processor time that it took."""

        def answer(question: Document) -> Document:
            began_s = time.process_time()
            found = getattr(self.arms[question["hand"]], what)(question)
            return {"answer": found, "seconds": time.process_time() - began_s}

        return answer


class Arm:
    """One hand's side."""

    def __init__(self, model: Any, polygon: Any, hand: Any, space: TrunkAndArm | WholeBody) -> None:
        self._space, self._model, self._body = space, space.model, space.solids
        corners = polygon.vertices_m
        edges = np.roll(corners, -1, axis=0) - corners
        self._inward = np.column_stack([-edges[:, 1], edges[:, 0]]) / np.linalg.norm(edges, axis=1)[:, None]
        gripper = model.description.grippers[hand]
        self._touching = set(gripper.touch_links)
        self._links = [model.link_of(item) for item in model.geometry().geometryObjects]
        self._data = self._model.createData()
        self._tcp = self._model.frames[self._model.getFrameId(gripper.tcp_frame)]
        # what is locked weighs too
        self._share = sum(self._model.inertias[k].mass for k in range(1, self._model.njoints)) / model.mass_kg
        moving = self._share * np.array(pin.centerOfMass(self._model, self._data, space.home))
        still = np.array(model.com(model.q_home)) - moving
        self._least = np.sum(self._inward * (corners - still[:2]), axis=1) + model.description.com_margin_m
        self._hand, self._hand_solids = pin.Model(), pin.GeometryModel()
        self._hand.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "hand")
        for item in self._body.geometryObjects:
            if item.parentJoint == self._tcp.parentJoint:
                place = self._tcp.placement.inverse() * item.placement
                self._hand_solids.addGeometryObject(pin.GeometryObject(item.name, 1, place, item.geometry))
        self._hand_data = self._hand.createData()

    def forget(self, problem: Document) -> None:
        """Another scene comes."""
        self._problem, self._hand_phase, self._broad = problem, None, None

    def has_room(self, question: Document) -> bool:
        """Tell whether the open hand alone fits at all of some poses."""
        if self._hand_phase is None:
            self._take_in_hand()
        return not any(
            pin.computeCollisions(
                self._hand, self._hand_data, self._hand_phase, pin.SE3ToXYZQUAT(_se3(pose)), True
            )
            for pose in question["poses"]
        )

    def free(self, question: Document) -> bool:
        """Tell whether all of some points, shape (n, size), are valid in a phase: some of all parts first."""
        self._switch(question)
        return self._all_valid(np.array(question["points"]))

    def straight(self, question: Document) -> bool:
        """Tell whether the straight way between two points is free."""
        self._switch(question)
        first, last = (np.array(question[name]) for name in ("start", "goal"))
        count = max(2, int(np.ceil(np.abs(last - first).max() / STEP_RAD)) + 1)
        return self._all_valid(first + (last - first) * np.linspace(0.0, 1.0, count)[:, None])

    def detour(self, question: Document) -> Any:
        """A way around, shape (n, size), or None: RRT-Connect, then OMPL's simplification."""
        self._switch(question)
        lower, upper = self._space.lower, self._space.upper
        size = len(lower)
        space = ob.RealVectorStateSpace(size)
        bounds = ob.RealVectorBounds(size)
        for i in range(size):
            bounds.setLow(i, float(lower[i]))
            bounds.setHigh(i, float(upper[i]))
        space.setBounds(bounds)
        setup = og.SimpleSetup(space)
        x = np.zeros(size)

        def valid(state: Any) -> bool:
            for i in range(size):
                x[i] = state[i]
            return self._all_valid(x[None])

        setup.setStateValidityChecker(valid)
        space.setLongestValidSegmentFraction(STEP_RAD / space.getMaximumExtent())
        first, last = space.allocState(), space.allocState()
        for i in range(size):
            first[i], last[i] = question["start"][i], question["goal"][i]
        setup.setStartAndGoalStates(first, last)
        setup.setPlanner(og.RRTConnect(setup.getSpaceInformation()))
        if not setup.solve(question["budget_s"]) or not setup.haveExactSolutionPath():
            return None
        setup.simplifySolution()
        return [[float(state[i]) for i in range(size)] for state in setup.getSolutionPath().getStates()]

    def _all_valid(self, points: Any) -> bool:
        rows, reached = self._space.rows(points)
        return bool(reached.all()) and all(self._valid(rows[k]) for k in _coarse_first(len(rows)))

    def _valid(self, q: Any) -> bool:
        com = pin.centerOfMass(self._model, self._data, q)[:2]
        if (self._inward @ (self._share * com) < self._least).any():
            return False
        return not pin.computeCollisions(self._model, self._placing, self._broad, q, True)

    def _take_in_hand(self) -> None:
        """The hand alone among everything but the target."""
        others = [item for item in self._problem["objects"] if item["name"] != self._problem["target"]]
        solids = coal_scene.with_objects(self._hand_solids, others)
        placed = solids.createData()
        own = self._hand_solids.ngeoms
        margins = np.zeros((solids.ngeoms, solids.ngeoms))
        margins[:own, own:] = [item["margin_m"] for item in others]
        placed.setSecurityMargins(solids, margins)
        # kept, because the broad phase does not
        self._hand_kept = solids, placed
        self._hand_phase = BroadPhase(self._hand, solids, placed)

    def _take_in(self) -> None:
        """Everything, and the target once more in the hand; which pairs count is switched."""
        problem, links = self._problem, self._links
        objects, target = problem["objects"], problem["target"]
        held = {**next(item for item in objects if item["name"] == target), "name": "held"}
        solids = self._body.copy()
        for item in [*objects, held]:
            solids.addGeometryObject(coal_scene.with_objects(pin.GeometryModel(), [item]).geometryObjects[0])
        own, count = len(links), solids.ngeoms
        names = [item["name"] for item in objects]
        joint = np.array([item.parentJoint for item in solids.geometryObjects])
        joint[-1] = self._tcp.parentJoint
        solids.geometryObjects[count - 1].parentJoint = self._tcp.parentJoint
        reach = np.zeros((count, count), bool)
        for pair in self._body.collisionPairs:
            reach[pair.first, pair.second] = True
        reach[:own, own:-1] = True
        reach &= joint[:, None] != joint[None, :]
        touching = np.array([link in self._touching for link in links])
        grasp, at = reach.copy(), own + names.index(target)
        grasp[:own, at] &= ~touching
        lift = grasp.copy()
        lift[:, at] = lift[at, :] = False
        lift[:own, -1] = ~touching & (joint[:own] != joint[-1])
        lift[own:-1, -1] = [name != target and name not in problem["supports"] for name in names]
        margins = np.zeros((count, count))
        margins[:own, own:-1] = margins[own:-1, -1] = 0.0
        margins[:own, own:-1] += [item["margin_m"] for item in objects]
        margins[own:-1, -1] = [item["margin_m"] for item in objects]
        solids.removeAllCollisionPairs()
        solids.setCollisionPairs(reach | grasp | lift)
        placed = solids.createData()
        placed.setSecurityMargins(solids, margins)
        self._phases = {"reach": reach, "grasp": grasp, "lift": lift}
        self._phase = ""
        self._solids, self._placed, self._placing = solids, placed, self._model.createData()
        self._broad = BroadPhase(self._model, solids, placed)

    def _switch(self, question: Document) -> None:
        """Judge the pairs of a phase from now on; a lift says where the TCP has hold of the target."""
        if self._broad is None:
            self._take_in()
        if question["phase"] == "lift":
            hold = self._tcp.placement * _se3(question["world_T_tcp"]).inverse()
            at = next(
                item for item in self._solids.geometryObjects if item.name == self._problem["target"]
            ).placement
            self._solids.geometryObjects[self._solids.ngeoms - 1].placement = hold * at
        if question["phase"] != self._phase:
            self._phase = question["phase"]
            self._placed.setActiveCollisionPairs(self._solids, self._phases[self._phase])


def _coarse_first(count: int) -> Iterable[int]:
    """Every sixteenth first: most of what collides is found out early."""
    stride = max(1, count // 16)
    return [*range(0, count, stride), *(k for k in range(count) if k % stride)]


def _se3(pose: Any) -> Any:
    matrix = np.array(pose)
    return pin.SE3(matrix[:3, :3], matrix[:3, 3])


if __name__ == "__main__":
    body = Body()
    asked = {name: body.asked(name) for name in ("has_room", "free", "straight", "detour")}
    serve({"load": body.load, "scene": body.scene, **asked})
