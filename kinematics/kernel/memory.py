"""All numbers of a problem in two buffers, so that a compiled call takes them in no time.

A call of compiled code costs a fifth of a microsecond for each array that it is given. The arrays are
therefore packed behind each other, and the compiled code makes its views of them.
"""

from __future__ import annotations

from typing import NamedTuple

from kinematics.arrays import Array, Indices
from kinematics.compiled.compiler import inlined
from kinematics.compiled.pointers import floats1, floats2, floats3, ints1, ints2, ints3
from kinematics.distance.solids import Solids
from kinematics.kernel.chains import Chains
from kinematics.kernel.pairs import Pairs
from kinematics.kernel.tuning import Tuning
from kinematics.model.tree import Tree
from kinematics.standing.flat_coordinates import Coordinates, Limits


class Problem(NamedTuple):
    """Everything that does not change from question to question."""

    tree: Tree
    chains: Chains
    space: Coordinates
    limits: Limits
    solids: Solids
    pairs: Pairs
    tuning: Tuning


class Work(NamedTuple):
    """Memory of the compiled code; the separating directions outlive a question.

    Attributes:
        x, q: A point and its configuration.
        base_R: Rotation of its base.
        R, p: Poses of bodies.
        com: Centre of mass.
        needed: Whether a body has to be placed.
        ball: Centres of the bodies' balls.
        centre: Centres of the moving solids' balls.
        reach: How far each joint moves.
        moved: How far bodies move, as ``motion_bound`` writes it.
        axis: Separating direction of each pair.
        S, v: Scratch of GJK.
        first_R, first_p, second_R, second_p, R_between, p_between: Scratch of relative poses.
        open_pairs: Pairs that are open, two generations, shape (2, n).
        spans: Intervals that hold them: index, first and last open pair, whether the posture is open;
            two generations, shape (2, m, 4).
        rate: How far each joint turns or slides, with its sign, by body; NaN where it does not do so
            at one speed.
        spin: World axes of the joints, by body.
        sweep: Motion of the moving solids in the present interval, as ``motion_bound`` tells it.
        sweep_look: Number of the interval that each of them is of.
        look: Number of the present interval, shape (1,).
        away: Scratch: squared distances to the objects' boxes.
        near: Scratch: objects that are near a limb.
        direction: Scratch of a separating direction.
        drift: How the base moves in the present interval, as ``motion_bound.base_drift`` writes it.
    """

    x: Array
    q: Array
    base_R: Array
    R: Array
    p: Array
    com: Array
    needed: Indices
    ball: Array
    centre: Array
    reach: Array
    moved: Array
    axis: Array
    S: Array
    v: Array
    first_R: Array
    first_p: Array
    second_R: Array
    second_p: Array
    R_between: Array
    p_between: Array
    open_pairs: Indices
    spans: Indices
    rate: Array
    spin: Array
    sweep: Array
    sweep_look: Indices
    look: Indices
    away: Array
    near: Indices
    direction: Array
    drift: Array


class Packed(NamedTuple):
    """A problem and its memory.

    Attributes:
        floats, ints: All arrays behind each other.
        table: Begin and up to three lengths of each array, in the order of the fields, shape (n, 4).
    """

    floats: Array
    ints: Indices
    table: Indices


class Memory(NamedTuple):
    """Where a packed problem is; what compiled functions are called with.

    A call copies every array of a tuple that it is given, which for a problem and its memory takes
    two microseconds. So whoever is called makes views of its own of what it needs.

    Attributes:
        floats, ints: Addresses of the two buffers.
        table: As in ``Packed``.
    """

    floats: int
    ints: int
    table: Indices


@inlined
def problem_at(memory: Memory) -> Problem:
    """Views of the problem."""
    return _problem_in(memory.floats, memory.ints, memory.table)


@inlined
def work_at(memory: Memory) -> Work:
    """Views of the memory of the compiled code."""
    return _work_in(memory.floats, memory.ints, memory.table)


