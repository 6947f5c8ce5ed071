"""What a thing that goes into a room can be put on there."""

from __future__ import annotations

from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.scenes.furniture_names import kind_called
from robots.scenes.scene_description import Region
from trees.beliefs.grounding.destination import furniture_named
from trees.beliefs.grounding.grounding import Ambiguous, Choice
from trees.beliefs.grounding.questions import which_is_meant
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure
from trees.skills.place.placement import SURFACES, is_flat, is_surface


def on_what(room: str, region: Region, scene: PlanningScene) -> Failure:
    """The question on what it is to be put; its choices are the furniture that was seen in the room.

    Args:
        room: Its name.
        region: Where it is on the map.
        scene: What is believed to be around.
    """

    def is_there(item: SceneObject) -> bool:
        x_m, y_m, _ = item.world_T_object[:3, 3].tolist()
        return is_flat(item) and region.contains(x_m, y_m)

    called = {kind_of(item.name) for item in scene.objects.values() if not item.movable and is_surface(item)}
    ordered = sorted(called, key=lambda words: (SURFACES.index(kind_called(words)), words))
    found = {words: filter(is_there, furniture_named(words, scene)) for words in ordered}
    largest = {words: next(tops, None) for words, tops in found.items()}
    choices = tuple(Choice(top.name, f"the {words}") for words, top in largest.items() if top is not None)
    message = f"on what in the {room} shall it be put?"
    if not choices:
        return Failure.infeasible(f"{message} nothing that things are put on was seen there")
    return which_is_meant(Ambiguous(message, choices), "on", one_will_do=True)
