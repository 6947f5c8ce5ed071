"""Recall where something is that stays where it is, or that this robot put down itself."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import SceneObject
from robots.perception.detector import Category
from trees.beliefs.grounding.destination import Place, aim_of, place_believed, words_of
from trees.beliefs.grounding.furniture_called import called_so, others_like
from trees.beliefs.grounding.grounding import Found, ground
from trees.beliefs.scene.labels import label_of, words_besides
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.readings.odometry import what_is_around
from trees.tasks import Destination, ObjectDescription
from trees.toolbox import Toolbox


class RecallPlace(Leaf):
    """Take from the world model, without a look, where a piece of furniture or a person was last seen.

    The same goes for an object that this robot has put down. The robot then goes there and looks again. Other
    objects are recalled only with ``anything``, as a last resort, since somebody may have moved them.
    """

    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports(place=Place)
    CONTRACT = Contract(
        precondition="none",
        postcondition="furniture or a person of that name, where it was last seen; or the only thing that "
        "this robot put down, or of anything that was seen, that fits, where it was last seen or let go of",
        deadline_s=1.0,
    )
    ASKS = True

    def __init__(
        self,
        name: str,
        toolbox: Toolbox,
        wiring: Mapping[str, str] | None = None,
        *,
        anything: bool = False,
    ) -> None:
        super().__init__(name, toolbox, wiring)
        self._anything = anything

    def step(self) -> Status | Failure:
        """Look it up."""
        aim = aim_of(self.get_input("task"))
        wanted = (aim.name or aim.kind) if isinstance(aim, ObjectDescription) else str(aim)
        world = self.toolbox.world
        fixed = {name: item for name, item in world.scene.objects.items() if not item.movable}
        called = words_besides((name, label_of(item)) for name, item in fixed.items())
        meant = called_so(wanted, called) if wanted is not None else frozenset()
        if meant:
            item = fixed[min(meant)]
            return self.recall(item, "furniture" if isinstance(item.shape, Box) else "person")
        seen = {name: item for name, item in world.scene.objects.items() if item.movable}
        for pool in (world.put_down, seen if self._anything else {}):
            if (thing := self._only(aim, pool)) is not None:
                return self.recall(thing, "object")
        others = others_like(wanted or "", map(kind_of, fixed))
        return Failure.postcondition(f"no {words_of(aim)} seen, now or before{others}")

    def recall(self, item: SceneObject, category: Category) -> Status | Failure:
        """Tell the place of what fits."""
        self._set_output("place", place_believed(item, category))
        self.feedback_message = f"{item.name} where it was {'put' if category == 'object' else 'seen'}"
        return DONE

    def _only(self, aim: Destination | None, pool: Mapping[str, SceneObject]) -> SceneObject | None:
        """The only one of some things that fits; None when there is none, or several."""
        world = self.toolbox.world
        if isinstance(aim, str):
            return pool.get(aim)
        if not isinstance(aim, ObjectDescription):
            return None
        scene = world.scene.with_objects([*world.scene.objects.values(), *pool.values()])
        around = what_is_around(self.toolbox, scene)
        match ground(aim, around.only(tuple(pool))):
            case Found((name,)):
                return pool[name]
            case _:
                return None
