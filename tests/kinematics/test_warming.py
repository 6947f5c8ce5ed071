import pytest

from kinematics import warming
from kinematics.checking import (
    certificate as check_certificate,
)
from kinematics.checking import (
    compiled_course as check_course,
)
from kinematics.checking import (
    compiled_effort as check_effort,
)
from kinematics.checking import (
    compiled_placing as check_placing,
)
from kinematics.checking import (
    plain_limits as check_quickly,
)
from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.compiled import readiness
from kinematics.dynamics import ground_loads
from kinematics.ik import reach
from kinematics.kernel import door
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.motion_planner import MotionPlanner
from kinematics.requests.pick import PickRequest
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing import posture as compiled_configurations
from kinematics.timing import timing_kernel

USED = [
    check_certificate.certify,
    check_course.running_lengths,
    check_effort.loads_of,
    check_placing.place_all,
    check_quickly.plainly_within,
    compiled_configurations.configurations,
    ground_loads.ground_loads,
    timing_kernel.excess,
    timing_kernel.fastest_rates,
    timing_kernel.grid_times,
    timing_kernel.running_mean,
    door.ask,
    reach.reach,
]


def test_what_was_warmed_is_all_that_a_pick_and_its_checks_call(talos, stance, make):
    warming.warm(talos)
    planner, checker = MotionPlanner(talos), TrajectoryChecker(talos)
    scene = PlanningScene().with_objects([make.table(), make.cup()])

    plan = planner.answer(PickRequest(talos.q_home, stance, scene, "cup"))
    for step in (plan.reach, plan.approach, plan.lift):
        assert isinstance(checker.check(step.trajectory, step.scene, step.concessions), CheckedTrajectory)

    assert [len(function.signatures) for function in USED] == [1] * len(USED)


@pytest.mark.parametrize("there", [True, False])
def test_the_checker_takes_compiled_code_where_it_is_there(talos, monkeypatch, there):
    monkeypatch.setattr(readiness, "usable", lambda: there)

    assert (TrajectoryChecker(talos)._finder is not None) is there
