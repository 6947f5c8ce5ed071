"""The published schemas are those of the code."""

import pytest

from kinematics.formats.solid_document import MAX_SIZE_M
from tools.documents.schemas import FOLDER, SCHEMAS, text_of


@pytest.mark.parametrize("name", sorted(SCHEMAS))
def test_a_published_schema_is_what_the_code_makes(name):
    stored = (FOLDER / f"{name}.schema.json").read_text("utf-8")

    assert stored == text_of(SCHEMAS[name]()), "run python -m tools.documents.schemas"


def test_every_published_schema_is_made_by_the_code():
    assert {file.name.removesuffix(".schema.json") for file in FOLDER.glob("*.schema.json")} == set(SCHEMAS)


def test_a_schema_has_the_bounds_of_the_reader():
    definitions = SCHEMAS["trajectory"]()["$defs"]

    assert definitions["BallDocument"]["properties"]["radius_m"]["maximum"] == MAX_SIZE_M


def test_a_key_that_need_not_be_there_has_no_value_that_stands_for_it():
    report = SCHEMAS["report"]()

    assert "left_out" not in report["required"]
    assert "default" not in report["properties"]["left_out"]
