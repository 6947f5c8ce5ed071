"""Turn the head to who took something, so that the picture shows both the face and the hands."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.ik.body_gaze import with_joints
from kinematics.ik.gaze import gaze_joints
from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.held_object import HeldObject
from trees.nodes.ports import ports
from trees.port_values import Placement
from trees.skills.looking.aiming_leaf import AimingLeaf
from trees.skills.looking.look_at import joints_of


class LookAtTaker(AimingLeaf):
    """Turn the eyes to the person, midway in the picture between crown and lower end of what was let go.

    Nobody is found in a picture without the head, and what somebody holds is nobody's where the picture ends
    above it. A person who is not in the planning scene any more is looked for at the height of people.
    """

    INPUT_PORTS = ports(held=HeldObject, place=Place, placement=Placement)
    OUTPUT_PORTS = ports()

    def joints(self) -> Mapping[str, float]:
        """The goal of the head's joints, and of the trunk's if need be, rad."""
        toolbox, model = self.toolbox, self.toolbox.model
        person = toolbox.world.scene.objects.get(self.get_input("place").name)
        # a trunk that still leans over where the thing was lets the head look up no farther
        upright = joints_of(toolbox.policy.level_gazes[0], model.description)
        if person is None:
            return upright
        q = with_joints(toolbox.motion.reference(), model, upright)
        eye = model.frame_pose(q, model.description.camera.frame)[:3, 3]
        crown = person.world_T_object[:3, 3].copy()
        crown[2] += 0.5 * person.shape.height_m
        let_go = self.get_input("placement").odom_T_object[:3, 3]
        lower = 0.5 * (let_go + crown)  # who takes something draws it back to himself
        lower[2] = let_go[2] - 0.5 * self.get_input("held").shape.height_m
        # what is held is nearer than the face, so that midway in the picture is not midway in space
        ways = [(end - eye) / np.linalg.norm(end - eye) for end in (lower, crown)]
        return {**upright, **gaze_joints(model, q, eye + np.sum(ways, axis=0))}
