"""Choose where to stand to put something behind a door: where a placing on a board has a plan."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import chain

import numpy as np
from py_trees.common import Status

from kinematics.geometry.planar import PlanarPose
from kinematics.ik.arm_frames import link_moved_by
from kinematics.model.robot_description import Hand
from kinematics.model.stance import Stance
from kinematics.requests.place import PlaceRequest, Spot
from kinematics.scene.planning_scene import SceneObject
from trees.beliefs.grounding.destination import Place
from trees.beliefs.openings.fridge_inside import front_of, inside_of_fridge, spots_in_fridge, spots_in_sight
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.place.plan_place import place_request
from trees.skills.walk_to.choose_stand import ChooseStand
from trees.skills.walking.reachable_standing import (
    EYE_AHEAD_M,
    TURNED_RAD,
    Stand,
    StandingRoom,
    posture_at,
)
from trees.skills.walking.standing_place import EDGE_M

_REACH_M = 1.0
"""From the shoulder to the spot, on the floor, at most, of a robot without a map of its reach."""
_NINTHS = 9
"""What differs by less in its share of directions is alike."""
_SPOTS = 2
_MOST_PATIENTLY = 16
"""Places that are asked about once more, when a quick look at all of them has found nothing."""


class ChooseStandToPut(ChooseStand):
    """Find where to stand so that the held object can be placed behind a door.

    The planner is asked for a placing from one place after the other, beginning here, with the object where
    the arm has it now; the first place with a plan is taken. Each is first asked about with a short search,
    and only if none has a plan are the best of them searched for longer. A robot that cannot walk stays where
    it stands.
    """

    # beside an open door only who turns towards it reaches in with the hand on the other side
    TURNED_RAD = (*TURNED_RAD, 0.9, -0.9, 1.2, -1.2)
    BESIDE = (PlanarPose(0.02, 0.02, 0.02), PlanarPose(-0.02, -0.02, -0.02))

    INPUT_PORTS = ports(place=Place, held=HeldObject)
    OUTPUT_PORTS = ports(stand=Stand)
    CONTRACT = Contract(
        precondition="the place was seen; the object is an attached body",
        postcondition="a placing has a plan from the chosen place, and from beside it if that can be",
        deadline_s=30.0,
    )

    def begin(self) -> None:
        """Find the boards, then list the places."""
        inside = inside_of_fridge(self.toolbox.world.scene)
        self._inside: Failure | None = inside if isinstance(inside, Failure) else None
        self._spots: tuple[Spot, ...] = ()
        self._front: PlanarPose | None = None
        self._quick = True
        self._from: dict[PlanarPose, tuple[Spot, ...]] = {}
        if not isinstance(inside, Failure):
            held: HeldObject = self.get_input("held")
            self._spots = spots_in_fridge(held, inside, self.toolbox.world.scene)
            self._front = PlanarPose.of(front_of(inside.boards[0]))
        super().begin()

    def usual(self, place: Place, body: PlanarPose) -> PlanarPose:
        """Square in front of the boards."""
        return super().usual(place, body) if self._front is None else self._front @ PlanarPose(-EDGE_M)

    def usual_again(self) -> PlanarPose | None:
        """None before boards: those have a front of their own."""
        return super().usual_again() if self._front is None else None

    def thing(self, _place: Place) -> SceneObject | None:
        """The object on the best spot."""
        if not self._spots:
            return None
        held: HeldObject = self.get_input("held")
        return SceneObject(held.name, held.shape, self._spots[0].world_T_object)

    def hands(self) -> tuple[Hand, ...]:
        """The hand that holds it."""
        return (self.get_input("held").hand,)

    def stands(
        self, here: PlanarPose, places: Sequence[PlanarPose], room: StandingRoom
    ) -> Iterator[PlanarPose]:
        """Here first, for who stands well does not walk; then where the hand gets there best."""
        thing = self.thing(self._place)
        if thing is None:
            return iter(())
        x, y = (float(value) for value in thing.world_T_object[:2, 3])
        spot, shoulder, reach = PlanarPose(x, y), self._shoulder(), self.reach(thing)

        def share(one: PlanarPose) -> float:
            if reach is not None:
                return math.ceil(_NINTHS * reach(one)) / _NINTHS
            return 1.0 if (one @ shoulder).distance_m(spot) <= _REACH_M else 0.0

        first = [here] if share(here) > 0.0 else []
        reached = [one for one in places if share(one) > 0.0]
        reached.sort(key=lambda one: (-share(one), (one @ shoulder).distance_m(spot)))
        return filter(self._in_sight, chain(first, filter(room.has, reached)))

    def _in_sight(self, body: PlanarPose) -> tuple[Spot, ...]:
        """The spots that the eyes see from a place to stand."""
        if body not in self._from:
            eye, model = body @ PlanarPose(EYE_AHEAD_M), self.toolbox.model
            height_m = float(model.frame_pose(model.q_home, model.description.camera.frame)[2, 3])
            place, held = np.array([eye.x_m, eye.y_m, height_m]), self.get_input("held")
            self._from[body] = spots_in_sight(self._spots, held, self.toolbox.world.scene, place)
        return self._from[body]

    def harder(self) -> Iterator[PlanarPose]:
        """Those that were asked about quickly, once more."""
        again = self._tried if self._quick else []
        self._quick, self._tried = False, []
        self._most = self._asked + _MOST_PATIENTLY
        return iter(again)

    def request(self, body: PlanarPose, stance: Stance) -> PlaceRequest:
        """The present posture, carried over to the place."""
        q = posture_at(self.toolbox.motion.reference(), self._here, body)
        spots = tuple(few_of_each(self._in_sight(body) or self._spots))
        return place_request(self.toolbox, self.get_input("held"), spots, q, stance, quick=self._quick)

    def _shoulder(self) -> PlanarPose:
        """Of the arm that holds it, from the middle between the feet of the home posture."""
        model, hand = self.toolbox.model, self.get_input("held").hand
        link = link_moved_by(model, model.description.groups[f"{hand}_arm"][1])
        x, y = (float(value) for value in model.frame_pose(model.q_home, link)[:2, 3])
        return PlanarPose(x, y)

    def step(self) -> Status | Failure:
        """Nothing to ask without boards, or for a robot that cannot walk."""
        if self._inside is not None:
            return self._inside
        held = self.get_input("held")
        if not self._spots:
            return Failure.infeasible(f"there is no room for the {held.name} near the front of any board")
        if self.toolbox.walking is None or self._settings is None:
            self._set_output("stand", Stand.beside(self._place, self._here))
            return DONE
        return super().step()

    def without_any(self) -> Status | Failure:
        """Nobody walks to where nothing can be done."""
        return Failure.infeasible(
            f"there is no place to stand from which a board of the {self._place.name} is within reach",
            places=self._asked,
        )


def few_of_each(spots: Sequence[Spot]) -> Iterator[Spot]:
    """The first few spots of each board: asking about all of them from everywhere takes seconds."""
    for board in dict.fromkeys(spot.touches for spot in spots):
        yield from [spot for spot in spots if spot.touches == board][:_SPOTS]
