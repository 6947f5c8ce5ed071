"""What a model sends is validated against the published schema, and never trusted."""

import json
from pathlib import Path

import jsonschema
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from executive.meaning import StopCommand, command_json
from executive.understanding.model_output import ModelOutputError, model_output_schema, read_model_output
from trees.tasks import GoHomeTask, ObjectDescription, ObjectOf, PickTask, Relation

SCHEMA_FILE = Path(__file__).parents[3] / "docs" / "reference" / "model_output.schema.json"
SCHEMA = json.loads(SCHEMA_FILE.read_text())

LEFT_CUP = {
    "action": "pick",
    "object": {"kind": "cup", "color": "red", "relation": {"is": "left_of", "to": {"kind": "bottle"}}},
    "from": "table",
    "hand": "left",
    "confidence": 0.95,
}


def wrong_with(text):
    """Why a text is refused, or None when it is read."""
    try:
        read_model_output(text)
    except ModelOutputError as wrong:
        return str(wrong)
    return None


def refused(text):
    with pytest.raises(ModelOutputError) as caught:
        read_model_output(text if isinstance(text, str) else json.dumps(text))
    return str(caught.value)


@pytest.mark.requirement("L7")
def test_the_published_schema_is_that_of_the_code():
    assert model_output_schema() == SCHEMA, "run python -m tools.documents.schemas"


@pytest.mark.requirement("L7")
@pytest.mark.parametrize(
    "document",
    [
        {"command": "pick up the red cup", "confidence": 0.93},
        [{"command": "go home", "confidence": 1}, LEFT_CUP],
        {"steps": ["go home", {"action": "stop"}], "confidence": 0.9},
        LEFT_CUP,
    ],
)
def test_what_the_schema_allows_is_read(document):
    jsonschema.validate(document, SCHEMA)

    assert all(0.0 <= step.confidence <= 1.0 for step in read_model_output(json.dumps(document)))


@pytest.mark.requirement("F2")
@pytest.mark.parametrize(
    "code", [0x07, 0x0A, 0x7F, 0x9B, 0xAD, 0x200D, 0x2028, 0x202E, 0x2066, 0xE000, 0xE0041]
)
@pytest.mark.parametrize(
    ("action", "place"),
    [
        ({"action": "say", "text": "hi"}, ("text",)),
        ({"action": "pick", "object": {"name": "cup"}}, ("object", "name")),
    ],
)
def test_what_steers_a_terminal_unseen_is_refused_as_in_sentences(code, action, place):
    document = json.loads(json.dumps({**action, "confidence": 0.9}))
    inner = document if len(place) == 1 else document[place[0]]
    inner[place[-1]] += f"{chr(code)}2J"

    assert f"invisible character U+{code:04X}" in refused(document)
    assert refused(document).isprintable()
    if code not in (0xE000, 0xE0041):
        assert not jsonschema.Draft202012Validator(SCHEMA).is_valid(document)


@pytest.mark.requirement("F2")
@pytest.mark.requirement("L7")
@pytest.mark.parametrize(
    "action",
    [
        {"action": "pick", "object": {}},
        {"action": "place", "on": {}},
        {"action": "pick", "object": {"kind": "cup", "relation": {"is": "on", "to": {}}}},
    ],
)
def test_an_object_without_any_slot_is_read_no_more_than_the_schema_allows_it(action):
    document = {**action, "confidence": 0.9}

    assert not jsonschema.Draft202012Validator(SCHEMA).is_valid(document)
    assert "an object without any slot says nothing" in refused(document)


def test_an_unknown_key_is_told_without_what_steers_a_terminal():
    assert refused({"command": "go home", "confidence": 0.9, "\u009b2J": 1}).isprintable()


def test_words_of_any_script_are_read():
    assert wrong_with(json.dumps({"action": "say", "text": "Grüße, 你好 😀", "confidence": 0.9})) is None


def test_a_structured_action_is_the_same_task_as_its_slots_say():
    [step] = read_model_output(json.dumps(LEFT_CUP))

    relation = Relation("left_of", ObjectDescription("bottle"))
    assert step.content == PickTask(
        step.content.text, ObjectDescription("cup", "red", relation=relation), "table", "left"
    )
    assert command_json(step.content) == {key: LEFT_CUP[key] for key in LEFT_CUP if key != "confidence"}


