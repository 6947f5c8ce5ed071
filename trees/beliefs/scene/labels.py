"""What the things of a planning scene are called."""

from __future__ import annotations

from kinematics.scene.label import Label
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.scenes.scene_words import COLORS
from trees.beliefs.scene.scene_update import kind_of


def split_words(words: str) -> tuple[str, str | None]:
    """Kind and colour of "red cup 2"; furniture has no colour."""
    color, _, kind = kind_of(words).partition(" ")
    return (kind, color) if kind and color in COLORS else (kind_of(words) or words, None)


def label_of(item: SceneObject) -> Label:
    """What a thing was seen to be called; of one without a label, what its name in the scene says."""
    return item.label if item.label is not None else label_in(item.name, item.movable)


def label_in(name: str, movable: bool = True) -> Label:
    """What a name of the planning scene says: kind and colour of an object, the kind of all else."""
    return Label(*split_words(name)) if movable else Label(kind_of(name))


def label_named(name: str, scene: PlanningScene) -> Label:
    """What is known of what a name in a planning scene, or in its hands, is called."""
    if name in scene.attached:
        return label_of(scene.attached[name].body)
    item = scene.objects.get(name)
    return label_in(name) if item is None else label_of(item)
