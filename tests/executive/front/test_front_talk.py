"""A proposal is read back and answered before it is done, and after a failure once more."""

import pytest

from executive.dialogue.settle_words import goes_on
from executive.front.front_talk import FrontTalk
from executive.front.proposal import ModelFailure, ModelFailureKind
from executive.session.events import InputTaken, QuestionAsked, TaskRefused
from executive.session.task_result import TaskResult
from executive.understanding.statement import Statement
from executive.understanding.understanding import understand
from trees.failures import Failure, FailureKind

pytestmark = pytest.mark.requirement("L10")

TEXT = "up with the red cup, mate"


class Person:
    """Gives its answers in their order; None when there are no more."""

    def __init__(self, *answers):
        self.answers, self.asked = list(answers), []

    def __call__(self, question):
        self.asked.append(question.text)
        return self.answers.pop(0) if self.answers else None


@pytest.fixture
def talk():
    """Makes a talk between a model and a person."""

    def make(front, person, interruption=goes_on):
        events = []
        talk = FrontTalk(front, person, events.append, lambda: False, interruption=interruption)
        return talk, events

    return make


def said(text=TEXT):
    return Statement(understand(text).parsed)


def failed(message="no can is in view"):
    return TaskResult(TEXT, "pick", "failed", failure=Failure(FailureKind.INFEASIBLE, message))


def test_after_yes_it_is_done(front, talk, steps):
    person = Person("yes")
    settled = talk(front(steps("pick up the red cup")), person)[0].settled(said())

    assert person.asked == ["I understood: pick up the red cup; shall I?"]
    assert [one.action for one in settled.parsed.commands] == ["pick"]
    assert settled.parsed.text == TEXT


@pytest.mark.parametrize("answer", ["no", "never mind"])
def test_after_no_nothing_is(front, talk, steps, answer):
    settled = talk(front(steps("pick up the red cup")), Person(answer))[0].settled(said())

    assert settled.parsed.outcome == "refused"
    assert "withdrawn by the answer" in settled.parsed.refusal.message


def test_where_nobody_answers_the_question_stays_open(front, talk, steps):
    settled = talk(front(steps("pick up the red cup")), Person())[0].settled(said())

    assert settled.parsed.question.text.startswith("I understood: pick up the red cup")
    assert not settled.parsed.commands


def test_without_a_read_back_what_is_grounded_and_sure_is_done_unasked(front, talk, steps):
    person = Person()
    settled = talk(front(steps("pick up the red cup"), reads_back=False), person)[0].settled(said())

    assert settled.parsed.commands
    assert not person.asked


def test_without_a_read_back_what_was_not_said_is_asked_all_the_same(front, talk, steps):
    person = Person()
    settled = talk(front(steps("pick up the blue cup"), reads_back=False), person)[0].settled(said())

    assert settled.parsed.outcome == "question"
    assert person.asked


def test_another_answer_goes_back_to_the_model(front, talk, steps):
    model = front(steps("pick up the blue cup"), steps("pick up the green cup"))
    person = Person("I meant the green cup", "yes")

    settled = talk(model, person)[0].settled(said())

    assert settled.parsed.commands[0].object.color == "green"
    assert "you did not say" not in person.asked[1]


def test_a_question_of_the_model_is_put_and_its_answer_told(front, talk, steps):
    model = front('{"steps": [], "question": "Which cup?"}', steps("pick up the red cup"))
    person = Person("the red one", "yes")

    settled = talk(model, person)[0].settled(said("up with it, mate"))

    assert person.asked[0] == "the model asks: Which cup?"
    assert settled.parsed.commands


def test_questions_without_an_end_stay_open(front, talk):
    model = front('{"steps": [], "question": "Which one?"}')

    settled = talk(model, Person(*["that one"] * 50))[0].settled(said())

    assert settled.parsed.outcome == "question"


def test_why_a_model_gave_nothing_is_told_beside_what_the_parser_said(front, talk):
    model = front(ModelFailure.of(ModelFailureKind.TIMEOUT, "20 s were allowed"))

    settled = talk(model, Person())[0].settled(said())

    assert settled.parsed.outcome == "refused"
    assert "does not fit here" in str(settled.parsed.refusal) or "word" in str(settled.parsed.refusal)
    assert "the model 'house': no answer came in time: 20 s were allowed" in str(settled.parsed.refusal)


def test_a_cancel_while_the_model_is_asked_ends_it(front, talk, steps):
    cancelled = Failure(FailureKind.CANCELED, "cancelled")
    person = Person("yes")

    assert talk(front(steps("go home")), person, lambda: cancelled)[0].settled(said()) is cancelled
    assert not person.asked


def test_questions_answers_and_the_models_own_words_are_recorded(front, talk, steps):
    told, events = talk(front(steps("pick up the red cup")), Person("yes"))
    told.settled(said())

    assert [type(event) for event in events] == [InputTaken, QuestionAsked, InputTaken]
    assert events[0].what == "model"


def test_after_a_failure_the_model_proposes_anew_and_it_is_read_back(front, talk, steps):
    model = front(steps("pick up the red can"), steps("pick up the red cup"))
    person = Person("yes", "yes")
    told, _ = talk(model, person)
    statement = told.settled(said())

    other = told.again(statement, [failed()])

    assert other.parsed.commands[0].object.kind == "cup"
    assert person.asked[1] == "I understood: pick up the red cup; shall I?"
    assert "no can is in view" in model._asker.asked[1][1]["content"]


def test_it_proposes_anew_so_often_and_no_more(front, talk, steps):
    model = front(steps("go home"), steps("wave"), steps("look at the red cup"), attempts=1)
    told, _ = talk(model, Person(*["yes"] * 5))
    statement = told.settled(said())

    assert told.again(statement, [failed()]) is not None
    assert told.again(statement, [failed()]) is None


def test_the_same_again_is_no_new_proposal(front, talk, steps):
    told, events = talk(front(steps("go home")), Person("yes", "yes"))
    statement = told.settled(said())

    assert told.again(statement, [failed()]) is None
    assert isinstance(events[-1], TaskRefused)
    assert "proposes again what has failed" in events[-1].message


@pytest.mark.parametrize("outcome", ["done", "cancelled", "question"])
def test_only_what_has_failed_goes_back(front, talk, steps, outcome):
    told, _ = talk(front(steps("go home"), steps("wave")), Person("yes", "yes"))
    statement = told.settled(said())

    assert told.again(statement, [TaskResult(TEXT, "pick", outcome)]) is None
