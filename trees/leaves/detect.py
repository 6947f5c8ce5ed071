"""See what is there, remember it, and find the object that is meant."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray
from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from robots.perception.standing import standing_on_tops
from trees.contract import Contract
from trees.failures import CHOICES_JOINED_BY, Failure
from trees.leaf import DONE
from trees.look_leaf import LookLeaf, View, estimates_of
from trees.ports import ports
from trees.scene_update import kind_of, support_of, updated_scene, words_for
from trees.sight import behind_a_hand, in_view
from trees.steps import Target
from trees.tasks import ObjectOf, PickTask


class Detect(LookLeaf):
    """Fuse a few frames into the world model, and choose the one object that the task means.

    Fails when it is not seen, when several fit (the failure's ``choices`` list them), and when the
    furniture that it stands on is not known: a motion past a table that was not seen would hit it.
    """

    INPUT_PORTS = ports(task=PickTask)
    OUTPUT_PORTS = ports(target=Target)
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="exactly one object that fits was seen, in half of the frames at least, on known "
        "furniture; everything seen is in the world model",
        deadline_s=2.0,
    )

    def judge(self, views: list[View]) -> Status | Failure:
        """Update the world model, then choose."""
        world, policy = self.toolbox.world, self.toolbox.policy
        estimates = standing_on_tops(self._not_in_hand(estimates_of(views)))
        update = updated_scene(world.scene, estimates, policy, lambda point: self._unseen(views[-1], point))
        world.update(update.scene)
        self.measured(frames=len(views), things=len(update.seen), scene_version=update.scene.version)
        chosen = self._choose(update.seen)
        if isinstance(chosen, Failure):
            return chosen
        self._set_output("target", chosen)
        x, y, z = chosen.odom_T_object[:3, 3]
        self.feedback_message = f"{chosen.name} at {x:.2f}, {y:+.2f}, {z:.2f} m"
        return DONE

    def _not_in_hand(self, estimates: Sequence[ObjectEstimate]) -> list[ObjectEstimate]:
        """Leave out what is seen in a hand: it is attached, and must not become an obstacle as well."""
        scene, q = self.toolbox.world.scene, self.toolbox.sensing.state().q
        held = [
            (self.toolbox.model.frame_pose(q, body.frame) @ body.frame_T_object)[:3, 3]
            for body in scene.attached.values()
        ]
        near = self.toolbox.policy.same_object_m
        return [
            estimate
            for estimate in estimates
            if all(float(np.linalg.norm(estimate.odom_T_object[:3, 3] - place)) > near for place in held)
        ]

    def _unseen(self, view: View, point: NDArray[np.float64]) -> bool:
        model = self.toolbox.model
        if not in_view(model.description.camera, view.odom_T_camera, point):
            return True
        q = self.toolbox.sensing.state_at(view.frame.stamp_s).q
        eye = view.odom_T_camera[:3, 3]
        return behind_a_hand(model, q, eye, point, self.toolbox.policy.hidden_by_hand_m)

    def _choose(self, seen: Mapping[str, ObjectEstimate]) -> Target | Failure:
        task: PickTask = self.get_input("task")
        scene, wanted = self.toolbox.world.scene, task.object
        if isinstance(wanted, ObjectOf):
            raise TypeError("the object of an earlier task was not filled in")
        fitting = {
            name: estimate
            for name, estimate in seen.items()
            if estimate.category == "object"
            and wanted.kind in (None, estimate.kind)
            and wanted.color in (None, estimate.color)
        }
        if not fitting:
            return Failure.postcondition(f"no {wanted} seen", seen=_words(seen))
        standing = {
            name: support_of(scene.objects[name], scene, self.toolbox.policy.support_gap_m)
            for name in fitting
        }
        on_known = [name for name, support in standing.items() if support is not None]
        if not on_known:
            return Failure.postcondition(f"what the {wanted} stands on is not seen", seen=_words(seen))
        on_source = [
            name
            for name in on_known
            if task.source is None or ((s := standing[name]) is not None and kind_of(s.name) == task.source)
        ]
        if not on_source:
            return Failure.postcondition(f"a {wanted} is seen, but not on the {task.source}")
        if len(on_source) > 1:
            choices = _described({name: fitting[name] for name in on_source})
            return Failure.infeasible(
                f"which {wanted}? there are {len(on_source)}",
                choices=CHOICES_JOINED_BY.join(choices),
                count=len(on_source),
            )
        name, estimate = on_source[0], fitting[on_source[0]]
        return Target(
            name, estimate.kind, estimate.color, estimate.shape, estimate.odom_T_object, estimate.confidence
        )


def _words(seen: Mapping[str, ObjectEstimate]) -> str:
    """What was seen, each thing once."""
    return ", ".join(sorted({words_for(estimate) for estimate in seen.values()})) or "nothing"


def _described(fitting: Mapping[str, ObjectEstimate]) -> list[str]:
    """Words that tell objects apart: colour and kind, else also where it is, from the left."""
    from_left = sorted(fitting.values(), key=lambda estimate: -float(estimate.odom_T_object[1, 3]))
    words = [words_for(estimate) for estimate in from_left]
    if len(set(words)) == len(words):
        return words
    places = [estimate.odom_T_object[:3, 3] for estimate in from_left]
    return [
        f"{word} {x:.2f} m ahead, {abs(y):.2f} m to the {'left' if y > 0 else 'right'}"
        for word, (x, y, _) in zip(words, places, strict=True)
    ]
