"""Where something is said: things and people of a scene have names that are understood there."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from executive.vocabulary.in_a_place import words_of_the_place

if TYPE_CHECKING:
    from robots.scenes.scene_description import SceneDescription


@contextmanager
def spoken_in(scene: str | SceneDescription | None) -> Iterator[None]:
    """Let what is said within be understood by the names of a scene's things and people, too.

    Args:
        scene: It, its name, or the path of its file; None: nothing is known of the place.

    Raises:
        SceneError: There is no such scene.
    """
    # whoever only parses needs no scene
    from robots.perception.told_labels import told_fronts
    from robots.scenes.scene_description import names_of_people, spoken_words
    from robots.scenes.scene_file import load_scene

    if scene is None:
        known = words_of_the_place(())
    else:
        place = load_scene(scene) if isinstance(scene, str) else scene
        known = words_of_the_place(spoken_words(place), names_of_people(place), told_fronts(place.furniture))
    with known:
        yield
