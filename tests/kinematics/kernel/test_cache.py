import shutil

import pytest

from kinematics.kernel import cache, readiness


@pytest.fixture
def home(tmp_path, monkeypatch):
    """A home of its own, and nothing remembered of the other."""
    monkeypatch.setattr("pathlib.Path.home", lambda: tmp_path)
    cache.folder.cache_clear()
    cache.source_key.cache_clear()
    yield tmp_path
    cache.folder.cache_clear()
    cache.source_key.cache_clear()


def test_it_is_not_ready_before_it_was_compiled_and_ready_after(home):
    assert not readiness.ready()
    cache.mark_complete()
    assert readiness.ready()


def test_other_sources_have_another_folder(home, monkeypatch, tmp_path):
    before = cache.folder()
    cache.mark_complete()
    changed = tmp_path / "sources"
    changed.mkdir()
    (changed / "judge.py").write_text("# changed")
    monkeypatch.setattr(cache, "_SOURCES", changed)
    cache.folder.cache_clear()
    cache.source_key.cache_clear()

    assert cache.folder() != before
    assert not readiness.ready()


def test_another_processor_is_not_ready(home, monkeypatch):
    cache.mark_complete()
    monkeypatch.setattr("llvmlite.binding.get_host_cpu_name", lambda: "abacus")

    assert not readiness.ready()


def test_without_a_folder_to_write_to_it_is_never_ready(home, monkeypatch):
    def no_home():
        raise RuntimeError("no home")

    monkeypatch.setattr("pathlib.Path.home", no_home)
    cache.mark_complete()

    assert cache.folder() is None
    assert not readiness.ready()


def test_only_a_few_folders_of_other_sources_are_kept(home):
    place = cache.folder()
    for k in range(12):
        (place.parent / f"kernel-{k:016d}").mkdir()
    cache.mark_complete()

    assert place.exists()
    assert len(list(place.parent.glob("kernel-*"))) == 6


def test_an_installed_copy_of_the_same_sources_does_not_unmake_a_checkout(home, monkeypatch, tmp_path):
    cache.mark_complete()
    copy = tmp_path / "installed"
    shutil.copytree(cache._SOURCES, copy)
    with monkeypatch.context() as elsewhere:
        elsewhere.setattr(cache, "_SOURCES", copy)
        assert not readiness.ready()
        cache.mark_complete()
        assert readiness.ready()

    assert readiness.ready()
