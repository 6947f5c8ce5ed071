"""Plans and shortens with roboplan.

Settings: those of its own RRT benchmark (RRT-Connect, 100,000 nodes) and of its documented shortcutter,
both with its default bisection and, unless a finer one is said, its default step of 0.05; hulls instead of
meshes, by the URDF.
"""

from __future__ import annotations

import itertools
import time
from pathlib import Path
from typing import Any

import numpy as np
from line_protocol import Document, serve
from roboplan.core import (
    Box,
    Cylinder,
    JointConfiguration,
    PathShortcutter,
    PathShortcuttingOptions,
    Scene,
    Sphere,
    hasCollisionsAlongPath,
    loadUrdfSceneDescription,
)
from roboplan.rrt import RRT, RRTOptions

GROUP = "arm"
COLOR = np.array([0.5, 0.5, 0.5, 1.0])


class Peer:
    """One robot and, for each question, the solids around it."""

    def __init__(self) -> None:
        self.scene: Any = None
        self.names: list[str] = []

    def load(self, question: Document) -> Document:
        """Read the robot."""
        self.scene = Scene("benchmark", loadUrdfSceneDescription(question["urdf"], []))
        self.scene.importSrdf(Path(question["srdf"]).read_text("utf-8"))
        return {"joints": self.scene.getJointNames()}

    def plan(self, question: Document) -> Document:
        """RRT-Connect, then shortcuts."""
        began_s = time.process_time()
        self._replace(question["problem"]["objects"])
        set_up_s = time.process_time()
        options = RRTOptions(
            group_name=GROUP,
            max_nodes=100_000,
            rrt_connect=True,
            collision_check_step_size=question["step_rad"],
            max_planning_time=question["budget_s"],
        )
        planner = RRT(self.scene, options)
        planner.setRngSeed(question["seed"])
        start, goal = JointConfiguration(), JointConfiguration()
        start.positions = np.array(question["problem"]["start"])
        goal.positions = np.array(question["problem"]["goal"])
        try:
            path = planner.plan(start, goal)
        except RuntimeError:
            path = None
        planned_s = time.process_time()
        if path is not None:
            shortcuts = PathShortcuttingOptions(
                group_name=GROUP, max_step_size=question["step_rad"], seed=question["seed"]
            )
            path = PathShortcutter(self.scene, shortcuts).shortcut(path)
        ended_s = time.process_time()
        return {
            "path": None if path is None else [np.asarray(q).tolist() for q in path.positions],
            "set_up_s": set_up_s - began_s,
            "plan_s": planned_s - set_up_s,
            "shorten_s": ended_s - planned_s,
        }

    def edges(self, question: Document) -> Document:
        """Whether straight lines are free, all of one scene, by its own test of an edge."""
        self._replace(question["objects"])
        edges = [(np.array(a), np.array(b)) for a, b in question["edges"]]
        began_s = time.process_time()
        free = [not hasCollisionsAlongPath(self.scene, a, b, question["step_rad"], True) for a, b in edges]
        return {"free": free, "judge_s": time.process_time() - began_s}

    def _replace(self, objects: list[Document]) -> None:
        for name in self.names:
            self.scene.removeGeometry(name)
        self.names = [item["name"] for item in objects]
        for item in objects:
            pose, size = np.asfortranarray(_pose(item)), item["size"]
            if item["kind"] == "box":
                self.scene.addBoxGeometry(item["name"], "universe", Box(*size), pose, COLOR)
            elif item["kind"] == "cylinder":
                self.scene.addCylinderGeometry(item["name"], "universe", Cylinder(*size), pose, COLOR)
            else:
                self.scene.addSphereGeometry(item["name"], "universe", Sphere(*size), pose, COLOR)
        # solids that stand on one another are not the arm's business
        self.scene.setCollisions(list(itertools.combinations(self.names, 2)), False)


def _pose(item: Document) -> Any:
    x, y, z, w = item["quaternion"]
    pose = np.eye(4)
    pose[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    pose[:3, 3] = item["position"]
    return pose


if __name__ == "__main__":
    peer = Peer()
    serve({"load": peer.load, "plan": peer.plan, "edges": peer.edges})
