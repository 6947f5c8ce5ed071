"""The Python interface: submit, subscribe, answer, cancel, await."""

import asyncio
import re
from pathlib import Path

import pytest

from executive.embedding.ticket import Ticket
from executive.session.events import InputTaken, QuestionAsked, TaskAccepted, TaskEnded
from executive.trust import Trust

GUIDE = Path(__file__).parents[3] / "docs" / "guides" / "python.md"
DOUBTFUL = [{"command": "go home", "confidence": 0.4}]
CONFIRM = "step 1, 'go home', has confidence 0.40, below 0.80: shall it be done?"


@pytest.mark.requirement("S9")
def test_a_ticket_gives_results_and_tells_events(fake_stage):
    on, heard = fake_stage(), []
    ticket = on.requests.submit("pick up the red cup")
    ticket.subscribe(heard.append)

    [result] = ticket.result()

    assert (result.outcome, result.acted_on) == ("done", "red cup")
    assert isinstance(heard[0], TaskAccepted)
    assert isinstance(heard[-1], TaskEnded)
    assert any(type(event).__name__ == "NodeChanged" for event in heard)


def test_nothing_begins_before_somebody_waits(fake_stage):
    on = fake_stage()

    ticket = on.requests.submit("pick up the red cup")

    assert not ticket.done
    assert not on.events


def test_tickets_run_in_their_order_whoever_is_waited_for(fake_stage):
    on = fake_stage()
    first, second = on.requests.submit("pick up the red cup"), on.requests.submit("go home")

    second.result()

    assert first.done
    assert [event.meaning["action"] for event in on.of(TaskAccepted)] == ["pick", "go_home"]


@pytest.mark.requirement("L6")
def test_a_question_holds_the_ticket_until_it_is_answered(fake_stage):
    on = fake_stage()
    ticket = on.requests.submit("pick up the cup")
    while ticket.advance():
        pass

    assert ticket.question.choices == ("red cup", "blue cup")
    assert not ticket.advance()
    assert not on.arms_moved()
    ticket.answer("the blue one")
    assert ticket.result()[0].acted_on == "blue cup"


def test_a_question_that_nobody_answers_ends_the_task(fake_stage):
    assert fake_stage().requests.submit("pick up the cup").result()[0].outcome == "question"


def test_an_answer_without_a_question_is_a_mistake(fake_stage):
    with pytest.raises(RuntimeError, match="no question"):
        fake_stage().requests.submit("go home").answer("yes")


@pytest.mark.requirement("S7")
def test_a_ticket_can_be_cancelled_on_its_way_and_the_next_one_works(fake_stage):
    on = fake_stage()
    ticket = on.requests.submit("pick up the red cup")
    for _ in range(30):
        ticket.advance()

    ticket.cancel("changed my mind")

    assert ticket.result()[0].outcome == "cancelled"
    assert on.requests.submit("go home").result()[0].outcome == "done"


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("text", ["pick up", "pick up the cup"])
def test_a_cancel_while_a_question_is_open_does_not_reach_the_next_ticket(fake_stage, text):
    on = fake_stage()
    ticket = on.requests.submit(text)
    while ticket.advance():
        pass

    ticket.cancel("changed my mind")
    ticket.result()

    assert on.requests.submit("go home").result()[0].outcome == "done"


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("text", ["pick up", "pick up the cup"])
def test_a_cancel_while_a_question_is_open_ends_the_ticket_as_cancelled(fake_stage, text):
    on = fake_stage()
    ticket = on.requests.submit(text)
    while ticket.advance():
        pass

    ticket.cancel("changed my mind")

    [result] = ticket.result()
    assert (result.outcome, result.failure.message) == ("cancelled", "changed my mind")
    assert on.of(InputTaken)[-1].what == "cancel"
    assert [event.value for event in on.of(InputTaken) if event.value] == ["changed my mind"]


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("text", ["pick up", "pick up the red cup"])
def test_a_ticket_that_is_cancelled_before_its_turn_neither_asks_nor_begins(fake_stage, text):
    on = fake_stage()
    ticket = on.requests.submit(text)
    ticket.on_question(lambda question: pytest.fail(f"asked {question.text!r}"))

    ticket.cancel("changed my mind")

    assert [result.outcome for result in ticket.result()] == ["cancelled"]
    assert not on.of(QuestionAsked)
    assert not on.of(TaskAccepted)


