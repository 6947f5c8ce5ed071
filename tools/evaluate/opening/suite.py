"""The suites ``open`` and ``close``: doors with hinges on either side, and drawers; one in four locked."""

from __future__ import annotations

import argparse
from functools import partial

from rich.console import Console

from tools.evaluate.opening.episode import OpeningOrder, died, run_openings
from tools.evaluate.opening.faults import OPENING_FAULTS
from tools.evaluate.opening.records import OpeningRecord, OpeningSummary
from tools.evaluate.opening.scenes import SCENES
from tools.evaluate.record_suite import run_record_suite

OPENING_SUITES = ("open", "close")


def run_opening_suite(options: argparse.Namespace, messages: Console) -> int:
    """Run it; 0 when every demand is met, 1 when not, 2 for an option that it does not have."""
    where = options.scene or None
    if (where and where not in SCENES) or options.fault not in (None, *OPENING_FAULTS):
        known, scenes = ", ".join(OPENING_FAULTS), " and ".join(SCENES)
        messages.print(
            f"error: the suite {options.suite} takes no scene but {scenes}, and of faults {known}",
            style="bold",
            markup=False,
        )
        return 2
    return run_record_suite(
        options.suite,
        [
            OpeningOrder(
                options.suite, options.seed + i, options.robot, options.fault, options.perception, where
            )
            for i in range(options.episodes)
        ],
        run_openings,
        died,
        partial(OpeningSummary, options.suite, options.seed, fault=options.fault),
        line=_line,
        place=lambda record: (record.seed,),
        execution=options.execution,
        document=options.json,
        messages=messages,
    )


def _line(record: OpeningRecord) -> str:
    where = f"{record.hinge} {record.kind}".strip() + (" locked" if record.locked else "")
    faults = ", ".join(record.faults) or "well"
    why = (record.failure or record.detail or "")[-200:]
    return f"seed {record.seed} {where} {record.outcome} at {record.opening:.2f}, {faults}. {why}"
