"""Which joints are leg, arm, torso or head, and which nothing is to move: by tree, places and names."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from tools.robot_data.drafting.anatomy import Anatomy
from tools.robot_data.drafting.guesses import Guesses

_FINGER = re.compile(
    r"finger|thumb|gripper|jaw|knuckle|phalan|pinky|(?<!h)index|middle|(^|_)ring_|little|claw|allegro", re.I
)
_WHEEL = re.compile(r"wheel|caster|roller", re.I)
_LEG = re.compile(r"(^|[^a-z])leg|hip|knee|ankle|foot|thigh|shin|calf|HFE|HAA|KFE", re.I)
_ARM = re.compile(r"arm|shoulder|elbow|wrist", re.I)
_HEAD = re.compile(r"head|neck|eye|camera|pan_|tilt|skull|display", re.I)
_LEFT = re.compile(r"left|(^|_)l_|_l(_|$)|^L[A-Z]", re.ASCII)
_RIGHT = re.compile(r"right|(^|_)r_|_r(_|$)|^R[A-Z]", re.ASCII)
_MOST_OF_A_FINGER = 5
_FINGER_M = 0.2
_LEAST_OF_AN_ARM = 3
_HINGES_OF_A_LEG = 6
_NECK = 3
_TWIG = 2


@dataclass(frozen=True, slots=True)
class Limbs:
    """The joints of a robot, sorted.

    Attributes:
        groups: Joints from the body outwards by group, as ``[groups]`` names them; empty ones left out.
        held: Joints that nothing moves.
        fingers: Of these, the ones that hang on a hand.
        standing: Whether it stands on two legs of six hinges.
    """

    groups: Mapping[str, tuple[str, ...]]
    held: tuple[str, ...]
    fingers: frozenset[str]
    standing: bool


def find_limbs(anatomy: Anatomy, guesses: Guesses, base: str | None = None) -> Limbs:
    """Sort a robot's joints.

    Args:
        anatomy: The robot's.
        guesses: What was guessed is added to it.
        base: "welded" holds the legs of who could stand; "floating" asks for legs.

    Raises:
        ValueError: There is no arm, or no legs where they are asked for.
    """
    fingers = _fingers(anatomy)
    held = {name for name, joint in anatomy.joints.items() if _held_anyway(anatomy, name)} | fingers
    hinges = [name for name in anatomy.joints if name not in held]
    held |= _twigs(anatomy, hinges)
    hinges = [name for name in hinges if name not in held]
    ends = [name for name in hinges if not any(one in hinges for one in anatomy.subtree(name)[1:])]
    ways = {end: [name for name in anatomy.way(end) if name in hinges] for end in ends}
    shared = {name for name in hinges if sum(name in way for way in ways.values()) > 1}
    chains = [[name for name in way if name not in shared] for way in ways.values()]
    sorts: dict[str, list[list[str]]] = {"leg": [], "arm": [], "head": [], "none": []}
    for chain in chains:
        sorts[_sort(anatomy, chain, alone=len(chains) == 1)].append(chain)
    if not sorts["arm"]:
        sorts["arm"] = [chain for chain in sorts["none"] if len(chain) >= _LEAST_OF_AN_ARM]
    arms = sorted(sorts["arm"], key=len, reverse=True)[:2]
    if not arms:
        raise ValueError("no arm was found: no chain of three hinges or more that is neither leg nor neck")
    legs = [chain[:_HINGES_OF_A_LEG] for chain in sorts["leg"] if len(chain) >= _HINGES_OF_A_LEG]
    standing = len(sorts["leg"]) == 2 and len(legs) == 2 and base != "welded"
    if base == "floating" and not standing:
        raise ValueError(f"{len(legs)} legs of six hinges were found; to stand takes two")
    groups: dict[str, tuple[str, ...]] = {}
    if standing:
        groups |= _sides(anatomy, "leg", legs)
    carrying = {name for arm in arms for name in anatomy.way(arm[0])}
    torso = [name for name in hinges if name in shared and name in carrying]
    groups["torso"] = tuple(torso)
    groups |= _sides(anatomy, "arm", arms)
    heads = sorted(sorts["head"], key=len, reverse=True)[:1]
    groups["head"] = tuple(heads[0]) if heads else ()
    moved = {name for members in groups.values() for name in members}
    rest = tuple(name for name in anatomy.joints if name not in moved)
    for group, members in groups.items():
        if members:
            guesses.add(f"groups.{group}", ", ".join(members), "by the tree of joints, places and names")
    return Limbs(
        {group: members for group, members in groups.items() if members}, rest, frozenset(fingers), standing
    )


def _held_anyway(anatomy: Anatomy, name: str) -> bool:
    joint = anatomy.joints[name]
    if joint.kind not in ("revolute", "continuous") or joint.mimics is not None or joint.lower >= joint.upper:
        return True
    turns_a_wheel = (
        joint.kind == "continuous" and len(anatomy.subtree(name)) <= _TWIG and len(anatomy.way(name)) <= _TWIG
    )
    return turns_a_wheel or bool(_WHEEL.search(name) or _WHEEL.search(joint.link))


def _fingers(anatomy: Anatomy) -> set[str]:
    """Joints of hands: by name, or several short chains at the end of a long one, or joints that slide."""
    found: set[str] = set()
    for name, joint in anatomy.joints.items():
        if name in found:
            continue
        depth = len(anatomy.way(name)) - 1
        named = bool(_FINGER.search(name)) and _small(anatomy, name)
        siblings = [one for one in anatomy.children(joint.parent) if _small(anatomy, one)]
        grown = depth >= _LEAST_OF_AN_ARM + 1 and len(siblings) > 1 and name in siblings
        if depth >= _LEAST_OF_AN_ARM and (named or grown or joint.kind == "prismatic"):
            found |= set(anatomy.subtree(name))
    return found


def _small(anatomy: Anatomy, name: str) -> bool:
    subtree = anatomy.subtree(name)
    points = anatomy.all_points(subtree)
    away = np.linalg.norm(points - anatomy.place(name)[:3, 3], axis=1)
    return len(subtree) <= _MOST_OF_A_FINGER and (not len(away) or float(away.max()) < _FINGER_M)


def _twigs(anatomy: Anatomy, hinges: list[str]) -> set[str]:
    """Ends of a chain that part into several of one or two joints: eyes, sensors."""
    found: set[str] = set()
    for name in [None, *hinges]:
        children = [one for one in anatomy.children(name) if one in hinges]
        short = all(
            len([one for one in anatomy.subtree(child) if one in hinges]) <= _TWIG for child in children
        )
        if name is not None and len(children) > 1 and short:
            found |= {one for child in children for one in anatomy.subtree(child)}
    return found


def _sort(anatomy: Anatomy, chain: list[str], *, alone: bool) -> str:
    names = [*chain, *(anatomy.joints[name].link for name in chain)]
    if not chain:
        return "none"
    if alone:
        return "arm"
    said = {
        sort: sum(bool(pattern.search(name)) for name in names)
        for sort, pattern in (("leg", _LEG), ("arm", _ARM), ("head", _HEAD))
    }
    best = max(said, key=lambda sort: said[sort])
    if said[best] > 0 and not (best == "head" and len(chain) > _NECK + 1):
        return best if best != "arm" or len(chain) >= _LEAST_OF_AN_ARM else "none"
    heights = anatomy.everything()[:, 2]
    low, high = float(heights.min()), float(heights.max())
    end = float(min(*anatomy.all_points(chain)[:, 2], *(anatomy.place(name)[2, 3] for name in chain)))
    if end < low + 0.1 * (high - low) and len(chain) >= _LEAST_OF_AN_ARM:
        return "leg"
    if len(chain) <= _NECK:
        return "head" if float(anatomy.place(chain[-1])[2, 3]) > low + 0.7 * (high - low) else "none"
    return "arm"


def _sides(anatomy: Anatomy, limb: str, chains: list[list[str]]) -> dict[str, tuple[str, ...]]:
    """By side: as the names say, else the one with the greater y is left; a single arm is the right."""
    if len(chains) == 1:
        return {f"right_{limb}": tuple(chains[0])}
    said = [sum(bool(_LEFT.search(name)) - bool(_RIGHT.search(name)) for name in chain) for chain in chains]
    aside = [float(anatomy.place(chain[0])[1, 3] + anatomy.place(chain[-1])[1, 3]) for chain in chains]
    order = sorted(range(2), key=lambda k: (-said[k], -aside[k]))
    return {f"left_{limb}": tuple(chains[order[0]]), f"right_{limb}": tuple(chains[order[1]])}
