"""What an executive knows of the place of a served robot before it has seen anything."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from robots.errors import SceneError
from robots.perception.place_map import place_map
from robots.scenes.scene_description import Region, names_of_people
from robots.scenes.scene_file import load_scene


def known_of(scene: str, rng: np.random.Generator) -> tuple[Mapping[str, Region], frozenset[str]]:
    """The map of the rooms, and what people are called; empty where the scene's file cannot be read here.

    Args:
        scene: Its name, or the path of its file.
        rng: Draws the errors of the map.
    """
    try:
        known = load_scene(scene)
        return place_map(known, rng), names_of_people(known)
    except SceneError:
        return {}, frozenset()
