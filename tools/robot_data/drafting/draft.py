"""All that is drafted of a robot before its home posture and its pairs of links are looked for."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from kinematics.arrays import Array
from tools.robot_data.drafting.anatomy import Anatomy
from tools.robot_data.drafting.eyes import Eyes, eyes_of
from tools.robot_data.drafting.facing import level_turn
from tools.robot_data.drafting.guesses import Guesses
from tools.robot_data.drafting.hands import HandPlace, hand_of
from tools.robot_data.drafting.limbs import Limbs, find_limbs
from tools.robot_data.drafting.servos import Kind, kinds_of
from tools.robot_data.drafting.soles import SolePlace, sole_of

PEDESTAL_M = 0.75
"""An arm of a table is bolted to a pedestal as high as one."""
_TABLE_ARM_M = 0.45
"""A base that is lower than this, with a single arm and nothing else, is that of an arm for a table."""
_GAP_M = 0.005
_HANGS_M = 0.05
_UNDER_HANDS_M = 0.3
_LEAST_BOX_M = 0.01
_PROUD = 1.1


@dataclass(frozen=True, slots=True)
class BoxAround:
    """A box for a link that has no collision shape.

    Attributes:
        link: Whose.
        size_m: Edges.
        xyz: Its middle in the link's frame.
        drawn: Whether it is to be seen.
        instead: Whether it takes the place of the link's own shapes.
    """

    link: str
    size_m: tuple[float, float, float]
    xyz: tuple[float, float, float]
    drawn: bool = False
    instead: bool = False


@dataclass(frozen=True, slots=True)
class Draft:
    """A robot's data, but for its home posture.

    Attributes:
        anatomy, limbs: What it was made from.
        base_link, imu_link: Links.
        mount_z_m: Height of a welded base.
        reach_m: From the shoulder to the TCP, the arm stretched.
        held: Positions of the joints that nothing moves.
        hands, soles: By side.
        kinds: Of joints.
        eyes: The camera; None for none.
        boxes: For links without collision shapes, and a pedestal.
    """

    anatomy: Anatomy
    limbs: Limbs
    base_link: str
    imu_link: str | None
    mount_z_m: float
    reach_m: float
    held: dict[str, float]
    hands: dict[str, HandPlace]
    soles: dict[str, SolePlace]
    kinds: list[Kind]
    eyes: Eyes | None
    boxes: list[BoxAround]


def draft_of(path: Path, root: Path, base: str | None, guesses: Guesses) -> Draft:
    """Look at a URDF.

    Args:
        path: The file.
        root: Folder that its ``package://`` paths begin at.
        base: "floating", "welded" or None for what the legs say.
        guesses: What was guessed is added to it.

    Raises:
        DescriptionError: It is no URDF.
        ValueError: A robot without arms, or without the legs that are asked for.
    """
    anatomy = Anatomy(path, root)
    limbs = find_limbs(anatomy, guesses, base)
    turn = level_turn(anatomy, limbs)
    if not np.allclose(turn, np.eye(3)):
        anatomy.turn = turn
        guesses.add(
            "ahead and up", str(turn.astype(int).tolist()), "of the root link's axes, by legs and sides"
        )
        upright = bool(turn[2, 2] > 0.0)
        if limbs.standing and not upright:
            guesses.add("body.base", "welded", "its root link's z is not up")
        limbs = find_limbs(anatomy, guesses, base if upright else "welded")
    if (
        limbs.standing
        and base is None
        and not all(_has_shape(anatomy, limbs, side) for side in ("left", "right"))
    ):
        guesses.add("body.base", "welded", "it has two legs, and feet without a shape to stand on")
        limbs = find_limbs(anatomy, guesses, "welded")
    sides = {side: limbs.groups[f"{side}_arm"] for side in ("left", "right") if f"{side}_arm" in limbs.groups}
    hands = {side: hand_of(anatomy, limbs, arm) for side, arm in sides.items()}
    soles: dict[str, SolePlace] = {}
    if limbs.standing:
        soles = {side: sole_of(anatomy, limbs.groups[f"{side}_leg"]) for side in ("left", "right")}
    reach = max(_length(anatomy, arm, hands[side]) for side, arm in sides.items())
    held = _held(anatomy, limbs, guesses)
    boxes = _boxes(anatomy, limbs, guesses)
    mount = 0.0
    if not limbs.standing:
        mount, pedestal = _mount(anatomy, limbs, guesses)
        boxes += pedestal
    eyes = eyes_of(anatomy, limbs, anatomy.root, reach)
    for side, hand in hands.items():
        guesses.add(f"hand.tcp.{side}", f"on {hand.link}", hand.why)
    for side, sole in soles.items():
        guesses.add(
            f"sole.{side}", f"{sole.x_m} x {sole.y_m} m", "the lowest face of the foot, joints at zero"
        )
    guesses.add(
        "camera", "none" if eyes is None else eyes.frame, "the URDF has none" if eyes is None else eyes.why
    )
    imu = _imu(anatomy) if limbs.standing else None
    if limbs.standing:
        guesses.add("body.imu_link", str(imu), "a link of that name, else the base")
    if limbs.standing:
        guesses.add("body.base", "floating", "it has two legs of six hinges")
    elif all(one.key != "body.base" for one in guesses.all):
        guesses.add("body.base", "welded", "as asked" if base else "it has no two legs of six hinges")
    guesses.add("body.reach_m", f"{reach:.2f}", "the stretched arm")
    if anatomy.capsules:
        guesses.add(
            "source.capsules_as_cylinders", "true", "capsules are not judged; their ends are left out"
        )
    for name in anatomy.endless:
        if name not in held:
            guesses.add(f"limits.position.{name}", "[-pi, pi]", "it turns without end")
    return Draft(
        anatomy, limbs, anatomy.root, imu, mount, reach, held, hands, soles,
        kinds_of(anatomy, limbs, guesses), eyes, boxes,
    )  # fmt: skip


def _has_shape(anatomy: Anatomy, limbs: Limbs, side: str) -> bool:
    return len(anatomy.all_points(anatomy.subtree(limbs.groups[f"{side}_leg"][-1]))) > 0


def _length(anatomy: Anatomy, arm: tuple[str, ...], hand: HandPlace) -> float:
    places = [anatomy.place(name)[:3, 3] for name in arm]
    tcp = (anatomy.frame(hand.link) @ hand.link_T_tcp)[:3, 3]
    steps = np.diff(np.vstack([*places, tcp]), axis=0)
    return float(np.linalg.norm(steps, axis=1).sum())


def _held(anatomy: Anatomy, limbs: Limbs, guesses: Guesses) -> dict[str, float]:
    """Where held joints stand: at zero, a lift half way up; those that mimic one follow it."""
    held = {}
    for name in limbs.held:
        joint = anatomy.joints[name]
        if joint.mimics in limbs.held:
            continue
        lift = joint.kind == "prismatic" and name not in limbs.fingers
        held[name] = 0.5 * (joint.lower + joint.upper) if lift else joint.zero
        why = (
            "a lift, half way up"
            if lift
            else "a finger"
            if name in limbs.fingers
            else "in no arm, leg or neck"
        )
        guesses.add(f"held.{name}", f"{held[name]:g}", why)
    return held


def _boxes(anatomy: Anatomy, limbs: Limbs, guesses: Guesses) -> list[BoxAround]:
    moving = [None, *(name for joints in limbs.groups.values() for name in joints), *limbs.held]
    found = []
    for link in (link for name in moving for link in anatomy.links_of(name)):
        box = anatomy.link_box(link)
        fails = anatomy.hull_fails(link)
        if box is None or (anatomy.collides_with(link) and not fails):
            continue
        low, high = box
        size = np.maximum(high - low, _LEAST_BOX_M)
        found.append(BoxAround(link, _triple(size), _triple(0.5 * (low + high)), instead=fails))
        why = "a collision mesh has no convex hull" if fails else "the URDF has no collision shape"
        guesses.add(f"collision of {link}", "a box", f"{why}: around all of the link")
    return found


def _mount(anatomy: Anatomy, limbs: Limbs, guesses: Guesses) -> tuple[float, list[BoxAround]]:
    """Height of a welded base, and the pedestal of an arm for a table."""
    base = anatomy.all_points([name for name in limbs.held if name not in limbs.fingers])
    base = np.vstack([base, anatomy.points(None)])
    if not len(base):
        base = np.zeros((1, 3))
    low, high = base.min(axis=0), base.max(axis=0)
    if set(limbs.groups) == {"right_arm"} and float(high[2] - low[2]) < _TABLE_ARM_M:
        height = PEDESTAL_M - float(low[2])
        size = np.array([*(np.maximum(high - low, 0.1)[:2] * _PROUD), PEDESTAL_M - _GAP_M])
        xyz = np.array([*(0.5 * (low + high))[:2], float(low[2]) - _GAP_M - 0.5 * size[2]])
        guesses.add(
            "body.mount_xyz_m", f"[0, 0, {height:.3f}]", "an arm for a table: on a pedestal as high as one"
        )
        return height, [BoxAround(anatomy.root, _triple(size), _triple(xyz), drawn=True)]
    hanging = float(anatomy.everything()[:, 2].min())
    if hanging < float(low[2]) - _HANGS_M:
        height = _UNDER_HANDS_M - hanging
        guesses.add(
            "body.mount_xyz_m", f"[0, 0, {height:.3f}]", "its arms hang below its base: with room below them"
        )
        return height, []
    height = _GAP_M - float(low[2])
    guesses.add("body.mount_xyz_m", f"[0, 0, {height:.3f}]", "its lowest part is on the floor")
    return height, []


def _imu(anatomy: Anatomy) -> str:
    names = [str(frame.name) for frame in anatomy.model.frames]
    links = {
        name
        for name in names
        if "imu" in name.lower() and anatomy.urdf.find(f"link[@name='{name}']") is not None
    }
    return min(links) if links else anatomy.root


def _triple(values: Array) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return x, y, z
