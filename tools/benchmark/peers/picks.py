"""A pick by other libraries: the product's grasps as data, mink, OMPL over Coal and toppra for the rest.

The peers work in their own environments; what each stage took they report themselves, and passing things
on between them costs nothing. It ends with the first plan that holds, as the product's does.
"""

from __future__ import annotations

import contextlib
import math
import pickle
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.relaxed_start import relaxed_at
from kinematics.geometry import poses
from kinematics.ik.placo_ik import without_meshes
from kinematics.ik.result import IkTolerance
from kinematics.model.robot_description import HANDS, Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.planning.grasps import ABOVE_MIDDLE, OTHER_HEIGHTS, GraspCandidate, grasp_table
from kinematics.planning.pick_planner import MOST_BLOCKED
from kinematics.planning.pick_task import APPROACH_M
from kinematics.planning.planning_task import CARTESIAN_PACE, CARTESIAN_POINTS, REACH_PACE
from kinematics.requests.pick import PickRequest
from kinematics.scene.support_of import under_foot_of
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.timing.curve_timing import Pace
from tools.benchmark.peers.environments import PeerEnvironment
from tools.benchmark.peers.peer_process import PeerProcess, peer_process
from tools.benchmark.problems.problem import object_to_json

Document = dict[str, Any]

# Environment and runner of each part.
PARTS = {"mink": "pick_ik_mink", "ompl": "pick_plan_ompl", "toppra": "pick_time_toppra"}
# Of a pelvis's velocity, m/s and rad/s, and acceleration: more than the legs allow, so that it costs nothing.
PELVIS_LIMIT = 10.0
# Longest search for a detour, s.
DETOUR_S = 1.0
# The last judgement looks so often, as the referee of the arm does; or every so many seconds, as the
# referee of the checker does where solids are near.
JUDGED_RAD = 1.0 / 256.0
JUDGED_S = 0.0005
BY_WAY, BY_TIME = "judgement", "judgement by time"
STAGES = ("room", "ik", "valid", "path", "timing", BY_WAY, BY_TIME)
_ROOT = Path(__file__).parents[3]
_BASE_LINK = "base_link"


@dataclass(frozen=True, slots=True)
class PeerPick:
    """What the peers made of one pick.

    Attributes:
        solved: A plan was found, timed and judged.
        seconds: Processor time by the names in ``STAGES``; the plan's motions alone are judged by time.
    """

    solved: bool
    seconds: Mapping[str, float]

    @property
    def by_way_s(self) -> float:
        """All stages together, judged by way."""
        return sum(self.seconds.values()) - self.seconds.get(BY_TIME, 0.0)

    @property
    def by_time_s(self) -> float:
        """All stages together, judged by time."""
        return sum(self.seconds.values()) - self.seconds.get(BY_WAY, 0.0)


@dataclass(frozen=True, slots=True)
class _Way:
    """A grasp with the points of its approach and its lift, shape (n, size) each."""

    candidate: GraspCandidate
    approach: Array
    lift: Array


@dataclass(frozen=True, slots=True)
class _Posture:
    """Points that the inverse kinematics reached in turn, shape (n, size), and its own state at the last."""

    points: Array
    state: list[float]


@contextlib.contextmanager
def peer_picker(model: RobotModel, cache: Path, whole_body: bool) -> Iterator[PeerPicker]:
    """The peers at work for as long as the context lasts; their environments are ready."""
    with contextlib.ExitStack() as stack:
        processes = {
            name: stack.enter_context(peer_process(PeerEnvironment(name, cache), runner))
            for name, runner in PARTS.items()
        }
        yield PeerPicker(model, processes, cache / "talos", whole_body)


