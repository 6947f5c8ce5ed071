"""Fold a look into the world model."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.ik.arm_frames import elbow_frame
from kinematics.scene.namespace import reserved_names
from kinematics.scene.planning_scene import PlanningScene
from kinematics.scene.support_of import support_of, top_m
from robots.perception.fusion.cameras import HEAD, PlacedCamera, Seen
from robots.perception.object_estimate import ObjectEstimate
from robots.perception.standing import seen_to_float, standing_on_tops
from trees.beliefs.openings.moved_parts import without_moved_parts
from trees.beliefs.scene.scene_update import (
    SceneUpdate,
    kind_of,
    scene_object,
    updated_scene,
    words_for,
)
from trees.beliefs.sight.in_plain_sight import in_plain_sight
from trees.beliefs.sight.sight import Glimpse
from trees.failures import Failure, Reason
from trees.policy import TreePolicy
from trees.readings.disagreement import tell_disagreement
from trees.skills.looking.look_leaf import View, seen_in
from trees.toolbox import Toolbox


def glimpse_of(toolbox: Toolbox, view: View) -> Glimpse:
    """What a picture shows, with hands, forearms and held things in the way where they were then."""
    model = toolbox.model
    q = toolbox.sensing.state_at(view.frame.stamp_s).q
    parts = []
    for hand in model.description.hands:
        elbow, tcp = model.frame_poses(q, [elbow_frame(model, hand), model.description.tcp_frames[hand]])
        parts += [tcp[:3, 3], 0.5 * (elbow[:3, 3] + tcp[:3, 3])]
    held = toolbox.world.scene.attached.values()
    parts += [(model.frame_pose(q, body.frame) @ body.frame_T_object)[:3, 3] for body in held]
    return Glimpse(view.odom_T_camera, tuple(parts))


def not_in_hand(toolbox: Toolbox, estimates: Sequence[ObjectEstimate]) -> list[ObjectEstimate]:
    """Those estimates that are of nothing that a hand holds.

    What is nearer than ``same_object_m`` to what is held is that. So is what looks like it, hangs in the air
    and is nearer than ``slid_m``: it has slid in the hand, or was seen while an encoder was off. Believed as
    a second one it would bar every way of that hand. What is seen to be taller reaches as far as the held
    thing does: where the hand hides its foot it seems to stand on the table.
    """
    scene, policy = toolbox.world.scene, toolbox.policy
    if not scene.attached:
        return list(estimates)
    q = toolbox.sensing.state().q
    held = {
        name: (toolbox.model.frame_pose(q, body.frame) @ body.frame_T_object)[:3, 3]
        for name, body in scene.attached.items()
    }
    around = _with_furniture(scene, estimates, policy)
    return [
        estimate
        for estimate in estimates
        if all(
            _apart_m(estimate, place, scene.attached[name].body.shape.height_m)
            > (policy.slid_m if _hangs_like(name, estimate, around, policy) else policy.same_object_m)
            for name, place in held.items()
        )
    ]


def _apart_m(estimate: ObjectEstimate, place: Array, height_m: float) -> float:
    """How far a thing of some height is from where it could be within what is seen to be at least as tall."""
    x, y, z = (estimate.odom_T_object[:3, 3] - place).tolist()
    within_m = max(0.5 * (estimate.shape.height_m - height_m), 0.0)
    return float(np.hypot(np.hypot(x, y), max(abs(z) - within_m, 0.0)))


def _hangs_like(held: str, estimate: ObjectEstimate, around: PlanningScene, policy: TreePolicy) -> bool:
    """Whether something looks like what is held and stands on nothing."""
    if words_for(estimate) != kind_of(held):
        return False
    return support_of(scene_object(held, estimate, policy), around, policy.support_gap_m) is None


def _with_furniture(
    scene: PlanningScene, estimates: Iterable[ObjectEstimate], policy: TreePolicy
) -> PlanningScene:
    """What is believed, and the furniture of this look, as it is seen now."""
    seen = (estimate for estimate in estimates if estimate.category == "furniture")
    tops = [scene_object(f"seen {number}", estimate, policy) for number, estimate in enumerate(seen)]
    return scene.with_objects([*scene.objects.values(), *tops])


def folded_look(
    toolbox: Toolbox, views: list[View], *, may_have_moved: bool = True, keeping: bool = False
) -> SceneUpdate:
    """Replace the world model's scene by what a look tells, and remember the look.

    What is in a hand is left out: it is attached, and must not become an obstacle as well. What was out of
    sight, cut off by the picture's edge or hidden stays.

    Args:
        toolbox: Knows the world model.
        views: The look's pictures.
        may_have_moved: As for ``updated_scene``.
        keeping: Whether what an earlier look showed stays in any case.
    """
    world, policy = toolbox.world, toolbox.policy
    seen = seen_in(views)
    _tell_what_cameras_say(toolbox, seen, {view.source: view for view in views})
    told = not_in_hand(toolbox, seen.estimates)
    _tell_what_floats(toolbox, told)
    estimates = standing_on_tops(told)
    glimpse, camera = glimpse_of(toolbox, views[-1]), toolbox.model.description.camera
    own = views[-1].source == HEAD  # what others show tells nothing of what the robot's own eyes overlook
    others = tuple(world.scene.objects.values())
    update = updated_scene(
        without_moved_parts(world.scene, estimates),
        estimates,
        policy,
        lambda item: (
            keeping or not own or not in_plain_sight(item, glimpse, camera, others, policy.hidden_by_hand_m)
        ),
        may_have_moved=may_have_moved,
        reserved=reserved_names(toolbox.model),
        before=world.sightings,
    )
    update = _with_felt_tops(toolbox, _with_what_looks_told(toolbox, update))
    world.update(update.scene)
    world.note_sightings(update.seen)
    world.note_top_errors(update.seen)
    if own:
        world.note_glimpse(glimpse)
    return update


def _tell_what_cameras_say(toolbox: Toolbox, seen: Seen, newest: Mapping[str, View]) -> None:
    """Say where cameras contradict each other; the robot's own then counts, which goes where its hands go.

    A camera that shows nothing is blind where it should show what another one does.
    """
    for thing, innovation in seen.differing:
        message = f"the {innovation.source} shows the {words_for(thing)} elsewhere than my own camera"
        failure = Failure.postcondition(message, apart_m=innovation.size, usual_m=innovation.sigma)
        tell_disagreement(toolbox, failure.because(Reason.CAMERAS_DIFFER))
    for name in seen.blind:
        if not _should_show(toolbox, newest[name], seen.estimates):
            continue
        failure = Failure.postcondition(f"the {name} shows nothing of what another camera shows")
        tell_disagreement(toolbox, failure.because(Reason.CAMERA_BLIND))


def _should_show(toolbox: Toolbox, view: View, shown: Iterable[ObjectEstimate]) -> bool:
    """Whether something is well within a camera's pictures, by where the others show it."""
    own = toolbox.model.description.camera
    placed = next((camera for camera in toolbox.cameras if camera.name == view.source), None)
    camera = placed or PlacedCamera(
        HEAD,
        toolbox.detector,
        view.odom_T_camera,
        (own.horizontal_fov_rad, own.vertical_fov_rad),
        own.range_m,
    )
    return any(camera.should_show(one.odom_T_object[:3, 3]) for one in shown)


