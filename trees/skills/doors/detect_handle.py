"""See a door or drawer, with its handle or as one that is pushed shut, and remember it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from py_trees.common import Status

from kinematics.scene.planning_scene import SceneObject
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.articulated import DRAWER
from trees.beliefs.grounding.furniture_called import is_said_of
from trees.beliefs.openings.handles import BODY_OF, MEANT_BY, HandleTarget, handles_in, same_front
from trees.beliefs.scene.scene_update import SceneUpdate, kind_of, words_for
from trees.failures import Failure, FailureKind
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import optional, ports
from trees.readings.odometry import feet_pose
from trees.skills.doors.meant_part import (
    meant_part,
    misnamed,
    noun_of,
    opens_nothing,
    those_meant_here,
    whole_of,
    with_fronts,
)
from trees.skills.doors.pushed_front import fronts_in, is_pushed, with_known_bars
from trees.skills.looking.folded_look import folded_look
from trees.skills.looking.look_leaf import LookLeaf, View
from trees.tasks import CloseTask, ObjectDescription, OpenTask
from trees.toolbox import Toolbox


class DetectHandle(LookLeaf):
    """See the door or drawer that the task names, with its handle, and remember it in the world model.

    A search looks in several directions; that one look does not show the handle is an answer, not a failure.
    Once a handle was chosen, only that one is looked for. Until then the only one in a look is taken, and
    ``ChooseHandle`` decides when the others have been seen.
    """

    ASKS = True
    INPUT_PORTS = ports(task=object, known=optional(HandleTarget))
    OUTPUT_PORTS = ports(handle=HandleTarget)
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="exactly one handle that fits was seen with what it opens; everything seen is in the "
        "world model",
        deadline_s=2.0,
    )

    def __init__(self, name: str, toolbox: Toolbox, wiring: Mapping[str, str] | None = None) -> None:
        """Make the leaf; what was chosen before is the "handle" where no wiring says otherwise."""
        super().__init__(name, toolbox, {"known": "handle", **(wiring or {})})

    def candidates(self, seen: Mapping[str, ObjectEstimate]) -> list[HandleTarget]:
        """What of a look can be moved."""
        return handles_in(seen, feet_pose(self.toolbox))

    def judge(self, views: list[View]) -> Status | Failure:
        """Update the world model, then choose."""
        before = self.toolbox.world.scene
        update = folded_look(self.toolbox, views)
        self.measured(frames=len(views), things=len(update.seen), scene_version=update.scene.version)
        task: OpenTask | CloseTask = self.get_input("task")
        wanted = task.object
        if told := opens_nothing(task, self.toolbox.detector.fronts):
            return Failure.infeasible(told)
        fitting = those_meant_here(task, self.candidates(update.seen), self.toolbox)
        if not fitting:
            return self._unseen(task, update)
        named = wanted.name if isinstance(wanted, ObjectDescription) else None
        chosen = before.objects.get(named) if named is not None else None
        known: HandleTarget | None = self.optional("known")
        if chosen is not None:  # an answer: names may have changed with this look, places have not
            handle = min(fitting, key=lambda item: self._away_m(item, chosen))
        elif known is not None:
            same = same_front(known, fitting, update.scene)
            if same is None:
                return Failure.postcondition(f"the {known.kind} that is meant is not seen from here")
            handle = same
        elif (wrong := misnamed(task, fitting)) is not None:
            return wrong
        elif len(fitting) == 1:
            (handle,) = fitting
        elif isinstance(meant := meant_part(task, fitting, self.toolbox), Failure):
            return meant
        else:
            handle = meant
        self._set_output("handle", handle)
        self.feedback_message = f"{handle.part}, open by {handle.shown(handle.opening):.2f} {handle.unit}"
        return DONE

    def _unseen(self, task: OpenTask | CloseTask, update: SceneUpdate) -> Failure:
        """Why a look shows none: what is named shows no front at all, or there may be one elsewhere."""
        noun, places = noun_of(task), self.toolbox.places
        what = noun or "door or drawer"
        kind = None if noun is None else MEANT_BY.get(noun)
        objects = update.scene.objects.items()
        known = [f"{item.moves.of} {kind_of(name)}" for name, item in objects if item.moves is not None]
        fronts = with_fronts({*known, *self.toolbox.detector.fronts}, kind)
        shown = {
            words_for(one)
            for one in update.seen.values()
            if one.category == "furniture" and one.kind not in BODY_OF.values()
        }
        whole = whole_of(task, places) or (None if noun in MEANT_BY else noun)
        bare = [name for name in sorted(shown - fronts) if whole and is_said_of(whole, name)]
        if not bare:
            return Failure.postcondition(f"no handle of a {what} seen")
        if whole == noun:
            return Failure.infeasible(f"the {bare[0]} has nothing that I can open or close")
        return Failure.infeasible(f"the {bare[0]} has no {what} that I can open or close")

    def _away_m(self, item: HandleTarget, known: SceneObject) -> float:
        """How far a part is from where something was known to be."""
        part = self.toolbox.world.scene.objects[item.part]
        return float(np.linalg.norm((part.world_T_object - known.world_T_object)[:3, 3]))


class DetectFront(DetectHandle):
    """See a front that is to be pushed shut, with or without its handle.

    An open door hides its handle from most directions, and a hand can push it without one. Drawers count for
    a robot that pushes them, small doors for none.
    """

    _by_handle: list[HandleTarget]

    def candidates(self, seen: Mapping[str, ObjectEstimate]) -> list[HandleTarget]:
        """Fronts with what they belong to, and with bars that were seen on them before."""
        pushing = self.toolbox.model.description.pushing
        pushed: list[HandleTarget] = []
        self._by_handle = []
        for one in fronts_in(seen, drawers=True):
            pushes = pushing.drawers if one.kind == DRAWER else is_pushed(seen[one.part], pushing)
            (pushed if pushes else self._by_handle).append(one)
        return with_known_bars(pushed, self.toolbox.world.scene)

    def judge(self, views: list[View]) -> Status | Failure:
        """What is meant and is not pushed is told, so that nobody looks for it elsewhere."""
        outcome = super().judge(views)
        chosen = self.optional("known") is not None
        if chosen or not isinstance(outcome, Failure) or outcome.kind is not FailureKind.POSTCONDITION:
            return outcome
        meant = those_meant_here(self.get_input("task"), self._by_handle, self.toolbox)
        if not meant:
            return outcome
        what = "a drawer" if any(one.kind == DRAWER for one in meant) else "a door so small"
        return Failure.infeasible(f"{what} is closed by its handle")
