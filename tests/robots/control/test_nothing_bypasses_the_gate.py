"""Whatever produces setpoints, each one that reaches the robot is one that the gate let through."""

import pytest


def let_through(rig):
    """Notes the setpoints that the gate accepts from now on."""
    gate, accepted = rig.loop._gate, []
    submit = gate.submit

    def noting(setpoint):
        refusal = submit(setpoint)
        if refusal is None:
            accepted.append(gate.last)
        return refusal

    gate.submit = noting
    return accepted


@pytest.mark.requirement("S4")
@pytest.mark.requirement("S6")
def test_arms_fingers_and_stops_reach_the_robot_through_the_gate_alone(rig, motions):
    accepted = let_through(rig)
    rig.loop.motion.start(motions.arms(rig.loop.motion.reference()))
    rig.loop.grippers["right"].close()
    rig.run(0.4)
    rig.loop.stop(2, "by the test")
    rig.run(0.4)
    rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), -0.3))
    rig.loop.grippers["right"].open()
    rig.run(0.3)
    rig.loop.emergency_stop("by the test")
    rig.run(0.6)

    assert len(rig.robot.commands) == len(accepted) == rig.loop.statistics.accepted == 850
    for sent, passed in zip(rig.robot.commands, accepted, strict=True):
        assert sent.sequence == passed.sequence
        assert sent.owner == passed.owner
        assert (sent.q == passed.q).all()
