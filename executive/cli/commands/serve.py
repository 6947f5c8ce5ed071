"""``executive serve``: live mode, until interrupted."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from executive.cli.commands.choices import (
    GROOT_PORT,
    LOOPBACK,
    REAL_PACE,
    VIEW_PORT,
    ConfidenceOption,
    ConfigOption,
    FolderOption,
    GrootOption,
    GrootPortOption,
    ModelOption,
    PerceptionOption,
    PolicyChoice,
    PolicyOption,
    RosDomainOption,
    RosInterfaceOption,
    RosNamespaceOption,
    RosOption,
    SceneOption,
    ServedPaceOption,
    ViewOption,
    ViewPortOption,
    YesOption,
    robot_name,
    whole_number_from,
)
from executive.config import (
    config_files,
    leave_opengl_to_the_renderer,
    runs_directory,
    runtime_directory,
    use_config,
)
from executive.runs.run_request import DEFAULT_ROBOT
from executive.trust import THRESHOLD, Trust


def serve(
    robot: Annotated[
        str, typer.Option(help="Name of the robot, or its folder.", callback=robot_name)
    ] = DEFAULT_ROBOT,
    scene: SceneOption = None,
    perception: PerceptionOption = None,
    seed: Annotated[
        int, typer.Option(parser=whole_number_from(0), metavar="N", help="Of everything random.")
    ] = 0,
    record: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Record the runs here, their motion too.")
    ] = None,
    pace: ServedPaceOption = REAL_PACE,
    confidence: ConfidenceOption = THRESHOLD,
    policy: PolicyOption = PolicyChoice.ASK,
    ordinary: Annotated[
        bool, typer.Option("--ordinary", help="Do not use real-time scheduling even if it is permitted.")
    ] = False,
    evaluation: Annotated[
        bool, typer.Option("--evaluation", help="Let evaluations read the simulator's truth.")
    ] = False,
    quiet: Annotated[bool, typer.Option("--quiet", help="Say nothing unless something is wrong.")] = False,
    plain: Annotated[bool, typer.Option("--plain", help="Lines, as always here.")] = False,
    ros: RosOption = False,
    ros_domain: RosDomainOption = 0,
    ros_namespace: RosNamespaceOption = "",
    ros_interface: RosInterfaceOption = LOOPBACK,
    view: ViewOption = False,
    view_port: ViewPortOption = VIEW_PORT,
    groot: GrootOption = False,
    groot_port: GrootPortOption = GROOT_PORT,
    model: ModelOption = None,
    yes: YesOption = False,
    body: Annotated[
        str | None, typer.Option(metavar="NAME", help="Attach this body in place of a simulated one.")
    ] = None,
    body_option: Annotated[
        list[str] | None, typer.Option(metavar="KEY=VALUE", help="An option of the body.")
    ] = None,
    config: ConfigOption = None,
    folder: FolderOption = None,
) -> None:
    """Serve a robot: its control in one process, the executive in another."""
    from executive.checks.machine import compile_kernel
    from executive.doors.companion import Companion
    from executive.live.caller.service import Service, ServiceRequest
    from executive.robot_settings import robot_settings
    from executive.runs.run_log import require_recordable
    from executive.runs.run_search import note_folder
    from executive.understanding.command_parser import parser_with
    from robots.models.description import load_robot_for_tasks
    from robots.models.usual_scene import usual_scene
    from robots.outside import known_scenes
    from robots.scenes.scene_file import load_scene

    del plain  # nothing is drawn here
    where = folder or runtime_directory()
    doors = {
        "the ROS bridge": _bridge(where, ros_domain, ros_namespace, ros_interface) if ros else [],
        "the page": _page(where, view_port) if view else [],
        "the monitor for Groot2": _monitor(where, groot_port) if groot else [],
        "the recorder": _recorder(where) if record is not None else [],
    }
    use_config(config)
    body_options = _body_options(body, body_option or (), perception is not None, pace, evaluation)

    if model is not None:
        from executive.doors.model.front_model import usable_model

        usable_model(model)

    def say(line: str) -> None:
        if not quiet:
            typer.echo(line, err=True)

    leave_opengl_to_the_renderer()
    machine = load_robot_for_tasks(robot)
    scene = scene or usual_scene(robot)
    seen_by = None if perception is None else perception.value
    if body is None and load_scene(scene).seen_by(seen_by).perception.kind == "rgbd":
        from robots.simulated.camera.camera_perception import require_camera

        require_camera(machine)
    if scene not in known_scenes():
        scene = str(Path(scene).absolute())  # who sends a script may be in another folder
    parser_with(config_files())  # a file of settings with a mistake is said here, not by the executive
    robot_settings(config_files())
    runs = record or runs_directory()
    require_recordable(runs)
    compile_kernel(say)
    request = ServiceRequest(
        folder=where,
        robot=robot,
        scene=scene,
        seed=seed,
        record=runs,
        pace=pace,
        realtime=not ordinary,
        evaluation=evaluation,
        trust=Trust(confidence, policy.value),
        model=model or "",
        reads_back=not yes,
        perception=seen_by,
        body=body or "",
        body_options=body_options,
    )
    note_folder(request.record)
    with contextlib.ExitStack() as beside:
        service = beside.enter_context(Service(request, say))
        for name, command in doors.items():
            if command:
                beside.enter_context(Companion(name, command, say))
        place = f"in {scene}" if body is None else f"where its body {body} is"
        say(f"{robot} stands {place}; sockets are in {where}. Ctrl-C ends it.")
        raise typer.Exit(service.watch())


def _body_options(
    body: str | None, options: Sequence[str], seen_by: bool, pace: float, evaluation: bool
) -> tuple[tuple[str, str], ...]:
    """The options of a body; what is wrong with them is said before anything is attached."""
    from executive.errors import UserError
    from robots.interface.bodies import BodyError, body_named

    if body is None:
        if options:
            raise UserError("--body-option is an option of the body that --body NAME attaches")
        return ()
    try:
        body_named(body)
    except BodyError as wrong:
        raise UserError(str(wrong)) from wrong
    simulated = {"--perception": seen_by, "--pace": pace != REAL_PACE, "--evaluation": evaluation}
    for option in (option for option, asked in simulated.items() if asked):
        raise UserError(f"{option} is for a simulated world, and the body {body} is in none")
    pairs = [option.partition("=") for option in options]
    for key, equals, _ in pairs:
        if not key or not equals:
            raise UserError(f"--body-option: expected KEY=VALUE, not {key!r}")
    return tuple((key, value) for key, _, value in pairs)


def _bridge(folder: Path, domain: int, namespace: str, interface: str) -> list[str]:
    """How the ROS bridge is started; what is wrong with its settings is said before the robot stands."""
    from executive.doors.companion import require_extra
    from executive.doors.ros.settings import RosSettings

    require_extra("ros", "cyclonedds")
    settings = RosSettings(domain, namespace, interface)
    module = "executive.doors.ros.bridge_process"
    return [sys.executable, "-m", module, str(folder), str(settings.domain), namespace, interface]


def _page(folder: Path, port: int) -> list[str]:
    """How the page is started."""
    from executive.doors.companion import OF_THE_VIEW, require_extra

    require_extra("view", *OF_THE_VIEW)
    return [sys.executable, "-m", "executive.doors.view.view_process", str(folder), str(port)]


def _monitor(folder: Path, port: int) -> list[str]:
    """How what Groot2 connects to is started."""
    from executive.doors.companion import require_extra

    require_extra("groot", "zmq", "msgpack")
    return [sys.executable, "-m", "executive.doors.groot.groot_process", str(folder), str(port)]


def _recorder(folder: Path) -> list[str]:
    """How what records motion is started; nothing, and that is said, where it is not installed."""
    from executive.doors.recorder.feed import complaint_without_extra

    if (missing := complaint_without_extra()) is not None:
        typer.echo(f"executive: {missing}", err=True)
        return []
    return [sys.executable, "-m", "executive.doors.recorder.served_recorder", str(folder)]
