"""Simulation with control: how much faster than real time, and what control costs beside physics."""

from __future__ import annotations

from executive.session.assembly import Assembly, assemble
from robots.control.period import PERIOD_S
from robots.scenes.scene_file import load_scene
from tools.benchmark.figures import Figure, figure, timed_s

_ROBOT, _SCENE = "talos", "tabletop"
# Periods that are timed together: long enough that reading the clock does not count.
_BLOCK = 50


def control(quick: bool) -> list[Figure]:
    """Blocks of control periods, interleaved with blocks of physics alone in a second world."""
    scene = load_scene(_SCENE)
    ours, peer = assemble(_ROBOT, scene, 0), assemble(_ROBOT, scene, 1)
    for assembly in (ours, peer):
        assembly.session.hold(0.2)
    periods, physics = [], []
    for _ in range(40 if quick else 300):
        periods.append(timed_s(lambda: ours.session.hold(_BLOCK * PERIOD_S)) / _BLOCK)
        physics.append(timed_s(lambda: _physics_alone(peer)) / _BLOCK)
    return [
        figure(
            "times real time",
            [PERIOD_S / s for s in periods],
            "physics alone",
            [PERIOD_S / s for s in physics],
        ),
        figure("control period, us", [1e6 * s for s in periods], "physics alone", [1e6 * s for s in physics]),
    ]


def _physics_alone(assembly: Assembly) -> None:
    """The robot under its last setpoint: MuJoCo's steps and the sensors."""
    for _ in range(_BLOCK):
        assembly.world.robot.advance(PERIOD_S)
