"""What an errand goes by: what is believed of the world, where the robot is, and what its hands hold."""

from __future__ import annotations

from dataclasses import replace

from executive.errands.nearness import Nearness, is_away, is_near
from executive.errands.other_furniture import named_other, with_other_furniture_named
from executive.errands.prepared import Known
from executive.errands.required import puts_on
from executive.meaning import Command
from executive.references import references
from trees.beliefs.grounding.grounding import Found, ground
from trees.beliefs.openings.drawer_inside import DrawerInside, inside_of_drawer
from trees.beliefs.openings.fridge_inside import LEAST_OPEN_RAD, door_opening_rad
from trees.beliefs.scene.believed_thing import Surroundings
from trees.beliefs.scene.held_object import HeldObject
from trees.readings.held import held_object
from trees.readings.odometry import base_pose, body_pose, what_is_around
from trees.tasks import Bringing, ObjectDescription, ObjectOf
from trees.toolbox import Toolbox


class ErrandBeliefs:
    """What an errand believes of the world, read from the toolbox's world model each time it is asked."""

    def __init__(self, toolbox: Toolbox) -> None:
        self._toolbox = toolbox

    def note_where_asked(self) -> None:
        """An errand begins here; "the other table" is not the one before the robot now."""
        self._toolbox.world.asked_at = base_pose(self._toolbox)
        self._toolbox.world.sent_to = None

    def known(self) -> Known:
        """What makes steps of an errand needless, or needed."""
        toolbox = self._toolbox
        opening = door_opening_rad(toolbox.world.scene)
        return Known(
            self._in_view,
            lambda task: isinstance(held_object(toolbox, task.object, task.hand), HeldObject),
            opening is not None and opening >= LEAST_OPEN_RAD,
            self._is_near,
            frozenset(toolbox.places),
            self._stood_on,
            is_away(body_pose(toolbox)),
            isinstance(inside_of_drawer(toolbox.world.scene), DrawerInside),
        )

    def with_other_furniture_named(self, command: Command) -> Command:
        """A command whose "other" furniture is named, if it is known by now which one that is."""
        leaves = self._stood_on(command) if puts_on(command) else None
        return with_other_furniture_named(command, self.around(), leaves)

    def around(self) -> Surroundings:
        """What is believed to be around the robot."""
        return what_is_around(self._toolbox)

    def _is_near(self, wanted: Nearness) -> bool:
        if references(wanted.thing):  # what an earlier task is about is not known before that has ended
            return False
        around = self.around()
        wanted = replace(wanted, thing=named_other(wanted.thing, around))
        return is_near(wanted, around, self._toolbox.world.scene, base_pose(self._toolbox))

    def _stood_on(self, task: Bringing) -> str | None:
        """What the object of a task stood on before it came into a hand."""
        held = held_object(self._toolbox, task.object, task.hand)
        origins = self._toolbox.world.taken_from
        return origins[held.name].support if isinstance(held, HeldObject) and held.name in origins else None

    def _in_view(self, pick: Bringing) -> bool:
        """Whether what is to be taken is believed to be where it is said to be."""
        if not isinstance(pick.object, ObjectDescription) or isinstance(pick.source, ObjectOf):
            return False
        return isinstance(ground(pick.object, self.around(), pick.source, pick.count), Found)
