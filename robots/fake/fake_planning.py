"""A planner that always finds something, or fails in the way that it is told to."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any, Generic, TypeVar

import numpy as np

from kinematics.arrays import Array
from kinematics.ik.gaze import gaze_joints
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.planning.gesture_planner import GesturePlanner
from kinematics.requests.check import CheckRequest
from kinematics.requests.control import ControlPlan, ControlRequest, TurnPlan, TurnRequest
from kinematics.requests.gesture import (
    CarryRequest,
    GestureRequest,
    OfferRequest,
    PointRequest,
    RaiseHandRequest,
    SwingRequest,
)
from kinematics.requests.grasp import Grasp
from kinematics.requests.handle import HandlePlan, HandleRequest
from kinematics.requests.move import MovePlan, MoveRequest, RetreatRequest
from kinematics.requests.pick import PickPlan, PickRequest
from kinematics.requests.place import PlacePlan, PlaceRequest
from kinematics.requests.request import Request
from kinematics.requests.step import NoPlan, PlannedStep
from kinematics.requests.view import ViewRequest
from kinematics.scene.concessions import Concession, ConcessionReason, touching
from kinematics.scene.planning_scene import AttachedBody, PlanningScene
from kinematics.scene.support_of import under_foot_of
from robots.clock import Clock
from robots.fake.fake_gesture import FakeGesture
from robots.fake.scripted_world import diameter_m

Answer = TypeVar("Answer")

_APPROACH_M = 0.10
_BAR_M = 0.02
_LABELS = ("side", "top", "diagonal", "far side")
# Position-only inverse kinematics by damped least squares; converges in a dozen steps.
_STEPS = 40
_DAMPING = 1e-4


class FakeJob(Generic[Answer]):
    """A planning job of the fake robot; satisfies ``trees.toolbox.Job``, and is done after a while."""

    def __init__(self, answer: Callable[[], Answer], clock: Clock, ready_s: float) -> None:
        """Promise an answer for a time."""
        self.canceled = False
        self._answer, self._clock, self._ready_s = answer, clock, ready_s

    @property
    def done(self) -> bool:
        """Whether its time has come."""
        return not self.canceled and self._clock.now_s() >= self._ready_s - 1e-9

    def result(self) -> Answer:
        """The answer, or whatever making it raised."""
        return self._answer()

    def cancel(self) -> None:
        """Forget it."""
        self.canceled = True


class FakePlanning:
    """Plans for the fake robot; satisfies ``trees.toolbox.Planning``, and ignores obstacles and limits.

    Attributes:
        delay_s: Time that a job takes.
        motion_s: Duration of every motion, and of each stretch of one to and fro.
        raises: Raised by every job while it is set.
        hangs: While true, jobs never end.
        no_plan: Answered to every planning request while it is set.
        unsafe: Asked with each check; what it returns is answered instead of a checked trajectory.
        requests: Everything that was asked.
        jobs: The jobs of those requests.
        gestures: The planner of gestures, which searches their postures as the true one does.
        reached: What ``reach`` has answered to what; fakes of one model may share it.
    """

    def __init__(
        self, model: RobotModel, clock: Clock, check: Callable[[CheckRequest], CheckedTrajectory | Unsafe]
    ) -> None:
        """A planner for one robot.

        Args:
            model: The robot.
            clock: Time.
            check: The checker: the true one, or a test's, for only a checker can make its answer.
        """
        self.delay_s = 0.02
        self.motion_s = 0.08
        self.raises: Exception | None = None
        self.hangs = False
        self.no_plan: NoPlan | None = None
        self.unsafe: Callable[[CheckRequest], Unsafe | None] = lambda _request: None
        self.requests: list[Request[object] | CheckRequest] = []
        self.jobs: list[FakeJob[Any]] = []
        self.gestures = GesturePlanner(model, FakeGesture)
        self.reached: dict[tuple[bytes, Hand, bytes], Array] = {}
        self._model, self._clock, self._check = model, clock, check

        self._answers: Mapping[type[Request[Any]], Callable[[Any], Any]] = {
            PickRequest: self._pick,
            PlaceRequest: self._place,
            HandleRequest: self._handle,
            ControlRequest: self._control,
            TurnRequest: self._turn,
            OfferRequest: self._offer,
            **dict.fromkeys((RaiseHandRequest, SwingRequest, PointRequest, CarryRequest), self._gesture),
            RetreatRequest: self._retreat,
            MoveRequest: self._move,
            ViewRequest: self._view,
        }

    def submit(self, request: Request[Answer]) -> FakeJob[Answer]:
        """Begin to answer."""
        self.requests.append(request)
        return self._begun(lambda: self.answer(request))

    def check(self, question: CheckRequest) -> FakeJob[CheckedTrajectory | Unsafe]:
        """Begin to judge."""
        self.requests.append(question)
        return self._begun(lambda: self.verdict(question))

    def _begun(self, answer: Callable[[], Answer]) -> FakeJob[Answer]:
        ready_s = float("inf") if self.hangs else self._clock.now_s() + self.delay_s
        job = FakeJob(answer, self._clock, ready_s)
        self.jobs.append(job)
        return job

    def verdict(self, question: CheckRequest) -> CheckedTrajectory | Unsafe:
        """Judge at once.

        Raises:
            Exception: The one that ``raises`` holds.
        """
        if self.raises is not None:
            raise self.raises
        return self.unsafe(question) or self._check(question)

    def answer(self, request: Request[Answer]) -> Answer:
        """Answer at once.

        Raises:
            Exception: The one that ``raises`` holds.
        """
        if self.raises is not None:
            raise self.raises
        refused = self.no_plan is not None
        plan: Callable[[Any], Any] = self._refuse if refused else self._answers[type(request)]
        answer: Answer = plan(request)
        return answer

    def _refuse(self, _request: object) -> NoPlan | None:
        return self.no_plan

    def _gesture(self, request: GestureRequest) -> MovePlan | NoPlan:
        return self._timed(self.gestures.plan(replace(request, scene=_bare(request.scene))))

    def _retreat(self, request: RetreatRequest) -> MovePlan:
        frame = self._model.description.grippers[request.hand].tcp_frame
        place = self._model.frame_pose(request.q_start, frame)[:3, 3] + request.world_offset_m
        return self._moved(request, self.reach(request.q_start, request.hand, place))

    def _move(self, request: MoveRequest) -> MovePlan:
        return self._moved(request, self._posture(request))

    def _view(self, request: ViewRequest) -> MovePlan:
        place = request.points_m[int(np.argmax(request.worth))]
        return self._moved(request, self._looking_at(request.q_start, place))

    def _moved(self, request: Request[object], goal: Array) -> MovePlan:
        return MovePlan(self._step("move", request.q_start, goal, request.stance, request.scene))

    def _pick(self, request: PickRequest) -> PickPlan | NoPlan:
        target = request.scene.objects[request.target]
        place = target.world_T_object[:3, 3]
        nearer: Hand = "left" if place[1] > 0.0 else "right"
        hands = sorted(request.hands, key=lambda hand: hand != nearer)
        keys = [(hand, label) for hand in hands for label in _LABELS]
        left = [key for key in keys if f"{key[0]} {key[1]}" not in request.excluded]
        if not left:
            return NoPlan("every grasp was tried before", {"tried before": len(keys)})
        hand, label = left[0]
        gripper = self._model.description.grippers[hand]
        at_grasp = self.reach(self._looking_at(self._upright(request.q_start), place), hand, place)
        world_T_tcp = self._model.frame_pose(at_grasp, gripper.tcp_frame)
        before = self.reach(at_grasp, hand, place - _APPROACH_M * world_T_tcp[:3, 0])
        lifted = self.reach(at_grasp, hand, place + np.array([0.0, 0.0, request.lift_m]))
        reason = ConcessionReason
        grasped = touching(gripper.touch_links, [target.name], reason.GRASPED_OBJECT, "approach")
        under = under_foot_of(target, request.scene)
        carried = touching([target.name], under, reason.SUPPORT_OF_HELD_OBJECT, "lift")
        stance = request.stance
        return PickPlan(
            grasp=Grasp(hand, label, world_T_tcp, _APPROACH_M, diameter_m(target.shape)),
            reach=self._step("reach", request.q_start, before, stance, request.scene),
            approach=self._step("approach", before, at_grasp, stance, request.scene, grasped),
            lift=self._step("lift", at_grasp, lifted, stance, request.scene, carried),
            considered=len(keys) - len(left) + 1,
        )

    def _place(self, request: PlaceRequest) -> PlacePlan | NoPlan:
        """Over the first spot and down onto it, eyes on it; the hand's orientation is as it comes."""
        if not request.spots:
            return NoPlan("there is no spot left", {"no free spot": 1})
        spot, body = request.spots[0], request.scene.attached[request.held]
        frames = self._model.description.tcp_frames
        hand = next(hand for hand, frame in frames.items() if frame == body.frame)
        place, up = spot.world_T_object[:3, 3], np.array([0.0, 0.0, 1.0])
        hover = self._looking_at(self._carry(request.q_start, hand, place + spot.hover_m * up, body), place)
        down = self._carry(hover, hand, place - spot.below_m * up, body)
        carried = touching([request.held], spot.touches, ConcessionReason.SUPPORT_OF_HELD_OBJECT, "lower")
        return PlacePlan(
            hand=hand,
            spot=0,
            world_T_object=spot.world_T_object,
            transfer=self._step("transfer", request.q_start, hover, request.stance, request.scene),
            lower=self._step("lower", hover, down, request.stance, request.scene, carried),
            considered=1,
        )

    def _handle(self, request: HandleRequest) -> HandlePlan | NoPlan:
        """To the bar, in whatever orientation; the way after it is taken for reachable."""
        left = [hand for hand in request.hands if f"{hand} bar" not in request.excluded]
        if not left:
            return NoPlan("every grasp was tried before", {"tried before": len(request.hands)})
        hand, bar = left[0], request.path.at(request.s_from)
        at_bar = self.reach(request.q_start, hand, bar.position_m)
        gripper = self._model.description.grippers[hand]
        world_T_tcp = self._model.frame_pose(at_bar, gripper.tcp_frame)
        before = self.reach(at_bar, hand, bar.position_m - _APPROACH_M * world_T_tcp[:3, 0])
        in_hand = touching(gripper.touch_links, request.parts, ConcessionReason.HANDLE_IN_HAND, "approach")
        return HandlePlan(
            grasp=Grasp(hand, "bar", world_T_tcp, _APPROACH_M, _BAR_M),
            reach=self._step("reach", request.q_start, before, request.stance, request.scene),
            approach=self._step("approach", before, at_bar, request.stance, request.scene, in_hand),
            lead_to=request.s_to,
            considered=1,
        )

    def _control(self, request: ControlRequest) -> ControlPlan | NoPlan:
        """To the knob or button, in whatever orientation; that a knob can be turned is taken for granted."""
        left = [hand for hand in request.hands if f"{hand} roll 0" not in request.excluded]
        if not left:
            return NoPlan("every way was tried before", {"tried before": len(request.hands)})
        hand, place = left[0], request.scene.objects[request.control].world_T_object[:3, 3]
        there = self.reach(request.q_start, hand, place)
        gripper = self._model.description.grippers[hand]
        world_T_tcp = self._model.frame_pose(there, gripper.tcp_frame)
        before = self.reach(there, hand, place - _APPROACH_M * world_T_tcp[:3, 0])
        in_hand = touching(
            gripper.touch_links, [request.control], ConcessionReason.HANDLE_IN_HAND, "approach"
        )
        return ControlPlan(
            grasp=Grasp(hand, "roll 0", world_T_tcp, _APPROACH_M, _BAR_M),
            reach=self._step("reach", request.q_start, before, request.stance, request.scene),
            approach=self._step("approach", before, there, request.stance, request.scene, in_hand),
            considered=1,
            short_m=request.short_m,
        )

    def _turn(self, request: TurnRequest) -> TurnPlan:
        """A little aside instead of about the hand's own axis, and back."""
        gripper = self._model.description.grippers[request.hand]
        here = self._model.frame_pose(request.q_start, gripper.tcp_frame)
        there = self.reach(request.q_start, request.hand, here[:3, 3] + 0.02 * here[:3, 1])
        back = self.reach(there, request.hand, here[:3, 3] - _APPROACH_M * here[:3, 0])
        links, parts = gripper.touch_links, [request.control]
        turning = touching(links, parts, ConcessionReason.HANDLE_IN_HAND, "turn")
        leaving = touching(links, parts, ConcessionReason.HANDLE_IN_HAND, "back")
        return TurnPlan(
            self._step("turn", request.q_start, there, request.stance, request.scene, turning),
            self._step("back", there, back, request.stance, request.scene, leaving),
        )

    def _carry(self, q: Array, hand: Hand, place: Array, body: AttachedBody) -> Array:
        """Bring the middle of what a hand holds to a place."""
        frame = self._model.description.tcp_frames[hand]
        for _ in range(5):
            turn = self._model.frame_pose(q, frame)[:3, :3]
            q = self.reach(q, hand, place - turn @ body.frame_T_object[:3, 3])
        return q

    def _offer(self, request: OfferRequest) -> MovePlan:
        frame = request.scene.attached[request.held].frame
        hand = next(hand for hand, name in self._model.description.tcp_frames.items() if name == frame)
        aside = 0.2 if hand == "left" else -0.2
        goal = self.reach(request.q_start, hand, np.array([0.5, aside, 1.15]))
        return MovePlan(self._step("offer", request.q_start, goal, request.stance, request.scene))

    def _timed(self, answer: MovePlan | NoPlan) -> MovePlan | NoPlan:
        if isinstance(answer, NoPlan):
            return answer
        trajectory = answer.step.trajectory
        timed = replace(trajectory, t_s=self.motion_s * trajectory.t_s)
        return MovePlan(replace(answer.step, trajectory=timed))

    def _upright(self, q: Array) -> Array:
        """The same configuration with the trunk at home: a look may have leaned it."""
        q, trunk = q.copy(), 7 + self._model.indices(self._model.description.groups.get("torso", ()))
        q[trunk] = self._model.q_home[trunk]
        return q

    def _looking_at(self, q: Array, place: Array) -> Array:
        """The same configuration with the head turned to a place."""
        q = q.copy()
        for joint, angle in gaze_joints(self._model, q, place).items():
            q[7 + self._model.joint_index(joint)] = angle
        return q

    def _posture(self, request: MoveRequest) -> Array:
        goal = request.q_start.copy() if request.keep_others else self._model.q_home.copy()
        for joint, angle in request.joints.items():
            goal[7 + self._model.joint_index(joint)] = angle
        goal[:3] += request.pelvis_m
        return goal

    def _step(
        self,
        name: str,
        q_start: Array,
        q_goal: Array,
        stance: Stance,
        scene: PlanningScene,
        concessions: tuple[Concession, ...] = (),
    ) -> PlannedStep:
        t_s = np.array([0.0, self.motion_s])
        trajectory = Trajectory(
            self._model.joints, stance, t_s, np.array([q_start, q_goal]), np.zeros((2, self._model.nv))
        )
        return PlannedStep(name, trajectory, scene, concessions)

    def reach(self, q: Array, hand: Hand, place: Array) -> Array:
        """Move arm and trunk until the TCP is at a place, shape (3,), in whatever orientation."""
        asked = q.tobytes(), hand, place.tobytes()
        if asked not in self.reached:
            self.reached[asked] = self._reach(q, hand, place)
        return self.reached[asked].copy()

    def _reach(self, q: Array, hand: Hand, place: Array) -> Array:
        description = self._model.description
        groups = description.groups
        index = 7 + self._model.indices((*groups["torso"], *groups[f"{hand}_arm"]))
        frame, q = description.grippers[hand].tcp_frame, q.copy()
        for _ in range(_STEPS):
            error = place - self._model.frame_pose(q, frame)[:3, 3]
            if float(np.linalg.norm(error)) < 1e-6:
                break
            jacobian = self._model.frame_jacobian(q, frame)[:3, index - 1]  # q has a quaternion, v has none
            q[index] += jacobian.T @ np.linalg.solve(jacobian @ jacobian.T + _DAMPING * np.eye(3), error)
        return q


def _bare(scene: PlanningScene) -> PlanningScene:
    """What is held, and nothing around."""
    return replace(scene, objects=MappingProxyType({}))
