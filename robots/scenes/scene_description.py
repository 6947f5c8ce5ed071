"""A scene as values: the world's truth, from which the simulator is built.

Read from a TOML file by ``robots.scenes.scene_file``; evaluations make random ones directly. The robot is
told nothing of it but what it perceives. World frame: z up, floor at z = 0, origin at the robot's
nominal start, x ahead, y to its left. Lengths in m, angles in rad, masses in kg.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import Literal

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Shape
from robots.scenes.fixed_camera import FixedCamera
from robots.scenes.fixture import Control, FixedBox
from robots.scenes.furniture_names import own_name
from robots.scenes.light import Light
from robots.scenes.meshes.object_model import ObjectModel
from robots.scenes.named_region import NamedRegion
from robots.scenes.opening import Opening
from robots.scenes.scene_words import ANY_LABEL, COLORS

Posture = Literal["standing", "sitting", "lying"]
POSTURES: tuple[Posture, ...] = ("standing", "sitting", "lying")
PERCEPTION_KINDS = ("stub", "rgbd")
"""A stub that reads the simulator's truth and spoils it, or the robot's own camera."""
GESTURES = ("waving", "raising left arm", "raising right arm", "pointing left", "pointing right")
"""What a person may do with the arms; the sides are the person's own."""


@dataclass(frozen=True, slots=True)
class RobotStart:
    """Where the robot really stands at the beginning; it does not know."""

    x_m: float = 0.0
    y_m: float = 0.0
    yaw_rad: float = 0.0


@dataclass(frozen=True, slots=True)
class PerceptionModel:
    """Which perception the robot has, and the declared errors of the stub.

    Attributes:
        kind: "stub", or "rgbd" for what the robot's own camera shows; its errors are the robot's data.
        bias_m: Standard deviation, each axis, of an error drawn once for each solid and episode.
        calibration_m: The same of an error that all things of one camera share, drawn once an episode.
        noise_m: The same, drawn anew for each frame.
        orientation_noise_rad: Of the rotation vector, each axis, each frame.
        size_noise: Relative standard deviation of estimated sizes, drawn once an episode.
        dropout: Chance that a visible solid is missing from a frame.
        latency_s: From picture to delivery.
        rate_hz: Frames a second.
        false_rate: Mean number of detections a frame of things that are not there.
        merge_distance_m: Two objects whose surfaces are nearer than this may be seen as one.
        merge_chance: Chance of it, drawn each frame.
        min_visible: Share of an object's surface points that must be in sight.
        trait_dropout: Chance that a person's posture, gesture or piece of clothing is not told in a frame.
        labels: Words that it can tell besides those of the scene's things; "any" among them makes it open.
    """

    kind: str = "stub"
    bias_m: float = 0.005
    noise_m: float = 0.002
    orientation_noise_rad: float = 0.005
    size_noise: float = 0.01
    dropout: float = 0.02
    latency_s: float = 0.05
    rate_hz: float = 30.0
    false_rate: float = 0.02
    merge_distance_m: float = 0.004
    merge_chance: float = 0.05
    min_visible: float = 0.25
    labels: tuple[str, ...] = ()
    trait_dropout: float = 0.1
    calibration_m: float = 0.0


@dataclass(frozen=True, slots=True)
class MovingPart:
    """The door of a fridge, or the top drawer of a chest of drawers.

    Attributes:
        hinge: On which side a door hangs, seen by who stands before it; None for a drawer.
        mass_kg: Of the moving part.
        friction: Of the hinge, Nm, or of the slide, N.
        seal_n: Pull at the handle that a magnetic seal resists with while a door is nearly closed.
        locked: It does not open.
        opening: How far it is open when the scene begins, rad or m.
        handle_height_m: Of the bar's middle: above the floor on a door, above the front's middle on a drawer.
        handle_inset_m: From the free edge of a door to the bar.
        handle_radius_m, handle_length_m: Of the bar.
        handle_friction: Effective, with the finger pads.
    """

    hinge: Literal["left", "right"] | None
    mass_kg: float
    friction: float
    seal_n: float = 0.0
    locked: bool = False
    opening: float = 0.0
    handle_height_m: float = 1.0
    handle_inset_m: float = 0.06
    handle_radius_m: float = 0.0125
    handle_length_m: float = 0.36
    handle_friction: float = 0.9


@dataclass(frozen=True, slots=True)
class Furniture:
    """A piece of furniture: a table, or something that opens (see ``robots.scenes.articulated``).

    ``size_m`` is depth along its own x, width along y, and the height of the top above the floor;
    ``position_m`` is its centre on the floor; ``opens`` is its door or drawer, if it has one. Of a fixture
    (see ``robots.scenes.fixture``) ``foot_m`` is the height of its underside, ``boxes`` what it is made of
    where that is not one box, ``controls`` are its knobs and buttons, and ``openings`` its doors and drawers.
    ``regions`` are parts with names. ``names`` and ``categories`` are what people call it besides its kind
    and its name, and what it belongs to.
    """

    name: str
    kind: str
    size_m: tuple[float, float, float]
    position_m: tuple[float, float]
    yaw_rad: float = 0.0
    friction: float = 0.7
    opens: MovingPart | None = None
    foot_m: float = 0.0
    boxes: tuple[FixedBox, ...] = ()
    controls: tuple[Control, ...] = ()
    openings: tuple[Opening, ...] = ()
    regions: tuple[NamedRegion, ...] = ()
    names: tuple[str, ...] = ()
    categories: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class SceneItem(Sealed):
    """A movable object with its pose in the world.

    Attributes:
        name: Its name in the scene; a name of its own ("tomato soup") is told by perception, one that says
            colour and kind ("red cup 2") is not.
        kind: What it is: "cup", or any other word.
        color: One of ``scene_words.COLORS``, or None.
        shape: Its solid.
        mass_kg, friction: Of the whole.
        world_T_object: Its pose, shape (4, 4).
        wall_m: Thickness of walls and bottom of a box or bowl that is hollow and open at the top.
        names: What it is called besides, the usual name first.
        categories: What sorts of things it belongs to.
        texture: File of the picture that is on it, around a can and on the sides of a box, or None.
        mesh: File of the mesh that it was made of, or None.
        model: What was made of that; ``shape`` is its outline then.
    """

    name: str
    kind: str
    color: str | None
    shape: Shape
    mass_kg: float
    friction: float
    world_T_object: Transform
    wall_m: float | None = None
    names: tuple[str, ...] = ()
    categories: tuple[str, ...] = ()
    texture: str | None = None
    mesh: str | None = None
    model: ObjectModel | None = None


