"""See that the object is in the container."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.free_spots import footprint_radius_m
from kinematics.scene.planning_scene import SceneObject
from kinematics.scene.support_of import half_height_m
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.bystanders import disturbed
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.looking.look_around import LookAround
from trees.skills.put_in.inside_of import inside_of

# A container that was pushed farther than this was not left alone.
_PUSHED_M = 0.04
# What comes down less far than this below the rim stands on it.
_INTO_M = 0.01


class VerifyPutIn(LookAround):
    """See that the hand is empty, and that the object is inside the container.

    The walls may hide it; then it must not be seen anywhere beside the container, and the evidence says that
    it was not seen.
    """

    INPUT_PORTS = ports(stood=dict, held=HeldObject, place=Place)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="the hand was opened over the container; the head is at rest",
        postcondition="the object was seen between the container's walls; the container and everything else "
        "stand where they stood",
        deadline_s=2.0,
    )

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Compare the places."""
        held, place = self.get_input("held"), self.get_input("place")
        if self.toolbox.grippers[held.hand].reading().holding:
            return Failure.postcondition(f"the {held.hand} hand still holds the {held.name}")
        drawer = inside_of(place, self.toolbox.world.scene) if place.category == "furniture" else None
        if isinstance(drawer, Failure):
            return drawer
        container = seen.get(place.name)
        if container is None and drawer is None:
            return Failure.postcondition(f"the {place.name} is not seen where it was")
        # of a drawer its front is out of sight when the head looks into it
        now = place.odom_T_place if container is None else container.odom_T_object
        pushed_m = float(np.linalg.norm((now - place.odom_T_place)[:2, 3]))
        if pushed_m > _PUSHED_M:
            return Failure.postcondition(f"the {place.name} was pushed", pushed_m=pushed_m)
        stood = self.get_input("stood")  # one like it that was there before tells nothing
        same = [
            item for name, item in seen.items() if item.may_be(held.kind, held.color) and name not in stood
        ]
        inside = [
            item
            for item in same
            if (
                drawer.holds(item.odom_T_object[:3, 3])
                if drawer is not None
                else container is not None and _inside(item, container)
            )
        ]
        rim_m = None if container is None else _extent_m(container)[1]
        if drawer is not None:
            rim_m = drawer.rim_m
        if inside and rim_m is not None and not any(_below_the_rim(item, rim_m) for item in inside):
            return Failure.postcondition(f"the {held.name} stands on the {place.name}, not in it")
        if not inside:
            where = f"is seen beside the {place.name}" if same else f"is not seen in the {place.name}"
            return Failure.postcondition(f"the {held.name} {where}")
        policy, scene = self.toolbox.policy, self.toolbox.world.scene
        harm = disturbed(stood, scene, policy.undisturbed_m, place.name)
        if harm is not None:
            return harm
        evidence = {"object": held.name, "in": place.name, "seen": True, "pushed_m": pushed_m}
        self.measured(**evidence)
        self._set_output("evidence", evidence)
        self.feedback_message = "seen inside"
        return DONE


def _below_the_rim(item: ObjectEstimate, rim_m: float) -> bool:
    """Whether an object comes down into what has room for it: what is solid has none."""
    return _extent_m(item)[0] <= rim_m - _INTO_M


def _extent_m(item: ObjectEstimate) -> tuple[float, float]:
    """Heights of its lowest and its highest point."""
    half_m = half_height_m(SceneObject(item.kind, item.shape, item.odom_T_object))
    middle_m = float(item.odom_T_object[2, 3])
    return middle_m - half_m, middle_m + half_m


def _inside(item: ObjectEstimate, container: ObjectEstimate) -> bool:
    local = (poses.inverse(container.odom_T_object) @ item.odom_T_object)[:3, 3]
    shape = container.shape
    if isinstance(shape, Box):
        half = 0.5 * np.array(shape.size_m[:2])
        return bool(np.all(np.abs(local[:2]) <= half))
    return float(np.linalg.norm(local[:2])) <= footprint_radius_m(shape)
