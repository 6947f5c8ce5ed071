"""``python -m tools.documents.model_output_schema``: write the schema of model output from the code."""

from __future__ import annotations

import json
from pathlib import Path

from executive.understanding.model_output import model_output_schema

FILE = Path(__file__).parents[2] / "docs" / "reference" / "model_output.schema.json"


def main() -> None:
    """Write the schema."""
    FILE.write_text(json.dumps(model_output_schema(), indent=1, sort_keys=True) + "\n", "utf-8")
    print(f"wrote {FILE.name}")


if __name__ == "__main__":
    main()
