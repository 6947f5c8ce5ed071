"""Draft a robot's folder from its URDF: groups, limits, home, base, hands, eyes, pairs that are not judged.

    python -m tools.robot_data new robot.urdf

Everything that the URDF does not tell is guessed, and every guess is listed in ``guesses.txt`` beside the
description. What stands on two legs of six hinges gets soles; every other robot is welded, its wheels and
legs held. Hands reach and do not grasp until somebody describes their fingers.
"""

from __future__ import annotations

import argparse
import contextlib
import importlib.metadata
import re
import sys
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from kinematics.errors import KinematicsError
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.support_polygon import SupportPolygon
from robots.errors import RobotsError
from robots.models.description import DISABLED_COLLISIONS, load_description
from robots.outside import DESCRIPTION
from tools.robot_data.disabled_collisions import SAMPLES, DisabledPairs, find, pairs_text
from tools.robot_data.drafting.draft import draft_of
from tools.robot_data.drafting.guesses import Guesses
from tools.robot_data.drafting.postures import NoHomeError, home_of
from tools.robot_data.drafting.text import description_text

GUESSES = "guesses.txt"
_LEVEL, _FLAT_M = 0.9999, 0.002
_CLOSE_SHARE = 0.2
"""Links with few joints between them that touch in more of all configurations than this are built so."""
_PACKAGE = "example-robot-data"
_ROOT = "cmeel.prefix/share/example-robot-data/robots"


@dataclass(frozen=True, slots=True)
class Source:
    """Where a URDF is.

    Attributes:
        path: The file.
        root: Folder that its ``package://`` paths begin at.
        keys: Of ``[source]``.
    """

    path: Path
    root: Path
    keys: Mapping[str, str]


def source_of(urdf: str) -> Source:
    """Find a URDF: a file, or one of the package example-robot-data, by its path in there.

    Raises:
        FileNotFoundError: There is none; the message names where it was looked for.
    """
    packaged = Path(str(importlib.metadata.distribution(_PACKAGE).locate_file(_ROOT))).resolve()
    path = Path(urdf).expanduser()
    if not path.is_file():
        path = packaged / urdf
    if not path.is_file():
        raise FileNotFoundError(f"no URDF {urdf!r}, neither here nor in {_PACKAGE}: {packaged}")
    path = path.resolve()
    if path.is_relative_to(packaged):
        keys = {"distribution": _PACKAGE, "root": _ROOT, "urdf": str(path.relative_to(packaged))}
        return Source(path, packaged, keys)
    packages = set(re.findall(r"package://([^/\"]+)/", path.read_text("utf-8")))
    root = next(
        (folder for folder in path.parents if all((folder / one).is_dir() for one in packages)), path.parent
    )
    return Source(path, root, {"root": str(root), "urdf": str(path.relative_to(root))})


def draft_folder(source: Source, folder: Path, base: str | None, samples: int, command: str) -> Guesses:
    """Write a robot's folder; who has legs that do not carry it is drafted once more, welded.

    Args, and what is raised and returned, as of ``draft_as``.
    """
    guesses = draft_as(source, folder, base, samples, command)
    if base is None and not _stands(_model(folder)):
        guesses = draft_as(source, folder, "welded", samples, command)
        guesses.add("body.base", "welded", "it has two legs, and no posture was found in which they carry it")
        (folder / GUESSES).write_text(guesses.text(), "utf-8")
    return guesses


def _stands(model: RobotModel) -> bool:
    """Whether a robot at home is in balance, the margin and a half inside its soles; the welded are."""
    if model.description.welded:
        return True
    stance = stance_at(model, model.q_home)
    flat = all(pose[2, 2] > _LEVEL and abs(pose[2, 3]) < _FLAT_M for _, pose in stance.soles)
    margin_m = SupportPolygon(stance, model.description.soles).com_margin_m(model.com(model.q_home)[:2])
    return flat and margin_m > 1.5 * model.description.com_margin_m


