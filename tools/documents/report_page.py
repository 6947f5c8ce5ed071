"""The page of the reports: every key of the published schemas of a run and of a check."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from tools.documents.markdown import table

REFERENCE = Path(__file__).parents[2] / "docs" / "reference"

_HEAD = """\
# Reports

What `--report FILE.json` writes, by the published schemas. Every key is there unless it is *optional*; there
are no others. What the kinds of failures mean: [failures](../understand/failures.md).
"""
_SCHEMAS = (
    ("Report of a run", "report.schema.json"),
    ("Report of a check", "check-report.schema.json"),
)

Schema = Mapping[str, Any]


def report_page(folder: Path = REFERENCE) -> str:
    """The page: a part for each schema, in it a table for the document and each of its parts."""
    parts = [_HEAD]
    for title, file in _SCHEMAS:
        schema = json.loads((folder / file).read_text("utf-8"))
        parts += [f"## {title}\n", f"{schema.get('description', '')} Schema: [{file}]({file}).\n".lstrip()]
        definitions = schema.get("$defs", {})
        parts.append(_keys(schema, definitions))
        for name, definition in definitions.items():
            if "properties" in definition:
                about = definition.get("description")
                parts += [
                    f"### {name.removesuffix('Document')}\n",
                    *([f"{about}\n"] if about else []),
                    _keys(definition, definitions),
                ]
    return "\n".join(parts)


def _keys(schema: Schema, definitions: Schema) -> str:
    return table(("key", "holds", "meaning"), _rows(schema, definitions, ""))


def _rows(schema: Schema, definitions: Schema, before: str) -> Iterator[tuple[str, str, str]]:
    """The keys of an object, those of objects within it after theirs, by their path."""
    needed = schema.get("required", ())
    for name, value in schema["properties"].items():
        optional = "" if name in needed else "*optional*; "
        yield f"`{before}{name}`", optional + _holds(value, definitions), value.get("description", "")
        inner = value.get("items", value)
        if "properties" in inner:
            yield from _rows(inner, definitions, f"{before}{name}{'[]' if 'items' in value else ''}.")


def _holds(value: Schema, definitions: Schema) -> str:
    """What a value may be, in words; what has a part of its own on the page is named."""
    if "$ref" in value:
        name = str(value["$ref"]).rpartition("/")[2]
        return (
            name.removesuffix("Document")
            if "properties" in definitions[name]
            else _holds(definitions[name], definitions)
        )
    if "const" in value:
        return json.dumps(value["const"])
    if "enum" in value:
        return ", ".join(str(one) for one in value["enum"])
    for key in ("oneOf", "anyOf"):
        if key in value:
            return " or ".join(_holds(one, definitions) for one in value[key])
    kinds = value.get("type", "anything")
    told = kinds if isinstance(kinds, str) else " or ".join(kinds)
    for key in ("items", "additionalProperties"):
        if isinstance(value.get(key), Mapping):
            told += f" of {_holds(value[key], definitions)}"
    return told


def _named(definition: str) -> str:
    """What a part of a document is called on the page."""
    return definition.removesuffix("Document")
