"""The same planner and checker for robots of other kinds: a welded arm, a small humanoid."""

import dataclasses

import numpy as np
import pytest

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.collision.collision_world import CollisionWorld
from kinematics.collision.validity import SampledValidity
from kinematics.errors import KinematicsError, MissingPartError
from kinematics.formats.trajectory_document import read_trajectory, write_trajectory
from kinematics.formats.trajectory_fit import fit, stored_from
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.ik.placo_ik import PlacoIk
from kinematics.ik.result import DEFAULT_TOLERANCE, IkTolerance
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance, stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.model.support_polygon import SupportPolygon
from kinematics.motion.curves import PolynomialCurve
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory, FindingKind, Unsafe
from kinematics.planning.path_planner import PathPlanner, PathSettings
from kinematics.requests.check import CheckRequest
from kinematics.scene.planning_scene import FLOOR, PlanningScene, SceneObject
from kinematics.standing.free_coordinates import FreeCoordinates
from kinematics.timing.curve_timing import Pace, time_curve
from robots.models.description import load_description

NO_STANCE = Stance(())
# the cubics between samples overshoot a velocity that is held, by some 1e-4
PACE = Pace(velocity=0.95)


def box(name, size_m, x, y, z):
    return SceneObject(name, Box(size_m), poses.translation(x, y, z), margin_m=0.01, movable=False)


@pytest.fixture(scope="module")
def panda():
    """Panda, bolted to the floor."""
    return RobotModel(dataclasses.replace(load_description("panda"), mount_xyz_m=(0.0, 0.0, 0.0)))


@pytest.fixture(scope="module")
def among_boxes():
    return PlanningScene().with_objects(
        [
            box("pillar", (0.2, 0.2, 0.5), 0.5, 0.3, 0.25),
            box("crate", (0.15, 0.3, 0.3), 0.4, -0.45, 0.5),
            box("shelf", (0.3, 0.6, 0.03), 0.6, 0.0, 0.35),
        ]
    )


@pytest.fixture(scope="module")
def panda_space(panda):
    return FreeCoordinates(StandingRobot(panda, NO_STANCE))


@pytest.fixture(scope="module")
def panda_checker(panda):
    return TrajectoryChecker(panda)


def planner_of(model, space, stance, scene, iterations=2000):
    world = CollisionWorld(model, scene, extra_margin_m=0.004, self_margin_m=0.005)
    judge = SampledValidity(StandingRobot(model, stance), world)
    return PathPlanner(model, space, judge, PathSettings(iterations=iterations))


def free_points(planner, low, high, count, seed):
    rng, found = np.random.default_rng(seed), []
    while len(found) < count:
        x = rng.uniform(low, high)
        if planner.is_free(x):
            found.append(x)
    return found


def at_rest(model, q, duration_s=0.4, stance=NO_STANCE):
    """A trajectory that holds one configuration."""
    t = np.linspace(0.0, duration_s, 5)
    return Trajectory(model.joints, stance, t, np.tile(q, (5, 1)), np.zeros((5, model.nv)))


def kinds(verdict):
    assert isinstance(verdict, Unsafe), "accepted"
    return {finding.kind for finding in verdict.findings}


def test_a_welded_arm_has_its_joints_as_free_coordinates(panda, panda_space):
    x = panda_space.from_q(panda.q_home)

    q, reached = panda_space.to_q(np.array([x, x + 0.1]))

    assert panda_space.size == 7
    assert reached.all()
    assert np.array_equal(q[0], panda.q_home)
    assert np.array_equal(q[1, :7], panda.q_home[:7])
    assert q[1, 7:] == pytest.approx(panda.q_home[7:] + 0.1)


@pytest.mark.requirement("U4", "S6")
def test_a_welded_arm_moves_between_random_postures_among_boxes(
    panda, panda_space, panda_checker, among_boxes
):
    planner = planner_of(panda, panda_space, NO_STANCE, among_boxes)
    points = free_points(planner, panda.lower_rad + 0.02, panda.upper_rad - 0.02, 20, seed=0)
    rng, detours = np.random.default_rng(1), 0

    for start, goal in zip(points[::2], points[1::2], strict=True):
        curve = planner.plan(start, goal, list(range(7)), rng)
        assert curve is not None
        detours += planner.straight(start, goal) is None
        trajectory = time_curve(StandingRobot(panda, NO_STANCE), curve, PACE)
        verdict = panda_checker.check(trajectory, among_boxes)
        assert isinstance(verdict, CheckedTrajectory), str(verdict)
        assert panda_space.from_q(trajectory.q[0]) == pytest.approx(start, abs=1e-9)
        assert panda_space.from_q(trajectory.q[-1]) == pytest.approx(goal, abs=1e-9)
        assert verdict.min_com_margin_m == np.inf

    assert detours >= 2  # both ways of planning were used


