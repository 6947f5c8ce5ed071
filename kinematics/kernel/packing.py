"""Put a problem's numbers into two buffers: what stays the same for many scenes is laid out once."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.distance.solids import Solids
from kinematics.kernel.buffers import Buffers
from kinematics.kernel.chains import Chains
from kinematics.kernel.memory import Packed, Problem, Work
from kinematics.kernel.pairs import Carriers, OwnPairs, Pairs
from kinematics.kernel.tuning import Tuning
from kinematics.model.tree import Tree
from kinematics.standing.flat_coordinates import Coordinates, Limits

Value = Array | Indices | int | float
Parts = tuple[Array | Indices, ...]
"""Arrays that are one, behind each other."""

# Room for pairs that are open at once, and for intervals of an edge.
_OPEN_PAIRS = 32768
_SPANS = 4096
# Lists of whole numbers that questions read before they write them; the others are a question's own.
_LASTING_LISTS = ("needed", "sweep_look", "look", "near")

_FIELDS = {
    "tree": Tree._fields,
    "chains": Chains._fields,
    "space": Coordinates._fields,
    "limits": Limits._fields,
    "solids": Solids._fields,
    "pairs": Pairs._fields,
    "tuning": Tuning._fields,
}


def _rows_of(name: str) -> list[int]:
    """Rows of the table that a part of a problem has."""
    before = Problem._fields[: Problem._fields.index(name)]
    begin = sum(len(_FIELDS[part]) for part in before)
    return list(range(begin, begin + len(_FIELDS[name])))


_PAIR_ROWS = dict(zip(Pairs._fields, _rows_of("pairs"), strict=True))
_GIVEN = _rows_of("tuning")[-1] + 1
FIXED_ROWS = [*_rows_of("tree"), *_rows_of("space"), *_rows_of("limits"), *_rows_of("tuning")]
CARRIED_ROWS = [
    *_rows_of("chains"),
    *(_PAIR_ROWS[name] for name in (*OwnPairs._fields, *Carriers._fields)),
]
_AROUND = ("object_margin", "judged", "object_low", "object_high")
_SOLID_ROWS = dict(zip(Solids._fields, _rows_of("solids"), strict=True))
HULL_ROWS = [_SOLID_ROWS["points"]]
SCENE_SOLIDS = tuple(name for name in Solids._fields if name != "points")
"""What a scene adds to; the vertices of its hulls come behind the robot's."""
SCENE_ROWS = [
    *(_SOLID_ROWS[name] for name in SCENE_SOLIDS),
    *(_PAIR_ROWS[name] for name in _AROUND),
]
_LASTING = [_GIVEN + Work._fields.index(name) for name in _LASTING_LISTS]
JUDGED_ROW = _PAIR_ROWS["judged"]


class Block(NamedTuple):
    """Some arrays of a collision problem, one behind the other in two buffers, as compiled code takes them.

    Attributes:
        floats, ints: The two buffers.
        table: Of each array, where it begins in its buffer and up to three lengths, shape (n, 4).
        are_floats: In which of the two buffers each of them is, shape (n,).
        rows: Which rows of a problem's table they are, shape (n,).
    """

    floats: Array
    ints: Indices
    table: Indices
    are_floats: Indices
    rows: Indices


def block(values: Iterable[Value | Parts], rows: Sequence[int]) -> Block:
    """Lay out arrays, numbers, and arrays that come in parts; ``rows`` says which of a problem they are."""
    floats: list[Array | Indices] = []
    ints: list[Array | Indices] = []
    table, are_floats = [], []
    ends = [0, 0]
    for value in values:
        parts = value if isinstance(value, tuple) else (np.atleast_1d(value),)
        first = parts[0]
        is_float = first.dtype.kind == "f"
        length = sum([len(part) for part in parts])
        table.append((ends[is_float], length, *first.shape[1:], 0, 0)[:4])
        are_floats.append(is_float)
        ends[is_float] += sum([part.size for part in parts])
        (floats if is_float else ints).extend([part.ravel() for part in parts])
    return Block(
        np.concatenate(floats) if floats else np.empty(0),
        np.concatenate(ints) if ints else np.empty(0, np.int64),
        np.array(table, np.int64).reshape(-1, 4),
        np.array(are_floats, np.int64),
        np.array(rows, np.int64),
    )