def test_people_are_told_by_what_is_seen_of_them():
    person = {"kind": "person", "traits": ["sitting", "red shirt"]}
    steps = [{"action": "walk_to", "to": person, "confidence": 0.9}]

    [step] = read_model_output(json.dumps({"steps": steps}))
    assert step.content.to == ObjectDescription("person", traits=("sitting", "red shirt"))


def test_a_reference_and_a_stop_are_structured_too():
    steps = read_model_output(
        json.dumps(
            [
                LEFT_CUP,
                {"action": "pick", "object": {"ref": 0}, "confidence": 1.0},
                {"action": "stop", "confidence": 1.0},
            ]
        )
    )

    assert steps[1].content.object == ObjectOf(0)
    assert steps[2].content == StopCommand("stop")


@pytest.mark.requirement("L7", "F2")
@pytest.mark.parametrize(
    ("document", "says"),
    [
        ({"command": "go home", "confidence": 1.01}, "confidence"),
        ({"command": "go home", "confidence": "0.9"}, "confidence"),
        ({"command": "go home", "confidence": True}, "confidence"),
        ({"command": "go home"}, "confidence is missing"),
        ({"command": "", "confidence": 0.9}, "command"),
        ({"command": "x" * 501, "confidence": 0.9}, "command"),
        ({"command": "go home", "confidence": 0.9, "speed": 9}, "speed: Extra"),
        ({"command": ["go home"], "confidence": 0.9}, "command"),
        ({"action": "explode", "confidence": 0.9}, "'explode' is none of"),
        ({"action": "pick", "confidence": 0.9}, "object: Field required"),
        ({"action": "pick", "object": {"kind": "cup", "zork": 1}, "confidence": 0.9}, "zork: Extra"),
        ({"action": "move", "linear_m_s": 1e9, "confidence": 0.9}, "linear_m_s"),
        ({"action": "pick", "object": {"kind": "cup"}, "count": 1000, "confidence": 0.9}, "count"),
        ({"action": "pick", "object": {"kind": "c\u0007p"}, "confidence": 0.9}, "kind"),
        ({"steps": [], "confidence": 0.9}, "0 steps"),
        ({"steps": ["go home"] * 21, "confidence": 0.9}, "21 steps"),
        ({"steps": ["go home"]}, "steps[0].confidence is missing"),
        ({"steps": "go home", "confidence": 0.9}, "list of steps"),
        ([[]], "[0] must be"),
        (3, "must be an object"),
        ('{"command": "go home", "confidence": NaN}', "NaN"),
        ('{"command": "go home", "confidence": Infinity}', "Infinity"),
        ('{"command": "go home", "confidence": 1e999}', "too large"),
        ('{"command": "go home", "confidence": 9' + "9" * 5000 + "}", "too large"),
        ('{"command": "a", "command": "b", "confidence": 0.9}', "'command' is there twice"),
        ("[" * 100_0 + "]" * 100_0, "deeper than"),
        ('{"a":' * 5000, "deeper than"),
        ("[" + " " * 70_000 + "]", "70002 characters"),
        ('{"command": "go home", ', "not JSON"),
        ("{'command': 'go home'}", "not JSON"),
    ],
)
def test_what_does_not_fit_is_refused_with_the_place_and_the_reason(document, says):
    assert says in refused(document)


@given(
    st.recursive(
        st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=20),
        lambda inner: (
            st.lists(inner, max_size=3)
            | st.dictionaries(
                st.sampled_from(["command", "confidence", "steps", "action", "object", "kind", "ref", "x"]),
                inner,
                max_size=4,
            )
        ),
        max_leaves=12,
    )
)
@settings(suppress_health_check=[HealthCheck.too_slow], max_examples=300, deadline=None)
def test_any_json_is_read_or_refused_and_agrees_with_the_schema(document):
    try:
        text = json.dumps(document, allow_nan=False)
    except ValueError:
        refused(json.dumps(document))
        return
    valid = jsonschema.Draft202012Validator(SCHEMA).is_valid(document)
    wrong = wrong_with(text)
    assert valid if wrong is None else not valid or "confidence is missing" in wrong


@given(st.text(max_size=200))
def test_any_text_is_read_or_refused(text):
    for opening in ("", "{", "["):
        assert wrong_with(opening + text) != ""


def test_a_sentence_of_one_step_is_kept_as_it_is():
    assert read_model_output('{"command": "go home", "confidence": 1.0}')[0].content == "go home"
    assert read_model_output('{"action": "go_home", "confidence": 1.0}')[0].content == GoHomeTask("go home")
