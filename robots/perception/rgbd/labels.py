"""What a thing is called by its shape alone, and what labellers add to that."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from kinematics.geometry.shapes import Cylinder
from robots.perception.labels.naming import Naming
from robots.perception.rgbd.shapes import Solid
from robots.scenes.scene_words import OBJECT_KINDS

ALIKE_BELOW = 0.85
"""A kind that is less sure than this is told with those that look alike."""


@dataclass(frozen=True, slots=True)
class Call:
    """What a thing is called.

    Attributes:
        kind: The word that fits best.
        score: In [0, 1].
        alike: Other kinds and names that look much the same, the likelier first.
        names: What it is called besides.
    """

    kind: str
    score: float
    alike: tuple[str, ...] = ()
    names: tuple[str, ...] = ()


def by_shape(solids: Sequence[Solid]) -> list[Call]:
    """The usual kinds by shape and size.

    A beaker is a cup, or a bowl where it is wide; what is round and closed is a can or, where it is tall, a
    bottle. Between the two sizes it can be either.
    """
    return [_call(solid) for solid in solids]


def kinds() -> frozenset[str]:
    """The words that shape alone can tell."""
    return frozenset(OBJECT_KINDS)


def with_names(calls: Sequence[Call], named: Sequence[Naming]) -> list[Call]:
    """Calls with what a labeller made of them: a usual kind replaces the shape's, other words are names."""
    return [_with_name(call, naming) for call, naming in zip(calls, named, strict=True)]


def _with_name(call: Call, naming: Naming) -> Call:
    kind = next((word for word in naming.names if word in OBJECT_KINDS), call.kind)
    names = tuple(word for word in naming.names if word not in OBJECT_KINDS)
    alike = () if kind != call.kind else call.alike
    maybe = tuple(word for word in naming.maybe if word != kind)
    return replace(call, kind=kind, names=names, alike=tuple(dict.fromkeys((*alike, *maybe))))


def _call(solid: Solid) -> Call:
    shape = solid.shape
    if solid.form in ("box", "crate", "ball") or not isinstance(shape, Cylinder):
        return Call("ball" if solid.form == "ball" else "box", 0.98)
    is_open = _share(solid.open_odds, 1.0)
    wide = _share(shape.radius_m - 0.75 * shape.height_m, 0.006)
    tall = _share(shape.height_m - 0.145, 0.006)
    if "top" not in solid.measured:  # it is at least so high
        tall = max(tall, 0.5)
    return _likeliest(
        {
            "cup": is_open * (1.0 - wide),
            "bowl": is_open * wide,
            "can": (1.0 - is_open) * (1.0 - tall),
            "bottle": (1.0 - is_open) * tall,
        }
    )


def _share(excess: float, width: float) -> float:
    return float(1.0 / (1.0 + np.exp(-np.clip(excess / width, -30.0, 30.0))))


def _likeliest(shares: Mapping[str, float]) -> Call:
    """The likeliest kind, with those that together with it leave little out."""
    first, *others = sorted(shares, key=lambda kind: (-shares[kind], kind))
    alike: list[str] = []
    told = shares[first]
    for kind in others:
        if told >= ALIKE_BELOW:
            break
        alike.append(kind)
        told += shares[kind]
    return Call(first, shares[first], tuple(alike))
