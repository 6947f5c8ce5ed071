"""Answers to Groot2, beside those of BehaviorTree.CPP's own publisher."""

import random
import struct

import behaviortreepy
import msgpack
import pytest
import zmq

from executive.doors.groot.monitored_tree import MonitoredTree
from executive.doors.groot.requests import HOOKS_REFUSED, answer

DOCUMENT = """<root BTCPP_format="4" main_tree_to_execute="Main"><BehaviorTree ID="Main">
  <Sequence name="do"><Sees name="sees"/><Fallback name="ways">
    <Inverter name="not"><Reach name="reach"/></Inverter>
    <ReactiveSequence name="guarded"><Near name="near"/><Grasp name="grasp"/>
    </ReactiveSequence></Fallback><Lift name="lift"/></Sequence></BehaviorTree></root>"""
_PORT = iter(range(17100, 17200, 2))
_TRANSITION = 9


def request(letter, number=7, version=2):
    return struct.pack("<BcI", version, letter, number)


class Publisher:
    """The real one, with a tree whose leaves answer by chance."""

    def __init__(self, seed):
        chance, status = random.Random(seed), behaviortreepy.NodeStatus
        any_of = [status.SUCCESS, status.FAILURE, status.RUNNING]
        factory = behaviortreepy.BehaviorTreeFactory()
        for name in ("Reach", "Grasp", "Lift"):
            factory.register_simple_stateful_action(
                name, lambda _: chance.choice(any_of), lambda _: chance.choice(any_of), lambda _: None
            )
        for name in ("Sees", "Near"):
            factory.register_simple_condition(name, lambda _: chance.choice(any_of[:2]))
        self.tree = factory.create_tree_from_text(DOCUMENT)
        self._port = next(_PORT)
        self._publisher = behaviortreepy.Groot2Publisher(self.tree, self._port)
        self._context = zmq.Context()

    def ask(self, *parts):
        socket = self._context.socket(zmq.REQ)
        socket.connect(f"tcp://127.0.0.1:{self._port}")
        socket.send_multipart(parts)
        assert socket.poll(5000)
        told = socket.recv_multipart()
        socket.close(0)
        return told

    def close(self):
        self._context.destroy(0)
        self._publisher = None


@pytest.fixture(params=range(5))
def theirs(request):
    made = Publisher(request.param)
    yield made
    made.close()


@pytest.fixture(scope="module")
def resting():
    """The real one, of a tree that nobody ticks."""
    made = Publisher(0)
    yield made
    made.close()


@pytest.fixture
def ours():
    return MonitoredTree(DOCUMENT)


def same(mine, other):
    """Whether two answers are the same but for the tree's id."""
    if other[0] == b"error":
        return mine == other
    return mine[0][:6] == other[0][:6] and len(mine[0]) == len(other[0]) == 22 and mine[1:] == other[1:]


def changes(told):
    """Number and status of each recorded change, without its time."""
    return [told[i + 6 : i + _TRANSITION] for i in range(0, len(told), _TRANSITION)]


@pytest.mark.parametrize(
    "parts",
    [
        [request(b"S")],
        [request(b"S", 2**32 - 1)],
        [request(b"S", version=3)],
        [request(b"S"), b"more"],
        [request(b"B")],
        [request(b"B"), b""],
        [request(b"B"), b"Main"],
        [request(b"B"), b"Other;Main"],
        [request(b"B"), b"Other"],
        [request(b"r")],
        [request(b"r"), b"stop"],
        [request(b"r"), b"what"],
        [request(b"t")],
        [request(b"D")],
        [request(b"A")],
        [request(b"X")],
        [request(b"I")],
        [request(b"R")],
        [request(b"U")],
        [request(b"N")],
        [request(b"?")],
        [request(b"\0")],
        [b""],
        [b"short"],
        [request(b"S") + b"x"],
    ],
    ids=repr,
)
def test_each_request_is_answered_as_by_the_real_publisher(parts, resting, ours):
    assert same(answer(parts, ours, 1), resting.ask(*parts))


def test_statuses_and_changes_of_any_run_are_those_of_the_real_publisher(theirs, ours):
    begun = theirs.ask(request(b"r"), b"start")
    mine = answer([request(b"r"), b"start"], ours, 1_700_000_000_000_000)
    assert begun[1].isdigit()
    assert mine[1].isdigit()
    for _ in range(40):
        theirs.tree.tick_exactly_once()
        told = theirs.ask(request(b"t"))[1]
        for change in changes(told):
            ours.change(*struct.unpack("<HB", change), 1_700_000_000_000_500)
        assert changes(answer([request(b"t")], ours, 1)[1]) == changes(told)
        assert same(answer([request(b"S")], ours, 1), theirs.ask(request(b"S")))


def test_nodes_have_the_numbers_that_the_real_publisher_gives_them(resting, ours):
    told = resting.ask(request(b"T"))[1].decode()
    mine = answer([request(b"T")], ours, 1)[1].decode()

    for uid, name in enumerate(["do", "sees", "ways", "not", "reach", "guarded", "near", "grasp", "lift"], 1):
        for text in (told, mine):
            (line,) = [line for line in text.replace("><", ">\n<").splitlines() if f'name="{name}"' in line]
            assert f'_uid="{uid}"' in line


@pytest.mark.parametrize("letter", [b"I", b"R", b"U"])
def test_hooks_are_refused(letter, ours):
    assert answer([request(letter), b"{}"], ours, 1) == [b"error", HOOKS_REFUSED.encode()]


def test_another_tree_has_another_id(ours):
    assert MonitoredTree(DOCUMENT, 1).id != ours.id
    assert MonitoredTree(DOCUMENT.replace("do", "try")).id != ours.id


def test_what_nodes_say_stands_on_the_blackboard(ours):
    ours.note(
        [
            {"name": "reach", "status": "running", "message": "0.12 m to go"},
            {"name": "grasp", "status": "idle", "message": "old"},
        ]
    )

    told = msgpack.unpackb(answer([request(b"B"), b"Main"], ours, 1)[1])
    assert told == {"Main": {"reach": "0.12 m to go"}}


def test_only_the_newest_thousand_changes_are_kept(ours):
    answer([request(b"r"), b"start"], ours, 100)
    for i in range(3000):
        ours.change(1, 1 + i % 2, 100 + i)

    kept = answer([request(b"t")], ours, 1)[1]
    assert len(kept) == 1000 * _TRANSITION
    assert int.from_bytes(kept[-9:-3], "little") == 2999
