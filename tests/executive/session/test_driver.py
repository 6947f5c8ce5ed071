"""Steps go on to their end, tick by tick and question by question, whoever drives them."""

import pytest

from executive.session.driver import Driver, driven


def steps(*yielded):
    """Yields these, and returns what was answered to those that are questions."""
    given = []
    for one in yielded:
        answer = yield one
        if one is not None:
            given.append(answer)
    return given


def broken():
    yield None
    raise ZeroDivisionError("a defect")


def test_steps_are_driven_to_what_they_return():
    assert driven(steps(None, None)) == []


def test_questions_are_answered_and_ticks_are_not():
    assert driven(steps(None, "which?", None, "sure?"), {"which?": "red", "sure?": "yes"}.get) == [
        "red",
        "yes",
    ]


def test_a_question_that_nobody_answers_stays_open():
    assert driven(steps("which?")) == [None]


def test_something_else_is_done_after_each_tick_but_not_after_a_question():
    ticks = []

    driven(steps(None, "which?", None), between=lambda: ticks.append(len(ticks)))

    assert ticks == [0, 1]


def test_an_open_question_holds_the_steps_until_it_is_answered():
    driver = Driver(steps("which?", None))
    driver.advance()

    assert not driver.advance()
    assert driver.question == "which?"

    driver.answer("red")
    while driver.advance():
        pass
    assert driver.result == ["red"]


def test_an_answer_without_a_question_is_a_mistake():
    with pytest.raises(RuntimeError, match="no question"):
        Driver(steps(None)).answer("red")


def test_there_is_no_result_before_the_end():
    with pytest.raises(RuntimeError, match="before the end"):
        _ = Driver(steps(None)).result


def test_steps_that_raised_have_ended_and_their_result_is_what_they_raised():
    driver = Driver(broken())
    driver.advance()
    with pytest.raises(ZeroDivisionError):
        driver.advance()

    assert driver.done
    assert not driver.advance()
    with pytest.raises(ZeroDivisionError):
        _ = driver.result
