"""A hand that puts something down has felt how high the top is."""

from __future__ import annotations

from dataclasses import replace

from kinematics.scene.planning_scene import SceneObject
from kinematics.scene.support_of import lowest_point_m, top_m
from robots.perception.fusion.felt_top import FeltTop
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure, Reason
from trees.port_values import Placement
from trees.readings.disagreement import tell_disagreement
from trees.toolbox import Toolbox


def foot_m(toolbox: Toolbox, held: HeldObject) -> float:
    """Height of the lowest point of what a hand holds, by the encoders."""
    model, q = toolbox.model, toolbox.sensing.state().q
    pose = model.frame_pose(q, model.description.tcp_frames[held.hand]) @ held.tcp_T_object
    return lowest_point_m(SceneObject(held.name, held.shape, pose))


def note_felt_top(toolbox: Toolbox, held: HeldObject, placement: Placement, touched_m: float) -> None:
    """Remember at which height a hand has felt a top, and say so where the camera shows it elsewhere.

    What stands on the top was seen with the same camera as the top: what that is wrong by for both is no
    difference between them.

    Args:
        toolbox: Knows the world model.
        held: What the hand holds.
        placement: Where it is put.
        touched_m: Height of its foot when the touch was felt.
    """
    world = toolbox.world
    tops = [world.scene.objects[name] for name in placement.touches if name in world.scene.objects]
    top = next((item for item in tops if not item.movable), None)
    if top is None:
        return
    felt = FeltTop(f"{held.hand} hand", toolbox.clock.now_s(), touched_m)
    error, half_m = world.top_errors.get(top.name), 0.5 * held.shape.height_m
    if error is not None:
        variance_m2 = 2.0 * float(error.own_m2[2, 2]) + (error.size_share * half_m) ** 2
        innovation = felt.compared(top_m(top), variance_m2)
        if innovation.disagrees:
            felt = replace(felt, contradicts=True)
            (above_m,) = innovation.difference.tolist()
            where = "above" if above_m > 0.0 else "below"
            message = (
                f"the {felt.source} feels the {top.name} {abs(above_m) * 1e3:.0f} mm {where} where it is seen"
            )
            failure = Failure.postcondition(message, above_m=above_m, usual_m=innovation.sigma)
            tell_disagreement(toolbox, failure.because(Reason.FELT_OTHER_HEIGHT))
    world.note_felt_top(top.name, felt)
