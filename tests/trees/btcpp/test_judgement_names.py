"""Judgements in documents: called by names that no moved file changes; documents of before are still read."""

import re
import sys
import types
from functools import partial
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

import trees.nodes.judgements
from tests.trees.example_tasks import FURTHER, TASKS, root_of
from trees.btcpp import judgement_names
from trees.btcpp.errors import TreeDocumentError
from trees.btcpp.judgement_names import known_judgements, load_judgements, own_judgements
from trees.btcpp.leaf_kinds import known_leaves
from trees.btcpp.literals import from_text, to_text
from trees.btcpp.own_kinds import JUDGES, JUDGES_ATTEMPTS, JUDGES_WAYS
from trees.btcpp.reader import read_tree
from trees.btcpp.writer import write_tree
from trees.failures import Failure
from trees.nodes.alternatives import Alternatives
from trees.nodes.judgements import (
    Judgement,
    defect,
    judgement,
    looking_elsewhere_is_useless,
    no_other_attempt_helps,
    tidying_helps,
)
from trees.skills import built_in
from trees.skills.doors.close import handle_is_no_help
from trees.skills.doors.find_handle import can_walk
from trees.skills.doors.handle.step_back import leave_handle
from trees.skills.doors.open import moving_it_again_is_useless, what_was_seen_decides
from trees.skills.place.know_destination import cannot_go_there
from trees.skills.put_in.put_behind_door import put_behind_door
from trees.skills.telling.tree import find_several
from trees.tasks import FindTask

DATA = Path(__file__).parent / "data"
MODULE = re.compile(r"\b(trees|robots|kinematics|executive)\.[a-z_]|[a-z]:[a-z_]")


MADE_BY = {
    **{skill: partial(root_of, TASKS[built.task]) for skill, built in built_in().items()},
    "put_behind_door": put_behind_door,
    "find_several": partial(find_several, FURTHER[FindTask][0]),
    "leave_handle": leave_handle,
}


@pytest.fixture(params=MADE_BY)
def tree(request, stage):
    return MADE_BY[request.param](stage.toolbox)


def judgements_of(tree):
    for node in tree.iterate():
        for asked in ("hopeless", "worth_trying", "worth_it"):
            if hasattr(node, asked):
                yield getattr(node, asked)


def alternatives(judgement, port="hopeless"):
    body = f'<Alternatives {port}="{judgement}"><GoHome/></Alternatives>'
    return f'<root BTCPP_format="4"><BehaviorTree ID="Main">{body}</BehaviorTree></root>'


def test_every_judgement_of_every_skill_is_known_by_its_name(tree):
    for one in judgements_of(tree):
        assert isinstance(one, Judgement), one
        assert known_judgements()[one.name] is one


def test_a_stored_tree_names_no_module(tree):
    assert not MODULE.search(write_tree(tree))


def test_a_judgement_is_read_as_the_one_that_was_written():
    assert to_text(tidying_helps) == "tidying_helps"
    assert from_text("tidying_helps", JUDGES) is tidying_helps


def test_every_judgement_says_what_it_means():
    assert all(one.meaning for one in known_judgements().values())


def test_a_name_that_two_judgements_have_is_not_overlooked(monkeypatch):
    @judgement
    def defect(failure: Failure) -> bool:
        """Another one."""
        return False

    monkeypatch.setattr(trees.nodes.judgements, "another", defect, raising=False)

    with pytest.raises(ValueError, match="two judgements are called 'defect'"):
        own_judgements.__wrapped__()


def test_a_name_that_two_leaves_have_is_not_overlooked(probe_leaf, monkeypatch):
    class GoHome(probe_leaf, register=False):
        pass

    assert known_leaves()["GoHome"] is not GoHome

    monkeypatch.setattr(GoHome, "__module__", "trees.skills.example")
    with pytest.raises(ValueError, match="two leaves are called GoHome"):
        known_leaves()