@dataclass(frozen=True, slots=True)
class Person:
    """A person who is somewhere, or walks about.

    Attributes:
        name: What the person is called.
        position_m: Where the person is, or begins to walk.
        yaw_rad: Where the person faces; of who lies, from the feet to the head.
        takes: Whether the person takes what the robot offers.
        posture: How the person is.
        gesture: What the person does with the arms, one of ``GESTURES``, or None.
        clothes: What can be seen of them, each with its colour: "red shirt".
        way_m: Points that the person walks to one after the other, and stays at the last one.
        speed_m_s: Of the walk.
        starts_s: Simulated time at which it begins.
        follows: Whether the person walks behind the robot, once it has been near, instead of going a way.
    """

    name: str
    position_m: tuple[float, float]
    yaw_rad: float
    takes: bool = False
    posture: Posture = "standing"
    gesture: str | None = None
    clothes: tuple[str, ...] = ()
    way_m: tuple[tuple[float, float], ...] = ()
    speed_m_s: float = 0.4
    starts_s: float = 0.0
    follows: bool = False

    @property
    def walks(self) -> bool:
        """Whether the person may be elsewhere later on."""
        return bool(self.way_m) or self.follows


@dataclass(frozen=True, slots=True)
class Region:
    """A part of the floor that has a name: "kitchen".

    Attributes:
        name: What people call it.
        position_m: Its middle.
        size_m: Along its own x and y.
        yaw_rad: Its x is where somebody faces who has come in.
    """

    name: str
    position_m: tuple[float, float]
    size_m: tuple[float, float]
    yaw_rad: float = 0.0

    def contains(self, x_m: float, y_m: float) -> bool:
        """Whether a place on the floor is in it."""
        c, s = math.cos(self.yaw_rad), math.sin(self.yaw_rad)
        dx, dy = x_m - self.position_m[0], y_m - self.position_m[1]
        return abs(c * dx + s * dy) <= 0.5 * self.size_m[0] and abs(c * dy - s * dx) <= 0.5 * self.size_m[1]


@dataclass(frozen=True, slots=True)
class SceneDescription:
    """Everything in the world but the robot's body."""

    name: str
    robot_start: RobotStart = field(default_factory=RobotStart)
    perception: PerceptionModel = field(default_factory=PerceptionModel)
    furniture: tuple[Furniture, ...] = ()
    objects: tuple[SceneItem, ...] = ()
    people: tuple[Person, ...] = ()
    places: tuple[Region, ...] = ()
    light: Light = field(default_factory=Light)
    cameras: tuple[FixedCamera, ...] = ()

    def seen_by(self, kind: str | None) -> SceneDescription:
        """The same scene with another perception, "stub" or "rgbd"; None leaves it as the scene says."""
        if kind is None:
            return self
        return replace(self, perception=replace(self.perception, kind=kind))


def told_names(name: str, kind: str, names: Iterable[str]) -> tuple[str, ...]:
    """The names that a detector which knows the thing tells, the usual one first.

    A scene's own name for a thing counts, if it says more than colour, kind and a number: "tomato soup", and
    not "red can 2". A colour alone is a noun there: "orange".

    Args:
        name: As the scene has it.
        kind: "can".
        names: What the scene says that it is called besides.
    """
    said = name.casefold().rstrip("0123456789 ").split()
    own = " ".join([word for word in said if word not in COLORS] or said)  # an orange is orange
    given = tuple(" ".join(one.split()) for one in names)
    if not own or own == kind.casefold() or own in {one.casefold() for one in given}:
        return given
    return (*given, " ".join(name.rstrip("0123456789 ").split()))


def spoken_words(scene: SceneDescription) -> frozenset[str]:
    """What the things of a scene may be called: kinds, names and sorts, and what is declared besides."""
    words = {word for word in scene.perception.labels if word.casefold() != ANY_LABEL}
    for item in scene.objects:
        words |= {item.kind, *told_names(item.name, item.kind, item.names), *item.categories}
    for piece in scene.furniture:
        words |= {*filter(None, [own_name(piece.name, piece.kind)]), *piece.names, *piece.categories}
        words |= {region.name for region in piece.regions}
    return frozenset(words)


def names_of_people(scene: SceneDescription) -> frozenset[str]:
    """What the people of a scene are called."""
    return frozenset(person.name for person in scene.people)
