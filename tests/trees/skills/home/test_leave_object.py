"""What the task after a cancelled one does first with a hand that is about an object."""

import pytest
from py_trees.common import Status

from kinematics.requests.check import CheckRequest
from kinematics.requests.move import RetreatRequest
from kinematics.scene.planning_scene import PlanningScene
from robots.fake.fake_world import cup, table
from trees import readiness
from trees.build import build_tree
from trees.events import NodeChanged
from trees.skills.home.find_left_about import FindLeftAbout
from trees.skills.home.hand_about import objects_in_open_grasp
from trees.skills.home.lift_clear import held_near_support
from trees.skills.home.tree import IfNothingIsKnown
from trees.tasks import GoHomeTask, ObjectDescription, PickTask, SayTask

RED_CUP = PickTask("pick up the red cup", ObjectDescription("cup", "red"))
GO_HOME = GoHomeTask("go home")


def cancelled_at(stage, where, after_ticks=0):
    """A pick that is halted while a leaf of that name runs; what the events say afterwards counts."""
    tree = stage.pick()
    stage.when(where, lambda: tree.halt("the person said stop"), after_ticks)
    stage.play(tree)
    assert tree.failure.message == "the person said stop"
    for _ in range(20):
        stage.fake.step()
    stage.events.clear()
    return stage


def order(stage):
    """Names of the nodes in the order in which they first ran."""
    begun = [e.where.rsplit("/", 1)[-1] for e in stage.events if isinstance(e, NodeChanged)]
    return list(dict.fromkeys(begun))


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("where", ["close gripper", "verify hold"])
@pytest.mark.parametrize("task", [RED_CUP, GO_HOME], ids=lambda task: task.action)
def test_after_a_cancel_with_the_fingers_about_the_cup_the_hand_leaves_it_first(stage, where, task):
    cancelled_at(stage, where)
    (about,) = objects_in_open_grasp(stage.toolbox)
    assert about.name == "red cup"

    tree = stage.play(build_tree(task, stage.toolbox))

    assert tree.status == "success", tree.failure
    names = order(stage)
    assert (
        names.index("let go")
        < names.index("draw back")
        < names.index("look" if task is RED_CUP else "move home")
    )


@pytest.mark.requirement("S7")
def test_an_open_hand_that_was_stopped_on_its_way_in_is_drawn_back_too(stage):
    cancelled_at(stage, "close gripper")
    stage.fake.grippers["right"].open()
    stage.fake.grippers["left"].open()
    for _ in range(60):
        stage.fake.step()

    tree = stage.play(build_tree(RED_CUP, stage.toolbox))

    assert tree.status == "success", tree.failure
    assert "draw back" in order(stage)


def test_what_the_hand_holds_is_not_let_go(stage):
    cancelled_at(stage, "stream lift", 1)
    assert "red cup" in stage.told.scene.attached

    assert objects_in_open_grasp(stage.toolbox) == ()
    tree = stage.play(build_tree(GO_HOME, stage.toolbox))

    assert tree.status == "success"
    assert "let go" not in order(stage)
    assert "red cup" in stage.told.scene.attached


@pytest.mark.requirement("S7")
def test_who_takes_over_finds_what_stands_between_the_fingers(stage):
    cancelled_at(stage, "verify hold")

    assert stage.run(FindLeftAbout("find", stage.toolbox)) is Status.SUCCESS
    assert stage.output("held").name == "red cup"
    assert stage.output("touched")


def test_who_takes_over_keeps_what_was_lifted(stage):
    cancelled_at(stage, "verify lift")
    scene = stage.told.scene
    body = scene.attached["red cup"]
    q = stage.toolbox.motion.reference()
    place = stage.toolbox.model.frame_pose(q, body.frame) @ body.frame_T_object
    stage.told.update(scene.with_detached("red cup", place))
    assert objects_in_open_grasp(stage.toolbox)

    assert stage.run(FindLeftAbout("find", stage.toolbox)) is Status.FAILURE


def test_who_takes_over_lets_go_before_the_hands_go_home(stage, monkeypatch):
    cancelled_at(stage, "verify hold")
    monkeypatch.setattr(IfNothingIsKnown, "needed", lambda _self: True)
    monkeypatch.setattr(readiness, "objects_in_open_grasp", lambda _toolbox: ())

    tree = stage.play(build_tree(GO_HOME, stage.toolbox))

    assert tree.status == "success", tree.failure
    names = order(stage)
    assert names.index("let go") < names.index("draw back") < names.index("move home")


@pytest.mark.requirement("S7")
def test_what_a_hand_feels_and_nobody_has_seen_is_lifted_first(stage):
    cancelled_at(stage, "verify hold")
    scene = stage.told.scene
    stage.told.update(PlanningScene(scene.version + 1))
    before = len(stage.fake.planning.requests)

    tree = stage.play(build_tree(GO_HOME, stage.toolbox))

    assert tree.status == "success", tree.failure
    plans = [one for one in stage.fake.planning.requests[before:] if isinstance(one, RetreatRequest)]
    assert [one.world_offset_m[2] for one in plans] == [0.05]


def test_words_are_said_without_moving_the_hand(stage):
    cancelled_at(stage, "verify hold")

    stage.play(build_tree(SayTask("say hello", "hello"), stage.toolbox))

    assert "let go" not in order(stage)


def test_a_hand_that_is_nowhere_near_anything_is_about_nothing(stage_with):
    stage = stage_with(table(), cup())
    stage.play(stage.pick(), 5)

    assert objects_in_open_grasp(stage.toolbox) == ()


@pytest.mark.requirement("S7")
def test_a_cup_that_is_not_seen_past_the_arms_is_looked_for_from_home(stage):
    cancelled_at(stage, "confirm target")
    stage.fake.detector.blind = True
    stage.when("go home", lambda: setattr(stage.fake.detector, "blind", False))

    tree = stage.play(build_tree(RED_CUP, stage.toolbox))

    assert tree.status == "success", tree.failure
    assert "go home" in order(stage)


def test_what_is_nowhere_is_not_looked_for_twice_from_home(stage):
    stage.fake.world.remove("red cup")

    tree = stage.play(stage.pick())

    assert tree.status == "failure"
    looks = [e for e in stage.events if isinstance(e, NodeChanged) and e.where.endswith("look ahead/look")]
    assert len([e for e in looks if e.status == "running"]) <= 1


@pytest.mark.requirement("S7")
def test_what_a_cancelled_task_left_standing_in_the_hand_is_lifted_clear_first(stage):
    cancelled_at(stage, "stream lift")
    assert held_near_support(stage.toolbox) is not None
    before = len(stage.fake.planning.requests)

    tree = stage.play(build_tree(GO_HOME, stage.toolbox))

    assert tree.status == "success", tree.failure
    plans = [one for one in stage.fake.planning.requests[before:] if not isinstance(one, CheckRequest)]
    assert isinstance(plans[0], RetreatRequest)
    assert plans[0].world_offset_m[2] > 0.03
    assert [one.names for one in plans[0].concessions] == [("red cup", "table")]
    assert "red cup" in stage.told.scene.attached


def test_what_is_held_in_the_air_needs_no_lifting(stage):
    stage.play(stage.pick())

    assert held_near_support(stage.toolbox) is None
