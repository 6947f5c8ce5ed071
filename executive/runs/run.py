"""One run from its request to its report: refuse early, then move, then say what happened."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from executive.config import (
    chosen_config,
    config_files,
    leave_opengl_to_the_renderer,
    shown_directory,
)
from executive.dialogue.attendant import Attendant, Nobody
from executive.dialogue.settle_words import settled
from executive.ending_signals import EndedBySignal, taken_by, told
from executive.errors import NotWritableError
from executive.exit_codes import ExitCode
from executive.reports.report import Report
from executive.robot_settings import RobotSettings, robot_settings
from executive.runs.junit import write_junit
from executive.runs.real_pace import RealPace
from executive.runs.run_account import RunAccount, RunSubject
from executive.runs.run_log import RunLog, require_writable, write_report
from executive.runs.run_request import RunRequest
from executive.scripts.script_run import Said, not_begun, run_statements, settle_all, verdict
from executive.session.cancellation import Cancellation
from executive.session.events import Event, EventSink
from executive.understanding.spoken_in import spoken_in
from executive.understanding.statement import Statement
from kinematics.formats.trajectory_document import write_trajectory
from kinematics.formats.trajectory_fit import stored_from
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.requests.check import CheckRequest
from robots.clock import WallClock, local_time
from robots.models.description import load_robot_for_tasks
from robots.outside import known_scenes
from robots.perception.labels.labelling import Labelling
from robots.scenes.scene_description import SceneDescription
from robots.scenes.scene_file import load_scene
from trees.failures import Failure
from trees.self_knowledge import USUAL_START, Calendar

if TYPE_CHECKING:
    from executive.front.front_talk import FrontTalk
    from executive.runs.pictures import Pictures
    from executive.screens.display import Display
    from executive.session.assembly import Assembly


OnRecord = Callable[[Path, Mapping[str, Any]], Path | None]
_WAITS_S = 0.02


@dataclass(frozen=True, slots=True)
class Performance:
    """How a run ended.

    Attributes:
        line: For people.
        exit_code: Of the report; a failure as well where all was done and something that was asked for, a
            report or a picture, could not be written.
        report: What it says.
        run_name: Name of the recorded run.
        complaints: What could not be written, and who could not say what things are called.
    """

    line: str
    exit_code: ExitCode
    report: Report
    run_name: str
    complaints: tuple[str, ...] = ()


def perform(
    request: RunRequest,
    display: Display,
    attendant: Attendant | None = None,
    on_event: Callable[[Event], None] | None = None,
    cancellation: Cancellation | None = None,
    heeds_signals: bool = True,
    on_assembly: Callable[[Assembly], None] = lambda _assembly: None,
    on_record: OnRecord = lambda _folder, _header: None,
) -> Performance:
    """Carry a request out.

    A signal to end, Ctrl-C among them, cancels it: the robot brakes and holds, and all that was asked for is
    written. The second one is the emergency stop, which the robot is brought to rest by as well. Only a third
    one, for a program that does not get that far, ends the program at once.

    Args:
        request: What to do.
        display: Shows what goes on.
        attendant: Who answers questions and may cancel; nobody when left out.
        on_event: Hears of every event as well.
        cancellation: The run's cancel, where the attendant has to know of it at the questions that come
            before there is a robot.
        heeds_signals: Whether signals to end are this run's; where not, they end the program.
        on_assembly: Called with the robot and its session before the first task.
        on_record: Called with the folder of the recorded run, and what its ``run.json`` says, before anything
            else happens; tells where the newest picture of the robot's camera is to be shown, or None.

    Everything that can be wrong with it, or with the machine, is found before anything moves.

    Raises:
        UserError: An option, the scene or the machine is not good for it.
        RobotsError: The robot's or the scene's data are not.
    """
    ending = _Ending(cancellation or Cancellation())
    with taken_by(ending.take) if heeds_signals else nullcontext(), spoken_in(request.scene):
        return _performed(request, display, attendant or Nobody(), on_event, ending, on_assembly, on_record)


def _performed(
    request: RunRequest,
    display: Display,
    attendant: Attendant,
    on_event: Callable[[Event], None] | None,
    ending: _Ending,
    on_assembly: Callable[[Assembly], None],
    on_record: OnRecord,
) -> Performance:
    leave_opengl_to_the_renderer()
    settings = request.settings or robot_settings(config_files())
    request = replace(request, settings=replace(settings, begins=settings.begins or local_time()))
    scene = _preflight(request)
    labelling = _labelling(request, scene)
    pictures, display = _pictures(request, display)
    scene_path = None if request.scene in known_scenes() else Path(request.scene)
    subject = RunSubject(request.input, request.robot, request.scene, request.seed)
    header = {**subject.header(), **_header(request)}
    with RunLog(request.record, header, scene_path, request.script, chosen_config()) as log:
        slot = on_record(log.path, header)
        account = RunAccount(subject, log, display.event, *([] if on_event is None else [on_event]))
        keep = log if request.keep_trajectories else None
        results, checked, silences = _results(
            request,
            scene,
            labelling,
            attendant,
            account.hear,
            display,
            pictures,
            keep,
            ending,
            on_assembly,
            slot,
        )
        line, outcome, code = verdict(request.statements, results)
        report = account.close((line, outcome, code), results, checked)
    lacking = [] if pictures is None else list(pictures.complaints)
    lacking += _write_reports(request, report, results)
    broken_off = [] if log.complaint is None else [log.complaint]
    if code is ExitCode.DONE and (lacking or (request.keep_trajectories and broken_off)):
        code = ExitCode.FAILED
    return Performance(line, code, report, log.name, (*broken_off, *lacking, *silences))


def _header(request: RunRequest) -> dict[str, Any]:
    """What the record of a run tells of how it was asked for, beside its subject."""
    return {
        "on_question": request.on_question,
        "confidence": request.trust.threshold,
        "policy": request.trust.policy,
        **({} if request.perception is None else {"perception": request.perception}),
        **({} if request.settings is None else {"says_of_itself": request.settings.to_json()}),
        **({} if request.front is None else {"model": request.front.header()}),
        **({"faults": [fault.to_json() for fault in request.faults]} if request.faults else {}),
    }


def _write_reports(request: RunRequest, report: Report, results: Sequence[Said]) -> list[str]:
    """Write the reports that were asked for; complaints of those that cannot be: the result stands."""
    complaints = []
    if request.report is not None:
        try:
            write_report(request.report, report.to_json())
        except NotWritableError as wrong:
            complaints.append(str(wrong))
    if request.junit is not None:
        try:
            write_junit(request.junit, request.input, results)
        except NotWritableError as wrong:
            complaints.append(str(wrong))
    return complaints


def _preflight(request: RunRequest) -> SceneDescription:
    """Find what is wrong with the request before anything is built."""
    robot = load_robot_for_tasks(request.robot)
    scene = load_scene(request.scene).seen_by(request.perception)
    if scene.perception.kind == "rgbd":
        from robots.simulated.camera.camera_perception import require_camera

        require_camera(robot)
    for path in (request.report, request.snapshot, request.video, request.junit):
        if path is not None:
            require_writable(path)
    return scene


def _labelling(request: RunRequest, scene: SceneDescription) -> Labelling:
    """Who is asked what things are called: beside what was shown, a model where there is one that sees."""
    asked = request.seeing if scene.perception.kind == "rgbd" else None
    model = None if asked is None else asked()
    return Labelling(shown_directory(), packages=True, model=model, words=scene.perception.labels)


def _pictures(request: RunRequest, display: Display) -> tuple[Pictures | None, Display]:
    """What draws the run, if that was asked for, and who shows it."""
    if request.snapshot is None and request.video is None:
        return None, display
    from executive.runs.pictures import Pictures

    if not request.panel:
        return Pictures(request.snapshot, request.video), display
    from executive.screens.film_panel import FilmPanel

    panel = FilmPanel(display, f"{request.robot} in {request.scene}, seed {request.seed}")
    return Pictures(request.snapshot, request.video, panel.picture), panel


def _results(
    request: RunRequest,
    scene: SceneDescription,
    labelling: Labelling,
    attendant: Attendant,
    sink: EventSink,
    display: Display,
    pictures: Pictures | None,
    keep: RunLog | None,
    ending: _Ending,
    on_assembly: Callable[[Assembly], None],
    picture_slot: Path | None,
) -> tuple[list[Said], int, tuple[str, ...]]:
    """Run every statement; one that is not understood, and not expected so, stops all before it moves.

    Returns:
        The results, how many motions were checked, and who could not say what things are called.
    """

    def cancelled() -> Failure | None:
        return ending.cancellation.taken(0.0, sink)

    talk = _talk(request, attendant, sink, ending.cancellation, cancelled)

    def settle(said: Statement) -> Statement | Failure:
        if talk is not None and talk.takes(said):
            proposed = talk.settled(said)
            if isinstance(proposed, Failure) or proposed.parsed.question is not None:
                return proposed
            said = proposed
        return settled(said, attendant, request.on_question, sink, interruption=cancelled)

    statements, instead = settle_all(request.statements, settle, sink)
    if instead:
        return instead, 0, ()
    if (ended := cancelled()) is not None:
        return [(statements[0], [not_begun(statements[0], ended)])], 0, ()
    from executive.session.assembly import assemble, plan_faults

    def judged(asked: CheckRequest, answer: CheckedTrajectory | Unsafe) -> None:
        if keep is not None:
            safe = "safe" if isinstance(answer, CheckedTrajectory) else "unsafe"
            keep.add_motion(write_trajectory(stored_from(asked, assembly.model)), safe)

    settings = request.settings or RobotSettings()
    assembly = assemble(
        request.robot,
        scene,
        request.seed,
        sink=sink,
        on_tick=display.tick,
        on_judged=judged,
        identity=settings.identity,
        calendar=Calendar(settings.begins or USUAL_START),
        labelling=labelling,
        picture_slot=picture_slot,
        drawn=pictures is not None,
    )
    plan_faults(assembly.world, request.faults)
    on_assembly(assembly)
    attendant.begin(assembly.session)
    if (ended := cancelled()) is not None:
        return [(statements[0], [not_begun(statements[0], ended)])], 0, ()
    if pictures is not None:
        pictures.begin(assembly.world)
        assembly.session.watch_periods(pictures.tick)
    if request.in_real_time:
        assembly.session.watch_periods(RealPace(WallClock()))
    ending.emergency_stop = assembly.session.emergency_stop
    if talk is not None:
        talk.meet(assembly.session)
    with frozen_heap(), assembly.session.request(ending.cancellation):
        again = None if talk is None else talk.again
        results = run_statements(statements, assembly.session, attendant, request.on_question, sink, again)
    if pictures is not None:
        pictures.finish(assembly.world)
    return results, assembly.planning.checked, assembly.perception.silences


def _talk(
    request: RunRequest,
    attendant: Attendant,
    sink: EventSink,
    cancellation: Cancellation,
    cancelled: Callable[[], Failure | None],
) -> FrontTalk | None:
    """The talk with the model in front, where there is one."""
    if request.front is None:
        return None
    from executive.front.front_talk import FrontTalk

    wall = WallClock()

    def waiting() -> bool:
        wall.sleep(_WAITS_S)
        return cancellation.asked

    return FrontTalk(request.front, attendant.answer, sink, waiting, interruption=cancelled)


class _Ending:
    """What signals to end do to a run.

    Attributes:
        cancellation: The run's cancel: the first signal asks for it.
        emergency_stop: What the second one calls, as soon as there is a robot.
    """

    def __init__(self, cancellation: Cancellation) -> None:
        self.cancellation = cancellation
        self.emergency_stop: Callable[[str], None] | None = None
        self._count = 0

    def take(self, number: int) -> None:
        """Take one."""
        self._count += 1
        if self._count == 1:
            self.cancellation.ask(told(number, "cancelled"))
        elif self._count == 2 and self.emergency_stop is not None:
            self.emergency_stop(told(number, "stopped"))
        else:
            raise EndedBySignal(told(number, "cancelled"))


@contextmanager
def frozen_heap() -> Iterator[None]:
    """Leave everything that exists now out of collections until the end.

    Models, kernels and grammar are some hundred thousand objects that stay; looking through them again
    and again took 7 % of a pick's time.
    """
    gc.freeze()
    try:
        yield
    finally:
        gc.unfreeze()
