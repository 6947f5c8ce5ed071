"""One episode: a world, a sentence, perhaps a fault, and the truth about how it ended."""

from __future__ import annotations

from executive.runs.run import frozen_heap
from executive.session.assembly import assemble
from executive.session.task_result import TaskResult, chain
from executive.understanding.command_parser import parse
from robots.simulated.camera.feed import CameraFaults
from tools.evaluate.faults import FAULTS, FaultBench, FaultState
from tools.evaluate.judge import HELD_S, Judge
from tools.evaluate.orders import EpisodeOrder, body_for
from tools.evaluate.perception.camera_faults import CAMERA_FAULTS, with_camera_fault
from tools.evaluate.phases import PhaseWatch
from tools.evaluate.records import EpisodeRecord, broken_episode
from tools.evaluate.scenes import (
    TARGET,
    episode_rng,
    episode_scene,
    read_episode_scene,
    seen_by,
    sentence_for,
)


def run_episode(order: EpisodeOrder) -> EpisodeRecord:
    """Run one episode; whatever breaks becomes its record."""
    try:
        return _run(order)
    except Exception as broken:
        return broken_episode(order, broken)


def _run(order: EpisodeOrder) -> EpisodeRecord:
    scene = read_episode_scene(episode_scene(order.seed, order.fault, order.scene), order.seed)
    scene = seen_by(scene, order.perception)
    if order.fault in CAMERA_FAULTS:
        scene = with_camera_fault(scene, order.fault, TARGET, episode_rng(order.seed, 3))
    phases = PhaseWatch()
    assembly = assemble(order.robot, scene, order.seed, sink=phases.take, drawn=False, body=body_for(order))
    truth, session = assembly.world.truth, assembly.session
    judge = Judge(truth, TARGET)
    session.watch_periods(judge.on_period)
    state = FaultState()
    if order.fault is not None and order.fault in CAMERA_FAULTS:
        faults = assembly.perception.faults
        if not isinstance(faults, CameraFaults):
            raise TypeError(f"{order.fault} is a fault of the camera: perception must be rgbd")
        CAMERA_FAULTS[order.fault](faults, episode_rng(order.seed, 4))
        state.fired = True
    elif order.fault is not None:
        rng = episode_rng(order.seed, 2)
        injector, perception = assembly.world.faults, assembly.perception
        FAULTS[order.fault](FaultBench(TARGET, scene, truth, injector, perception, phases, rng), state)
    (command,) = parse(sentence_for(scene)).commands
    with frozen_heap():
        result = session.run_task(command)
        judge.begin_hold()
        session.hold(HELD_S)
    friction = next((item.friction for item in scene.objects if item.name == TARGET), None)
    return _record(order, result, judge, state, friction)


def _record(
    order: EpisodeOrder, result: TaskResult, judge: Judge, state: FaultState, friction: float | None
) -> EpisodeRecord:
    links = chain(result.failure)
    moving_wall_s = result.times.wall_s - result.times.planning_wall_s
    compared = judge.friction is not None and friction is not None
    return EpisodeRecord(
        seed=order.seed,
        outcome=result.outcome,
        truth=judge.truly_held,
        failure_kind=links[-1].kind.value if links else None,
        failure=" ← ".join(f"{link.where}: {link.message}" if link.where else link.message for link in links)
        or None,
        attempts=result.attempts,
        fault=order.fault,
        fault_fired=state.fired,
        recoverable=state.recoverable if order.fault is not None else None,
        lift_m=judge.held_lift_m,
        slip_m=judge.slip_m,
        fell=judge.fell,
        furniture_contacts=tuple(sorted(judge.furniture_contacts)),
        others_touched=tuple(sorted(judge.others_touched)),
        com_margin_m=judge.com_margin_m,
        friction_error=abs((judge.friction or 0.0) - (friction or 0.0)) if compared else None,
        planning_ms=1e3 * result.times.planning_wall_s / max(result.attempts, 1),
        simulated_s=result.times.simulated_s,
        wall_s=result.times.wall_s,
        realtime_factor=result.times.simulated_s / moving_wall_s if moving_wall_s > 0.0 else 0.0,
    )
