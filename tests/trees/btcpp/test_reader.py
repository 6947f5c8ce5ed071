"""Documents that people write: trees in trees, handed-on ports, and what is refused with which words."""

import sys

import pytest

from trees.btcpp.errors import TreeDocumentError
from trees.btcpp.reader import read_tree
from trees.leaves.go_home import GoHome
from trees.policy import Gaze
from trees.skills.looking.look_at import LookAt


def tree(body, *more):
    others = "".join(f'<BehaviorTree ID="{name}">{text}</BehaviorTree>' for name, text in more)
    head = '<root BTCPP_format="4" main_tree_to_execute="Main">'
    return f'{head}<BehaviorTree ID="Main">{body}</BehaviorTree>{others}</root>'


def test_leaves_get_their_settings_and_their_wiring(stage):
    root = read_tree(
        tree(
            '<Sequence name="all"><LookAt name="up" gaze="up;0.1;0.2"/>'
            '<CheckTrajectory step="{reach}"/><Action ID="GoHome"/></Sequence>'
        ),
        stage.toolbox,
    )
    look, check, home = root.children

    assert isinstance(look, LookAt)
    assert look.gaze == Gaze("up", 0.1, 0.2)
    assert look.name == "up"
    assert check.wiring == {"step": "reach", "checked": "checked"}
    assert isinstance(home, GoHome)


def test_a_tree_in_a_tree_has_keys_of_its_own_but_for_what_is_handed_on(stage):
    body = (
        '<Sequence><SubTree ID="Look" task="{job}"/><SubTree ID="Look" _autoremap="true"/>'
        '<SubTree ID="Look" name="third"/></Sequence>'
    )
    root = read_tree(tree(body, ("Look", '<Detect name="see" target="{@seen}"/>')), stage.toolbox)
    first, second, third = root.children

    assert first.wiring["task"] == "job"
    assert first.wiring["others"] == "Look_1_others"
    assert second.wiring["task"] == "task"
    assert third.wiring["task"] == "Look_3_task"
    assert {one.wiring["target"] for one in root.children} == {"seen"}
    assert third.name == "third"


def test_a_timeout_is_a_deadline_on_the_injected_clock(stage):
    root = read_tree(tree('<Timeout msec="250"><GoHome/></Timeout>'), stage.toolbox)

    assert root.deadline_s == 0.25


BOMB = '<!DOCTYPE x [<!ENTITY a "aa"><!ENTITY b "&a;&a;">]>'
DEEP = "<Inverter>" * 300 + "<GoHome/>" + "</Inverter>" * 300


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "is no XML"),
        ("<root/>", "must be a <root"),
        (tree("<GoHome/>").replace('"4"', '"3"'), "must be a <root"),
        (BOMB + tree("<GoHome/>"), "not read"),
        (tree("<GoHome/>").replace("<Behavior", '<include path="/etc/passwd"/><Behavior', 1), "not read"),
        (tree("<GoHome/>").replace('execute="Main"', 'execute="Other"'), "one of its trees: Main"),
        (tree("<GoHome/><GoHome/>"), "Main: needs one root node, not 2"),
        (tree("<GoHme/>"), "Main/GoHme: there is no node 'GoHme'; did you mean 'GoHome'?"),
        (tree('<Sequence name="a"/>'), "Main/a: needs 1 or more nodes below it, not 0"),
        (tree("<Inverter><GoHome/><GoHome/></Inverter>"), "needs 1 nodes below it, not 2"),
        (tree('<GoHome speed="9"/>'), "GoHome has no port 'speed'"),
        (tree('<LookAt name="l"/>'), "Main/l: LookAt needs a value at its port 'gaze'"),
        (tree('<LookAt gaze="up;high"/>'), "gaze: could not convert string to float: 'high'"),
        (tree('<LookAt gaze="up;nan"/>'), "gaze: must be finite"),
        (tree('<Survey keeping="yes"/>'), "keeping: must be true or false, not 'yes'"),
        (
            tree('<Detect part="yes"/>'),
            "part: must be one of alone, first, side, last, again, closer, known, asking, not 'yes'",
        ),
        (tree('<Detect task="pick"/>'), "task must refer to a key, as {task}, not 'pick'"),
        (tree('<GoHome _skipIf="x > 1"/>'), "_skipIf needs a script, and scripts are not run"),
        (tree('<SubTree ID="Nowhere"/>'), "there is no tree 'Nowhere'"),
        (tree('<SubTree ID="Main"/>'), "the tree 'Main' is within itself"),
        (tree('<Repeat num_cycles="often"><GoHome/></Repeat>'), "num_cycles: invalid literal"),
        (tree(DEEP), "deeper than 200 nodes"),
        (tree("<GoHome/>") + " " * 2_000_000, "longer than"),
    ],
)
def test_what_is_no_tree_is_refused_with_the_place_and_the_reason(stage, text, words):
    with pytest.raises(TreeDocumentError) as refused:
        read_tree(text, stage.toolbox)

    assert words in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    "judgement",
    [
        "os:system",
        "subprocess:run",
        "trees.build:build_tree",
        "trees.failures:Failure",
        "trees.nodes.alternatives:Alternatives",
        "trees.nodes.judgements:always_worth_trying",
        "os:defect",
        "trees.nodes.alternatives:failure_of",
        "Failure",
        "",
        "trees.nodes.judgements",
        "trees.nodes.judgements:defect.__globals__",
    ],
)
def test_nothing_but_a_judgement_can_be_named_as_one(stage, judgement):
    body = f'<Alternatives hopeless="{judgement}"><GoHome/></Alternatives>'

    with pytest.raises(TreeDocumentError, match="hopeless: "):
        read_tree(tree(body), stage.toolbox)


def test_a_module_that_brings_no_trees_is_not_even_imported(stage, tmp_path, monkeypatch):
    (tmp_path / "stranger.py").write_text(
        "from trees.failures import Failure\n\n\ndef judge(failure: Failure) -> bool:\n    return True\n"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    body = '<Alternatives hopeless="stranger:judge"><GoHome/></Alternatives>'

    with pytest.raises(TreeDocumentError, match="there is no judgement 'stranger:judge'"):
        read_tree(tree(body), stage.toolbox)

    assert "stranger" not in sys.modules
