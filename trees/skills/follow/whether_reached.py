"""Whether somebody is where a task says that it ends."""

from __future__ import annotations

import numpy as np

from kinematics.walking.route.path_planning import footprints
from trees.beliefs.grounding.destination import furniture_named
from trees.tasks import Destination, ObjectDescription
from trees.toolbox import Toolbox


def has_reached(toolbox: Toolbox, to: Destination, at: tuple[float, float], near_m: float) -> bool:
    """Whether a place on the floor is in a room, or near to a piece of furniture or a person.

    What is neither on the map nor was seen is not reached.

    Args:
        toolbox: Knows the map and what is believed.
        to: Where the task ends.
        at: The place, in the odometry frame, m.
        near_m: So near to what stands somewhere is there.
    """
    word = (to.name or to.kind or "") if isinstance(to, ObjectDescription) else str(to)
    region = toolbox.places.get(word)
    if region is not None:
        return region.contains(*at)
    scene = toolbox.world.scene
    named = [item for item in scene.objects.values() if item.name.casefold() == word.casefold()]
    found = named or furniture_named(word, scene)
    there = footprints(scene.with_objects(found))
    return any(float(one.distance_m(np.array([at]))[0]) <= near_m for one in there)
