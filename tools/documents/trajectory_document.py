"""What a stored trajectory says: docs/reference/trajectory.schema.json, with its reader's bounds."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from kinematics.formats.json_reader import MAX_TEXT
from kinematics.formats.solid_document import (
    MAX_CORNERS,
    MAX_ENTRIES,
    MAX_MASS_KG,
    MAX_PARTS,
    MAX_POSITION,
    MAX_SIZE_M,
    UNIT_TOLERANCE,
)
from kinematics.formats.trajectory_document import (
    MAX_DURATION_S,
    MAX_JOINTS,
    MAX_SAMPLES,
    MAX_VELOCITY,
    MIN_SPACING_S,
    SCHEMA,
)
from kinematics.scene.concessions import ConcessionReason
from tools.documents.published import Published, absent, constant

Name = Annotated[str, Field(min_length=1, max_length=MAX_TEXT)]
Length = Annotated[float, Field(gt=0.0, le=MAX_SIZE_M)]
Extent = Annotated[float, Field(ge=-MAX_SIZE_M, le=MAX_SIZE_M)]
Distance = Annotated[float, Field(ge=0.0, le=MAX_SIZE_M)]
Coordinate = Annotated[float, Field(ge=-MAX_POSITION, le=MAX_POSITION)]
Rate = Annotated[float, Field(ge=-MAX_VELOCITY, le=MAX_VELOCITY)]
Position = Annotated[list[Coordinate], Field(min_length=3, max_length=3)]
Quaternion = Annotated[
    list[Annotated[float, Field(ge=-2.0, le=2.0)]],
    Field(min_length=4, max_length=4, description=f"x, y, z, w, of length 1 within {UNIT_TOLERANCE:g}."),
]
_UNIQUE = {"uniqueItems": True}
NamePair = Annotated[list[Name], Field(min_length=2, max_length=2, json_schema_extra=_UNIQUE)]


class PoseDocument(Published):
    """A pose."""

    position_m: Position
    quaternion_xyzw: Quaternion


class PartsDocument(Published):
    """What a solid is the outline of: convex parts in its own frame, which contacts are judged by."""

    key: Name
    """Things of one key are made of the same parts."""
    corners_m: Annotated[
        list[
            Annotated[
                list[Annotated[list[Extent], Field(min_length=3, max_length=3)]],
                Field(min_length=4, max_length=MAX_CORNERS),
            ]
        ],
        Field(min_length=1, max_length=MAX_PARTS),
    ]
    """Of each part the corners x, y, z; no part is flat."""


class OutlineDocument(Published):
    """What every solid may have."""

    parts: PartsDocument = absent()
    """What it is the outline of; left out where it is solid."""


class BoxDocument(OutlineDocument):
    """A box, centred on its own frame."""

    kind: Literal["box"]
    size_m: Annotated[list[Length], Field(min_length=3, max_length=3)]


class CylinderDocument(OutlineDocument):
    """A cylinder along z, centred on its own frame."""

    kind: Literal["cylinder"]
    radius_m: Length
    height_m: Length


class BallDocument(OutlineDocument):
    """A ball, centred on its own frame."""

    kind: Literal["ball"]
    radius_m: Length


ShapeDocument = Annotated[BoxDocument | CylinderDocument | BallDocument, Field(discriminator="kind")]


class SampleDocument(Published):
    """One instant."""

    t_s: Annotated[float, Field(ge=0.0, le=MAX_DURATION_S)] = Field(
        description="Time; 0 at the first sample, then at least "
        f"{MIN_SPACING_S:g} s later than the one before."
    )
    q: Annotated[list[Coordinate], Field(min_length=7)]
    """Base position x, y, z, base quaternion x, y, z, w, then one position for each joint."""
    v: Annotated[list[Rate], Field(min_length=6)]
    """Linear, then angular velocity of the base, both in the base's own frame, then one velocity for each
    joint."""


class HeldDocument(Published):
    """An object that the robot carries."""

    name: Name
    """A scene object of this name is the same thing, and leaves the world."""
    frame: Name
    """Frame of the robot that carries it, fixed to one of its hands."""
    shape: ShapeDocument
    position_m: Position
    """Of its centre, in that frame."""
    quaternion_xyzw: Quaternion
    touch_links: Annotated[list[Name], Field(max_length=MAX_ENTRIES)] = Field(default_factory=list)
    """Links that may touch it: those that the frame is fixed to, and those of its gripper."""
    mass_kg: Annotated[float, Field(ge=0.0, le=MAX_MASS_KG)] = 0.0
    """How heavy it is; balance and efforts are judged with it. 0 when it is left out."""


class SolidDocument(Published):
    """A solid of the world."""

    name: Name
    shape: ShapeDocument
    position_m: Position
    quaternion_xyzw: Quaternion
    margin_m: Distance = 0.0
    """Distance that the robot keeps from it."""
    movable: bool = True
    """Whether it may be grasped; furniture may not."""


class ConcessionDocument(Published):
    """A pair that the motion's planner asks the checker to overlook."""

    pair: NamePair
    """A link or held object, and an object of the scene."""
    reason: ConcessionReason
    step: Name
    """During which step of a plan."""
    distance_m: Distance = absent()
    """What the pair keeps instead of the object's margin, for "starts near" alone; the others may touch."""


class TrajectoryDocument(Published):
    """A motion in time, as `executive check FILE.json` reads it. SI units: m, rad, s. All poses are in one
    frame, z up, floor at z = 0: the world frame of the scene file, or that of `objects`; unless said
    otherwise. Between two samples a joint moves as the cubic Hermite polynomial of their positions and
    velocities, the base likewise, its orientation by the normalised blend of the quaternions.
    """

    schema_: Annotated[int, constant(SCHEMA, key="schema")]
    robot: Name
    """Name of the robot, as `executive list robots` prints it."""
    joints: Annotated[list[Name], Field(max_length=MAX_JOINTS, json_schema_extra=_UNIQUE)]
    """Body joints, in the order of the columns of `q` and `v` after the base's; any order, but all of the
    robot's, without its grippers."""
    stance: Annotated[dict[str, PoseDocument], Field(max_length=MAX_ENTRIES)]
    """Where the feet stand during the whole motion: name of a sole's frame to its pose. It lies on the floor,
    and there is one at least unless the base is welded."""
    samples: Annotated[list[SampleDocument], Field(min_length=2, max_length=MAX_SAMPLES)]
    held: Annotated[list[HeldDocument], Field(max_length=MAX_ENTRIES)] = Field(default_factory=list)
    """Objects that the robot carries during the whole motion."""
    objects: Annotated[list[SolidDocument], Field(max_length=MAX_ENTRIES)] = absent()
    """What is around, in the trajectory's frame, unless a scene file is given; the floor always is. Without
    this key a scene file says it."""
    allowed: Annotated[list[NamePair], Field(max_length=MAX_ENTRIES)] = Field(default_factory=list)
    """Pairs of names that may touch and are not judged: a link of a gripper and an object, a held object and
    an object, a link and an object beside which the motion begins. Two links of the robot, and the floor,
    are refused."""
    concessions: Annotated[list[ConcessionDocument], Field(max_length=MAX_ENTRIES)] = Field(
        default_factory=list
    )
    """What the planner asks to be overlooked. The checker bounds it; a concession beyond its rules is
    a finding."""
