"""What is in a foreign scene: objects, furniture, what opens, and what was left out and why."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from kinematics.arrays import Array, Sealed
from robots.errors import CannotImportError
from robots.simulated.importing.bodies import WORLD, Foreign, label_of_body
from robots.simulated.importing.openings import Opening, opening_of

_NOTHING = ("object", "base", "body", "root", "main", "world", "link")
"""Names of bodies that say nothing of what these are."""
_IN_FLOOR_M = 0.02
"""Feet may reach so far into the floor."""


@dataclass(frozen=True, slots=True)
class FoundObject:
    """A thing that may be moved.

    Attributes:
        body: MuJoCo's index of its root.
        label: What it is called.
        bodies: All bodies of it.
        mass_kg: As the file says.
        openings: What of it opens: a lid.
    """

    body: int
    label: str
    bodies: tuple[int, ...]
    mass_kg: float
    openings: tuple[Opening, ...] = ()


@dataclass(frozen=True, slots=True)
class FoundPiece(Sealed):
    """Something that stays where it is.

    Attributes:
        body: MuJoCo's index of its root; the world's for geoms of its own.
        label: What it is called.
        bodies: Those that do not move.
        low, high: Lowest and highest corner of those along its own axes, shape (3,), m.
        yaw_rad: How its own axes are turned in the world.
        openings: Its drawers, doors, lids, knobs and buttons.
        is_nameless: Nothing in the file says what it is.
    """

    body: int
    label: str
    bodies: tuple[int, ...]
    low: Array
    high: Array
    yaw_rad: float
    openings: tuple[Opening, ...] = ()
    is_nameless: bool = False


@dataclass(frozen=True, slots=True)
class Inventory:
    """A foreign scene.

    Attributes:
        foreign: The model.
        objects, pieces: What is in it.
        left_out: Bodies that are neither, with the reason; nothing is dropped without one.
        ground_m: Height of its floor in its own world.
    """

    foreign: Foreign
    objects: tuple[FoundObject, ...]
    pieces: tuple[FoundPiece, ...]
    left_out: tuple[tuple[str, str], ...]
    ground_m: float = 0.0


def inventory_of(foreign: Foreign) -> Inventory:
    """Look through a scene, body by body from the world outwards.

    Raises:
        CannotImportError: There is nothing in it.
    """
    model = foreign.model
    driven = {int(model.jnt_bodyid[joint]) for joint in _driven_joints(foreign)}
    objects: list[FoundObject] = []
    pieces: list[FoundPiece] = []
    left_out: list[tuple[str, str]] = []
    pieces += _built_in(foreign)
    for root in _roots(foreign):
        bodies = foreign.subtree(root)
        name = foreign.name(root)
        reason = _no_thing(foreign, bodies, driven)
        if reason is not None:
            left_out.append((name, reason))
        elif foreign.is_free(root):
            objects.append(_object(foreign, root, bodies))
        else:
            piece, odd = _piece(foreign, root, bodies)
            pieces.append(piece)
            left_out += odd
    if seen := foreign.geoms([WORLD], colliding=False):
        left_out.append(("the world", f"{_counted(len(seen), 'surface')} of it, which nothing touches"))
    if not objects and not pieces:
        raise CannotImportError(f"{foreign.file}: there is nothing in it: no object, no furniture")
    return Inventory(foreign, tuple(objects), tuple(pieces), tuple(left_out), _ground_m(foreign, pieces))


def _ground_m(foreign: Foreign, pieces: list[FoundPiece]) -> float:
    """Where its floor is: the highest level plane that nothing is below; else what reaches down most."""
    lowest = min((float(piece.low[2]) for piece in pieces), default=0.0)
    plane = int(mujoco.mjtGeom.mjGEOM_PLANE)
    levels = [
        float(foreign.data.geom_xpos[k][2])
        for k in range(foreign.model.ngeom)
        if int(foreign.model.geom_type[k]) == plane and foreign.data.geom_xmat[k][8] > 0.99
    ]
    below = [level for level in levels if level <= lowest + _IN_FLOOR_M]
    return max(below, default=min(lowest, 0.0))


def _no_thing(foreign: Foreign, bodies: list[int], driven: set[int]) -> str | None:
    """Why some bodies are neither an object nor furniture; None where they are.

    A model without anything that touches, as a mesh for pictures alone, is taken by what is seen of it.
    """
    if driven & set(bodies):
        return "has motors: it is a robot, or a part of one"
    if foreign.planes(bodies):
        return "is a floor, and the floor is flat here"
    if not foreign.solid_geoms(bodies):
        return "has no solid"
    if any(int(foreign.model.body_mocapid[body]) >= 0 for body in bodies):
        return "is moved by a program: a marker"
    if foreign.led() & set(bodies):
        return "is moved by a program, by a marker that it is tied to: it is a robot, or a part of one"
    whole = range(foreign.model.nbody)
    touches = foreign.geoms(bodies, colliding=True) or not foreign.geoms(whole, colliding=True)
    if not touches and not foreign.is_free(bodies[0]):
        return "is only seen, nothing touches it"
    return None


def _counted(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def _built_in(foreign: Foreign) -> list[FoundPiece]:
    """Solids of the world itself, each a piece: a wall, a worktop."""
    found = []
    for geom in foreign.geoms([WORLD], colliding=True):
        corners = foreign.corners(geom)
        rotation = foreign.data.geom_xmat[geom].reshape(3, 3)
        yaw = float(np.arctan2(rotation[1, 0], rotation[0, 0]))
        name = str(foreign.model.geom(geom).name) or f"solid {geom}"
        own = corners @ _level_turn(yaw)
        found.append(FoundPiece(WORLD, label_of_body(name), (), own.min(axis=0), own.max(axis=0), yaw))
    return found


def _level_turn(yaw: float) -> Array:
    """What turns rows of points in the world into a frame that is turned about the vertical."""
    c, s = np.cos(yaw), np.sin(yaw)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def _driven_joints(foreign: Foreign) -> set[int]:
    """Joints that motors move, by themselves or by tendons."""
    model = foreign.model
    direct = (int(mujoco.mjtTrn.mjTRN_JOINT), int(mujoco.mjtTrn.mjTRN_JOINTINPARENT))
    found: set[int] = set()
    for motor in range(model.nu):
        kind, of = int(model.actuator_trntype[motor]), int(model.actuator_trnid[motor, 0])
        if kind in direct:
            found.add(of)
        elif kind == int(mujoco.mjtTrn.mjTRN_TENDON):
            first, count = int(model.tendon_adr[of]), int(model.tendon_num[of])
            found |= {int(model.wrap_objid[wrap]) for wrap in range(first, first + count)}
    return found


def _roots(foreign: Foreign) -> list[int]:
    """Where each thing begins: below the world, and below bodies that hold nothing but several things."""
    found: list[int] = []

    def split(body: int) -> None:
        children = foreign.children(body)
        bare = not foreign.geoms([body], True) and not foreign.geoms([body], False)
        if bare and not foreign.joints(body) and len(children) > 1 and _apart(foreign, children):
            for child in children:
                split(child)
        else:
            found.append(body)

    for child in foreign.children(WORLD):
        split(child)
    return found


def _apart(foreign: Foreign, bodies: list[int]) -> bool:
    """Whether bodies are things of their own: one moves freely, or each of several holds what moves on it."""
    if any(foreign.is_free(body) for body in bodies):
        return True
    if any(foreign.joints(body) for body in bodies):
        return False
    carriers = [body for body in bodies if any(foreign.joints(each) for each in foreign.subtree(body))]
    return len(carriers) > 1


def _object(foreign: Foreign, root: int, bodies: list[int]) -> FoundObject:
    openings = tuple(
        found
        for body in bodies[1:]
        if foreign.joints(body) and (found := opening_of(foreign, body)) is not None
    )
    mass = float(foreign.model.body_subtreemass[root])
    return FoundObject(root, label_of_body(_telling_name(foreign, root)), tuple(bodies), mass, openings)


def _piece(foreign: Foreign, root: int, bodies: list[int]) -> tuple[FoundPiece, list[tuple[str, str]]]:
    """Furniture with what opens of it; bodies of it that nothing can be told of."""
    moving = [body for body in bodies if foreign.joints(body)]
    carried = {each for body in moving for each in foreign.subtree(body)}
    fixed = [body for body in bodies if body not in carried]
    openings, odd = [], []
    for body in moving:
        if foreign.geoms(bodies, colliding=True) and not foreign.geoms(foreign.subtree(body), colliding=True):
            odd.append((foreign.name(body), "moves, but is only seen: nothing touches it"))
            continue
        opening = opening_of(foreign, body)
        if opening is None:
            odd.append((foreign.name(body), "moves by several joints, or has no solid"))
        else:
            openings.append(opening)
    solid = foreign.solid_geoms(fixed) or foreign.solid_geoms(bodies)
    corners = np.concatenate([foreign.corners(geom) for geom in solid])
    rotation = foreign.pose(root)[:3, :3]
    yaw = float(np.arctan2(rotation[1, 0], rotation[0, 0]))
    own = corners @ _level_turn(yaw)
    label = label_of_body(_telling_name(foreign, root), fixed=True)
    return (
        FoundPiece(
            root,
            label,
            tuple(fixed),
            own.min(axis=0),
            own.max(axis=0),
            yaw,
            tuple(openings),
            is_nameless=not any(_says_something(foreign.name(body)) for body in bodies),
        ),
        odd,
    )


def _telling_name(foreign: Foreign, root: int) -> str:
    """A root's name, where it says what it is; else the file's where that is all, else one below it."""
    names = [str(foreign.model.body(body).name) for body in foreign.subtree(root)]
    if _says_something(names[0]):
        return names[0]
    if len(foreign.children(WORLD)) == 1:
        return foreign.file.stem
    return next((name for name in names if _says_something(name)), foreign.file.stem)


def _says_something(name: str) -> bool:
    return bool(name) and label_of_body(name) not in _NOTHING