def test_a_welded_arm_that_turns_its_last_joint_alone_keeps_the_others_still(panda, panda_space):
    start = panda_space.from_q(panda.q_home)
    goal = start + np.eye(7)[6] * 0.5

    trajectory = time_curve(StandingRobot(panda, NO_STANCE), PolynomialCurve(np.stack([start, goal])), PACE)

    assert np.abs(trajectory.q[:, :13] - panda.q_home[:13]).max() < 1e-12
    assert np.ptp(trajectory.q[:, 13]) == pytest.approx(0.5)


def test_planner_and_checker_agree_about_a_welded_arm(panda, panda_space, panda_checker, among_boxes):
    world = CollisionWorld(panda, among_boxes)
    rng = np.random.default_rng(3)
    margin = 0.02
    seen = {True: 0, False: 0}

    for x in rng.uniform(panda.lower_rad + margin, panda.upper_rad - margin, (80, 7)):
        q = panda_space.to_q(x[None, :])[0][0]
        collides = world.collides(q)
        contacts = {FindingKind.SELF_COLLISION, FindingKind.SCENE_COLLISION}
        verdict = panda_checker.check(at_rest(panda, q), among_boxes)
        found = isinstance(verdict, Unsafe) and bool(kinds(verdict) & contacts)
        assert found == collides, str(verdict)
        seen[collides] += 1

    assert min(seen.values()) >= 10


def test_an_arm_on_the_floor_may_stand_on_it_and_not_reach_into_it(panda, panda_checker):
    scene = PlanningScene()
    low = panda.q_home.copy()
    low[7:] = (0.0, 1.75, 0.0, -0.2, 0.0, 1.6, 0.0)

    assert panda.frame_pose(low, "tcp_right")[2, 3] < 0.0
    pair = CollisionWorld(panda, scene).colliding_pair(low)
    assert pair is not None
    assert FLOOR in pair
    assert FindingKind.SCENE_COLLISION in kinds(panda_checker.check(at_rest(panda, low), scene))
    assert not CollisionWorld(panda, scene).collides(panda.q_home)
    assert isinstance(panda_checker.check(at_rest(panda, panda.q_home), scene), CheckedTrajectory)


@pytest.mark.requirement("S6")
@pytest.mark.parametrize(
    ("column", "by", "subject"),
    [(0, 0.005, ("panda_link0",)), (2, -0.005, ("panda_link0",)), (4, 0.01, ("panda_link0", "orientation"))],
)
def test_a_welded_base_that_is_not_at_its_mount_is_found(panda, panda_checker, column, by, subject):
    q = panda.q_home.copy()
    q[column] += by
    q[3:7] /= np.linalg.norm(q[3:7])

    verdict = panda_checker.check(at_rest(panda, q), PlanningScene())

    assert FindingKind.STANCE in kinds(verdict)
    assert subject in [finding.subject for finding in verdict.findings]


@pytest.mark.requirement("S6")
def test_a_welded_base_that_strays_between_two_samples_is_found(panda, panda_checker):
    still = at_rest(panda, panda.q_home)
    v = still.v.copy()
    v[1:3, 1] = (0.2, -0.2)

    verdict = panda_checker.check(dataclasses.replace(still, v=v), PlanningScene())

    assert FindingKind.STANCE in kinds(verdict)


@pytest.mark.requirement("S6")
def test_a_load_that_is_too_heavy_for_a_welded_arm_is_an_effort_finding(panda):
    weak = {name: dataclasses.replace(limit, effort=5.0) for name, limit in panda.description.limits.items()}
    model = RobotModel(dataclasses.replace(panda.description, limits=weak))

    verdict = TrajectoryChecker(model).check(at_rest(model, model.q_home), PlanningScene())

    assert kinds(verdict) == {FindingKind.EFFORT_LIMIT}