def _tell_what_floats(toolbox: Toolbox, estimates: Sequence[ObjectEstimate]) -> None:
    """Say where a top and what stands on it are seen at heights that do not fit.

    The mean of both counts then; margins are wider than what it may be wrong by.
    """
    for i, innovation in seen_to_float(estimates):
        if innovation.disagrees:
            (above_m,) = innovation.difference.tolist()
            top = words_for(estimates[i])
            where = "above" if above_m > 0.0 else "below"
            message = f"what is on the {top} seems to stand {where} its top: one is seen at a wrong height"
            failure = Failure.postcondition(message, above_m=above_m, usual_m=innovation.sigma)
            tell_disagreement(toolbox, failure.because(Reason.SEEN_TO_FLOAT))


def _with_felt_tops(toolbox: Toolbox, update: SceneUpdate) -> SceneUpdate:
    """Tops that a hand has felt elsewhere than they are seen, at the height that both agree on.

    What this look shows on them is raised with them.
    """
    scene = update.scene
    for name, felt in toolbox.world.felt_tops.items():
        estimate = update.seen.get(name)
        if not felt.contradicts or estimate is None or estimate.error is None or name not in scene.objects:
            continue
        top = scene.objects[name]
        variance_m2 = float(estimate.error.covariance_m2[2, 2])
        raised_m = felt.fused(top_m(top), variance_m2) - top_m(top)
        gap_m = toolbox.policy.support_gap_m
        on_it = [
            item
            for item in map(scene.objects.__getitem__, update.seen)
            if item.movable and (below := support_of(item, scene, gap_m)) is not None and below.name == name
        ]
        raised = poses.translation(0.0, 0.0, raised_m)
        moved = [replace(item, world_T_object=raised @ item.world_T_object) for item in (top, *on_it)]
        scene = scene.with_objects({**scene.objects, **{item.name: item for item in moved}}.values())
    return update if scene is update.scene else SceneUpdate(scene, update.seen)


def _with_what_looks_told(toolbox: Toolbox, update: SceneUpdate) -> SceneUpdate:
    """People with all that the looks of this task have told of them, not the newest alone."""
    scene, seen = update.scene, dict(update.seen)
    for name, estimate in update.seen.items():
        if estimate.category == "person":
            traits = toolbox.world.note_person(name, estimate.traits)
            if traits != estimate.traits:
                seen[name] = replace(estimate, traits=traits)
                scene = scene.with_object(scene_object(name, seen[name], toolbox.policy))
    return SceneUpdate(scene, seen)
