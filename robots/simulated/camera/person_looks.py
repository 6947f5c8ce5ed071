"""What people look like to a camera: a face and hair, shoes, hands, and arms as long as arms are.

The mannequin that the robot could touch keeps its arms close, so that its outline holds them all; a gesture
is in the picture alone.
"""

from __future__ import annotations

from collections.abc import Sequence

import mujoco

from robots.scenes.scene_description import Person
from robots.simulated.body.geom_roles import WORLD_GROUP, in_simulator
from robots.simulated.body.person_model import HEAD_M, SKIN, has_hand, limbs, pad_geom, posed, worn

Point = tuple[float, float, float]
HAIR, DARK = (0.16, 0.10, 0.07, 1.0), (0.10, 0.09, 0.09, 1.0)
_SHOULDER_M = (0.0, 0.19, 1.40)
"""Of the left; the right one is its mirror image."""
_ARMS: dict[str, tuple[Point, Point]] = {
    "raising": ((0.04, 0.23, 1.67), (0.06, 0.21, 1.93)),
    "waving": ((0.03, 0.42, 1.46), (0.07, 0.52, 1.72)),
    "pointing": ((0.02, 0.46, 1.40), (0.04, 0.74, 1.42)),
}
"""Elbow and hand of a left arm, by the first word of a gesture."""
_UPPER_M, _FORE_M, _HAND_M = 0.048, 0.040, 0.042
_HANGING_M = (0.02, -0.21, 0.84)
_ELBOW_M = (0.0, -0.21, 1.08)
_LEFT_HAND_M = (0.0, 0.17, 0.82)


def add_person_looks(spec: mujoco.MjSpec, person: Person) -> set[str]:
    """Draw what the mannequin lacks; tells which of its solids are not to be drawn."""
    look = _Look(spec, person)
    look.head()
    look.shoes()
    look.shoulders()
    side, arm = _gesture(person)
    hidden = set()
    if side != "right":  # the mannequin's right arm is up where nothing is said of it
        hidden.add(f"{person.name}/{len(limbs(person)) - 1}")
        look.limb("right upper arm", _UPPER_M, (0.0, -0.19, 1.40), _ELBOW_M)
    if side != "left":
        look.ball("left hand", _LEFT_HAND_M, _HAND_M)
    if side != "right" and not has_hand(person):
        look.limb("right forearm", _FORE_M, _ELBOW_M, _HANGING_M)
        look.ball("right hand", _HANGING_M, _HAND_M)
    if arm is None:
        return hidden
    sign = 1.0 if side == "left" else -1.0
    shoulder, elbow, hand = ((x, sign * y, z) for x, y, z in (_SHOULDER_M, *arm))
    look.limb("upper arm", _UPPER_M, shoulder, elbow)
    look.limb("lower arm", _FORE_M, elbow, hand)
    look.ball("hand", hand, _HAND_M)
    number = len(limbs(person)) - (2 if side == "left" else 1)
    hidden.add(f"{person.name}/{number}")
    if not keeps_forearm(person):
        mark = in_simulator("")
        pads = {pad_geom(person.name, one).removeprefix(mark) for one in ("upper", "lower")}
        hidden |= {f"{person.name}/palm"} | pads
    return hidden


def keeps_forearm(person: Person) -> bool:
    """Whether the hand that takes things is to be seen: not while its arm does something else."""
    return not (has_hand(person) and _gesture(person)[0] == "right")


def _gesture(person: Person) -> tuple[str, tuple[Point, Point] | None]:
    """Which arm does something, and where its elbow and hand are."""
    if person.gesture is None:
        return "", None
    verb = person.gesture.partition(" ")[0]
    return "right" if "right" in person.gesture else "left", _ARMS[verb]


class _Look:
    """Adds solids that are drawn, and touch nothing, to a person."""

    def __init__(self, spec: mujoco.MjSpec, person: Person) -> None:
        self._body, self._person = spec.body(in_simulator(person.name)), person

    def head(self) -> None:
        """Hair that leaves the face free, eyes, and a nose."""
        x, y, z = HEAD_M
        self.ellipsoid("hair", (x - 0.026, y, z + 0.022), (0.105, 0.114, 0.108), HAIR)
        self.ellipsoid("nose", (x + 0.112, y, z - 0.012), (0.018, 0.014, 0.022), SKIN)
        for name, side in (("left eye", 1.0), ("right eye", -1.0)):
            self.ellipsoid(name, (x + 0.096, y + side * 0.040, z + 0.018), (0.014, 0.014, 0.014), DARK)

    def shoulders(self) -> None:
        """What joins the arms, and the neck."""
        self.limb("shoulders", 0.055, (0.0, -0.17, 1.40), (0.0, 0.17, 1.40))
        neck = self._geom("neck", mujoco.mjtGeom.mjGEOM_CAPSULE, (0.05, 0.0, 0.0), SKIN)
        neck.fromto = [*posed(self._person, (0.0, 0.0, 1.40)), *posed(self._person, (0.0, 0.0, 1.58))]

    def shoes(self) -> None:
        """Toes that point where the person faces."""
        forward = 0.28 if self._person.posture == "sitting" else 0.05
        for name, side in (("left shoe", 1.0), ("right shoe", -1.0)):
            if self._person.posture == "sitting":
                place = (forward, side * 0.09, 0.04)
                self._solid(name, place, (0.13, 0.05, 0.04), DARK)
            else:
                self.ellipsoid(name, (forward, side * 0.10, 0.04), (0.13, 0.05, 0.04), DARK)

    def limb(self, name: str, radius: float, start: Point, end: Point) -> None:
        """A part of an arm, in its sleeve."""
        geom = self._geom(
            name, mujoco.mjtGeom.mjGEOM_CAPSULE, (radius, 0.0, 0.0), worn(self._person, legs=False)
        )
        geom.fromto = [*posed(self._person, start), *posed(self._person, end)]

    def ball(self, name: str, place: Point, radius: float) -> None:
        """A hand."""
        geom = self._geom(name, mujoco.mjtGeom.mjGEOM_SPHERE, (radius, 0.0, 0.0), SKIN)
        geom.pos = list(posed(self._person, place))

    def ellipsoid(self, name: str, place: Point, half: Point, color: Sequence[float]) -> None:
        """Something of who stands, wherever the posture has it."""
        lies = self._person.posture == "lying"
        self._solid(name, posed(self._person, place), half[::-1] if lies else half, color)

    def _solid(self, name: str, place: Point, half: Point, color: Sequence[float]) -> None:
        geom = self._geom(name, mujoco.mjtGeom.mjGEOM_ELLIPSOID, half, color)
        geom.pos = list(place)

    def _geom(
        self, name: str, kind: mujoco.mjtGeom, size: Sequence[float], color: Sequence[float]
    ) -> mujoco.MjsGeom:
        return self._body.add_geom(
            name=in_simulator(f"{self._person.name}/{name}"),
            type=kind,
            size=list(size),
            rgba=list(color),
            mass=0.0,
            contype=0,
            conaffinity=0,
            group=WORLD_GROUP,
        )
