import pytest
from py_trees.behaviour import Behaviour

from trees.failures import Failure
from trees.nodes.judgements import Judgement, defect, judgement, no_other_attempt_helps


def test_a_judgement_is_called_as_the_function_that_it_is_made_of():
    @judgement
    def broken(failure: Failure) -> bool:
        """Whether it broke."""
        return failure.message == "it broke"

    assert broken(Failure.error("it broke"))
    assert not broken(Failure.error("it did not"))


def test_its_name_is_the_functions_wherever_that_stands():
    assert defect.name == "defect"
    assert "trees" not in repr(defect)


def test_it_tells_what_it_judges():
    assert defect.takes == (Failure,)
    assert no_other_attempt_helps.takes == (Failure, Failure | None)


def test_it_tells_what_it_means():
    assert defect.meaning == "No other way helps against a defect or a halt."


def test_only_a_function_with_a_public_name_can_be_one():
    def _hidden(failure: Failure) -> bool:
        return True

    for function in (_hidden, lambda failure: True):
        with pytest.raises(ValueError, match="needs a public name"):
            judgement(function)


def test_ways_can_be_judged_too():
    @judgement
    def any_way(way: Behaviour, failure: Failure | None) -> bool:
        """Every one."""
        return True

    assert isinstance(any_way, Judgement)
    assert any_way.takes == (Behaviour, Failure | None)
