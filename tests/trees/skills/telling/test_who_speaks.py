"""Who "me" is: the nearest of the people around, near enough to speak."""

import pytest

from robots.fake.fake_world import person, table
from trees.build import build_tree
from trees.tasks import FindTask

ME = FindTask("see who speaks", person="me")


def run(stage, task=ME):
    return stage.play(build_tree(task, stage.toolbox))


@pytest.mark.requirement("L3")
def test_of_two_people_the_nearer_one_speaks(new_stage):
    stage = new_stage(table(), person("Ben", (3.0, 0.2)), person("Ana", (1.4, -0.6)))

    tree = run(stage)

    assert tree.status == "success"
    assert tree.evidence["found"] == "Ana"


def test_somebody_who_is_far_away_speaks_when_nobody_else_is_there(new_stage):
    stage = new_stage(table(), person("Ben", (4.0, 0.2)))

    assert run(stage).evidence["found"] == "Ben"


def test_with_nobody_there_the_search_ends_with_a_reason(new_stage):
    tree = run(new_stage(table()))

    assert tree.status == "failure"
    assert tree.failure.root.message == "nobody is seen"
