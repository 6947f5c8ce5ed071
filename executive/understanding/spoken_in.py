"""Where something is said: things and people of a scene have names that are understood there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager

from executive.vocabulary.in_a_place import words_of_the_place


@contextmanager
def spoken_in(scene: str | None) -> Iterator[None]:
    """Let what is said within be understood by the names of a scene's things and people, too.

    Args:
        scene: Name of a scene, or path of a scene file; None: nothing is known of the place.

    Raises:
        SceneError: There is no such scene.
    """
    # whoever only parses needs no scene
    from robots.perception.told_labels import told_fronts
    from robots.scenes.scene_description import names_of_people, spoken_words
    from robots.scenes.scene_file import load_scene

    place = None if scene is None else load_scene(scene)
    known: tuple[Iterable[str], ...] = ((),)
    if place is not None:
        known = spoken_words(place), names_of_people(place), told_fronts(place.furniture)
    with words_of_the_place(*known):
        yield