@inlined
def _problem_in(floats: int, ints: int, table: Indices) -> Problem:
    """Views of the problem, in the order of ``packing.pack``; addresses of the two buffers."""
    return Problem(
        tree=Tree(
            parent=ints1(ints, table[0]),
            kind=ints1(ints, table[1]),
            column=ints1(ints, table[2]),
            spin=ints1(ints, table[3]),
            axis=floats2(floats, table[4]),
            turned=ints1(ints, table[5]),
            place_R=floats3(floats, table[6]),
            place_p=floats2(floats, table[7]),
            mass=floats1(floats, table[8]),
            lever=floats2(floats, table[9]),
        ),
        chains=Chains(
            joint=ints2(ints, table[10]),
            length=ints1(ints, table[11]),
            limb=ints1(ints, table[12]),
            limbs=ints1(ints, table[13])[0],
            centre=floats2(floats, table[14]),
            radius=floats1(floats, table[15]),
        ),
        space=Coordinates(
            floating=ints1(ints, table[16])[0],
            columns=ints1(ints, table[17]),
            bodies=ints1(ints, table[18]),
            leg_bodies=ints2(ints, table[19]),
            hip=floats2(floats, table[20]),
            bones=floats2(floats, table[21]),
            foot_R=floats3(floats, table[22]),
            ankle=floats2(floats, table[23]),
        ),
        limits=Limits(
            lower=floats1(floats, table[24]),
            upper=floats1(floats, table[25]),
            inward=floats2(floats, table[26]),
            offset=floats1(floats, table[27]),
        ),
        solids=Solids(
            kind=ints1(ints, table[28]),
            body=ints1(ints, table[29]),
            R=floats3(floats, table[30]),
            p=floats2(floats, table[31]),
            size=floats2(floats, table[32]),
            round=floats1(floats, table[33]),
            few=ints2(ints, table[34]),
            pad=floats1(floats, table[35]),
            all=ints2(ints, table[36]),
            points=floats2(floats, table[37]),
            centre=floats2(floats, table[38]),
            radius=floats1(floats, table[39]),
            rough=ints1(ints, table[40]),
            rough_pad=floats1(floats, table[41]),
        ),
        pairs=Pairs(
            first=ints1(ints, table[42]),
            second=ints1(ints, table[43]),
            margin=floats1(floats, table[44]),
            group=ints1(ints, table[45]),
            group_first=ints1(ints, table[46]),
            group_second=ints1(ints, table[47]),
            first_level=ints1(ints, table[48]),
            second_level=ints1(ints, table[49]),
            group_margin=floats1(floats, table[50]),
            group_start=ints1(ints, table[51]),
            moving=ints1(ints, table[52])[0],
            object_margin=floats1(floats, table[53]),
            judged=ints2(ints, table[54]),
            limb_start=ints1(ints, table[55]),
            limb_bodies=ints1(ints, table[56]),
            body_start=ints1(ints, table[57]),
            body_solids=ints1(ints, table[58]),
            object_low=floats2(floats, table[59]),
            object_high=floats2(floats, table[60]),
        ),
        tuning=Tuning(
            first_reach_rad=floats1(floats, table[61])[0],
            hopeless=floats1(floats, table[62])[0],
            enough=floats1(floats, table[63])[0],
            point_step_rad=floats1(floats, table[64])[0],
            shortcut_m=floats1(floats, table[65])[0],
            shortcut_effort=floats1(floats, table[66])[0],
            shortcut_gain=floats1(floats, table[67])[0],
        ),
    )


@inlined
def _work_in(floats: int, ints: int, table: Indices) -> Work:
    """Views of the memory, in the order of ``packing.pack``; addresses of the two buffers."""
    return Work(
        x=floats1(floats, table[68]),
        q=floats1(floats, table[69]),
        base_R=floats2(floats, table[70]),
        R=floats3(floats, table[71]),
        p=floats2(floats, table[72]),
        com=floats1(floats, table[73]),
        needed=ints1(ints, table[74]),
        ball=floats2(floats, table[75]),
        centre=floats2(floats, table[76]),
        reach=floats1(floats, table[77]),
        moved=floats2(floats, table[78]),
        axis=floats2(floats, table[79]),
        S=floats2(floats, table[80]),
        v=floats1(floats, table[81]),
        first_R=floats2(floats, table[82]),
        first_p=floats1(floats, table[83]),
        second_R=floats2(floats, table[84]),
        second_p=floats1(floats, table[85]),
        R_between=floats2(floats, table[86]),
        p_between=floats1(floats, table[87]),
        open_pairs=ints2(ints, table[88]),
        spans=ints3(ints, table[89]),
        rate=floats1(floats, table[90]),
        spin=floats2(floats, table[91]),
        sweep=floats2(floats, table[92]),
        sweep_look=ints1(ints, table[93]),
        look=ints1(ints, table[94]),
        away=floats1(floats, table[95]),
        near=ints1(ints, table[96]),
        direction=floats1(floats, table[97]),
        drift=floats1(floats, table[98]),
    )
