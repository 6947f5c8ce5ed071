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
    (changed / "judge.py").write_text("from kinematics.kernel.compiler import compiled")
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
    for k in range(20):
        (place.parent / f"kernel-{k:016d}").mkdir()
    cache.mark_complete()

    assert place.exists()
    assert len(list(place.parent.glob("kernel-*"))) == 1 + cache._KEPT


def test_another_checkout_of_the_same_sources_finds_what_the_first_one_compiled(home, monkeypatch, tmp_path):
    cache.mark_complete()
    copy = tmp_path / "checkout" / "kinematics" / "kernel"
    shutil.copytree(cache._SOURCES, copy)
    for source in cache._SOURCES.parent.glob("*.py"):
        shutil.copy(source, copy.parent)
    first = cache.folder()
    monkeypatch.setattr(cache, "_SOURCES", copy)
    cache.folder.cache_clear()
    cache.source_key.cache_clear()

    assert cache.folder() == first
    assert readiness.ready()


def changed_copy(monkeypatch, tmp_path, name):
    copy = tmp_path / "changed" / "kernel"
    shutil.copytree(cache._SOURCES, copy)
    (copy / name).write_text((copy / name).read_text() + "\n# changed\n")
    monkeypatch.setattr(cache, "_SOURCES", copy)
    cache.source_key.cache_clear()
    return cache.source_key()


@pytest.mark.parametrize("name", ["judge.py", "solids.py", "compiler.py"])
def test_what_compiled_code_is_made_from_names_the_folder(home, monkeypatch, tmp_path, name):
    before = cache.source_key()

    assert changed_copy(monkeypatch, tmp_path, name) != before


@pytest.mark.parametrize("name", ["collision_kernel.py", "readiness.py"])
def test_what_only_calls_compiled_code_does_not(home, monkeypatch, tmp_path, name):
    before = cache.source_key()

    assert changed_copy(monkeypatch, tmp_path, name) == before


def test_changed_compiled_code_beside_the_package_is_not_ready(home, monkeypatch, tmp_path):
    cache.mark_complete()
    monkeypatch.setattr(cache, "stamp_of", lambda folder: "other")

    assert not readiness.ready()


def test_a_checkout_with_other_code_beside_the_kernel_takes_nothing_away(home, monkeypatch):
    cache.mark_complete()
    mine = cache.place_of(cache._SOURCES.parent)
    with monkeypatch.context() as other:
        other.setattr(cache, "stamp_of", lambda folder: "other")
        cache.mark_complete()

        assert cache.place_of(cache._SOURCES.parent) != mine
        assert readiness.ready()
    assert readiness.ready()
