"""Progress and ending of a task in the messages of ``humanoid_executive_interfaces``.

``kinds`` holds the classes of the package's messages by their names: its module ``msg``, where it is built.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from progress import Account, Progress


def feedback_fields(progress: Progress, kinds: Any) -> dict[str, Any]:
    """The fields of the action's feedback."""
    return {
        "line": progress.line,
        "tree_path": list(progress.tree_path),
        "leaf": progress.leaf,
        "leaf_says": progress.leaf_says,
        "quantities": [kinds.Quantity(value=value, unit=unit) for value, unit in progress.quantities],
        "question": progress.question,
        "choices": list(progress.choices),
    }


def result_fields(account: Account, kinds: Any) -> dict[str, Any]:
    """The fields of the action's result."""
    return {
        "outcome": account.outcome,
        "message": account.message,
        "evidence": [
            kinds.Evidence(task=task, values=_values(measured, kinds)) for task, measured in account.evidence
        ],
        "failures": [
            kinds.Failure(
                kind=one.kind, where=one.where, message=one.message, numbers=_values(one.numbers, kinds)
            )
            for one in account.failures
        ],
        "report": account.report,
    }


def _values(named: Mapping[str, Any], kinds: Any) -> list[Any]:
    return [
        kinds.Value(
            name=name, text=str(value), number=float(value) if isinstance(value, int | float) else math.nan
        )
        for name, value in named.items()
    ]
