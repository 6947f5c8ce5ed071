"""Episodes of things that nobody here made: drawn from a scene of them, apart, asked for by their label."""

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.scenes.importing.import_object import import_object
from robots.scenes.scene_description import SceneItem
from robots.scenes.scene_file import load_scene
from tests import foreign_meshes as foreign
from tools.evaluate.__main__ import main
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import broken_episode
from tools.evaluate.report import save_scenes
from tools.evaluate.skills.episode import trial_of
from tools.evaluate.skills.putting_in import container_of
from tools.evaluate.skills.summary import SkillSummary
from tools.evaluate.upon import grips, hand_alone
from tools.evaluate.upon.grips import GripOrder, GripSummary, run_grip
from tools.evaluate.upon.putting_things import is_open_at_the_top
from tools.evaluate.upon.takeable import Hands, bolted_before, hands_of, why_not_asked_for
from tools.evaluate.upon.things import _radius_m
from trees.tasks import PlaceTask, PutInTask

SEEDS = range(12)


@pytest.fixture(scope="module")
def pool(tmp_path_factory):
    """A scene with what a hand can take, and a plate that none can."""
    folder = tmp_path_factory.mktemp("pool")
    meshes = {
        "tomato soup": foreign.can(),
        "big tomato soup": foreign.can(0.036, 0.13),
        "cereal": foreign.carton(),
        "ketchup": foreign.bottle(),
        "dinner plate": foreign.plate(),
    }
    lines = [
        '[[furniture]]\nname = "table"\nkind = "table"\nsize_m = [4.0, 4.0, 0.8]\nposition_m = [2.5, 0.0]'
    ]
    for number, (label, mesh) in enumerate(meshes.items()):
        file = foreign.written(mesh, folder, f"{label.replace(' ', '_')}.obj")
        import_object(file)
        where = f"position_m = [{0.4 * number - 1.0:.1f}, 0.0]"
        lines.append(f'[[object]]\nmesh = "{file.name}"\nlabel = "{label}"\non = "table"\n{where}')
    scene = folder / "shop.toml"
    scene.write_text("\n".join(lines))
    return scene


@pytest.mark.parametrize("seed", SEEDS)
def test_some_stand_apart_on_a_table_and_the_first_is_asked_for(pool, seed):
    trial = trial_of("things", seed, str(pool))

    objects = trial.scene.objects
    assert trial.sentence == f"pick up the {objects[0].name}"
    assert objects[0].name != "dinner plate"
    for one, other in itertools.combinations(objects, 2):
        apart_m = math.dist(one.world_T_object[:2, 3], other.world_T_object[:2, 3])
        assert apart_m > _radius_m(one) + _radius_m(other)
        assert one.name not in other.name
        assert other.name not in one.name


def test_the_table_suits_the_robot(pool):
    on_bench = trial_of("things", 3, str(pool), "panda").scene.furniture[0]
    standing = [trial_of("things", seed, str(pool)).scene.furniture[0] for seed in SEEDS]

    assert 0.70 <= on_bench.size_m[2] <= 0.80
    assert max(table.size_m[2] for table in standing) > 0.80


def test_the_scene_that_is_kept_of_a_failure_is_the_one_that_the_robot_had(pool, tmp_path):
    broken = broken_episode(EpisodeOrder(3, robot="panda"), RuntimeError("it broke"))
    summary = SkillSummary("things", 3, None, 0.02, [broken], str(pool))

    (file,) = save_scenes(summary, tmp_path, "panda").values()

    had = trial_of("things", 3, str(pool), "panda").scene
    assert load_scene(str(file)).furniture[0].size_m == pytest.approx(had.furniture[0].size_m)


def test_a_scene_of_which_no_hand_can_take_anything_is_refused_by_its_name(pool):
    text = pool.read_text()
    plates = pool.with_name("plates.toml")
    plates.write_text(text[: text.index("[[object]]")] + text[text.rindex("[[object]]") :])

    with pytest.raises(ValueError, match=r"plates.toml: the hands of talos can take nothing"):
        trial_of("things", 0, str(plates))