def test_an_arm_mounted_on_a_table_plans_and_is_judged_there(panda):
    mounted = dataclasses.replace(
        panda.description, mount_xyz_m=(0.3, -0.2, 0.7), mount_rpy_rad=(0.0, 0.0, np.pi / 2)
    )
    model = RobotModel(mounted)
    table = box("table", (0.6, 0.8, 0.7), 0.3, -0.2, 0.349)
    scene = PlanningScene().with_objects([table]).allowing([("panda_link0", "table")])
    space = FreeCoordinates(StandingRobot(model, NO_STANCE))
    planner = planner_of(model, space, NO_STANCE, scene)
    start = space.from_q(model.q_home)
    goal = start.copy()
    goal[0] = 1.2

    curve = planner.plan(start, goal, list(range(7)), np.random.default_rng(0))
    trajectory = time_curve(StandingRobot(model, NO_STANCE), curve, PACE)

    assert isinstance(TrajectoryChecker(model).check(trajectory, scene), CheckedTrajectory)
    assert model.frame_pose(model.q_home, "panda_link0")[:3, 3] == pytest.approx([0.3, -0.2, 0.7])
    ahead = model.frame_pose(model.q_home, "tcp_right")[:3, 3] - [0.3, -0.2, 0.7]
    assert ahead == pytest.approx([0.0, panda.frame_pose(panda.q_home, "tcp_right")[0, 3], 0.487], abs=1e-3)
    assert FindingKind.STANCE in kinds(TrajectoryChecker(panda).check(trajectory, scene))


def test_the_hand_of_a_welded_arm_is_brought_to_poses_with_its_base_in_place(panda):
    ik = PlacoIk(StandingRobot(panda, NO_STANCE), "right")
    rng = np.random.default_rng(0)

    for _ in range(20):
        q = panda.q_home.copy()
        posture = q[7:] + rng.normal(0.0, 0.4, 7)
        q[7:] = np.clip(posture, panda.lower_rad + 0.02, panda.upper_rad - 0.02)
        wanted = panda.frame_pose(q, "tcp_right")
        result = ik.solve(wanted, panda.q_home)
        assert result.within(IkTolerance())
        assert np.array_equal(result.q[:7], panda.q_home[:7])
        assert panda.frame_pose(result.q, "tcp_right") == pytest.approx(wanted, abs=3e-3)


def test_a_hand_that_the_robot_does_not_have_is_named(panda):
    with pytest.raises(MissingPartError, match="panda has no left hand"):
        PlacoIk(StandingRobot(panda, NO_STANCE), "left")


def test_a_welded_robot_cannot_tip_and_one_on_its_feet_cannot_stand_on_nothing(panda, talos):
    polygon = SupportPolygon(NO_STANCE, panda.description.soles)

    assert polygon.com_margin_m(np.array([9.0, 9.0])) == np.inf
    assert np.all(polygon.margins_m(np.array([[9.0, 9.0], [0.0, 0.0]])) == np.inf)
    with pytest.raises(KinematicsError):
        SupportPolygon(NO_STANCE, talos.description.soles)


def test_the_stance_of_a_welded_robot_is_empty_and_its_base_at_the_mount(panda):
    q = panda.q_home.copy()
    q[:3] = (1.0, 2.0, 3.0)

    assert stance_at(panda, q) == NO_STANCE
    assert np.array_equal(StandingRobot(panda, NO_STANCE).placed(q), panda.q_home)
    assert np.array_equal(StandingRobot(panda, NO_STANCE).q_home, panda.q_home)


@pytest.mark.requirement("S6")
def test_a_standing_robot_on_an_empty_stance_is_out_of_balance(talos):
    verdict = TrajectoryChecker(talos).check(at_rest(talos, talos.q_home), PlanningScene())

    assert FindingKind.BALANCE in kinds(verdict)


@pytest.fixture(scope="module")
def g1():
    return RobotModel(load_description("g1"))


@pytest.fixture(scope="module")
def g1_stance(g1):
    return stance_at(g1, g1.q_home)


@pytest.fixture(scope="module")
def before_a_table():
    return PlanningScene().with_objects([box("table", (0.4, 0.8, 0.04), 0.45, 0.0, 0.68)])


def test_a_small_humanoid_stands_at_home_in_balance_and_free_of_collisions(g1, g1_stance, before_a_table):
    verdict = TrajectoryChecker(g1).check(at_rest(g1, g1.q_home, stance=g1_stance), before_a_table)

    assert isinstance(verdict, CheckedTrajectory), str(verdict)
    assert verdict.min_com_margin_m > 0.05
    assert not CollisionWorld(g1, before_a_table, 0.004, 0.005).collides(g1.q_home)
    for _, world_T_sole in g1_stance.soles:
        assert world_T_sole[2, 3] == pytest.approx(0.0, abs=1e-9)
        assert world_T_sole[2, 2] == pytest.approx(1.0, abs=1e-9)


