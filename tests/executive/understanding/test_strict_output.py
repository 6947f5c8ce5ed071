"""The form for strict structured output fits the subset of servers, and our reader takes what comes in it."""

import json

import jsonschema
import pytest

from executive.understanding.model_output import read_model_output
from executive.understanding.strict_output import AnswerShapeError, read_strict_answer, strict_output_schema
from trees.tasks import ObjectDescription, PickTask

SCHEMA = strict_output_schema()
SUBSET = {"type", "enum", "const", "description", "properties", "items", "anyOf", "$ref", "$defs", "required"}
PICK = {
    "action": "pick",
    "object": {
        **dict.fromkeys(("name", "size", "material", "ordinal", "relation", "traits")),
        "kind": "cup",
        "color": "red",
    },
    **dict.fromkeys(("from", "hand", "count")),
    "confidence": 0.9,
}


def schemas(schema):
    """A schema and all schemas within it."""
    yield schema
    for key in ("properties", "$defs"):
        for one in schema.get(key, {}).values():
            yield from schemas(one)
    for one in [*schema.get("anyOf", ()), *([schema["items"]] if "items" in schema else [])]:
        yield from schemas(one)


@pytest.mark.requirement("L7")
def test_it_keeps_to_the_subset():
    for one in schemas(SCHEMA):
        assert set(one) <= SUBSET | {"additionalProperties"}
        if one.get("type") == "object":
            assert one["additionalProperties"] is False
            assert set(one["required"]) == set(one["properties"])
    assert SCHEMA["type"] == "object"
    assert "anyOf" not in SCHEMA


def test_it_is_small_enough_for_servers():
    assert sum(len(one.get("properties", ())) for one in schemas(SCHEMA)) <= 5000
    assert len(json.dumps(SCHEMA)) <= 120_000


@pytest.mark.requirement("L7")
def test_a_document_that_is_filled_with_nulls_is_read():
    document = {"steps": [PICK, {"command": "go home", "confidence": 0.8}], "question": None}
    jsonschema.validate(document, SCHEMA)

    read = read_strict_answer(json.dumps(document))
    pick, home = read_model_output(json.dumps(read.document))

    assert pick.content.object == ObjectDescription("cup", "red")
    assert isinstance(pick.content, PickTask)
    assert (home.content, home.confidence) == ("go home", 0.8)
    assert read.sentences == {1: "go home"}


def test_a_question_comes_alone():
    read = read_strict_answer('{"steps": [], "question": "Which cup?"}')

    assert read.question == "Which cup?"


@pytest.mark.parametrize(
    "text",
    ["", "go home", "17", "null", "[]", "{}", '{"steps": {}}', '{"steps": [], "question": 3}', '"go home"'],
)
def test_what_says_nothing_is_refused(text):
    with pytest.raises(AnswerShapeError):
        read_strict_answer(text)
