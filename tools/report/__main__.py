"""``python -m tools.report [--quick] [--only RUN ...]``: every suite is run, and ``docs/measured`` made."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from rich.console import Console

from executive.ending_signals import interrupt_by_all
from executive.errors import UserError
from executive.exit_codes import ExitCode
from robots.clock import WallClock
from tools.report.carrying_out import NotMeasuredError, Settings, carry_out, known_records
from tools.report.machine import ROOT, here
from tools.report.pages import share
from tools.report.published import RECORDS, publish
from tools.report.record import MeasuredRecord
from tools.report.runs import Run, chosen

FOLDER = ROOT / "docs" / "measured"
WORK = ROOT / "build" / "report"
_QUICK = "quick"
_HOUR_S = 3600.0


def main(arguments: Sequence[str] | None = None) -> int:
    """Run and publish; 0 when every run gave a record, 1 when not, 2 for a wrong option, 4 after a signal."""
    options = _options(arguments)
    messages = Console(stderr=True)
    try:
        return _report(options, messages)
    except KeyboardInterrupt as ended:
        told = f"{str(ended) or 'cancelled from the keyboard'}; the same command goes on after {options.work}"
        messages.print(told, markup=False, soft_wrap=True)
        return ExitCode.CANCELLED
    except (UserError, ValueError) as wrong:
        messages.print(f"error: {wrong}", style="bold", markup=False, soft_wrap=True)
        return 2


def _report(options: argparse.Namespace, messages: Console) -> int:
    is_ours = options.into is None and not options.quick
    folder: Path = options.into or (options.work / _QUICK / "measured" if options.quick else FOLDER)
    readme = ROOT / "README.md" if is_ours else None
    if options.pages:
        _told(publish(list(known_records(folder / RECORDS).values()), folder, readme), messages)
        return 0
    runs, place = chosen(options.only), here()
    work = options.work / (_QUICK if options.quick else "") / place.sources
    settings = Settings(work, place, options.jobs, options.quick, options.seed, options.episodes)
    # a part of a report replaces its part alone
    found = known_records(folder / RECORDS) if options.only else {}
    lacking = []
    for run, made in _carried_out(runs, settings, messages):
        if isinstance(made, MeasuredRecord):
            found[run.name] = made
        else:
            lacking.append(f"{run.name}: {made}")
    _told(publish(list(found.values()), folder, readme), messages)
    for line in lacking:
        messages.print(f"not measured: {line}", markup=False, soft_wrap=True)
    return 1 if lacking else 0


def _carried_out(
    runs: Sequence[Run], settings: Settings, messages: Console
) -> Iterator[tuple[Run, MeasuredRecord | NotMeasuredError]]:
    """Each run as it is through. Cut short, those of one episode run beside each other."""
    beside = [run for run in runs if settings.quick and not run.is_in_a_row]
    alone = [run for run in runs if run not in beside]
    clock, done = WallClock(), 0

    def one(run: Run) -> MeasuredRecord | NotMeasuredError:
        try:
            if settings.ending.is_set():
                return NotMeasuredError("ended before it began")
            return carry_out(run, settings)
        except NotMeasuredError as lack:
            return lack

    with ThreadPoolExecutor(settings.jobs) as pool:
        try:
            for some, made in ((beside, pool.map(one, beside)), (alone, map(one, alone))):
                for run, result in zip(some, made, strict=True):
                    done += 1
                    line = _line(run, result, done, len(runs), clock.now_s())
                    messages.print(line, markup=False, soft_wrap=True)
                    yield run, result
        finally:
            settings.ending.set()


def _line(run: Run, made: MeasuredRecord | NotMeasuredError, done: int, of: int, spent_s: float) -> str:
    result = (
        f"{made.judged}, good {share(made)}" if isinstance(made, MeasuredRecord) else f"not measured: {made}"
    )
    return f"{done} of {of}, {spent_s / _HOUR_S:.1f} h: {run.name} {result}"


def _told(changed: Sequence[Path], messages: Console) -> None:
    for file in changed:
        messages.print(f"wrote {file.relative_to(ROOT) if file.is_relative_to(ROOT) else file}", markup=False)


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m tools.report",
        description="Runs every suite and makes docs/measured from the records. A report that was ended "
        "goes on where it was, as long as the sources are the same.",
    )
    parser.add_argument(
        "--quick", action="store_true", help="one episode a suite: no claim, kept in build/report"
    )
    parser.add_argument(
        "--only", nargs="+", default=[], metavar="RUN", help="these runs or suites; others stay"
    )
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    parser.add_argument("--seed", type=int, default=0, help="seed of the first episode of each run")
    parser.add_argument("--episodes", type=int, help="so many in each run instead of its own number")
    parser.add_argument("--into", type=Path, metavar="DIR", help="another folder than docs/measured")
    parser.add_argument(
        "--work", type=Path, default=WORK, metavar="DIR", help="journals and logs (build/report)"
    )
    parser.add_argument(
        "--pages", action="store_true", help="run nothing: pages and pictures from the records"
    )
    return parser.parse_args(arguments)


if __name__ == "__main__":
    interrupt_by_all()
    sys.exit(main())
