"""Planned faults brought about in a simulated world."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from robots.scenes.planned_fault import PlannedFault
from robots.simulated.world import SimulatedWorld

_Act = Callable[[SimulatedWorld, str, tuple[float, ...]], None]

_ACTS: Mapping[str, _Act] = {
    "joint_stuck": lambda world, joint, _: world.body_faults.jam(joint),
    "joint_offline": lambda world, joint, _: world.body_faults.cut_power(joint),
    "joint_weak": lambda world, joint, values: world.body_faults.weaken(joint, values[0]),
    "encoder_offset": lambda world, joint, values: world.body_faults.offset_encoder(joint, values[0]),
    "gyro_bias": lambda world, _, values: world.body_faults.bias_gyro((values[0], values[1], values[2])),
    "battery_low": lambda world, _, values: world.body_faults.set_battery(values[0]),
    "object_gone": lambda world, name, _: world.faults.remove(name),
    "object_moved": lambda world, name, values: world.faults.displace(name, (values[0], values[1])),
    "object_knocked": lambda world, name, values: world.faults.knock(name, values[0], values[1]),
    "object_tipped": lambda world, name, values: world.faults.tip_over(name, values[0]),
    "object_slippery": lambda world, name, values: world.faults.set_pad_friction(name, values[0]),
}


def plan_fault(world: SimulatedWorld, fault: PlannedFault) -> None:
    """Let a fault happen at its time.

    Raises:
        ValueError: The robot has no such joint, or the scene no such object.
    """
    known = (
        [item.name for item in world.physics.scene.objects]
        if fault.name.startswith("object_")
        else list(world.robot.description.actuated)
    )
    if fault.target and fault.target not in known:
        raise ValueError(f"{fault.name}: no {fault.target!r} among {', '.join(known)}")
    act = _ACTS[fault.name]
    world.faults.at(fault.t_s, lambda: act(world, fault.target, fault.values))
