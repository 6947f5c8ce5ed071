"""Pictures of the report by matplotlib: with one version of it the same records give the same bytes."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from typing import Any

from executive.errors import UserError
from tools.evaluate.harness.statistics import interval
from tools.report.record import MeasuredRecord

_INK, _PALE = "#1b6ca8", "#b9c4cc"
_STYLES = (("#1b6ca8", "-"), ("#c04f15", "--"), ("#3a7d44", ":"), ("#7a3b8f", "-."))
"""Told apart without colours too."""
_ROW_IN = 0.2
_SETTINGS: Mapping[str, Any] = {
    "svg.hashsalt": "humanoid-executive",  # names inside the file would be drawn at random
    "svg.fonttype": "none",
    "font.family": "sans-serif",
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
}


def pictures(records: Sequence[MeasuredRecord]) -> dict[str, str]:
    """Every picture that the records give, by the name of its file.

    Args:
        records: Of one report.

    Raises:
        UserError: matplotlib is not installed.
    """
    made = {}
    shares = [record for record in records if record.kind == "episodes" and record.good is not None]
    if shares:
        made["good.svg"] = shares_picture(shares)
    for record in records:
        if record.kind == "scaling":
            made["scaling.svg"] = growth_picture(record.figures["courses"])
    return made


def shares_picture(records: Sequence[MeasuredRecord]) -> str:
    """Shares of good episodes with their intervals, a row for each run, as SVG.

    Args:
        records: Of which it is known how many were good.
    """
    rows = sorted(records, key=lambda record: (record.suite, record.name), reverse=True)
    figure, (axes,) = _figure(1, (7.0, 0.9 + _ROW_IN * len(rows)))
    for height, record in enumerate(rows):
        good = record.good or 0
        low, high = (100.0 * end for end in interval(good, max(record.judged, 1)))
        axes.plot((low, high), (height, height), color=_PALE, linewidth=3.0, solid_capstyle="butt")
        axes.plot((100.0 * good / max(record.judged, 1),), (height,), "o", color=_INK, markersize=4.0)
    axes.set_yticks(range(len(rows)), [f"{record.name} ({record.judged})" for record in rows])
    axes.set_xlim(0.0, 101.0)
    axes.set_ylim(-0.8, len(rows) - 0.2)
    axes.set_xlabel("good episodes, %, with the 95 % interval; in brackets how many episodes")
    axes.grid(axis="x", color="#e6eaed")
    axes.set_axisbelow(True)
    return _svg(figure)


def growth_picture(courses: Sequence[Mapping[str, Any]]) -> str:
    """Times against counts, all axes logarithmic, a diagram for each thing that grows, as SVG.

    Args:
        courses: As ``Course`` has them.
    """
    subjects = list(dict.fromkeys(one["against"] for one in courses))
    figure, diagrams = _figure(len(subjects), (4.6 * len(subjects), 3.8))
    for axes, subject in zip(diagrams, subjects, strict=True):
        lines = [one for one in courses if one["against"] == subject]
        for line, (color, dashes) in zip(lines, _STYLES, strict=False):
            label = f"{line['name']}: exponent {line['exponent']:.2f}"
            axes.loglog(line["counts"], line["median_ms"], "o", linestyle=dashes, color=color, label=label)
        axes.set_xlabel(f"number of {subject}")
        axes.set_ylabel("processor time, ms")
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.18), frameon=False)
    return _svg(figure)


def _figure(columns: int, size_in: tuple[float, float]) -> tuple[Any, Sequence[Any]]:
    """A figure and its diagrams side by side; nothing of matplotlib's global state is touched."""
    try:
        import matplotlib
        from matplotlib.figure import Figure
    except ImportError:
        raise UserError("pictures need matplotlib, of the extra [dev]: pip install matplotlib") from None
    with matplotlib.rc_context(dict(_SETTINGS)):
        figure = Figure(figsize=size_in, layout="constrained")
        return figure, list(figure.subplots(1, columns, squeeze=False)[0])


def _svg(figure: Any) -> str:
    import matplotlib

    drawn = io.StringIO()
    with matplotlib.rc_context(dict(_SETTINGS)):
        figure.savefig(drawn, format="svg", metadata={"Date": None, "Creator": None})
    lines = (line.rstrip() for line in drawn.getvalue().splitlines())
    return "\n".join(lines) + "\n"
