"""Whether answers are right as often as they say: ``python -m tools.calibration FILE.json [--seed S] ...``.

Runs count and describe in random scenes, alternately with the declared errors of perception and with a
camera that is far worse, compares each answer with the simulator's truth, and draws how often answers of
each stated confidence are right (``--picture FILE.svg``).
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from dataclasses import asdict, replace
from pathlib import Path

from robots.scenes.scene_description import PerceptionModel
from tools.calibration.answers import SKILLS, Answer, answers
from tools.calibration.fit import fitted
from tools.calibration.reliability import expected_error, reliability
from tools.calibration.reliability_plot import as_svg
from trees.skills.telling.settings import TellingSettings
from trees.skills.telling.telling_leaf import calibrated

NOISES = {
    "declared": PerceptionModel(),
    "poor": PerceptionModel(
        bias_m=0.01, noise_m=0.006, dropout=0.25, false_rate=0.5, merge_distance_m=0.02, merge_chance=0.3,
        min_visible=0.4,
    ),
}  # fmt: skip


def main(arguments: Sequence[str] | None = None) -> int:
    """Run, write, print; 0."""
    parser = argparse.ArgumentParser(prog="python -m tools.calibration", description=__doc__)
    parser.add_argument("file", type=Path, help="where the answers go; with --episodes 0 where they are")
    parser.add_argument("--episodes", type=int, default=100, help="of each skill with each camera")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--noise", choices=[*NOISES, "both"], default="both")
    parser.add_argument("--picture", type=Path, help="an SVG of stated and true")
    options = parser.parse_args(arguments)
    noises = list(NOISES) if options.noise == "both" else [options.noise]
    if options.episodes:
        _collect(options.file, noises, range(options.seed, options.seed + options.episodes))
    rows = json.loads(options.file.read_text("utf-8"))
    found = {noise: [_as_stated_now(Answer(**row)) for row in rows.get(noise, ())] for noise in noises}
    everything = [answer for some in found.values() for answer in some]
    for noise, some in (*found.items(), ("all", everything)):
        right = sum(answer.right for answer in some)
        stated = sum(answer.stated for answer in some)
        print(
            f"{noise}: {right} of {len(some)} right, {stated:.1f} stated; "
            f"expected calibration error {expected_error(some):.3f}"
        )
    for bin_ in reliability(everything):
        print(f"  stated {bin_.stated:.2f}: right {bin_.right:.2f} (of {bin_.count})")
    print("fit to these: slope {:.3f}, offset {:.3f}".format(*fitted(everything)))
    if options.picture is not None:
        options.picture.write_text(as_svg(found), "utf-8")
    return 0


def _as_stated_now(answer: Answer) -> Answer:
    """The answer with the confidence that the present policy would state."""
    if answer.raw == 0.0:
        return answer  # there was no answer at all
    settings = TellingSettings()
    stated = calibrated(answer.raw, settings.confidence_slope, settings.confidence_offset)
    return replace(answer, stated=stated)


def _collect(file: Path, noises: Sequence[str], seeds: range) -> None:
    rows: dict[str, list[dict[str, object]]] = {noise: [] for noise in noises}
    for noise in noises:
        for skill in SKILLS:
            for answer in answers(skill, seeds, NOISES[noise]):
                rows[noise].append(asdict(answer))
                print(f"{noise} {skill} {answer.seed}: {answer.why or 'right'}", file=sys.stderr)
                file.write_text(json.dumps(rows, indent=1) + "\n", "utf-8")


if __name__ == "__main__":
    sys.exit(main())