class PeerPicker:
    """Plans picks with the peers.

    Args:
        model: The robot, standing at its home.
        processes: By the names in ``PARTS``.
        folder: Where the robot's data are written for the other side.
        whole_body: Pelvis and legs move too, over feet that stand; else trunk and arm alone.
    """

    def __init__(
        self, model: RobotModel, processes: Mapping[str, PeerProcess], folder: Path, whole_body: bool
    ) -> None:
        self._model, self._processes, self._whole_body = model, processes, whole_body
        groups, self._stance = model.description.groups, stance_at(model, model.q_home)
        self._joints = {hand: [*groups["torso"], *groups[f"{hand}_arm"]] for hand in HANDS}
        folder.mkdir(parents=True, exist_ok=True)
        description = folder / f"{model.description.name}.pickle"
        description.write_bytes(pickle.dumps(model.description))
        urdf = folder / f"{model.description.name}_bodies.urdf"
        urdf.write_text(without_meshes(model.description.planning_urdf), "utf-8")
        processes["ompl"].ask(
            "load",
            root=str(_ROOT),
            description=str(description),
            joints=self._joints,
            whole_body=whole_body,
        )
        margin, tolerance = model.description.planning_margin_rad, IkTolerance()
        limits = zip(model.joints, model.lower_rad + margin, model.upper_rad - margin, strict=True)
        processes["mink"].ask(
            "load",
            urdf=str(urdf),
            base=_BASE_LINK,
            base_position=model.q_home[:3].tolist(),
            base_wxyz=model.q_home[[6, 3, 4, 5]].tolist(),
            home=dict(zip(model.joints, model.q_home[7:].tolist(), strict=True)),
            limits={name: [lower, upper] for name, lower, upper in limits},
            joints=self._joints,
            whole_body=whole_body,
            legs=[joint for name in groups if name.endswith("_leg") for joint in groups[name]],
            soles=[[frame, pose.tolist()] for frame, pose in self._stance.soles],
            com=model.com(model.q_home).tolist(),
            tcp={hand: model.description.tcp_frames[hand] for hand in HANDS},
            position_m=tolerance.position_m,
            orientation_rad=tolerance.orientation_rad,
        )

    def pick(self, request: PickRequest) -> PeerPick:
        """Plan, time and judge a pick, the natural grasps first."""
        self._seconds: Counter[str] = Counter()
        scene = relaxed_at(self._model, request.scene, request.q_start)
        target = scene.objects[request.target]
        self._processes["ompl"].ask(
            "scene",
            objects=[{**object_to_json(item), "margin_m": item.margin_m} for item in scene.objects.values()],
            target=request.target,
            supports=under_foot_of(target, scene),
        )
        for heights in ((ABOVE_MIDDLE,), (ABOVE_MIDDLE, *OTHER_HEIGHTS)):
            if self._best(request, natural_grasps(self._model, request, heights)):
                return PeerPick(True, dict(self._seconds))
        return PeerPick(False, dict(self._seconds))

    def _best(self, request: PickRequest, candidates: list[GraspCandidate]) -> bool:
        """The first grasp that a straight reach comes to; detours when so many have none, or at the end."""
        blocked: list[_Way] = []
        for candidate in candidates:
            way = self._way(request, candidate)
            if way is None:
                continue
            if self._straight(request, way):
                if self._completed(way, self._ends(request, way)):
                    return True
                continue
            blocked.append(way)
            if len(blocked) == MOST_BLOCKED:
                break
        return any(self._detoured(request, way) for way in blocked)

    def _way(self, request: PickRequest, candidate: GraspCandidate) -> _Way | None:
        grasp = candidate.grasp
        advance_m = self._model.description.grippers[grasp.hand].closing_advance_m
        along_m = [advance_m, *np.linspace(0.0, -APPROACH_M, CARTESIAN_POINTS).tolist()]
        places = [grasp.world_T_tcp @ poses.translation(far_m, 0.0, 0.0) for far_m in along_m]
        if not self._ask("room", "ompl", "has_room", grasp.hand, poses=[place.tolist() for place in places]):
            return None
        at_grasp = self._follow(grasp.hand, [grasp.world_T_tcp])
        if at_grasp is None or not self._free(candidate, "grasp", at_grasp.points):
            return None
        back = poses.line(grasp.world_T_tcp, places[-1], CARTESIAN_POINTS)[1:]
        behind = self._follow(grasp.hand, back, at_grasp)
        if behind is None or not self._free(candidate, "reach", behind.points[-1:]):
            return None
        if not self._free(candidate, "grasp", behind.points):
            return None
        lifted = poses.translation(0.0, 0.0, request.lift_m) @ grasp.world_T_tcp
        up = self._follow(grasp.hand, poses.line(grasp.world_T_tcp, lifted, CARTESIAN_POINTS)[1:], at_grasp)
        if up is None or not self._free(candidate, "lift", up.points):
            return None
        return _Way(
            candidate,
            np.concatenate([behind.points[::-1], at_grasp.points]),
            np.concatenate([at_grasp.points, up.points]),
        )

    def _straight(self, request: PickRequest, way: _Way) -> bool:
        start, goal = self._ends(request, way).tolist()
        hand = way.candidate.grasp.hand
        return bool(self._ask("path", "ompl", "straight", hand, phase="reach", start=start, goal=goal))

    def _detoured(self, request: PickRequest, way: _Way) -> bool:
        start, goal = self._ends(request, way).tolist()
        hand = way.candidate.grasp.hand
        path = self._ask(
            "path", "ompl", "detour", hand, phase="reach", start=start, goal=goal, budget_s=DETOUR_S
        )
        return path is not None and self._completed(way, np.array(path))

    def _completed(self, way: _Way, reach: Array) -> bool:
        """Give all three motions their time, then judge what they pass through."""
        parts = (
            ("reach", reach, REACH_PACE),
            ("grasp", way.approach, CARTESIAN_PACE),
            ("lift", way.lift, CARTESIAN_PACE),
        )
        timed = [self._timed(way.candidate, points, pace) for _, points, pace in parts]
        phases = [self._phase(way.candidate, phase) for phase, _, _ in parts]
        hand = way.candidate.grasp.hand
        for motion, phase in zip(timed, phases, strict=True):
            if motion is None:
                return False
            if not self._ask(BY_WAY, "ompl", "free", hand, points=motion["by_way"], **phase):
                return False
        for motion, phase in zip(timed, phases, strict=True):
            assert motion is not None
            self._ask(BY_TIME, "ompl", "free", hand, points=motion["by_time"], **phase)
        return True

    def _timed(self, candidate: GraspCandidate, points: Array, pace: Pace) -> Document | None:
        index = self._model.indices(self._joints[candidate.grasp.hand])
        pelvis = np.full(6 if self._whole_body else 0, PELVIS_LIMIT)
        velocity = np.concatenate([pelvis, self._model.velocity[index]])
        acceleration = np.concatenate([pelvis, self._model.acceleration[index]])
        answer = self._processes["toppra"].ask(
            "time",
            points=points.tolist(),
            velocity=(pace.velocity * velocity).tolist(),
            acceleration=(pace.acceleration * acceleration).tolist(),
            step_rad=JUDGED_RAD,
            step_s=JUDGED_S,
        )
        self._seconds["timing"] += answer["seconds"]
        found: Document | None = answer["answer"]
        return found

    def _ends(self, request: PickRequest, way: _Way) -> Array:
        index = self._model.indices(self._joints[way.candidate.grasp.hand])
        joints = request.q_start[7:][index]
        if not self._whole_body:
            return np.array([joints, way.approach[0]])
        pelvis = free_coordinates(StandingRobot(self._model, self._stance)).from_q(request.q_start)[:6]
        return np.array([np.concatenate([pelvis, joints]), way.approach[0]])

    def _free(self, candidate: GraspCandidate, phase: str, points: Array) -> bool:
        place = self._phase(candidate, phase)
        return bool(self._ask("valid", "ompl", "free", candidate.grasp.hand, points=points.tolist(), **place))

    @staticmethod
    def _phase(candidate: GraspCandidate, phase: str) -> Document:
        return {"phase": phase, "world_T_tcp": candidate.grasp.world_T_tcp.tolist()}

    def _follow(self, hand: Hand, targets: Iterable[Array], after: _Posture | None = None) -> _Posture | None:
        places = [pose.tolist() for pose in targets]
        state = None if after is None else after.state
        found = self._ask("ik", "mink", "follow", hand, targets=places, state=state)
        if len(found["points"]) < len(places):
            return None
        return _Posture(np.array(found["points"]), found["states"][-1])

    def _ask(self, stage: str, name: str, question: str, hand: Hand, **values: Any) -> Any:
        answer = self._processes[name].ask(question, hand=hand, **values)
        self._seconds[stage] += answer["seconds"]
        return answer["answer"]


def natural_grasps(model: RobotModel, request: PickRequest, heights: Sequence[float]) -> list[GraspCandidate]:
    """Grasps of all hands that may be used and are in reach, in the product's order."""
    found: list[GraspCandidate] = []
    target = request.scene.objects[request.target]
    for hand in request.hands:
        joint = model.pin.getJointId(model.description.groups[f"{hand}_arm"][1])
        shoulder = next(frame.name for frame in model.pin.frames if frame.parentJoint == joint)
        offset = (target.world_T_object - model.frame_pose(request.q_start, shoulder))[:3, 3]
        if np.linalg.norm(offset[:2]) > model.description.reach_m:
            continue
        heading = float(np.arctan2(offset[1], offset[0]))
        cost = 2.0 * math.hypot(offset[0], offset[1])
        gripper = model.description.grippers[hand]
        table = grasp_table(target, gripper, heading, APPROACH_M, heights, cost)
        found += [table.candidate(row) for row in range(len(table))]
    return sorted(found, key=lambda item: item.cost)