def test_in_place_everything_stays_and_what_a_hand_can_take_is_asked_for(pool):
    there = load_scene(str(pool))
    trials = [trial_of("in_place", seed, str(pool)) for seed in SEEDS]

    for trial in trials:
        assert [one.name for one in trial.scene.objects] == [one.name for one in there.objects]
        for one, other in zip(trial.scene.objects, there.objects, strict=True):
            assert (one.world_T_object == other.world_T_object).all()
        assert trial.sentence == f"pick up the {trial.aim}"
    assert len({trial.scene.robot_start for trial in trials}) == len(trials)
    assert len({trial.aim for trial in trials}) == 2
    assert not {"dinner plate", "tomato soup", "big tomato soup"} & {trial.aim for trial in trials}


def test_of_a_scene_it_is_told_why_each_thing_is_not_asked_for(pool):
    text = pool.read_text()
    reasons = {one.name: "" for one in load_scene(str(pool)).objects}
    reasons |= {"tomato soup": "others are called so", "big tomato soup": "others are called so"}
    reasons["dinner plate"] = "no hand can take it even where nothing else is"
    assert why_not_asked_for(load_scene(str(pool)), hands_of("talos")) == reasons

    on_floor = pool.with_name("on_the_floor.toml")
    stands = 'label = "ketchup"\non = "table"\nposition_m = [0.2, 0.0]'
    assert stands in text
    on_floor.write_text(text.replace(stands, 'label = "ketchup"\nposition_m = [-1.0, 0.0, 0.11]'))
    reasons["ketchup"] = "stands on no furniture"
    assert why_not_asked_for(load_scene(str(on_floor)), hands_of("talos")) == reasons


@pytest.mark.parametrize(("robot", "asked"), [("talos", True), ("panda", True), ("g1", False)])
def test_a_small_body_is_not_asked_for_what_is_far_from_the_edge(pool, robot, asked):
    there = load_scene(str(pool))
    (table,) = there.furniture
    narrow = replace(there, furniture=(replace(table, size_m=(1.2, 4.0, 0.8)),))

    reason = why_not_asked_for(narrow, hands_of(robot))["ketchup"]

    assert ("than this body reaches" in reason) is not asked


def test_what_stands_between_others_is_not_asked_for(tmp_path):
    scene = tmp_path / "between.toml"
    walls = "".join(
        f'\n[[object]]\nname = "block {side}"\nkind = "box"\nsize_m = [0.3, 0.1, 0.3]\non = "table"\n'
        f"position_m = [0.0, {side}]"
        for side in (-0.09, 0.09)
    )
    scene.write_text(
        '[[furniture]]\nname = "table"\nkind = "table"\nsize_m = [1.0, 1.0, 0.8]\nposition_m = [0.8, 0.0]\n'
        '[[object]]\nname = "red can"\nkind = "can"\ncolor = "red"\nradius_m = 0.03\nheight_m = 0.1\n'
        'on = "table"' + walls
    )

    reasons = why_not_asked_for(load_scene(str(scene)), hands_of("talos"))

    assert reasons["red can"] == "no hand has room beside it"


def test_an_arm_is_bolted_down_where_it_reaches_what_is_asked_for_and_not_in_furniture(pool):
    there = load_scene(str(pool))
    middle = next(one for one in there.objects if one.name == "ketchup")
    (table,) = there.furniture

    assert bolted_before(middle, there) == []

    narrow = replace(there, furniture=(replace(table, size_m=(0.6, 4.0, 0.8)),))
    starts = bolted_before(middle, narrow)

    assert starts
    for start in starts:
        ahead = math.dist((start.x_m, start.y_m), middle.world_T_object[:2, 3])
        assert 0.4 < ahead < 0.7
        assert abs(start.x_m - table.position_m[0]) > 0.3 + 0.1


@pytest.mark.parametrize(
    ("shape", "held"),
    [
        (Box((0.09, 0.07, 0.12)), True),
        (Box((0.09, 0.085, 0.12)), False),
        (Box((0.09, 0.01, 0.12)), False),
        (Box((0.09, 0.06, 0.015)), False),
        (Cylinder(0.035, 0.1), True),
        (Cylinder(0.045, 0.1), False),
        (Ball(0.035), True),
    ],
    ids=str,
)
def test_a_hand_alone_takes_what_is_between_its_fingers_widths_and_high_enough(shape, held):
    thing = SceneItem("thing", "thing", None, shape, 0.2, 0.6, np.eye(4))

    assert Hands("talos").take_alone(thing) is held


