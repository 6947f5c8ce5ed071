"""The part of a pick by OMPL and Coal: room for the hand, what is valid, ways, and the last judgement.

Legs and head stay where they are: neither OMPL nor roboplan plans for closed chains. So trunk and arm are
left, nine joints, as a robot of their own by Pinocchio's reduced model: fewer pairs, and no legs to
solve. Coal is asked through Pinocchio's broad phase that tries all boxes: 2.3 times as fast for these
sixty solids as its tree, with the same answers. One scene serves reach, approach and lift, whose pairs
are switched. A straight way is looked at every 0.05 rad of a joint; where it is blocked,
RRT-Connect with its default range and ``simplifySolution``.
"""

from __future__ import annotations

import pickle
import sys
import time
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

import coal_scene
import numpy as np
import ompl.base as ob
import ompl.geometric as og
import ompl.util as ou
import pinocchio as pin
from line_protocol import Document, serve

STEP_RAD = 0.05
BroadPhase = pin.BroadPhaseManager_NaiveCollisionManager


class Body:
    """The robot, standing still but for its trunk and one arm."""

    def load(self, question: Document) -> Document:
        """Read the robot from the product's own values."""
        sys.path.insert(0, question["root"])
        from kinematics.robot_model import RobotModel
        from kinematics.stance import SupportPolygon, stance_at

        ou.setLogLevel(ou.LogLevel.LOG_ERROR)
        ou.RNG.setSeed(1)
        model = RobotModel(pickle.loads(Path(question["description"]).read_bytes()))
        polygon = SupportPolygon(stance_at(model, model.q_home), model.description.soles)
        self.arms = {hand: Arm(model, polygon, hand, question["joints"][hand]) for hand in question["joints"]}
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
    """Trunk and one arm of a robot that stands still otherwise."""

    def __init__(self, model: Any, polygon: Any, hand: Any, joints: Sequence[str]) -> None:
        corners = polygon.vertices_m
        edges = np.roll(corners, -1, axis=0) - corners
        self._inward = np.column_stack([-edges[:, 1], edges[:, 0]]) / np.linalg.norm(edges, axis=1)[:, None]
        gripper = model.description.grippers[hand]
        self._touching = set(gripper.touch_links)
        locked = [k for k in range(1, model.pin.njoints) if model.pin.names[k] not in joints]
        self._model, self._body = pin.buildReducedModel(model.pin, model.geometry(), locked, model.q_home)
        order = [joints.index(name) for name in list(self._model.names)[1:]]
        self._order, self._back = np.array(order), np.argsort(order)
        self._links = [model.link_of(item) for item in model.geometry().geometryObjects]
        self._data = self._model.createData()
        self._tcp = self._model.frames[self._model.getFrameId(gripper.tcp_frame)]
        index = model.indices(joints)
        margin = model.description.planning_margin_rad
        self._lower, self._upper = model.lower_rad[index] + margin, model.upper_rad[index] - margin
        # what is locked weighs too
        self._share = sum(self._model.inertias[k].mass for k in range(1, self._model.njoints)) / model.mass_kg
        home = model.q_home[7:][index][self._order]
        moving = self._share * np.array(pin.centerOfMass(self._model, self._data, home))
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
        """Tell whether points, shape (n, 9), are all valid in a phase."""
        self._switch(question)
        return all(self._valid(x) for x in np.array(question["points"])[:, self._order])

    def judged(self, question: Document) -> bool:
        """Tell whether a dense line of points is valid in a phase: the ends first, then ever finer."""
        self._switch(question)
        points = np.array(question["points"])[:, self._order]
        return all(self._valid(points[k]) for k in _coarse_first(len(points)))

    def straight(self, question: Document) -> bool:
        """Tell whether the straight way between two points is free."""
        self._switch(question)
        first, last = (np.array(question[name])[self._order] for name in ("start", "goal"))
        count = max(2, int(np.ceil(np.abs(last - first).max() / STEP_RAD)) + 1)
        line = first + (last - first) * np.linspace(0.0, 1.0, count)[:, None]
        return all(self._valid(line[k]) for k in _coarse_first(count))

    def detour(self, question: Document) -> Any:
        """A way around, shape (n, 9), or None: RRT-Connect, then OMPL's simplification."""
        self._switch(question)
        size = len(self._lower)
        space = ob.RealVectorStateSpace(size)
        bounds = ob.RealVectorBounds(size)
        lower, upper = self._lower[self._order], self._upper[self._order]
        for i in range(size):
            bounds.setLow(i, float(lower[i]))
            bounds.setHigh(i, float(upper[i]))
        space.setBounds(bounds)
        setup = og.SimpleSetup(space)
        x = np.zeros(size)

        def valid(state: Any) -> bool:
            for i in range(size):
                x[i] = state[i]
            return self._valid(x)

        setup.setStateValidityChecker(valid)
        space.setLongestValidSegmentFraction(STEP_RAD / space.getMaximumExtent())
        first, last = space.allocState(), space.allocState()
        start, goal = (np.array(question[name])[self._order] for name in ("start", "goal"))
        for i in range(size):
            first[i], last[i] = float(start[i]), float(goal[i])
        setup.setStartAndGoalStates(first, last)
        setup.setPlanner(og.RRTConnect(setup.getSpaceInformation()))
        if not setup.solve(question["budget_s"]) or not setup.haveExactSolutionPath():
            return None
        setup.simplifySolution()
        states = setup.getSolutionPath().getStates()
        return np.array([[state[i] for i in range(size)] for state in states])[:, self._back].tolist()

    def _valid(self, x: Any) -> bool:
        com = pin.centerOfMass(self._model, self._data, x)[:2]
        if (self._inward @ (self._share * com) < self._least).any():
            return False
        return not pin.computeCollisions(self._model, self._placing, self._broad, x, True)

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
    asked = {name: body.asked(name) for name in ("has_room", "free", "judged", "straight", "detour")}
    serve({"load": body.load, "scene": body.scene, **asked})
