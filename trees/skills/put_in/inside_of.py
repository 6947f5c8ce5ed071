"""The room in what something is put into, where that is part of furniture."""

from __future__ import annotations

from kinematics.scene.planning_scene import PlanningScene
from robots.scenes.articulated import DRAWER
from trees.beliefs.grounding.destination import Place
from trees.beliefs.openings.drawer_inside import DrawerInside, inside_of_drawer, inside_of_region
from trees.beliefs.openings.handles import MEANT_BY
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure


def inside_of(place: Place, scene: PlanningScene) -> DrawerInside | Failure:
    """Measure a drawer that is open, or a compartment; why not, when nothing goes into it.

    Args:
        place: A piece of furniture, or a part of one, as it was seen.
        scene: What is believed to be around.
    """
    if MEANT_BY.get(kind_of(place.name)) == DRAWER:
        return inside_of_drawer(scene, place.name)
    if place.name not in scene.objects:
        return Failure.postcondition(f"the {place.name} is not seen where it was")
    return inside_of_region(place.name, scene)
