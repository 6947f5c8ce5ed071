"""Documents that are published with a schema, as pydantic models: what the schema is made from."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, ConfigDict, Field
from pydantic.json_schema import GenerateJsonSchema

DIALECT = "https://json-schema.org/draft/2020-12/schema"


class Published(BaseModel):
    """An object of a document, with no keys but its own; texts below its fields are told in the schema."""

    model_config = ConfigDict(extra="forbid", use_attribute_docstrings=True)


def absent() -> Any:
    """A key that need not be there, and stands for nothing then."""
    return Field(default_factory=lambda: None)


def constant(*values: int, key: str | None = None) -> Any:
    """A whole number that is one of some; ``key`` where the field has another name."""
    return Field(alias=key, json_schema_extra={"enum": list(values)})


class _Untitled(GenerateJsonSchema):
    """A schema whose keys are not told a second time as titles."""

    def field_title_should_be_set(self, schema: Any) -> bool:  # noqa: ARG002
        return False


def schema_of(document: type[Published], title: str) -> dict[str, Any]:
    """The JSON schema of a document.

    Args:
        document: Its model.
        title: What it is called.
    """
    schema = document.model_json_schema(schema_generator=_Untitled)
    return {"$schema": DIALECT, **schema, "title": title}