@pytest.mark.requirement("U4", "S6", "M5")
@pytest.mark.parametrize("hand", ["left", "right"])
def test_a_small_humanoid_reaches_with_both_hands_and_exact_feet(g1, g1_stance, before_a_table, hand):
    space = FreeCoordinates(StandingRobot(g1, g1_stance))
    planner = planner_of(g1, space, g1_stance, before_a_table, iterations=300)
    checker, ik = TrajectoryChecker(g1), PlacoIk(StandingRobot(g1, g1_stance), hand)
    groups, side = g1.description.groups, 1.0 if hand == "left" else -1.0
    moving = [space.index(joint) for joint in (*groups[f"{hand}_arm"], *groups["torso"])]
    rng, reached = np.random.default_rng(2), 0

    for _ in range(8):
        turn = poses.rotation_z(side * rng.uniform(-0.3, 0.6)) @ poses.rotation_y(rng.uniform(-0.2, 0.6))
        place = rng.uniform([0.25, 0.0, 0.78], [0.45, 0.3, 1.0]) * (1.0, side, 1.0)
        result = ik.solve(poses.transform(turn, place), g1.q_home)
        goal = space.from_q(result.q)
        if not result.within(IkTolerance(com_margin_m=0.025)) or not planner.is_free(goal):
            continue
        curve = planner.plan(space.from_q(g1.q_home), goal, moving, rng)
        assert curve is not None
        trajectory = time_curve(StandingRobot(g1, g1_stance), curve, Pace(0.5, 0.7))
        verdict = checker.check(trajectory, before_a_table)
        assert isinstance(verdict, CheckedTrajectory), str(verdict)
        for q in trajectory.q[::10]:
            for frame, world_T_sole in g1_stance.soles:
                assert g1.frame_pose(q, frame) == pytest.approx(world_T_sole, abs=1e-9)
        tcp = g1.frame_pose(trajectory.q[-1], g1.description.tcp_frames[hand])
        assert tcp[:3, 3] == pytest.approx(place, abs=1e-3)
        reached += 1

    assert reached >= 6


@pytest.mark.requirement("U4")
def test_a_small_humanoid_bends_its_legs_to_reach_down(g1, g1_stance):
    space = FreeCoordinates(StandingRobot(g1, g1_stance))
    planner = planner_of(g1, space, g1_stance, PlanningScene())
    start, low = space.from_q(g1.q_home), space.from_q(g1.q_home)
    low[2] -= 0.15
    low[4] += 0.1

    curve = planner.straight(start, low)
    trajectory = time_curve(StandingRobot(g1, g1_stance), curve, Pace(0.5, 0.7))
    knee = g1.joint_index("left_knee_joint")

    verdict = TrajectoryChecker(g1).check(trajectory, PlanningScene())
    assert isinstance(verdict, CheckedTrajectory), str(verdict)
    assert trajectory.q[-1, 7 + knee] > trajectory.q[0, 7 + knee] + 0.4


@pytest.mark.parametrize("name", ["panda", "g1"])
def test_a_stored_motion_of_any_robot_is_read_and_judged_like_the_motion_itself(name, panda, g1):
    model = {"panda": panda, "g1": g1}[name]
    request = CheckRequest(
        at_rest(model, model.q_home, stance=stance_at(model, model.q_home)), PlanningScene()
    )

    stored = read_trajectory(write_trajectory(stored_from(request, model)))
    again = fit(stored, model, PlanningScene())

    assert isinstance(TrajectoryChecker(model).check(again.trajectory, again.scene), CheckedTrajectory)


def test_a_small_humanoid_that_reaches_far_keeps_its_waist_off_the_limits(g1, g1_stance):
    ik = PlacoIk(StandingRobot.of(g1, g1_stance), "left")
    waist = g1.joint_index("waist_pitch_joint")

    far = ik.solve(poses.translation(0.40, 0.10, 0.76), g1.q_home)

    assert far.within(DEFAULT_TOLERANCE)
    # a curve through a few such points swings beyond them by some 10 mrad
    margin = g1.description.planning_margin_rad + 0.02
    assert g1.lower_rad[waist] + margin < far.q[7 + waist] < g1.upper_rad[waist] - margin