@pytest.mark.parametrize(
    ("written", "hint", "meant"),
    [
        ("trees.alternatives:defect", JUDGES, defect),
        ("trees.subtrees.search:looking_elsewhere_is_useless", JUDGES, looking_elsewhere_is_useless),
        ("trees.subtrees.open:looking_elsewhere_is_useless", JUDGES, what_was_seen_decides),
        ("trees.skills.doors.open:looking_elsewhere_is_useless", JUDGES, what_was_seen_decides),
        ("trees.nodes.judgements:looking_elsewhere_is_useless", JUDGES, looking_elsewhere_is_useless),
        ("trees.subtrees.open:hopeless", JUDGES_ATTEMPTS, moving_it_again_is_useless),
        ("trees.skills.doors.open:hopeless", JUDGES_ATTEMPTS, moving_it_again_is_useless),
        ("trees.subtrees.open:tidying_helps", JUDGES, tidying_helps),
        ("trees.subtrees.pick:_tidying_helps", JUDGES, tidying_helps),
        ("trees.leaves.go_home:_tidying_helps", JUDGES, tidying_helps),
        ("trees.subtrees.have_it:_cannot_go_there", JUDGES, cannot_go_there),
        ("trees.subtrees.close:_handle_is_no_help", JUDGES, handle_is_no_help),
        ("trees.subtrees.seen_from_elsewhere:_can_walk", JUDGES_WAYS, can_walk),
        ("trees.subtrees.place:_no_other_spot_helps", JUDGES_ATTEMPTS, no_other_attempt_helps),
        ("trees.skills.put_in.tree:_nothing_else_helps", JUDGES_ATTEMPTS, no_other_attempt_helps),
    ],
)
def test_names_of_before_are_read_as_what_they_meant(written, hint, meant):
    assert from_text(written, hint) is meant


@pytest.mark.parametrize("file", sorted(DATA.glob("*.xml")), ids=lambda file: file.stem)
def test_a_document_of_before_is_read_and_written_anew_without_modules(file, stage):
    stored = file.read_text("utf-8")
    assert MODULE.search(stored)

    again = write_tree(read_tree(stored, stage.toolbox))

    assert not MODULE.search(again)
    assert write_tree(read_tree(again, stage.toolbox)) == again
    assert again.count("hopeless=") == stored.count("hopeless=")


def test_an_unknown_judgement_is_refused_with_the_nearest_one(stage):
    with pytest.raises(TreeDocumentError, match="no judgement 'defects'; did you mean 'defect'"):
        read_tree(alternatives("defects"), stage.toolbox)


def test_where_none_is_near_those_that_fit_are_told(stage):
    with pytest.raises(TreeDocumentError, match=r"no judgement 'xyz'; there are .*worth_going") as refused:
        read_tree(alternatives("xyz", "worth_trying"), stage.toolbox)

    assert "defect" not in str(refused.value)


def test_a_judgement_of_something_else_is_refused_with_what_it_judges(stage):
    with pytest.raises(
        TreeDocumentError, match="'no_other_attempt_helps' judges Failure, Failure; here Failure is"
    ):
        read_tree(alternatives("no_other_attempt_helps"), stage.toolbox)


def test_a_function_that_is_not_declared_cannot_be_written(stage, probe_leaf):
    def always(failure: Failure) -> bool:
        return True

    for undeclared in (always, judgement(always)):
        node = Alternatives("ways", [probe_leaf("way", stage.toolbox)], hopeless=undeclared)
        with pytest.raises(ValueError, match="always"):
            to_text(node.hopeless)


@pytest.fixture
def bowing(monkeypatch):
    """A package from outside that brings judgements."""
    module = types.ModuleType("bowing_bow")
    monkeypatch.setitem(sys.modules, "bowing_bow", module)
    code = (
        "from trees.failures import Failure\nfrom trees.nodes.judgements import judgement\n"
        "@judgement\ndef too_stiff(failure: Failure) -> bool:\n    'It does not bend.'\n    return True\n"
        "@judgement\ndef defect(failure: Failure) -> bool:\n    'Another.'\n    return True\n"
        "def plain(failure): ...\n"
    )
    exec(code, module.__dict__)
    return module


def test_installed_packages_bring_judgements_of_their_own(bowing, monkeypatch):
    points = [
        EntryPoint("stiff", "bowing_bow:too_stiff", "humanoid_executive.judgements"),
        EntryPoint("again", "bowing_bow:too_stiff", "humanoid_executive.judgements"),
        EntryPoint("plain", "bowing_bow:plain", "humanoid_executive.judgements"),
        EntryPoint("taken", "bowing_bow:defect", "humanoid_executive.judgements"),
        EntryPoint("gone", "bowing_bow:nothing", "humanoid_executive.judgements"),
    ]

    found = load_judgements(points)

    assert found.judgements == {"too_stiff": bowing.too_stiff}
    assert len(found.complaints) == 4
    monkeypatch.setattr(judgement_names, "outside_judgements", lambda: found)
    known_judgements.cache_clear()
    try:
        assert from_text("too_stiff", JUDGES) is bowing.too_stiff
        assert from_text("bowing_bow:too_stiff", JUDGES) is bowing.too_stiff
        assert from_text("defect", JUDGES) is defect
        with pytest.raises(ValueError, match=r"no judgement 'trees\.bow:too_stiff'"):
            from_text("trees.bow:too_stiff", JUDGES)
    finally:
        known_judgements.cache_clear()
