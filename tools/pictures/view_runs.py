"""The runs that the pictures of the page show, each recorded in motion and read back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from executive.doors.recorder.feed import RunFeed
from executive.doors.recorder.parts import MotionParts
from executive.doors.view.motion_read import recording_in, recording_of
from executive.doors.view.recording import Moment, Recording
from executive.runs.run import perform
from executive.runs.run_log import run_in
from executive.runs.run_request import RunRequest
from executive.screens.display import NoDisplay
from executive.scripts.task_script import script_for
from executive.session.assembly import assemble
from executive.session.driver import driven
from executive.trust import USUAL_TRUST
from executive.understanding.command_parser import parse
from kinematics.formats.joint_motion import JointMotion
from robots.scenes.scene_file import load_scene
from trees.given_motion import FollowTrajectoryTask

ROBOT = "talos"


@dataclass(frozen=True, slots=True)
class Shown:
    """A run to be shown.

    Attributes:
        sentence: What is asked for.
        scene: Where.
        at_s: The moment that is shown, from the recording.
        seed: Of everything random.
    """

    sentence: str
    scene: str
    at_s: Callable[[Recording], float]
    seed: int = 0


def while_running(leaf: str, share: float) -> Callable[[Recording], float]:
    """The moment at which a share of the time of a leaf has passed."""

    def at_s(recording: Recording) -> float:
        def runs(moment: Moment) -> bool:
            return any(node["name"] == leaf and node["status"] == "running" for node in moment.nodes)

        times = [one.t_s for one in recording.moments if runs(one)]
        return times[int(share * len(times))]

    return at_s


def at_the_end(recording: Recording) -> float:
    """The last moment."""
    return recording.ends_s


MAIN_JOB = Shown("pick up the red cup on the table", "tabletop", while_running("stream reach", 0.7))
RUNS = {
    "view": MAIN_JOB,
    "view_kitchen": Shown("go to the kitchen", "flat", while_running("walk", 0.4)),
    "view_failure": Shown("pick up the green bottle on the table", "tabletop", at_the_end),
}


def recorded(shown: Shown, folder: Path) -> Recording:
    """Carry a run out, recorded in motion, and read it back."""
    said = script_for(shown.sentence, USUAL_TRUST, shown.scene)
    feed = RunFeed(NoDisplay(), print)
    request = RunRequest(
        shown.sentence,
        said.statements,
        ROBOT,
        shown.scene,
        shown.seed,
        folder,
        on_question="fail",
        perception="stub",
    )
    perform(request, feed, on_assembly=feed.begin, on_record=feed.record)
    feed.close()
    run = run_in(next(one.parent for one in sorted(folder.glob("*/run.json"))))
    if run is None:
        raise FileNotFoundError(folder)
    if not MotionParts(run.path).all():
        raise FileNotFoundError(run.path)
    return recording_of(run)


def refused(folder: Path) -> Recording:
    """A motion that somebody else has planned, into the table, after the robot has looked at it."""
    path = folder / "refused.mcap"
    feed = RunFeed(NoDisplay(), print)
    feed.open(path, {"input": "lower the left arm", "robot": ROBOT, "scene": "tabletop", "seed": "0"})
    assembly = assemble(ROBOT, load_scene("tabletop"), 0, sink=feed.event, on_tick=feed.tick)
    feed.begin(assembly)
    session, model = assembly.session, assembly.model
    (look,) = parse("count the cups on the table").commands
    session.run_task(look)
    joints = ("arm_left_1_joint", "arm_left_2_joint", "arm_left_3_joint", "arm_left_4_joint")
    now = assembly.loop.motion.reference()[7 + np.array([model.joints.index(one) for one in joints])]
    positions = np.array([now, [-0.48, 0.27, 0.14, -0.61]])
    motion = JointMotion(joints, np.array([0.0, 4.0]), positions, np.zeros_like(positions))
    driven(session.task_steps(FollowTrajectoryTask("lower the left arm", motion)))
    session.hold(0.3)
    feed.close()
    return recording_in(path)
