"""The record of a skill, and the registry that finds every one of them."""

from dataclasses import dataclass

import pytest

from trees import registry
from trees import skills as folders
from trees.build import NoSkillError, build_tree
from trees.registry import skill_called, skill_of, skills, task_that
from trees.skill import After, Skill, as_answered, as_asked
from trees.tasks import (
    WHERE_IT_WAS,
    GoHomeTask,
    HandOverTask,
    ObjectDescription,
    PickTask,
    PlaceTask,
    SayTask,
    WaitTask,
)


@dataclass(frozen=True, slots=True)
class Bow:
    text: str
    depth_m: float = 0.1

    action = "bow_low"


BOW = Skill(task=Bow, tree=lambda task, toolbox: None, example="bow low")


def test_a_skill_is_named_by_its_task():
    assert BOW.action == "bow_low"
    assert BOW.words == "bow low"


def test_a_skill_may_have_a_verb_of_its_own():
    assert skill_called("pick").words == "pick up"


def test_a_phrase_makes_a_task():
    assert BOW.task_of("bow") == Bow("bow")


def test_the_skill_of_a_task_is_found_by_its_type():
    pick = PickTask("pick up the cup", ObjectDescription("cup"))

    assert skill_of(pick) is skill_called("pick")
    assert skill_of(Bow("bow")) is None


def test_a_task_that_only_has_the_name_of_a_skill_is_none_of_its_tasks():
    @dataclass(frozen=True)
    class Pick:
        text: str
        action = "pick"

    assert skill_of(Pick("pick")) is None


def test_what_is_no_skill_is_told_with_the_skills_that_there_are(stage):
    with pytest.raises(NoSkillError, match="'bow_low' is no skill of this robot yet; it has answer, close"):
        build_tree(Bow("bow"), stage.toolbox)


def test_every_folder_with_a_tree_of_a_task_has_its_record():
    assert len(skills()) == 24
    assert all(name == skill.action for name, skill in skills().items())


def test_two_skills_of_one_name_are_a_defect_of_the_program(monkeypatch):
    monkeypatch.setattr(folders, "_records", lambda folder: [BOW])
    folders.built_in.cache_clear()

    with pytest.raises(TypeError, match="there is a skill 'bow_low' already"):
        folders.built_in()

    monkeypatch.undo()
    folders.built_in.cache_clear()


def test_a_pick_claims_what_was_measured():
    claim = skill_called("pick").claim

    evidence = {"hand": "left", "gripper_opening_m": 0.0612, "lift_m": 0.13}

    assert (
        claim("take it", "red cup", evidence) == "red cup held in the left hand, opening 61 mm, lifted 0.13 m"
    )


def test_a_skill_that_answers_claims_what_it_said():
    assert as_answered("how many", "", {"said": "two"}) == "two"
    assert as_asked("wave", "", {"said": "two"}) == "wave"


def test_a_wait_lasts_as_long_as_was_said():
    assert skill_called("wait").lasts_s(WaitTask("wait", 600.0)) == 600.0
    assert skill_called("say").lasts_s(SayTask("say", "hello")) == 0.0


CUP = ObjectDescription("cup")


def test_what_another_skill_needs_is_brought_about_by_the_task_of_the_skill_that_says_so():
    assert task_that(After.THING_HELD, "pick up the cup", object=CUP) == PickTask("pick up the cup", CUP)


def test_what_no_skill_brings_about_is_a_defect_of_the_program(monkeypatch):
    monkeypatch.setattr(registry, "built_in", lambda: {"bow_low": BOW})

    with pytest.raises(LookupError, match="no skill of this robot brings about that its ``object`` is in a"):
        task_that(After.THING_HELD, "pick up the cup", object=CUP)


@pytest.mark.parametrize(
    ("task", "goal"),
    [
        (HandOverTask("give it to Ana", CUP, "Ana"), "Ana"),
        (SayTask("tell Ana", "hello", "Ana"), "Ana"),
        (PlaceTask("put it on the table", CUP, on="table", to="kitchen"), "table"),
        (PlaceTask("put it back", CUP, on="table", to=WHERE_IT_WAS), WHERE_IT_WAS),
        (GoHomeTask("go home"), None),
    ],
)
def test_the_goal_of_a_task_is_where_its_thing_goes_or_whom_it_is_for(task, goal):
    assert skill_of(task).goal(task) == goal