@pytest.mark.requirement("S7")
def test_a_cancelled_ticket_keeps_its_turn(fake_stage):
    on = fake_stage()
    first, second, third = (on.requests.submit(text) for text in ("pick up the red cup", "wave", "go home"))

    second.cancel("changed my mind")

    assert third.result()[0].outcome == "done"
    assert first.result()[0].outcome == "done"
    assert second.result()[0].outcome == "cancelled"


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("text", ["pick up", "pick up the cup"])
def test_an_emergency_stop_ends_the_question_of_a_ticket(fake_stage, text):
    on = fake_stage(guarded=True)
    ticket = on.requests.submit(text)
    while ticket.advance():
        pass

    on.session.emergency_stop("the red button")

    ticket.advance()
    assert ticket.done
    [result] = ticket.result()
    assert result.outcome == "cancelled"
    assert "the red button" in result.failure.message


@pytest.mark.requirement("S7")
def test_a_cancel_of_what_is_refused_anyway_does_not_reach_the_next_ticket(fake_stage):
    on = fake_stage()
    ticket = on.requests.submit("pick up the zorbl")

    ticket.cancel("changed my mind")
    ticket.result()

    assert on.requests.submit("go home").result()[0].outcome == "done"


@pytest.mark.requirement("L7", "L8")
def test_steps_may_be_python_values(fake_stage):
    steps = [{"action": "pick", "object": {"kind": "cup", "color": "red"}, "confidence": 0.95}]

    [result] = fake_stage().requests.submit(steps).result()

    assert result.outcome == "done"
    assert result.provenance.confidence == 0.95


@pytest.mark.requirement("L8")
@pytest.mark.parametrize(
    ("answer", "outcome"),
    [
        ("yes", "done"), ("Yes.", "done"), ("sure", "done"), ("ok", "done"), ("go ahead", "done"),
        ("1", "done"), ("no", "refused"), ("the moon", "question"), (None, "question"),
    ],
)  # fmt: skip
def test_a_step_of_low_confidence_is_asked_about(fake_stage, answer, outcome):
    ticket = fake_stage().requests.submit(DOUBTFUL, trust=Trust(0.8))
    ticket.on_question(lambda question: answer)

    assert ticket.result()[0].outcome == outcome


@pytest.mark.requirement("L8")
@pytest.mark.parametrize(("on_question", "outcome"), [("first", "done"), ("fail", "question")])
def test_what_becomes_of_a_question_about_low_confidence_can_be_said_beforehand(
    fake_stage, on_question, outcome
):
    on = fake_stage()
    ticket = on.requests.submit(DOUBTFUL, trust=Trust(0.8), on_question=on_question)
    ticket.on_question(lambda question: pytest.fail(f"asked {question.text!r}"))

    assert ticket.result()[0].outcome == outcome
    assert [event.question for event in on.of(QuestionAsked)] == [CONFIRM]


@pytest.mark.requirement("L6")
def test_a_question_about_the_words_themselves_holds_the_ticket_until_it_is_answered(fake_stage):
    on = fake_stage()
    ticket = on.requests.submit("pick up")
    while ticket.advance():
        pass

    assert ticket.question.text == "pick up what?"
    assert not on.of(TaskAccepted)
    ticket.answer("the red cup")
    assert ticket.result()[0].acted_on == "red cup"
    assert [event.value for event in on.of(InputTaken)] == ["the red cup"]


@pytest.mark.requirement("L6")
def test_an_answer_to_the_words_that_is_not_understood_is_asked_again_with_the_reason(fake_stage):
    asked = []
    ticket = fake_stage().requests.submit("pick up")
    ticket.on_question(lambda question: asked.append(question) or ("zorbl", "the blue cup")[len(asked) - 1])

    assert ticket.result()[0].acted_on == "blue cup"
    assert [question.tried for question in asked] == ["", "'zorbl' is none of the choices"]


@pytest.mark.requirement("L6")
@pytest.mark.parametrize(("answer", "outcome"), [("never mind", "refused"), (None, "question")])
def test_a_question_about_the_words_can_be_withdrawn_or_left_open(fake_stage, answer, outcome):
    on = fake_stage()
    ticket = on.requests.submit("pick up something")
    ticket.on_question(lambda question: answer)

    assert ticket.result()[0].outcome == outcome
    assert not on.of(TaskAccepted)