def draft_as(source: Source, folder: Path, base: str | None, samples: int, command: str) -> Guesses:
    """Write a robot's folder, whatever becomes of it.

    Args:
        source: Its URDF.
        folder: Is made.
        base: "floating", "welded" or None for what the legs say.
        samples: Random configurations for the pairs of links that are not judged.
        command: What is told to have drafted it.

    Returns:
        What was guessed; it is in the folder too.

    Raises:
        ValueError: No arm was found, or no legs where they are asked for.
        RobotsError, KinematicsError: The robot cannot be loaded even so; the message names the part.
    """
    guesses = Guesses()
    draft = draft_of(source.path, source.root, base, guesses)
    folder.mkdir(parents=True, exist_ok=True)
    zero = {
        name: draft.anatomy.joints[name].rest for joints in draft.limbs.groups.values() for name in joints
    }
    text = description_text(draft, source.keys, zero, command)
    (folder / DISABLED_COLLISIONS).unlink(missing_ok=True)
    (folder / DESCRIPTION).write_text(text, "utf-8")
    description = load_description(str(folder.resolve()))
    pairs = find(RobotModel(description), samples, seed=0, close_share=_CLOSE_SHARE)
    _write_pairs(folder, pairs, samples)
    guesses.add(
        DISABLED_COLLISIONS, f"{len(pairs.never)} pairs never near", f"in {samples} random configurations"
    )
    for first, second in pairs.by_design:
        guesses.add(
            f"{DISABLED_COLLISIONS}: {first}, {second}",
            "not judged",
            "they touch too often: built into one another?",
        )
    home = None
    try:
        home = home_of(_model(folder), np.random.default_rng(0))
    except NoHomeError as none:
        for first, second in sorted(none.always):
            guesses.add(
                f"{DISABLED_COLLISIONS}: {first}, {second}", "not judged", "they touch in every home posture"
            )
        pairs = replace(pairs, by_design=tuple(sorted({*pairs.by_design, *none.always})))
        _write_pairs(folder, pairs, samples)
        with contextlib.suppress(NoHomeError):
            home = home_of(_model(folder), np.random.default_rng(0))
    if home is None:
        guesses.add(
            "home", "joints at zero", "no posture was found that touches nothing: look at the pairs of links"
        )
    else:
        guesses.add(
            "home",
            "drawn",
            "hands ahead with room to move, touching nothing; legs bent, the CoM over the soles",
        )
        (folder / DESCRIPTION).write_text(description_text(draft, source.keys, home, command), "utf-8")
        _model(folder)
    (folder / GUESSES).write_text(guesses.text(), "utf-8")
    return guesses


def _model(folder: Path) -> RobotModel:
    return RobotModel(load_description(str(folder.resolve())))


def _write_pairs(folder: Path, pairs: DisabledPairs, samples: int) -> None:
    (folder / DISABLED_COLLISIONS).write_text(pairs_text(pairs, str(folder), samples, 0), "utf-8")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    parser.add_argument("urdf", help="a file, or the path of one in the package example-robot-data")
    parser.add_argument("--folder", type=Path, help="where; the URDF's name, here, when left out")
    parser.add_argument("--base", choices=("floating", "welded"), help="whatever its legs say")
    parser.add_argument("--samples", type=int, default=SAMPLES, help="configurations for the pairs of links")


def run(chosen: argparse.Namespace) -> int:
    """Draft it, and print what was guessed."""
    try:
        source = source_of(chosen.urdf)
        folder = chosen.folder or Path(re.sub(r"\W+", "_", source.path.stem))
        command = f"python -m tools.robot_data new {chosen.urdf}"
        guesses = draft_folder(source, folder, chosen.base, chosen.samples, command)
    except (OSError, ValueError, RobotsError, KinematicsError) as wrong:
        print(f"{chosen.urdf}: {wrong}", file=sys.stderr)
        return 2
    print(guesses.text(), end="")
    where = folder if folder.is_absolute() else Path(folder)
    print(f"\n{len(guesses.all)} guesses, also in {folder / GUESSES}. Look them through, then:")
    shown = str(where) if "/" in str(where) else f"./{where}"
    print(f"python -m tools.robot_data reach {shown}")
    return 0
