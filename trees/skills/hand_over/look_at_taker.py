"""Turn the head to who took something, so that the picture shows both the face and the hands."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.held_object import HeldObject
from trees.nodes.ports import ports
from trees.port_values import Placement
from trees.skills.looking.aiming_leaf import AimingLeaf
from trees.skills.looking.look_at import joints_of, joints_that_show


class LookAtTaker(AimingLeaf):
    """Turn the eyes to the person, midway in the picture between crown and lower end of what was let go.

    Nobody is found in a picture without the head, and what somebody holds is nobody's where the picture ends
    above it. A person who is not in the planning scene any more is looked for at the height of people.
    """

    INPUT_PORTS = ports(held=HeldObject, place=Place, placement=Placement)
    OUTPUT_PORTS = ports()

    def joints(self) -> Mapping[str, float]:
        """The goal of the head's joints, and of the trunk's if need be, rad."""
        person = self.toolbox.world.scene.objects.get(self.get_input("place").name)
        if person is None:
            return joints_of(self.toolbox.policy.level_gazes[0], self.toolbox.model.description)
        model, camera = self.toolbox.model, self.toolbox.model.description.camera
        eye = model.frame_pose(self.toolbox.motion.reference(), camera.frame)[:3, 3]
        lower = self.get_input("placement").odom_T_object[:3, 3].copy()
        lower[2] -= 0.5 * self.get_input("held").shape.height_m
        crown = person.world_T_object[:3, 3].copy()
        crown[2] += 0.5 * person.shape.height_m
        # what is held out is nearer than the face, so that midway in the picture is not midway in space
        ways = [(end - eye) / np.linalg.norm(end - eye) for end in (lower, crown)]
        return joints_that_show(self.toolbox, eye + np.sum(ways, axis=0))