@pytest.mark.requirement("L5")
def test_a_refused_request_moves_nothing(fake_stage):
    on = fake_stage()

    [result] = on.requests.submit("pick up the zorbl").result()

    assert result.outcome == "refused"
    assert not on.of(TaskAccepted)


def test_a_ticket_can_be_awaited_while_other_coroutines_run(fake_stage):
    on, beats = fake_stage(), []

    async def beat(ticket):
        while not ticket.done:
            beats.append(on.session.now_s)
            await asyncio.sleep(0)

    async def main():
        ticket = on.requests.submit("pick up the cup")

        async def answer():
            while ticket.question is None:
                await asyncio.sleep(0)
            ticket.answer("red")

        results, *_ = await asyncio.gather(_awaited(ticket), beat(ticket), answer())
        return results

    [result] = asyncio.run(main())

    assert result.acted_on == "red cup"
    assert len(set(beats)) > 50


async def _until(condition):
    while not condition():
        await asyncio.sleep(0)


@pytest.mark.parametrize("waited_for", ["pick up the cup", "go home"])
def test_who_awaits_a_ticket_sleeps_while_a_question_is_open(fake_stage, monkeypatch, waited_for):
    on, advanced = fake_stage(), []
    asking = on.requests.submit("pick up the cup")
    last = asking if waited_for == "pick up the cup" else on.requests.submit(waited_for)
    advance = Ticket.advance
    monkeypatch.setattr(Ticket, "advance", lambda ticket: advanced.append(ticket) or advance(ticket))

    async def main():
        waiting = asyncio.ensure_future(_awaited(last))
        await _until(lambda: asking.question is not None)
        for _ in range(3):
            await asyncio.sleep(0)
        before = len(advanced)
        for _ in range(50):
            await asyncio.sleep(0)
        spun = len(advanced) - before
        asking.answer("red")
        return spun, await waiting

    spun, [result] = asyncio.run(main())

    assert (spun, result.outcome) == (0, "done")


@pytest.mark.requirement("S7", "S4")
@pytest.mark.parametrize(
    "end",
    [
        lambda session, ticket: ticket.cancel("enough"),
        lambda session, ticket: session.cancel("enough"),
        lambda session, ticket: session.emergency_stop("enough"),
    ],
    ids=["ticket", "session", "stop"],
)
def test_a_cancel_or_stop_from_another_thread_wakes_who_awaits_an_answer(fake_stage, end):
    on = fake_stage(guarded=True)
    ticket = on.requests.submit("pick up the cup")

    async def main():
        waiting = asyncio.ensure_future(_awaited(ticket))
        await _until(lambda: ticket.question is not None)
        for _ in range(3):
            await asyncio.sleep(0)
        await asyncio.to_thread(end, on.session, ticket)
        return await asyncio.wait_for(waiting, 30.0)

    [result] = asyncio.run(main())

    assert result.outcome == "cancelled"
    assert "enough" in result.failure.message


async def _awaited(ticket):
    return await ticket


def test_the_example_of_the_guide_runs_as_it_stands(fake_stage):
    [example] = re.findall(r"```python\n(.*?)```", GUIDE.read_text(), re.S)
    requests = fake_stage().requests

    names = {}
    exec(example.replace('assembly = assemble("talos", load_scene("tabletop"), seed=7)\n', "").replace(
        "requests = Requests(assembly.session)\n", ""), {"requests": requests}, names)  # fmt: skip

    assert names["results"][0].outcome == "done"


def test_a_request_that_broke_off_with_a_defect_has_ended_and_lets_the_next_one_begin(
    fake_stage, monkeypatch
):
    on = fake_stage()
    broken, following = on.requests.submit("wave"), on.requests.submit("go home")
    with monkeypatch.context() as patch:
        patch.setattr(
            on.session, "task_steps", lambda *_: (_ for _ in ()).throw(ZeroDivisionError("a defect"))
        )
        with pytest.raises(ZeroDivisionError):
            broken.result()

    assert broken.done
    assert following.result()[0].outcome == "done"
