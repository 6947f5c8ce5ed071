"""Tool calls as models send them are steps; what has another shape is told the one that is expected."""

import contextlib
import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from executive.meaning import command_json
from executive.understanding.model_output import ModelOutputError, read_model_output
from executive.understanding.understanding import understand

SLOTS = {"object": {"kind": "cup", "color": "red"}, "from": "table"}
CALL = {"name": "pick", "arguments": SLOTS}
WRITTEN = {"name": "pick", "arguments": json.dumps(SLOTS)}
PLAIN = {"action": "pick", **SLOTS}


def refused(document):
    with pytest.raises(ModelOutputError) as caught:
        read_model_output(document if isinstance(document, str) else json.dumps(document))
    return str(caught.value)


@pytest.mark.requirement("L7")
@pytest.mark.parametrize(
    "document",
    [
        CALL,
        WRITTEN,
        [CALL],
        {"type": "function", "id": "call_1", "function": WRITTEN},
        {"tool_calls": [{"id": "call_1", "type": "function", "function": WRITTEN}]},
        {"role": "assistant", "content": None, "tool_calls": [{"function": CALL}]},
        {"tool_calls": [CALL]},
        {"function_call": WRITTEN},
        {"type": "function_call", "call_id": "c", "id": "f", "status": "completed", **WRITTEN},
        {"type": "tool_use", "id": "t", "name": "pick", "input": SLOTS},
    ],
)
def test_a_tool_call_is_the_action_that_it_names(document):
    [step] = read_model_output(json.dumps(document))

    assert command_json(step.content) == PLAIN
    assert step.confidence == 1.0


@pytest.mark.parametrize("arguments", [{}, "", "{}", None])
def test_a_tool_without_arguments_needs_none(arguments):
    [step] = read_model_output(json.dumps({"name": "go_home", "arguments": arguments}))

    assert command_json(step.content) == {"action": "go_home"}


def test_several_calls_are_steps_in_their_order():
    calls = [{"function": WRITTEN}, {"function": {"name": "wave", "arguments": "{}"}}]

    steps = read_model_output(json.dumps({"tool_calls": calls}))

    assert [step.content.action for step in steps] == ["pick", "wave"]


def test_a_confidence_among_the_arguments_counts():
    [step] = read_model_output(json.dumps({"name": "go_home", "arguments": {"confidence": 0.3}}))

    assert step.confidence == 0.3
    assert understand(json.dumps({"name": "go_home", "arguments": {"confidence": 0.3}})).parsed.question


def test_a_tool_for_sentences_takes_a_sentence():
    [step] = read_model_output(json.dumps({"name": "command", "arguments": {"command": "go home"}}))

    assert step.content == "go home"


@pytest.mark.requirement("L7", "F2")
@pytest.mark.parametrize(
    ("document", "says"),
    [
        ({"name": "explode", "arguments": {}}, "'explode' is none of"),
        ({"name": "pick", "arguments": {}}, "arguments.object: Field required"),
        ({"tool_calls": [{"function": {"name": "pick", "arguments": "{}"}}]},
         "tool_calls[0].function.arguments.object: Field required"),
        ({"name": "pick", "arguments": {**SLOTS, "zork": 1}}, "arguments.zork: Extra"),
        ({"name": "pick", "arguments": '{"object": '}, "arguments: it is not JSON"),
        ({"name": "pick", "arguments": "[" * 50}, "arguments: it is nested deeper"),
        ({"name": "pick", "arguments": '{"a": 1, "a": 2}'}, "'a' is there twice"),
        ({"name": "pick", "arguments": [1]}, "arguments must be an object"),
        ({"name": "pick", "arguments": {**SLOTS, "action": "place"}}, "arguments.action"),
        ({"name": "pick", "arguments": SLOTS, "input": SLOTS}, "input: there are 'arguments' already"),
        ({"name": 3, "arguments": {}}, "name must be the name of an action"),
        ({"type": "code_interpreter", **CALL}, "'code_interpreter' is no tool call"),
        ({**CALL, "sudo": True}, "unknown key 'sudo'"),
        ({"tool_calls": []}, "0 steps"),
        ({"tool_calls": [{"name": "wave", "arguments": {}}] * 21}, "21 steps"),
        ({"tool_calls": CALL}, "tool_calls: must be a list"),
        ({"tool_calls": ["wave"]}, "tool_calls[0] must be an object with 'name'"),
        ({"tool_calls": [CALL], "content": "I will also dance"}, "no words beside"),
        ({"tool_calls": [CALL], "confidence": 0.9}, "unknown key 'confidence'"),
    ],
)  # fmt: skip
def test_a_call_that_cannot_be_taken_is_refused_with_place_and_reason(document, says):
    assert says in refused(document)


@pytest.mark.parametrize(
    "text",
    [
        '{"foo": 1}',
        '{"choices": [{"message": {"content": "go home"}}]}',
        '{"command": "go home", "confidence": 0.9} I hope that this helps!',
        '{"command": "go home", "confidence": 0.9}\n{"command": "wave", "confidence": 0.9}',
        '"go home"',
        "3",
    ],
)
def test_what_has_another_shape_is_told_the_one_that_is_expected(text):
    said = refused(text)

    assert '{"command": "go home", "confidence": 0.9}' in said
    assert '"arguments"' in said
    assert "nothing around it" in said


BLOCK = '```json\n{"command": "go home", "confidence": 0.9}\n```'


@pytest.mark.parametrize(
    "text",
    [
        f"Sure! Here is the plan:\n{BLOCK}",
        f"{BLOCK}\nLet me know if you need more.",
        f"Go home.\n{BLOCK}",
        f"{BLOCK}\n{BLOCK}",
        'Here you are: {"command": "go home", "confidence": 0.9}',
        'I call the tool: {"name": "pick", "arguments": {}}',
        "<tool_call>\n" + json.dumps(CALL) + "\n</tool_call>",
    ],
)
def test_words_around_the_output_are_told_as_that_and_nothing_is_done(text):
    parsed = understand(text).parsed

    assert parsed.commands == ()
    assert "words around the model's output" in parsed.refusal.message
    assert '{"command": "go home", "confidence": 0.9}' in parsed.refusal.message


def test_a_block_whose_end_has_no_line_of_its_own_is_taken():
    assert understand('```json\n{"command": "go home", "confidence": 0.9}```').parsed.commands


def test_a_mark_of_the_byte_order_before_the_output_is_no_part_of_it():
    assert understand('\ufeff{"command": "go home", "confidence": 0.9}').parsed.commands


@given(
    st.recursive(
        st.none() | st.booleans() | st.integers() | st.text(max_size=10),
        lambda inner: (
            st.lists(inner, max_size=3)
            | st.dictionaries(
                st.sampled_from(
                    ["name", "arguments", "function", "tool_calls", "type", "input", "command", "content"]
                ),
                inner,
                max_size=4,
            )
        ),
        max_leaves=12,
    )
)
def test_any_tool_call_is_read_or_refused(document):
    with contextlib.suppress(ModelOutputError):
        assert read_model_output(json.dumps(document))
