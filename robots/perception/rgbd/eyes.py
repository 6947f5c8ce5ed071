"""From a picture to detections: surfaces, things on them, what they are, and how sure that is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from robots.perception.detector import Detection, PerceptionFrame
from robots.perception.labels.labeller import Boxes, Labeller
from robots.perception.labels.naming import namings
from robots.perception.rgbd.cloud import Cloud, cloud_of
from robots.perception.rgbd.colors import (
    Light,
    as_in_daylight,
    facing_up,
    features,
    light_of,
    name_colors,
    piece_colors,
    smoothed_tint,
)
from robots.perception.rgbd.confidence import confidences
from robots.perception.rgbd.errors import Errors
from robots.perception.rgbd.explained import Explained
from robots.perception.rgbd.furniture import find_furniture, on_map
from robots.perception.rgbd.labels import Call, by_shape, kinds, with_names
from robots.perception.rgbd.openings.find import Cabinets
from robots.perception.rgbd.people.find import SeenPerson, find_people
from robots.perception.rgbd.people.hands import held, in_hands
from robots.perception.rgbd.picture import Picture
from robots.perception.rgbd.piece import Piece
from robots.perception.rgbd.samples import Samples, sample
from robots.perception.rgbd.segments import Segments, above, segment
from robots.perception.rgbd.shapes import CUT_SHARE, Solid, apart, find_solids
from robots.perception.rgbd.solids import LEAST_M
from robots.perception.rgbd.surfaces import MOST_TILT_RAD, Surface, find_surfaces
from robots.perception.rgbd.wholes import with_wholes
from robots.scenes.articulated import PART_KINDS
from robots.scenes.furniture import FURNITURE_KINDS, WALL
from robots.scenes.furniture_names import FIXTURE
from robots.scenes.scene_description import Furniture

PICTURED_BELOW = 0.6
"""Of what is as it is told less surely than this, the picture is told as well: a person may be asked."""
_AROUND_PX = 24
LEAST_THERE = 0.65
"""What is there less surely is not told: it may be a part of something else, or the edge of a thing."""


_LEAST_IN_HAND = 0.8
"""Where there are people there are arms, and a part of one may look like a thing."""
_LARGEST_M = 0.40
"""What is wider is no thing on a surface."""


@dataclass(frozen=True, slots=True)
class Thing:
    """One thing on a surface, with everything that was measured of it.

    Attributes:
        solid: Its shape and place.
        call: Its kind.
        color: Its colour, or None.
        color_share: How sure the colour is.
        color_features: What the colour was named by.
        evidence: What its confidence was made of, see ``confidence.FEATURES``.
        pixels: How many show it.
        box: Its part of the picture: first column and row, and those after the last.
        confidence: In [0, 1]: how likely it is there, of that kind and colour, and where it is told to be.
        there: In [0, 1]: how likely it is a thing at all.
    """

    solid: Solid
    call: Call
    color: str | None
    color_share: float
    color_features: tuple[float, ...]
    evidence: tuple[float, ...]
    pixels: int
    box: tuple[int, int, int, int]
    confidence: float
    there: float


@dataclass(frozen=True, slots=True)
class Seen(InFloat64):
    """Everything that was found in a picture.

    Attributes:
        things: On surfaces.
        furniture: The solids of pieces.
        people: Everybody, the nearest first.
        surfaces: Level ones, the largest first.
        light: Of the picture.
        cloud: Its points, with the camera's tilt corrected.
        labels: Which piece of the picture each pixel belongs to.
        tilt_rad: By how much the largest surface seemed to lean.
    """

    things: tuple[Thing, ...]
    furniture: tuple[Piece, ...]
    people: tuple[SeenPerson, ...]
    surfaces: tuple[Surface, ...]
    light: Light
    cloud: Cloud
    labels: NDArray[np.int32]
    tilt_rad: float


class Eyes:
    """Finds things in pictures.

    Args:
        known: The map of the furniture, in the odometry frame, with its error.
        labeller: Who tells what shape alone cannot; nobody when left out.
        words: What it is asked for; all that it can tell when left out.
    """

    def __init__(
        self,
        known: Sequence[Furniture] = (),
        labeller: Labeller | None = None,
        words: Sequence[str] | None = None,
    ) -> None:
        self._labeller = labeller
        self._fixed = tuple(piece for piece in known if piece.opens is None)
        # walls go on beyond the picture: where the map has them they are
        self._walls = [solid for piece in known if piece.kind == WALL for solid in on_map(piece)]
        self._cabinets = Cabinets(known)
        pieces = (piece for piece in known if piece.kind != FIXTURE)
        called = (word for piece in pieces for word in (*piece.names, *piece.categories))
        self._called = frozenset(word.casefold() for word in called)
        able = () if labeller is None or labeller.words is None else sorted(labeller.words)
        self._words = tuple(able if words is None else words)

    @property
    def labels(self) -> frozenset[str] | None:
        """The words that it can tell; None: any."""
        own = kinds() | self._called | ({*FURNITURE_KINDS, *PART_KINDS, "person"} - {FIXTURE})
        if self._labeller is None:
            return own
        return None if self._labeller.words is None else own | self._labeller.words

    def look(self, picture: Picture) -> Seen:
        """Everything in a picture."""
        cloud = cloud_of(picture)
        cloud, surfaces, tilt = find_surfaces(cloud)
        light = light_of(picture.color, surfaces[0].pixels if surfaces else None)
        cabinets = self._cabinets.look(cloud)
        known = [*self._fixed, *self._cabinets.unseen]
        pieces = find_furniture(cloud, surfaces, known, cabinets)
        about = Explained(cabinets, [*(piece for piece in pieces if piece.kind == "shelf"), *self._walls])
        segments, ground = _segments(cloud, surfaces, about)
        things: tuple[Thing, ...] = ()
        if segments.count:
            samples = sample(cloud, segments, ground)
            things = tuple(self._things(cloud, segments, samples, light).values())
        people = tuple(find_people(about.without(cloud), light))
        pieces = [piece for piece in pieces if "legs" not in piece.assumed or not _is_of(people, piece)]
        things = tuple(
            thing for thing in things if not any(_holds(one, thing.solid.place_m) for one in people)
        )
        things += self._in_hands(cloud, segments, surfaces, people, light)
        return Seen(things, tuple(pieces), people, surfaces, light, cloud, segments.labels, tilt)

    def detect(self, picture: Picture, sequence: int) -> PerceptionFrame:
        """What a picture shows, as every detector tells it."""
        return as_frame(self.look(picture), picture, sequence)

    def _in_hands(
        self,
        cloud: Cloud,
        segments: Segments,
        surfaces: Sequence[Surface],
        people: Sequence[SeenPerson],
        light: Light,
    ) -> tuple[Thing, ...]:
        """What people hold out to somebody."""
        if not people:
            return ()
        others = segments.labels > 0
        for surface in surfaces:
            on = surface.pixels.repeat(2, axis=0).repeat(2, axis=1)
            others |= on | above(cloud, surface)
        tint = smoothed_tint(as_in_daylight(cloud.picture.color, light))
        found = in_hands(cloud, people, others, tint)
        if not found.segments.count:
            return ()
        samples = sample(cloud, found.segments, found.lowest_m)
        things = self._things(cloud, found.segments, samples, light)
        return tuple(
            replace(thing, call=held(thing.call))
            for number, thing in things.items()
            if thing.there >= (LEAST_THERE if found.distinct[number] else _LEAST_IN_HAND)
        )

    def _things(self, cloud: Cloud, segments: Segments, samples: Samples, light: Light) -> dict[int, Thing]:
        """By the number of the piece that each was made of, from 0 on."""
        solids, whole = find_solids(cloud, samples)
        calls = by_shape(solids)
        image = cloud.picture.color
        if self._labeller is not None:
            boxes = Boxes(samples.boxes, segments.labels)
            named = namings(self._labeller, as_in_daylight(image, light), boxes, self._words)
            calls = with_names(calls, named)
        shown = piece_colors(image, segments.labels, segments.count, facing_up(cloud, segments.labels > 0))
        values = features(shown, light)
        names, shares, off = name_colors(values)
        belief = confidences(samples, solids, calls, shares, off)
        whole &= apart(solids, np.where(whole, belief.there, 0.0))
        return {
            k: Thing(
                solid=solids[k],
                call=calls[k],
                color=names[k] if shown.used[k] > 0.0 else None,
                color_share=float(shares[k]),
                color_features=tuple(values[k].tolist()),
                evidence=tuple(belief.evidence[k].tolist()),
                pixels=int(samples.pixels[k]),
                box=tuple(samples.boxes[k].tolist()),
                confidence=float(belief.right[k]),
                there=float(belief.there[k]),
            )
            for k in range(segments.count)
            if whole[k] and not _is_huge(solids[k]) and not _is_flat(solids[k])
        }


def _is_of(people: Sequence[SeenPerson], piece: Piece) -> bool:
    """Whether a level surface that no map knows is somebody's lap, or the front of who lies."""
    return any(_holds(one, piece.odom_T_solid[:3, 3]) for one in people)