def test_what_a_hand_takes_at_one_place_alone_and_not_5_mm_beside_is_not_asked_for(monkeypatch):
    flat = SceneItem("thing", "thing", None, Box((0.0802, 0.04632, 0.02742)), 0.2, 0.6, np.eye(4))

    assert not Hands("panda").take_alone(flat)

    monkeypatch.setattr(hand_alone, "_WRONG", np.zeros((1, 3)))
    assert Hands("panda").take_alone(flat)


def test_a_scene_that_has_nothing_for_a_hand_is_refused_before_any_episode(pool, capsys):
    text = pool.read_text()
    plates = pool.with_name("plates_alone.toml")
    plates.write_text(text[: text.index("[[object]]")] + text[text.rindex("[[object]]") :])

    assert main(["in_place", "--scene", str(plates), "--episodes", "1"]) == 2

    assert "dinner plate: no hand can take it even where nothing else is" in capsys.readouterr().err


def with_bowl(pool, radius_m, name):
    """The pool with a bowl in it, open at the top."""
    folder = pool.parent
    file = foreign.written(foreign.bowl(radius_m, 0.08), folder, f"{name}.obj")
    import_object(file)
    scene = folder / f"{name}.toml"
    bowl = f'[[object]]\nmesh = "{file.name}"\nlabel = "salad bowl"\non = "table"\nposition_m = [-1.4, 0.0]'
    scene.write_text(f"{pool.read_text()}\n{bowl}")
    return scene


def test_things_are_put_on_the_table_or_into_what_is_open_and_may_be_held_before(pool):
    trials = [trial_of("put_things", seed, str(pool)) for seed in SEEDS]

    tasks = [trial.tasks[-1] for trial in trials]
    assert {type(task) for task in tasks} == {PlaceTask, PutInTask}
    assert {len(trial.first) for trial in trials} == {0, 1}
    for trial, task in zip(trials, tasks, strict=True):
        assert task.object.name == trial.aim != "dinner plate"
        if isinstance(task, PutInTask):
            assert trial.sentence == f"put the {trial.aim} into the {container_of(trial).name}"
            assert container_of(trial).wall_m is not None


def test_a_scene_s_own_thing_that_is_open_at_the_top_is_put_into_as_often(pool):
    scene = with_bowl(pool, 0.11, "large")
    bowl = next(one for one in load_scene(str(scene)).objects if one.name == "salad bowl")
    trials = [trial_of("put_things", seed, str(scene)) for seed in SEEDS]

    assert is_open_at_the_top(bowl)
    into = {container_of(one).name for one in trials if isinstance(one.tasks[-1], PutInTask)}
    assert "salad bowl" in into
    assert len(into) > 1


def test_what_is_solid_flat_or_narrow_is_not_open_at_the_top(pool):
    narrow = with_bowl(pool, 0.05, "narrow")

    assert not any(is_open_at_the_top(one) for one in load_scene(str(narrow)).objects)


def test_without_a_scene_it_is_refused_with_what_to_say(capsys):
    assert main(["things", "--episodes", "1"]) == 2

    assert "the suite things needs a scene: --scene FILE" in capsys.readouterr().err


GRIPPED = {"ketchup": (3, True), "dinner plate": (4, False)}


@pytest.mark.parametrize(("index", "taken"), GRIPPED.values(), ids=GRIPPED)
def test_the_first_grasp_of_a_thing_is_tried_or_its_refusal_told(pool, index, taken):
    (record,) = run_grip(GripOrder(0, index, str(pool), "talos"))

    assert record.error is None
    assert record.held is record.holdable is taken
    assert bool(record.found) is taken
    assert taken or "flatter than this hand's fingers are thick" in record.reason
    assert not record.faults


def test_a_first_grasp_that_slips_counts_where_any_other_holds(pool, monkeypatch):
    tried = []

    def slips_once(*_):
        tried.append(None)
        return len(tried) > 1

    monkeypatch.setattr(grips, "holds", slips_once)

    (record,) = run_grip(GripOrder(0, GRIPPED["ketchup"][0], str(pool), "talos"))

    assert record.faults == ("slipped",)
    assert [bar.met for bar in GripSummary(0, [record]).bars()] == [False, True, True]


@pytest.mark.parametrize(
    ("robot", "said"), [("talos", "needs a scene"), ("g1", "closes its fingers on a palm")]
)
def test_grips_are_refused_with_what_they_need(robot, said, capsys):
    assert main(["grips", "--robot", robot, "--episodes", "1"]) == 2
    assert said in capsys.readouterr().err
