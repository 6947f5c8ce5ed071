"""``python -m tools.documents.schemas``: write the published schemas, docs/reference/, from the code."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from executive.understanding.model_output import model_output_schema
from executive.understanding.strict_output import strict_output_schema
from tools.documents.check_report_document import CheckReportDocument
from tools.documents.episode_document import EpisodeDocument
from tools.documents.published import schema_of
from tools.documents.report_document import ReportDocument
from tools.documents.trajectory_document import TrajectoryDocument

FOLDER = Path(__file__).parents[2] / "docs" / "reference"

SCHEMAS: Mapping[str, Callable[[], dict[str, Any]]] = {
    "model_output": model_output_schema,
    "model_output_strict": strict_output_schema,
    "report": lambda: schema_of(ReportDocument, "Report of one run"),
    "check-report": lambda: schema_of(CheckReportDocument, "Report of a check"),
    "episode": lambda: schema_of(EpisodeDocument, "Episode of an evaluation"),
    "trajectory": lambda: schema_of(TrajectoryDocument, "Stored trajectory"),
}
"""What makes each, by the file's name without its ending."""


def text_of(schema: Mapping[str, Any]) -> str:
    """The file's text."""
    return json.dumps(schema, indent=1, sort_keys=True) + "\n"


def main() -> None:
    """Write all schemas."""
    for name, make in SCHEMAS.items():
        file = FOLDER / f"{name}.schema.json"
        file.write_text(text_of(make()), "utf-8")
        print(f"wrote {file.name}")


if __name__ == "__main__":
    main()