def _holds(person: SeenPerson, place_m: Array) -> bool:
    """Whether a place is within the solid around somebody."""
    local = poses.inverse(person.odom_T_person) @ np.array([*place_m, 1.0])
    if isinstance(person.shape, Box):
        return bool((np.abs(local[:2]) < 0.5 * np.array(person.shape.size_m[:2])).all())
    return bool(np.hypot(*local[:2]) < person.shape.radius_m)


def _is_huge(solid: Solid) -> bool:
    """Whether it is no thing that anybody carries about, but a part of the room."""
    shape = solid.shape
    return max(shape.size_m[:2] if isinstance(shape, Box) else (2.0 * shape.radius_m,)) > _LARGEST_M


def _is_flat(solid: Solid) -> bool:
    """Whether it is no higher than noise, or than the bottom of a cup whose wall came back nowhere."""
    return solid.shape.height_m <= LEAST_M


def _segments(cloud: Cloud, surfaces: Sequence[Surface], furniture: Explained) -> tuple[Segments, Array]:
    """The pieces on all surfaces, the highest surface first, and the height of what each stands on.

    What furniture explains, the walls about a board or a drawer's bottom, is no thing on it.
    """
    labels = np.zeros(cloud.depth_m.shape, dtype=np.int32)
    ground: list[float] = []
    if not surfaces:
        return Segments(labels, 0), np.zeros(0)
    tint = smoothed_tint(cloud.picture.color)
    for surface in sorted(surfaces, key=lambda one: -one.height_m):
        mask = furniture.left_of(cloud, above(cloud, surface) & (labels == 0))
        found = with_wholes(cloud, segment(cloud, mask, tint), surface.height_m)
        new = found.labels > 0
        labels[new] = found.labels[new] + len(ground)
        ground += [surface.height_m] * found.count
    return Segments(labels, len(ground)), np.array(ground)


