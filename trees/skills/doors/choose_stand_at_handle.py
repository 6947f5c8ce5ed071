"""Choose where to stand for a handle that cannot be stood square before: the table is in the way."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, zip_longest

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.model.robot_description import Hand
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.requests.handle import HandleRequest
from kinematics.scene.planning_scene import SceneObject
from kinematics.scene.support_of import supports_of, top_m
from trees.beliefs.grounding.destination import Place
from trees.beliefs.openings.handles import HandleTarget
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.ports import ports
from trees.skills.doors.handle_standing import WalkToHandle
from trees.skills.doors.plan_handle import handle_request
from trees.skills.walk_to.choose_stand import ChooseStand
from trees.skills.walking.reachable_standing import Stand, StandingRoom, places_about
from trees.skills.walking.standing_place import sides_of
from trees.tasks import CloseTask, OpenTask

_MARK_M = 0.02
"""Edge of the cube that stands for a handle where it is asked from where things on a table are reached."""


class ChooseStandAtHandle(ChooseStand):
    """Find where to stand so that a hand can lead a handle all its way, from here or from elsewhere.

    What stands on a table may open towards its middle: there, nobody stands before it. The planner is asked
    from one place after the other at the nearest edge of what it stands on.
    """

    INPUT_PORTS = ports(task=object, handle=HandleTarget)
    OUTPUT_PORTS = ports(stand=Stand)
    CONTRACT = Contract(
        precondition="the handle was seen",
        postcondition="the handle's whole way has a plan from the chosen place, and from beside it if that "
        "can be",
        deadline_s=60.0,
    )

    def aim(self) -> Place:
        """The handle."""
        self._task: OpenTask | CloseTask = self.get_input("task")
        self._target: HandleTarget = self.get_input("handle")
        return place_of(self._target)

    def usual(self, place: Place, body: PlanarPose) -> PlanarPose:
        """At the side of what the handle is above that is nearest to the robot; square before it else."""
        sides = self._sides(place, body)
        return sides[0] if sides else super().usual(place, body)

    def _sides(self, place: Place, body: PlanarPose) -> list[PlanarPose]:
        """Where to stand at each side of what the handle is above, the nearest to the robot first."""
        scene = self.toolbox.world.scene
        x, y, z = place.odom_T_place[:3, 3].tolist()
        mark = SceneObject(place.name, place.shape, place.odom_T_place)
        fixed = scene.with_objects(item for item in scene.objects.values() if not item.movable)
        below = [scene.objects[name] for name in supports_of(mark, fixed, z)]
        top = max(below, key=top_m, default=None)
        if top is None or not isinstance(top.shape, Box):
            return []
        sides = sides_of(top.shape, top.world_T_object, PlanarPose(x, y), toward=PlanarPose(x, y))
        return sorted(sides, key=body.distance_m)

    @property
    def may_help(self) -> bool:
        """Whether another place can be better: what has no model is moved from square before it, or not."""
        target: HandleTarget = self.get_input("handle")
        return self.toolbox.can_walk and target.moves is not None

    def usual_again(self) -> PlanarPose | None:
        """None: a handle is seen again as it is."""
        return None

    def thing(self, place: Place) -> SceneObject | None:
        """The bar, where it is now: it is to be seen."""
        return SceneObject(place.name, place.shape, place.odom_T_place)

    def hands(self) -> tuple[Hand, ...]:
        """Those that suit the handle."""
        return self._target.hands

    def stands(
        self, here: PlanarPose, places: Sequence[PlanarPose], room: StandingRoom
    ) -> Iterator[PlanarPose]:
        """Here first, for who stands well does not walk; then by turns at one side and at the next."""
        thing = self.thing(self._place)
        sides = self._sides(self._place, here)
        if thing is None or not sides:
            return chain([here], filter(room.has, places))
        x, y = thing.world_T_object[:2, 3].tolist()
        rows = [
            [one for one in places_about(side, (x, y), self.TURNED_RAD, self.reach(thing)) if room.has(one)]
            for side in sides
        ]
        turns = chain.from_iterable(zip_longest(*rows))
        return chain([here], (one for one in turns if one is not None))

    def request(self, body: PlanarPose, stance: Stance) -> HandleRequest:
        """From the home posture there."""
        del body
        toolbox = self.toolbox
        q_home = StandingRobot.of(toolbox.model, stance).q_home
        return handle_request(toolbox, self._task, self._target, q_home, stance)

    def without_any(self) -> Failure:
        """Nothing moves then."""
        return Failure.infeasible(
            f"there is no place to stand from which the {self._target.handle} can be led all its way",
            places=self._asked,
        )


class WalkToStandAtHandle(WalkToHandle):
    """Walk to the place that was chosen for a handle."""

    INPUT_PORTS = ports(handle=HandleTarget, stand=Stand)
    OUTPUT_PORTS = ports(goal=PlanarPose)
    CONTRACT = WalkToHandle.CONTRACT

    def place(self, body: PlanarPose) -> PlanarPose:
        """Where it was chosen, beside the handle."""
        del body
        stand: Stand = self.get_input("stand")
        return stand.body(place_of(self._target))


def place_of(target: HandleTarget) -> Place:
    """A handle as something to stand for."""
    at = target.path.at(target.opening).position_m
    mark = Box((_MARK_M, _MARK_M, _MARK_M))
    return Place(target.handle, "object", mark, poses.translation(*at.tolist()), 1.0)
