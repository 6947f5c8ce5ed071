"""What the benchmarks measured, as one page, from what ``tools.benchmark SUITE --json`` writes."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from tools.benchmark.contest import COLUMNS, Standing, cells
from tools.benchmark.peers.environments import NAMES, PeerEnvironment

RUNNERS = Path(__file__).parent / "peers" / "runners"
_NO_PROTOCOL = ("line_protocol", "coal_scene", "reach_tolerance", "pick_coordinates")

_HEAD = """\
# Benchmarks

Made by `make report`; do not edit. Every number is processor time on one core. Planners and solvers take
turns on one problem after another in one run, beginning with another one each time, after a first problem
that does not count, so that the machine's ups and downs fall on all alike. What passes between the processes
is not counted. *times slower* and *times longer* are medians over single problems, beside their quartiles;
*peer / ours* is the ratio of two medians of one run. No ratio joins numbers of different runs.

Peers run in environments of their own with the versions locked in `tools/benchmark/peers/*.lock`; make them
with `python -m tools.benchmark.peers`. None is tuned down: the settings are told below, and where the
documented defaults were not the fastest for these problems, the faster ones were taken.
"""

_ARM = """\
Problems are drawn from a seed (`tools/benchmark/problems`), in the style of MotionBenchMaker's families. All
planners get the same convex hulls, the same fingers fixed open and the same floor. *solved* is the share that
got a path; *valid* the share of those paths that the referee found free: Coal at every 1/256 rad. Planners
that look every 0.05 rad, as the peers' documentation does, return paths that graze something in between.
*set up* is what taking in a new scene costs, beside the time to plan and shorten. *times slower* compares
with the first planner on the problems that both solved, *times longer* where both paths are valid; lengths
are those of valid paths.
"""

_PICK = """\
TALOS takes a cup amid 3 to 12 things on a table: grasp, whole-body inverse kinematics, path, timing and the
check of all motions. What has no plan is given to a long search with OMPL and Coal over twelve coordinates,
which shares neither grasps nor goals nor planner with the product, to tell whether it was possible.

The same picks are given to the fastest of the peers one after another: mink, OMPL over Coal, toppra. They get
the product's grasps in its order, the same solids, margins and limits, and what passes between them costs
nothing. They move trunk and one arm, nine joints over legs that stay, which is less to solve than the
product's whole body and enough for most of these tables; or pelvis and legs too: neither OMPL nor roboplan
plans for closed chains, so the legs follow by the product's own closed form. They end with the first plan
that holds, and pay for neither jerk, efforts nor balance in motion. Their last judgement is by samples, where
the product's is a proof: once at every 1/256 rad of any joint, as the referee of `arm` looks, and once at
every 0.5 ms, as the referee of the checker does near solids.
"""

_IK = """\
Random reachable poses of a hand, both feet standing and the CoM over them; five starts at most, the same for
everybody. *valid* is judged by Pinocchio: hand and feet to 0.5 mm and 3 mrad, CoM inside the support polygon,
joints within their limits. *length* is how far the joints went from the first start.
"""

_COLLISION = """\
Straight lines of 2 rad from random free configurations of the Panda, in the scenes of all families. An
optimistic error calls a line free that collides by Coal at every 1/256 rad, a pessimistic one the reverse. A
peer is asked twice: with the step that its documentation takes, and with the referee's, which tells what an
answer costs that is as right as ours.
"""

_CHECKER = """\
The trajectory checker on planned motions of TALOS amid things on a table, stretched to 5 s and sampled 1,000
times. What it is compared to is no checker: the least that anybody pays who looks at every sample.
"""

_MANY_CORES = """\
Picks through the harness, in processes and by Ray, beside a model of it; then what the model makes of as many
episodes as take days on one core. The model takes how long one core is until its first episode, how long
episodes are, and what the one process does that hands out and keeps, from the run on one core. It leaves out
what cores cost each other that share a memory, and what it takes to ship the sources to other machines.
"""

# In the order of the page.
_TEXTS = {
    "planning": "Every planning request of real picks in random scenes.\n",
    "pick": _PICK,
    "arm": _ARM,
    "ik": _IK,
    "collision": _COLLISION,
    "timing": "",
    "checker": _CHECKER,
    "tick": "Ticks of the behavior tree during real picks, but those in which planning was computed.\n",
    "control": "A control period with everything in it, beside physics alone.\n",
    "ros": "Joint states on the wire, from stamp to arrival, beside a bare pair of DDS at the same time.\n",
    "view": "The page in Debian's Chromium without a graphics card, on the same cores; wall time.\n",
    "eyes": "The same picks seen through either, taking turns; what the camera draws and looks at counts.\n",
    "many_cores": _MANY_CORES,
    "startup": "Fresh processes, beside one that only imports the libraries.\n",
}


def in_page_order(documents: Iterable[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """The suites' documents in the order of the page; what it has no place for comes last."""
    order = list(_TEXTS)
    return sorted(
        documents, key=lambda item: order.index(item["suite"]) if item["suite"] in order else len(order)
    )


def page(documents: Iterable[Mapping[str, Any]]) -> str:
    """The page, in Markdown."""
    parts = [_HEAD]
    for document in documents:
        parts.append(f"## {document['suite']}\n")
        if document["quick"]:
            parts.append("A quick run with few samples: read it as a direction, not as a result.\n")
        parts.append(_TEXTS.get(document["suite"], ""))
        if document["standings"]:
            parts.append(_standings(document["standings"]))
        if document["figures"]:
            parts.append(_figures(document["figures"]))
        parts += [f"- {note}\n" for note in document["notes"]]
    parts.append(_settings())
    return "\n".join(parts)


def _figures(figures: Iterable[Mapping[str, Any]]) -> str:
    rows = [("what", "ours", "peer", "its value", "peer / ours", "p95 / median")]
    for item in figures:
        value = item["peer_value"]
        rows.append(
            (
                item["name"],
                f"{item['ours']:.4g}",
                item["peer"] or "",
                "" if value is None else f"{value:.4g}",
                f"{value / item['ours']:.2f}" if value and item["ours"] else "",
                f"{item['spread']:.2f}",
            )
        )
    return _table(rows)


def _standings(standings: Iterable[Mapping[str, Any]]) -> str:
    return _table([COLUMNS, *(tuple(cells(Standing(**item))) for item in standings)])


def _table(rows: Sequence[Sequence[str]]) -> str:
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    lines.insert(1, "| " + " | ".join("---" for _ in rows[0]) + " |")
    return "\n".join(lines) + "\n"


def _settings() -> str:
    """What each runner's docstring says of the peer's settings, and the locked versions."""
    lines = ["## Peers\n"]
    lines += [f"- {PeerEnvironment(name, Path()).version.replace('==', ' ')}" for name in NAMES]
    lines.append(
        "- VAMP (`vamp-planner`) is not among them: the package registry has its source alone, whose build "
        "downloads more from elsewhere. It plans on spheres instead of hulls.\n"
    )
    for script in sorted(RUNNERS.glob("*.py")):
        if script.stem not in _NO_PROTOCOL:
            text = ast.get_docstring(ast.parse(script.read_text("utf-8"))) or ""
            lines.append(f"**{script.stem}**: {' '.join(text.split())}\n")
    return "\n".join(lines)
