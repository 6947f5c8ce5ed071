"""What a task does and what it came to, as the rclpy node tells it."""

import json
import math
import sys
from pathlib import Path

import pytest
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

import executive.doors.ros.node
from executive.doors.ros.node.progress import Progress, account_of, under_way

NODE = Path(executive.doors.ros.node.__file__).parent
PACKAGE = NODE / "humanoid_executive_interfaces"


def node(depth, name, status, message=""):
    return {"depth": depth, "name": name, "status": status, "message": message}


TREE = [
    node(0, "pick", "running"),
    node(1, "find", "success"),
    node(2, "look", "success"),
    node(1, "reach", "running"),
    node(2, "plan", "success", "3 ways"),
    node(2, "stream", "running", "at 0.42 of 1.5 s, +3 degrees, v2 of joint_7"),
    node(1, "lift", "idle"),
]


def test_the_path_leads_from_the_root_to_the_leaf_that_runs():
    assert under_way(TREE) == (("pick", "reach", "stream"), TREE[5]["message"])


@pytest.mark.parametrize("tree", [None, [], [node(0, "pick", "success"), node(1, "look", "running")]])
def test_where_nothing_is_under_way_there_is_no_path(tree):
    assert under_way(tree) == ((), "")


def test_the_numbers_of_a_leaf_are_told_with_the_word_behind_them():
    progress = Progress(tree_path=("a", "b"), leaf_says=TREE[5]["message"])

    assert progress.leaf == "b"
    assert progress.quantities == [(0.42, "of"), (1.5, "s"), (3.0, "degrees")]


REPORT = {
    "tasks": [
        {
            "text": "pick up the cup",
            "evidence": {"opening_m": 0.041, "held": True, "hand": "left"},
            "failure": None,
        },
        {
            "text": "put it down",
            "evidence": {},
            "failure": {
                "kind": "EXECUTION",
                "where": "place/lower",
                "message": "not lowered",
                "numbers": {"gap_m": 0.1},
                "cause": {
                    "kind": "UNSAFE",
                    "where": "place/check",
                    "message": "too near",
                    "numbers": {},
                    "cause": None,
                },
            },
        },
    ]
}


@pytest.fixture
def account(tmp_path):
    (tmp_path / "report.json").write_text(json.dumps(REPORT))
    return account_of({"outcome": "failed", "text": "failed: not lowered", "run": str(tmp_path)})


def test_an_account_holds_evidence_and_the_chain_of_failures(account):
    assert (account.outcome, account.message) == ("failed", "failed: not lowered")
    assert account.evidence == (("pick up the cup", REPORT["tasks"][0]["evidence"]),)
    assert [one.kind for one in account.failures] == ["EXECUTION", "UNSAFE"]
    assert json.loads(account.report) == REPORT


def test_a_task_that_was_not_recorded_is_accounted_for_by_its_result():
    account = account_of({"outcome": "refused", "text": "refused: no", "run": "/nowhere"})

    assert (account.outcome, account.evidence, account.failures, account.report) == ("refused", (), (), "")


@pytest.fixture
def messages(monkeypatch):
    """The module that fills the package's messages in, and the package's messages by rosbags."""
    monkeypatch.syspath_prepend(str(NODE))
    for name in ("own_messages", "progress"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    import own_messages

    store, found = get_typestore(Stores.ROS2_JAZZY), {}
    for path in sorted(PACKAGE.glob("msg/*.msg")):
        found |= get_types_from_msg(path.read_text(), f"{PACKAGE.name}/msg/{path.stem}")
    parts = (PACKAGE / "action" / "ExecuteTask.action").read_text().split("---\n")
    for name, text in zip(("Goal", "Result", "Feedback"), parts, strict=True):
        found |= get_types_from_msg(text, f"{PACKAGE.name}/msg/ExecuteTask_{name}")
    store.register(found)

    class Kinds:
        pass

    for name in found:
        setattr(Kinds, name.rpartition("/")[2], store.types[name])
    return own_messages, Kinds


def test_feedback_fills_the_packages_message(messages):
    own, kinds = messages
    progress = Progress("a line", ("pick", "reach"), "+0.5 m", "which cup?", ("red", "blue"))

    told = kinds.ExecuteTask_Feedback(**own.feedback_fields(progress, kinds))

    assert (told.tree_path, told.leaf, told.question) == (["pick", "reach"], "reach", "which cup?")
    assert (told.quantities[0].value, told.quantities[0].unit) == (0.5, "m")


def test_the_result_fills_the_packages_message(messages, account):
    own, kinds = messages

    told = kinds.ExecuteTask_Result(**own.result_fields(account, kinds))

    values = {one.name: (one.text, one.number) for one in told.evidence[0].values}
    assert values["opening_m"] == ("0.041", 0.041)
    assert values["held"] == ("True", 1.0)
    assert math.isnan(values["hand"][1])
    assert [one.where for one in told.failures] == ["place/lower", "place/check"]
    assert told.failures[0].numbers[0].number == 0.1


def test_every_interface_of_the_package_is_built():
    listed = (PACKAGE / "CMakeLists.txt").read_text()

    for kind in ("msg", "srv", "action"):
        for path in PACKAGE.glob(f"{kind}/*"):
            assert f'"{kind}/{path.name}"' in listed
