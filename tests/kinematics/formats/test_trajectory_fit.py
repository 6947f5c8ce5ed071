"""A stored trajectory meets its robot and its surroundings."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.errors import TrajectoryDocumentError
from kinematics.formats.solid_document import HeldObject
from kinematics.formats.trajectory_document import StoredTrajectory, read_trajectory, write_trajectory
from kinematics.formats.trajectory_fit import fit, stored_from
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box
from kinematics.model.stance import Stance
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory, FindingKind
from kinematics.requests.check import CheckRequest
from kinematics.scene.planning_scene import PlanningScene, SceneObject


@pytest.fixture(scope="module")
def checker(talos):
    return TrajectoryChecker(talos)


@pytest.fixture
def still(talos, stance):
    q = np.tile(talos.q_home, (3, 1))
    motion = Trajectory(talos.joints, stance, np.array([0.0, 0.3, 0.6]), q, np.zeros((3, talos.nv)))
    return StoredTrajectory("talos", motion)


def in_left_hand(size_m=0.05, ahead_m=0.0, touch=(), name="cup"):
    return HeldObject(name, "tcp_left", poses.translation(ahead_m, 0, 0), Ball(size_m / 2), frozenset(touch))


def judged(checker, talos, stored, scene=None):
    asked = fit(stored, talos, scene or PlanningScene())
    return checker.check(asked.trajectory, asked.scene)


def test_a_stored_motion_is_judged_as_the_motion_that_was_stored(checker, talos, still):
    back = read_trajectory(write_trajectory(still))

    assert isinstance(judged(checker, talos, back), CheckedTrajectory)


def test_joints_come_in_any_order_and_are_found_by_name(checker, talos, still):
    motion = still.trajectory
    order = np.random.default_rng(0).permutation(len(talos.joints))
    shuffled = Trajectory(
        tuple(talos.joints[i] for i in order),
        motion.stance,
        motion.t_s,
        np.hstack([motion.q[:, :7], motion.q[:, 7 + order]]),
        np.hstack([motion.v[:, :6], motion.v[:, 6 + order]]),
    )

    asked = fit(StoredTrajectory("talos", shuffled), talos, PlanningScene())

    assert asked.trajectory.joints == talos.joints
    assert np.array_equal(asked.trajectory.q, motion.q)
    assert isinstance(checker.check(asked.trajectory, asked.scene), CheckedTrajectory)


def test_what_is_held_collides(checker, talos, still):
    wall = SceneObject(
        "wall",
        Box((0.1, 0.1, 0.1)),
        talos.frame_pose(talos.q_home, "tcp_left") @ poses.translation(0.3, 0, 0),
    )
    scene = PlanningScene().with_object(wall)
    touch = talos.description.grippers["left"].links

    empty = judged(checker, talos, still, scene)
    short = judged(checker, talos, replace(still, held=(in_left_hand(0.05, 0.1, touch),)), scene)
    long = judged(checker, talos, replace(still, held=(in_left_hand(0.3, 0.16, touch),)), scene)

    assert isinstance(empty, CheckedTrajectory)
    assert isinstance(short, CheckedTrajectory)
    assert [(f.kind, set(f.subject)) for f in long.findings if "wall" in f.subject] == [
        (FindingKind.HELD_OBJECT_COLLISION, {"cup", "wall"})
    ]


def test_a_held_object_leaves_the_world(checker, talos, still):
    in_the_arm = SceneObject("cup", Ball(0.02), talos.frame_pose(talos.q_home, "arm_left_4_link"))
    scene = PlanningScene().with_object(in_the_arm)
    touch = talos.description.grippers["left"].links

    assert not isinstance(judged(checker, talos, still, scene), CheckedTrajectory)
    held = replace(still, held=(in_left_hand(0.03, 0.1, touch),))
    assert isinstance(judged(checker, talos, held, scene), CheckedTrajectory)


def test_an_allowed_pair_may_touch_and_no_other(checker, talos, still):
    hand = talos.frame_pose(talos.q_home, "arm_left_4_link")
    scene = PlanningScene().with_object(SceneObject("cup", Ball(0.02), hand))
    found = judged(checker, talos, still, scene).findings
    pairs = frozenset(frozenset(finding.subject) for finding in found)

    assert isinstance(judged(checker, talos, replace(still, allowed=pairs), scene), CheckedTrajectory)


def test_what_the_checker_was_asked_can_be_stored_and_asked_again(checker, talos, still):
    place = talos.frame_pose(talos.q_home, "tcp_left") @ poses.translation(0.3, 0, 0)
    wall = SceneObject("wall", Box((0.1, 0.1, 0.1)), place, margin_m=0.01)
    touch = talos.description.grippers["left"].links
    held = replace(still, held=(in_left_hand(0.3, 0.16, touch),))
    asked = fit(held, talos, PlanningScene().with_object(wall).allowing([("torso_2_link", "gone")]))

    back = read_trajectory(write_trajectory(stored_from(asked, talos)))
    again = fit(back, talos, PlanningScene().with_objects(back.objects))

    first = checker.check(asked.trajectory, asked.scene).findings
    second = checker.check(again.trajectory, again.scene).findings
    assert [(f.kind, f.t_s, f.subject, f.limit) for f in first] == [
        (f.kind, f.t_s, f.subject, f.limit) for f in second
    ]


def renamed(still, old, new):
    motion = still.trajectory
    return replace(motion, joints=tuple(new if name == old else name for name in motion.joints))


def without_head(still, talos):
    motion = still.trajectory
    keep = [i for i, name in enumerate(talos.joints) if name != "head_1_joint"]
    q = np.hstack([motion.q[:, :7], motion.q[:, [7 + i for i in keep]]])
    v = np.hstack([motion.v[:, :6], motion.v[:, [6 + i for i in keep]]])
    return replace(motion, joints=tuple(talos.joints[i] for i in keep), q=q, v=v)


def moved_soles(still, change):
    soles = tuple((name, world_T_sole @ change) for name, world_T_sole in still.trajectory.stance.soles)
    return replace(still.trajectory, stance=Stance(soles))


def renamed_sole(still):
    return replace(still.trajectory, stance=Stance((("left_soul_link", np.eye(4)),)))


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda s, _: replace(s, robot="g1"), "robot: is 'g1', to be judged as 'talos'"),
        (
            lambda s, _: replace(s, trajectory=renamed(s, "head_1_joint", "haed_1_joint")),
            "no joint 'haed_1_joint' among 30; did you mean 'head_1_joint'?",
        ),
        (lambda s, t: replace(s, trajectory=without_head(s, t)), "the robot's 'head_1_joint' is missing"),
        (lambda s, _: replace(s, trajectory=renamed_sole(s)), "did you mean 'left_sole_link'?"),
        (
            lambda s, _: replace(s, trajectory=moved_soles(s, poses.translation(0, 0, 0.1))),
            "stance.left_sole_link: lies not on the floor: height 0.1 m",
        ),
        (
            lambda s, _: replace(
                s, trajectory=moved_soles(s, poses.transform(poses.rotation_x(0.1), (0.0, 0.0, 0.0)))
            ),
            "tilt 0.1 rad",
        ),
        (lambda s, _: replace(s, held=(in_left_hand(name="floor"),)), "'floor' is the floor's name"),
        (lambda s, _: replace(s, held=(in_left_hand(name="leg_left_6_link"),)), "a part of the robot"),
        (lambda s, _: replace(s, held=(in_left_hand(touch=["nothing"]),)), "touch_links: no link 'nothing'"),
        (
            lambda s, _: replace(s, allowed=frozenset([frozenset(["cup", "torso_2_link"])])),
            "allowed: no link or object 'cup'",
        ),
    ],
)
def test_what_does_not_fit_the_robot_is_refused_with_its_place(talos, still, change, says):
    with pytest.raises(TrajectoryDocumentError) as refused:
        fit(change(still, talos), talos, PlanningScene())

    assert says in str(refused.value)


@pytest.mark.parametrize("name", ["floor", "torso_2_link"])
def test_a_scene_cannot_take_the_floor_away_or_pose_as_the_robot(talos, still, name):
    scene = PlanningScene().with_object(SceneObject(name, Ball(0.01), poses.translation(3, 0, 3)))

    with pytest.raises(TrajectoryDocumentError, match=name):
        fit(still, talos, scene)


def block_at(talos, link, name="block", **more):
    return SceneObject(name, Ball(0.02), talos.frame_pose(talos.q_home, link), **more)


def touching(still, *pairs):
    return replace(still, allowed=frozenset(map(frozenset, pairs)))


@pytest.mark.requirement("S6")
def test_a_document_cannot_let_the_robot_go_through_itself(talos, still):
    loose = touching(still, ("arm_left_5_link", "torso_2_link"))

    with pytest.raises(TrajectoryDocumentError, match=r"allowed: .*both parts of the robot"):
        fit(loose, talos, PlanningScene())


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("name", ["arm_left_5_link", "gripper_left_base_link", "cup", "wall"])
def test_a_document_cannot_let_anything_go_through_the_floor(talos, still, name):
    held = replace(touching(still, (name, "floor")), held=(in_left_hand(),))
    scene = PlanningScene().with_object(block_at(talos, "arm_left_4_link", "wall"))

    with pytest.raises(TrajectoryDocumentError, match=r"allowed: .*may not touch the floor"):
        fit(held, talos, scene)


def test_a_document_cannot_let_a_link_that_is_no_hand_go_through_what_it_is_not_beside(talos, still):
    far = PlanningScene().with_object(SceneObject("block", Ball(0.02), poses.translation(1.0, 0.0, 1.0)))

    with pytest.raises(TrajectoryDocumentError, match=r"does not begin with them side by side"):
        fit(touching(still, ("arm_left_4_link", "block")), talos, far)


def test_a_hand_may_touch_what_it_is_to_take(talos, still):
    far = PlanningScene().with_object(SceneObject("block", Ball(0.02), poses.translation(1.0, 0.0, 1.0)))

    asked = fit(touching(still, ("gripper_left_fingertip_1_link", "block")), talos, far)

    assert asked.scene.is_allowed("gripper_left_fingertip_1_link", "block")


def test_what_is_held_may_touch_what_carries_it_and_not_what_the_other_hand_holds(talos, still):
    table = PlanningScene().with_object(SceneObject("table", Box((1, 1, 0.1)), poses.translation(1, 0, 0.7)))
    can = HeldObject("can", "tcp_right", np.eye(4), Ball(0.025))
    both = replace(still, held=(in_left_hand(), can))

    assert fit(replace(both, allowed=frozenset([frozenset(("cup", "table"))])), talos, table)
    with pytest.raises(TrajectoryDocumentError, match=r"allowed: .*both held"):
        fit(replace(both, allowed=frozenset([frozenset(("cup", "can"))])), talos, table)


def test_what_is_held_cannot_be_let_through_the_other_arm(talos, still):
    with pytest.raises(TrajectoryDocumentError, match=r"touch_links: 'arm_right_5_link'"):
        fit(replace(still, held=(in_left_hand(touch=["arm_right_5_link"]),)), talos, PlanningScene())


def test_what_is_held_moves_with_a_hand(talos, still):
    with pytest.raises(TrajectoryDocumentError, match=r"held\[0\].frame: 'base_link'"):
        fit(replace(still, held=(replace(in_left_hand(), frame="base_link"),)), talos, PlanningScene())


def test_furniture_does_not_leave_the_world_as_something_held(talos, still):
    wall = PlanningScene().with_object(block_at(talos, "arm_left_4_link", "wall", movable=False))

    with pytest.raises(TrajectoryDocumentError, match=r"held\[0\].name: 'wall'"):
        fit(replace(still, held=(in_left_hand(name="wall"),)), talos, wall)


def test_what_is_held_is_not_much_smaller_than_the_scene_says(talos, still):
    scene = PlanningScene().with_object(SceneObject("cup", Ball(0.1), poses.translation(1.0, 0.0, 1.0)))

    with pytest.raises(TrajectoryDocumentError, match=r"held\[0\].shape: .*smaller"):
        fit(replace(still, held=(in_left_hand(0.05),)), talos, scene)


@pytest.mark.parametrize(
    ("soles", "says"),
    [
        ((), "stance: names no sole"),
        ((("arm_left_7_link", np.eye(4)),), "stance.arm_left_7_link: no sole 'arm_left_7_link'"),
    ],
)
def test_a_document_cannot_stand_on_nothing_or_on_what_is_no_sole(talos, still, soles, says):
    with pytest.raises(TrajectoryDocumentError, match=says):
        fit(
            replace(still, trajectory=replace(still.trajectory, stance=Stance(soles))), talos, PlanningScene()
        )


def test_what_a_document_could_not_say_is_not_written_into_one(talos, still):
    block = block_at(talos, "arm_left_4_link")
    far = SceneObject("far", Ball(0.02), poses.translation(1.0, 0.0, 1.0))
    kept = {frozenset(("arm_left_4_link", "block")), frozenset(("gripper_left_base_link", "far"))}
    scene = PlanningScene().with_objects([block, far]).allowing(tuple(pair) for pair in kept)
    loose = [("arm_left_4_link", "far"), ("arm_left_5_link", "torso_2_link"), ("far", "floor")]

    stored = stored_from(CheckRequest(still.trajectory, scene.allowing(loose)), talos)

    assert stored.allowed == kept
    assert fit(stored, talos, PlanningScene().with_objects(stored.objects)).scene.allowed == kept