def as_frame(seen: Seen, picture: Picture, sequence: int) -> PerceptionFrame:
    """Detections in the frame of the camera, as the robot believes it to be."""
    camera_T_odom = poses.inverse(picture.odom_T_camera)
    levelled = bool(seen.surfaces) and seen.tilt_rad <= MOST_TILT_RAD
    errors = Errors(picture.camera, picture.odom_T_camera, levelled)
    detections = [
        Detection(
            category="object",
            kind=thing.call.kind,
            color=thing.color,
            camera_T_object=camera_T_odom
            @ poses.transform(poses.rotation_z(thing.solid.yaw_rad), thing.solid.place_m),
            shape=thing.solid.shape,
            confidence=thing.confidence,
            names=thing.call.names,
            alike=thing.call.alike,
            error=errors.of_thing(thing.solid, thing.confidence),
            picture=_part(picture, thing) if thing.confidence < PICTURED_BELOW else None,
            cut=thing.solid.border > CUT_SHARE,
        )
        for thing in seen.things
        if thing.there >= LEAST_THERE
    ]
    detections += [
        Detection(
            category="furniture",
            kind=piece.kind,
            color=None,
            camera_T_object=camera_T_odom @ piece.odom_T_solid,
            shape=piece.shape,
            confidence=piece.confidence,
            name=piece.name,
            names=piece.names,
            categories=piece.categories,
            error=errors.of_furniture(piece),
        )
        for piece in seen.furniture
    ]
    detections += [
        Detection(
            category="person",
            kind="person",
            color=None,
            camera_T_object=camera_T_odom @ person.odom_T_person,
            shape=person.shape,
            confidence=person.confidence,
            traits=person.traits,
            error=errors.of_person(person.odom_T_person[:3, 3]),
        )
        for person in seen.people
    ]
    return PerceptionFrame(picture.stamp_s, sequence, tuple(detections), tilt_rad=seen.tilt_rad)


def _part(picture: Picture, thing: Thing) -> bytes:
    """The part of a picture that shows a thing, with a little around it, as a PNG file."""
    left, top, right, bottom = thing.box
    rows = slice(max(top - _AROUND_PX, 0), bottom + _AROUND_PX)
    columns = slice(max(left - _AROUND_PX, 0), right + _AROUND_PX)
    _, file = cv2.imencode(".png", picture.color[rows, columns, ::-1])
    return file.tobytes()