# A block of no arrays: its buffers are a part of those of the block before.
_NO_INTS = np.empty(0, np.int64)
_NO_ROWS = np.empty((0, 4), np.int64), _NO_INTS, _NO_INTS


class Sizes(NamedTuple):
    """The numbers that say how much memory the compiled collision judge needs.

    Attributes:
        bodies: Bodies of the kinematic tree.
        depth: The longest chain of joints between a body and the world.
        free: Free coordinates of a point.
        nq: Numbers of a configuration.
        moving, objects: Solids that move with the robot, and those of the scene.
        own_pairs: Pairs of solids that both move with the robot.
    """

    bodies: int
    depth: int
    free: int
    nq: int
    moving: int
    objects: int
    own_pairs: int


def pack(hulls: Block, vertices: Array, blocks: Sequence[Block], sizes: Sizes, buffers: Buffers) -> Packed:
    """Put a whole problem and the memory for it into two buffers; what outlives a question is zero.

    Args:
        hulls: The vertices that the buffers begin with already.
        vertices: Those that come behind them, shape (n, 3), m.
        blocks: All the rest.
        sizes: Of the memory.
        buffers: Where the two come from.
    """
    table = np.empty((_GIVEN + len(Work._fields), 4), np.int64)
    begins = np.zeros(2, np.int64)
    more = Block(vertices.ravel(), _NO_INTS, *_NO_ROWS)
    for part in (hulls, more, *blocks):
        table[part.rows] = part.table
        table[part.rows, 0] += begins[part.are_floats]
        begins += len(part.ints), len(part.floats)
    table[HULL_ROWS, 1] += len(vertices)
    ints, floats = begins.tolist()
    more_floats, more_ints = _lay_out_memory(sizes, floats, ints, table)
    packed = Packed(*buffers.take(more_floats, more_ints), table)
    np.concatenate([part.floats for part in (more, *blocks)], out=packed.floats[len(hulls.floats) : floats])
    np.concatenate([part.ints for part in blocks], out=packed.ints[:ints])
    packed.floats[floats:more_floats] = 0.0
    for begin, *lengths in table[_LASTING].tolist():
        packed.ints[begin : begin + math.prod(filter(None, lengths))] = 0
    return packed


def _lay_out_memory(sizes: Sizes, floats: int, ints: int, table: Indices) -> tuple[int, int]:
    """Write the rows of the memory; tell how long the buffers are with it."""
    n, depth, free, nq, moving, objects, own_pairs = sizes
    count = own_pairs + objects * moving
    float_shapes: dict[str, tuple[int, ...]] = {
        "x": (free,),
        "q": (nq,),
        "base_R": (3, 3),
        "R": (n, 3, 3),
        "p": (n, 3),
        "com": (3,),
        "ball": (n, 3),
        "centre": (moving, 3),
        "reach": (n,),
        "moved": (n, depth + 1),
        "axis": (count, 3),
        "S": (4, 3),
        "v": (3,),
        "first_R": (3, 3),
        "first_p": (3,),
        "second_R": (3, 3),
        "second_p": (3,),
        "R_between": (3, 3),
        "p_between": (3,),
        "rate": (n,),
        "spin": (n, 3),
        "sweep": (moving, 7),
        "away": (objects,),
        "direction": (3,),
        "drift": (8,),
    }
    int_shapes: dict[str, tuple[int, ...]] = {
        "needed": (n,),
        "open_pairs": (2, max(_OPEN_PAIRS, count)),
        "spans": (2, _SPANS, 4),
        "sweep_look": (moving,),
        "look": (1,),
        "near": (objects,),
    }
    for number, name in enumerate(Work._fields, _GIVEN):
        if name in float_shapes:
            shape = float_shapes[name]
            table[number] = (floats, *shape, 0, 0, 0)[:4]
            floats += math.prod(shape)
        else:
            shape = int_shapes[name]
            table[number] = (ints, *shape, 0, 0, 0)[:4]
            ints += math.prod(shape)
    return floats, ints
