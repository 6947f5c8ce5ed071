"""What people may say to a served executive, over a real socket: sentences, pauses, cancels, questions."""

import os

import pytest

from executive.dialogue.clarification import OpenQuestion
from executive.exit_codes import ExitCode
from executive.live.desk_messages import (
    Answer,
    Cancel,
    GetScene,
    GetWorld,
    HandBack,
    Jog,
    Listen,
    PauseTask,
    ResumeTask,
    Say,
    ScriptLine,
    TakeOver,
    Velocity,
    Watch,
    write_desk_message,
)
from executive.live.served_executive.desk import Desk
from robots.live.wire.connection import Connection
from robots.live.wire.messages import GetStatus, read_object, write_message
from robots.live.wire.unix_socket import connect_to
from trees.events import Said


class Attended:
    def __init__(self):
        self.heard, self.paused, self.velocities, self.by_hand = [], False, [], []

    def cancel(self, reason):
        self.heard.append(("cancel", reason))

    def pause(self, reason):
        self.heard.append(("pause", reason))
        self.paused = True

    def resume(self):
        self.heard.append(("resume",))
        self.paused = False

    def scene(self):
        return [{"name": "red cup"}]

    def world(self):
        return {"version": 3, "things": []}

    def take_over(self):
        self.by_hand.append("take over")

    def hear_jog(self, message):
        self.by_hand.append(message.move)

    def hand_back(self, ending):
        self.by_hand.append(ending)

    def hear_velocity(self, linear_m_s, angular_rad_s):
        self.velocities.append((linear_m_s, angular_rad_s))

    def status(self):
        return {"task": None, "paused": self.paused}


class Person:
    def __init__(self, path, desk):
        self.desk, self.connection = desk, Connection(connect_to(path))

    def says(self, message):
        payload = message if isinstance(message, bytes) else write_desk_message(message)
        self.connection.send(payload)
        for _ in range(5):
            self.desk.poll()
        return [read_object(frame.payload) for frame in self.connection.receive()]


@pytest.fixture
def attended():
    return Attended()


@pytest.fixture
def desk(attended, tmp_path):
    made = Desk(tmp_path / "desk.sock", attended, lambda text: text == "stop")
    yield made
    made.close()


@pytest.fixture
def another(desk, tmp_path):
    """Makes people, and sends them home at the end."""
    made = []

    def one():
        made.append(Person(tmp_path / "desk.sock", desk))
        return made[-1]

    yield one
    for person in made:
        person.connection.close("")


@pytest.fixture
def person(another):
    return another()


@pytest.fixture
def busy(desk, person):
    """Somebody's sentence is being carried out."""
    person.says(Say("pick up the red cup"))
    assert desk.next_order().said.text == "pick up the red cup"
    return person


def test_a_task_is_paused_and_goes_on(busy, attended):
    assert busy.says(PauseTask("a moment")) == [{"type": "done", "under_way": True}]
    assert busy.says(ResumeTask()) == [{"type": "done", "paused": True}]
    assert attended.heard == [("pause", "a moment"), ("resume",)]


def test_without_a_task_there_is_nothing_to_pause_to_resume_or_to_cancel(person, attended):
    assert person.says(PauseTask("a moment")) == [{"type": "done", "under_way": False}]
    assert person.says(ResumeTask()) == [{"type": "done", "paused": False}]
    assert person.says(Cancel("enough")) == [{"type": "done", "under_way": False}]
    assert ("pause", "a moment") not in attended.heard
    assert ("cancel", "enough") not in attended.heard


def test_who_listens_hears_what_others_are_told_of_their_orders_and_whose_they_are(desk, person, another):
    listener = another()
    assert listener.says(Listen()) == [{"type": "done", "listeners": 1}]
    person.says(Say("wave"))
    order = desk.next_order()
    order.tell("accepted: wave")
    order.end("done: wave", "done", ExitCode.DONE)

    heard = [read_object(frame.payload) for frame in listener.connection.receive()]
    assert [(one["type"], one["text"], one["by"]) for one in heard] == [
        ("heard", "accepted: wave", os.getpid()),
        ("heard", "done: wave", os.getpid()),
    ]
    assert person.says(GetStatus())[-1]["listeners"] == 1


def test_who_listens_is_not_told_twice_of_an_order_of_its_own_nor_after_it_has_gone(desk, person, another):
    person.says(Listen())
    person.says(Say("wave"))
    order = desk.next_order()
    order.tell("accepted: wave")

    assert [read_object(frame.payload)["type"] for frame in person.connection.receive()] == ["line"]
    person.connection.close("")
    assert another().says(GetStatus())[-1]["listeners"] == 0


def test_who_watches_hears_of_events_until_it_goes_away(desk, person, another):
    watcher = another()
    assert watcher.says(Watch()) == [{"type": "done"}]
    desk.watchers.event(Said(1.0, "hello"))
    (heard,) = [read_object(frame.payload) for frame in watcher.connection.receive()]
    assert (heard["told"]["event"], heard["line"]) == ("Said", "says: hello")
    assert person.connection.receive() == []

    watcher.connection.close("")
    desk.poll()
    assert desk.watchers.connections == []


def test_the_world_is_told_to_whoever_asks(person):
    assert person.says(GetWorld()) == [{"type": "world", "version": 3, "things": []}]


