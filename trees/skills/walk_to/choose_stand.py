"""Choose where to stand for an object: where a pick of it has a plan."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Sequence
from typing import ClassVar

from py_trees.common import Status

from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.requests.handle import HandlePlan
from kinematics.requests.pick import PickPlan, PickRequest
from kinematics.requests.place import PlacePlan
from kinematics.requests.request import Request
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import SceneObject
from kinematics.walking.route.path_planning import Footprint, footprints
from trees.beliefs.grounding.destination import Place
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.nodes.ports import ports
from trees.readings.odometry import feet_pose
from trees.skills.walking.reachable_standing import (
    TURNED_RAD,
    Stand,
    StandingRoom,
    places_about,
    sees,
    stance_of,
    stands_free,
)
from trees.skills.walking.standing_place import standing_place
from trees.skills.walking.walking_room import room_if_it_walks
from trees.toolbox import Job

Answer = PickPlan | PlacePlan | HandlePlan | NoPlan
"""What the planner says of a place to stand."""
_MOST = 40
"""Places that are asked about."""
_BESIDE = PlanarPose(0.02, 0.02, 0.02)


class ChooseStand(Leaf):
    """Find where to stand so that the object can be picked up.

    The planner is asked for a pick from one place after the other, beginning with the usual one; the first
    place with a plan is taken. The usual place is also chosen for all that is not an object of the planning
    scene, and, if there is room, for an object that can be picked up from nowhere: a person may only want the
    robot to go there.
    """

    INPUT_PORTS = ports(place=Place)
    OUTPUT_PORTS = ports(stand=Stand)
    CONTRACT = Contract(
        precondition="the place was seen",
        postcondition="a pick has a plan from the chosen place, and from beside it if that can be; or it is "
        "the usual one",
        deadline_s=30.0,
    )

    TURNED_RAD: ClassVar[tuple[float, ...]] = TURNED_RAD
    """How far out of the usual heading the robot may stand."""
    BESIDE: ClassVar[tuple[PlanarPose, ...]] = (_BESIDE,)
    """A place is taken if those that are so far beside it do as well, for nobody arrives exactly; where there
    is no such place, the one with most of them."""

    _job: Job[Answer] | None = None

    def begin(self) -> None:
        """List the places."""
        toolbox = self.toolbox
        place = self.aim()
        body = feet_pose(toolbox)
        scene = toolbox.world.scene
        self._place, self._here, self._job, self._asked, self._most = place, body, None, 0, _MOST
        self._tried: list[PlanarPose] = []
        self._usual = self.usual(place, body)
        self._stands: Iterator[PlanarPose] = iter(())
        self._stand, self._sure = self._usual, 0
        self._nearly: tuple[int, PlanarPose, str] | None = None
        self._above: tuple[Footprint, ...] = ()
        settings = self._settings = toolbox.model.description.walking
        thing = self.thing(place)
        if settings is not None and thing is not None:
            others = scene.without_object(thing.name) if thing.name in scene.objects else scene
            about, above = footprints(others), footprints(others, above_m=settings.hands_from_m)
            x, y = (float(value) for value in thing.world_T_object[:2, 3])
            model = toolbox.model
            eye_m = float(model.frame_pose(model.q_home, model.description.camera.frame)[2, 3])
            self._above = above
            places = places_about(self._usual, (x, y), self.TURNED_RAD, self.reach(thing))
            room = StandingRoom(self._usual, about, above, settings)
            self._stands = (
                stand for stand in self.stands(body, places, room) if sees(stand, eye_m, thing, scene)
            )

    def aim(self) -> Place:
        """What is to be within reach."""
        place: Place = self.get_input("place")
        return place

    def usual(self, place: Place, body: PlanarPose) -> PlanarPose:
        """Where one would stand without knowing better."""
        toolbox = self.toolbox
        gap_m, room = toolbox.policy.support_gap_m, room_if_it_walks(toolbox)
        return standing_place(place, toolbox.world.scene, body, gap_m, room)

    def usual_again(self) -> PlanarPose | None:
        """The usual place, where it is the one that ``SquaredUp`` finds again from nearby."""
        return self._usual

    def thing(self, place: Place) -> SceneObject | None:
        """What is to be within reach; None when it is no object that the scene holds."""
        return self.toolbox.world.scene.objects.get(place.name) if place.category == "object" else None

    def hands(self) -> tuple[Hand, ...]:
        """The hands that may be used."""
        return tuple(self.toolbox.model.description.grippers)

    def reach(self, thing: SceneObject) -> Callable[[PlanarPose], float] | None:
        """How well a body that stands somewhere gets to the object; None for a robot without a map."""
        known = self.toolbox.model.description.reachability
        if known is None:
            return None
        x, y, z = (float(value) for value in thing.world_T_object[:3, 3])
        hands = self.hands()
        return functools.cache(lambda body: known.best_from(body, hands, (x, y, z)))

    def stands(
        self, _here: PlanarPose, places: Sequence[PlanarPose], room: StandingRoom
    ) -> Iterator[PlanarPose]:
        """The places to ask about, in order, where there is room."""
        return filter(room.has, places)

    def request(self, body: PlanarPose, stance: Stance) -> Request[Answer]:
        """What the planner is asked for a place to stand."""
        del body
        toolbox = self.toolbox
        return PickRequest(
            q_start=StandingRobot.of(toolbox.model, stance).q_home,
            stance=stance,
            scene=toolbox.world.scene,
            target=self._place.name,
            lift_m=toolbox.policy.lift_m,
            seed=int(toolbox.rng.integers(2**31)),
        )

    def harder(self) -> Iterator[PlanarPose]:
        """Places to ask about once more, and more patiently, when none had a plan; none here."""
        return iter(())

    def without_any(self) -> Status | Failure:
        """What follows when there is a plan from nowhere."""
        if self._settings is not None and not stands_free(self._usual, self._above, self._settings):
            return Failure.infeasible(
                f"there is no place to stand from which the {self._place.name} is within reach",
                places=self._asked,
            )
        return self._choose(self._usual, "the usual place")

    def step(self) -> Status | Failure:
        """Ask, and wait for the answer."""
        if self._job is not None:
            if not self._job.done:
                return RUNNING
            answer = self._job.result()
            self._job = None
            if not isinstance(answer, NoPlan):
                words = f"for the {_hand_of(answer)} hand"
                if self._sure == len(self.BESIDE):
                    return self._choose(self._stand, words)
                if self._nearly is None or self._sure > self._nearly[0]:
                    self._nearly = self._sure, self._stand, words
                self._ask(self._stand @ self.BESIDE[self._sure])
                self._sure += 1
                return RUNNING
        following = next(self._stands, None) if self._asked < self._most else None
        if following is None:
            self._stands = self.harder()
            following = next(self._stands, None)
        if following is None and self._nearly is not None:
            _, stand, words = self._nearly  # better than none: there it is planned anew, or told
            return self._choose(stand, f"{words}, if it gets there exactly")
        if following is None:
            return self.without_any()
        self._stand, self._sure = following, 0
        self._tried.append(following)
        self._ask(following)
        return RUNNING

    def release(self, reason: str) -> None:
        """Forget the job."""
        self.feedback_message = reason
        if self._job is not None:
            self._job.cancel()

    def _ask(self, body: PlanarPose) -> None:
        stance = stance_of(self.toolbox.motion.stance(), self._here, body)
        self._asked += 1
        self._job = self.toolbox.planning.submit(self.request(body, stance))

    def _choose(self, body: PlanarPose, words: str) -> Status:
        self._set_output("stand", Stand.beside(self._place, body, self.usual_again()))
        self.feedback_message = words
        beside = self._usual.to(body)
        self.measured(asked=self._asked, ahead_m=beside.x_m, aside_m=beside.y_m, turned_rad=beside.yaw_rad)
        return DONE


def _hand_of(answer: object) -> str:
    match answer:
        case PickPlan() | HandlePlan():
            return answer.grasp.hand
        case PlacePlan():
            return answer.hand
        case _:
            raise TypeError(f"the planner answered {type(answer).__name__} for a place to stand")
