"""Two results of a suite are compared pair by pair."""

from dataclasses import replace

import numpy as np
import pytest

from tools.evaluate.__main__ import main
from tools.evaluate.compare import compare
from tools.evaluate.harness.journal import Journal
from tools.evaluate.harness.statistics import PairedShares, interval, ratio_interval, share_text
from tools.evaluate.harness.worker_pool import Cost
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import EpisodeRecord


def run(order: EpisodeOrder) -> EpisodeRecord:
    raise NotImplementedError


def journal(file, good, wall_s=1.0, suite="pick", seeds=range(40)):
    kept = Journal(file, suite, "1", run)
    for seed in seeds:
        record = EpisodeRecord(seed, "done", True, simulated_s=10.0)
        record = record if good(seed) else replace(record, outcome="failed", truth=False)
        kept.add(EpisodeOrder(seed), record, Cost(wall_s, wall_s))
    return file


def test_what_one_alone_does_is_counted_and_tested(tmp_path):
    first = journal(tmp_path / "a.jsonl", lambda seed: seed >= 12)
    second = journal(tmp_path / "b.jsonl", lambda seed: seed >= 2 or seed == 0, wall_s=2.0)

    found = compare(first, second)

    assert found.shares == PairedShares(both=28, first=0, second=11, neither=1)
    assert found.shares.p_value == pytest.approx(2 * 0.5**11)
    assert found.times()["wall_s"] == pytest.approx((2.0, 2.0, 2.0))
    assert found.times()["simulated_s"] == pytest.approx((1.0, 1.0, 1.0))


def test_equals_do_not_differ(tmp_path):
    found = compare(*(journal(tmp_path / name, lambda seed: seed % 2) for name in ("a.jsonl", "b.jsonl")))

    assert found.shares.p_value == 1.0


def test_what_changed_is_told_with_its_command(tmp_path, capsys):
    first = journal(tmp_path / "old.jsonl", lambda _: True)
    second = journal(tmp_path / "new.jsonl", lambda seed: seed != 7)

    assert main(["compare", str(first), str(second)]) == 0
    told = " ".join(capsys.readouterr().out.split())
    assert "good in old alone: python -m tools.evaluate pick --episodes 1 --jobs 1 --seed 7" in told
    assert "no more than chance" in told


@pytest.mark.parametrize(
    ("suite", "seeds", "told"),
    [("place", range(40), "different suites"), ("pick", range(50, 60), "no episode in common")],
)
def test_what_cannot_be_compared_is_refused(tmp_path, capsys, suite, seeds, told):
    first = journal(tmp_path / "a.jsonl", lambda _: True)
    second = journal(tmp_path / "b.jsonl", lambda _: True, suite=suite, seeds=seeds)

    assert main(["compare", str(first), str(second)]) == 2
    assert told in capsys.readouterr().err


def test_a_file_that_is_no_journal_is_refused_by_its_line(tmp_path, capsys):
    (tmp_path / "a.jsonl").write_text('{"suite": "pick"}\n')

    assert main(["compare", str(tmp_path / "a.jsonl"), str(tmp_path / "a.jsonl")]) == 2
    assert "line 1: format: Field required" in capsys.readouterr().err


@pytest.mark.requirement("U7")
def test_an_interval_is_wilsons():
    assert interval(19, 20) == pytest.approx((0.7639, 0.9911), abs=1e-4)
    assert interval(97, 100) == pytest.approx((0.9155, 0.9897), abs=1e-4)
    assert share_text(97, 100) == "97.0% (91.5% to 99.0%)"
    assert share_text(0, 0) == "none"


def test_the_interval_of_a_ratio_holds_it_when_times_scatter():
    rng = np.random.default_rng(1)
    first = rng.lognormal(0.0, 0.5, 200)
    second = 1.2 * first * rng.lognormal(0.0, 0.1, 200)

    ratio, low, high = ratio_interval(first, second, rng)

    assert low < 1.2 < high
    assert high - low < 0.1
    assert low < ratio < high
