"""Episodes of things that nobody here made: drawn from a scene of them, apart, asked for by their label."""

import itertools
import math

import pytest

from robots.scenes.importing.import_object import import_object
from robots.scenes.scene_file import load_scene
from tests import foreign_meshes as foreign
from tools.evaluate.__main__ import main
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import broken_episode
from tools.evaluate.report import save_scenes
from tools.evaluate.skills.episode import trial_of
from tools.evaluate.skills.summary import SkillSummary
from tools.evaluate.upon.things import _radius_m

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


def test_without_a_scene_it_is_refused_with_what_to_say(capsys):
    assert main(["things", "--episodes", "1"]) == 2

    assert "the suite things needs a scene: --scene FILE" in capsys.readouterr().err
