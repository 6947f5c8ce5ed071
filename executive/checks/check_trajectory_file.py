"""Judge a stored trajectory file: read it, put it into its scene, ask the checker."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from executive.errors import TrajectoryFileError
from executive.exit_codes import ExitCode
from executive.motion_file import read_motion_file
from executive.reports.check_report import CheckReport, MotionVerdict
from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.errors import TrajectoryDocumentError
from kinematics.formats.trajectory_document import StoredTrajectory, read_trajectory
from kinematics.formats.trajectory_fit import fit
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import Unsafe
from kinematics.scene.namespace import with_names_of_their_own
from kinematics.scene.planning_scene import PlanningScene
from robots.models.description import load_description
from robots.scenes.scene_file import load_scene
from robots.scenes.scene_solids import planning_scene

MAX_BYTES = 64_000_000
"""A minute of a humanoid at 500 samples a second."""


def load_trajectory(path: Path) -> StoredTrajectory:
    """Read a stored trajectory.

    Raises:
        TrajectoryFileError: File, place and reason.
    """
    return read_motion_file(path, MAX_BYTES, read_trajectory)


def check_stored(
    path: Path, robot: str | None = None, scene: str | None = None, margin_m: float = 0.0
) -> CheckReport:
    """Judge the trajectory of a file.

    Args:
        path: The file.
        robot: Name of the robot; the one that the file names when left out.
        scene: Name of a scene or path of a scene file. When left out, it is what the trajectory's own file
            says to be around, else the TOML file beside it (the same name, ``.toml``), else only the floor.
        margin_m: Distance to keep from everything in the scene, at least.

    Raises:
        TrajectoryFileError: The file, or what it names.
        RobotsError: There is no such robot or scene.
    """
    stored = load_trajectory(path)
    beside = path.with_suffix(".toml")
    if scene is None and stored.objects is None and beside.is_file():
        scene = str(beside)
    model = RobotModel(load_description(robot or stored.robot))
    _require_no_person(path, stored, scene)
    surroundings = _surroundings(stored, scene, margin_m, model)
    try:
        asked = fit(stored, model, surroundings)
    except TrajectoryDocumentError as unfit:
        raise TrajectoryFileError(path, str(unfit)) from unfit
    answer = TrajectoryChecker(model).check(asked.trajectory, asked.scene, asked.concessions)
    verdict = MotionVerdict("motion", asked.trajectory, answer)
    unsafe = isinstance(verdict.answer, Unsafe)
    return CheckReport(
        input=str(path),
        robot=model.description.name,
        scene=scene,
        outcome="unsafe" if unsafe else "safe",
        exit_code=ExitCode.UNSAFE if unsafe else ExitCode.DONE,
        message=str(verdict.answer) if unsafe else "safe: the checker found no defect",
        notes=_notes(stored, scene, surroundings, margin_m),
        motions=(verdict,),
    )


def _surroundings(
    stored: StoredTrajectory, scene: str | None, margin_m: float, model: RobotModel
) -> PlanningScene:
    if scene is not None:
        return with_names_of_their_own(planning_scene(load_scene(scene), margin_m), model)
    around = [replace(item, margin_m=max(item.margin_m, margin_m)) for item in stored.objects or ()]
    return PlanningScene().with_objects(around)


def _require_no_person(path: Path, stored: StoredTrajectory, scene: str | None) -> None:
    """Nobody may be touched because a trajectory says so."""
    named = {name for pair in stored.allowed for name in pair}
    if scene is None or not named:
        return
    for person in load_scene(scene).people:
        if person.name in named:
            raise TrajectoryFileError(path, f"allowed: {person.name!r} is a person, whom nothing may touch")


def _notes(
    stored: StoredTrajectory, scene: str | None, surroundings: PlanningScene, margin_m: float
) -> tuple[str, ...]:
    """What was taken for granted."""
    if scene is None and stored.objects is not None:
        count = len(surroundings.objects)
        around = f"scene of the file itself: {count} solids with their margins, and the floor"
    elif scene is None:
        around = "no scene was given and none lies beside the file: judged with nothing but the floor around"
    else:
        around = f"scene {scene}: {len(surroundings.objects)} solids and the floor, margin {margin_m:g} m"
    notes = [f"robot {stored.robot}", around]
    notes += [f"held: {item.name} by {item.frame}" for item in stored.held]
    if stored.allowed:
        pairs = sorted(" and ".join(sorted(pair)) for pair in stored.allowed)
        notes.append(f"may touch, because the file says so: {', '.join(pairs)}")
    if stored.concessions:
        pairs = sorted({" and ".join(one.names) for one in stored.concessions})
        notes.append(f"asked to be overlooked, as far as the checker grants it: {', '.join(pairs)}")
    return tuple(notes)