@pytest.mark.requirement("S7")
def test_a_spoken_stop_cancels_what_another_one_asked_for(busy, attended, another):
    (told,) = another().says(Say("stop"))

    assert told["exit_code"] == 0
    assert attended.heard == [("cancel", "stop was said")]


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("message", [Cancel("enough"), Say("stop")], ids=["cancel", "stop"])
def test_what_has_come_and_not_begun_yet_is_cancelled_too(person, desk, another, message):
    person.says(Say("walk to the kitchen"))

    (told,) = another().says(message)

    assert told.get("under_way", True) is True
    assert [read_object(frame.payload)["outcome"] for frame in person.connection.receive()] == ["cancelled"]
    assert desk.next_order() is None


def test_a_second_sentence_is_refused_while_one_is_carried_out(busy, another):
    (told,) = another().says(Say("wave"))

    assert told["exit_code"] == 2
    assert "busy" in told["text"]
    assert f"'pick up the red cup' (of process {os.getpid()})" in told["text"]


@pytest.mark.requirement("S7")
def test_who_gave_the_task_and_goes_away_cancels_it(busy, desk, attended):
    busy.connection.close("")
    desk.poll()
    desk.poll()

    assert attended.heard == [("cancel", "who gave the task has gone")]


def test_an_answer_counts_while_a_question_is_open(busy, desk):
    assert busy.says(Answer("2")) == [{"type": "done", "asked": False}]
    desk.question = OpenQuestion("which cup?")
    assert busy.says(Answer("2")) == [{"type": "done", "asked": True}]
    assert desk.given == ["2"]


def test_whoever_asks_for_the_scene_is_told_what_is_believed(another):
    assert another().says(GetScene()) == [{"type": "scene", "things": [{"name": "red cup"}]}]


@pytest.mark.requirement("U3")
def test_velocities_are_one_order_as_long_as_their_sender_sends_them(another, desk, attended):
    sender = another()
    sender.says(Velocity(0.2, 0.0))
    order = desk.next_order()
    sender.says(Velocity(0.3, 0.1))

    assert isinstance(order.said, Velocity)
    assert desk.next_order() is None
    assert attended.velocities == [(0.2, 0.0), (0.3, 0.1)]


@pytest.mark.requirement("U3")
def test_a_velocity_beside_a_task_is_refused_and_reaches_nobody(busy, another, attended):
    (told,) = another().says(Velocity(0.2, 0.0))

    assert told["type"] == "refused"
    assert attended.velocities == []


@pytest.mark.requirement("F4")
@pytest.mark.parametrize("payload", [b"{}", b"say", write_message("say"), write_message("pause", reason=7)])
def test_what_is_no_message_ends_the_connection_with_a_reason(person, payload, another):
    (told,) = person.says(payload)

    assert told["type"] == "error"
    assert another().says(GetStatus())[0]["type"] == "status"


def test_a_script_is_an_order_when_its_last_statement_has_come(person, desk):
    lines = (ScriptLine("tidy.toml", "wave"), ScriptLine("tidy.toml", "go home", "continue", last=True))

    person.says(lines[0])
    assert desk.next_order() is None
    person.says(lines[1])

    assert desk.next_order().said.lines == lines


def test_what_is_left_of_a_script_whose_sender_goes_away_is_forgotten(another, desk):
    first = another()
    first.says(ScriptLine("tidy.toml", "wave"))
    first.connection.close("")
    desk.poll()
    desk.poll()

    another().says(ScriptLine("tidy.toml", "go home", last=True))

    assert [line.text for line in desk.next_order().said.lines] == ["go home"]


@pytest.mark.requirement("S3")
def test_whoever_waits_for_a_turn_is_told_when_the_desk_closes(person, desk):
    person.says(Say("wave"))

    desk.close()

    (told,) = [read_object(frame.payload) for frame in person.connection.receive()]
    assert (told["type"], told["exit_code"]) == ("result", 1)


@pytest.mark.requirement("S7")
def test_a_script_that_only_says_stop_cancels_what_is_under_way(busy, attended, another):
    another().says(ScriptLine("stop.toml", "stop", last=True))

    assert attended.heard == [("cancel", "stop was said")]


@pytest.mark.parametrize("wrong", [{"expect": "refsued"}, {"on_failure": "never"}])
def test_a_statement_with_a_word_that_there_is_not_ends_the_connection(person, wrong):
    (told,) = person.says(ScriptLine("tidy.toml", "wave", **wrong))

    assert told["type"] == "error"
    assert next(iter(wrong.values())) in told["reason"]


@pytest.mark.requirement("S10")
def test_a_person_takes_over_what_is_under_way_says_words_and_gives_it_back(desk, attended, another):
    worker, person = another(), another()
    worker.says(Say("pick up the cup"))
    desk.next_order()

    (answer,) = person.says(TakeOver())
    person.says(Jog("brake"))
    person.says(HandBack("held_right"))

    assert answer["under_way"] is True
    assert attended.by_hand == ["take over", "brake", "held_right"]


@pytest.mark.requirement("S10")
def test_only_one_person_has_the_robot_and_words_of_others_are_not_heard(desk, attended, another):
    first, second = another(), another()
    first.says(TakeOver())

    (refused,) = second.says(TakeOver())
    second.says(Jog("brake"))

    assert refused["reason"] == "somebody else jogs the robot"
    assert attended.by_hand == []


@pytest.mark.requirement("S10")
def test_a_person_who_hangs_up_has_given_up(desk, attended, another):
    worker, person = another(), another()
    worker.says(Say("pick up the cup"))
    desk.next_order()
    person.says(TakeOver())

    person.connection.close("")
    for _ in range(5):
        desk.poll()

    assert attended.by_hand == ["take over", "give_up"]
