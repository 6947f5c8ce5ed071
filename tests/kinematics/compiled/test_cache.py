import shutil

import pytest

from kinematics import whole_file
from kinematics.compiled import cache, readiness
from kinematics.compiled.compiled_sources import CompiledSources
from kinematics.compiled.compiler import compiled


def forget():
    """Nothing is remembered of another home or of other sources."""
    for remembered in (cache.folder, cache.source_key, cache.stamp_of, cache._covered, cache._sources):
        remembered.cache_clear()


@pytest.fixture
def home(tmp_path, monkeypatch):
    """A home of its own, and nothing remembered of the other."""
    monkeypatch.setattr("pathlib.Path.home", lambda: tmp_path)
    forget()
    yield tmp_path
    forget()


def checkout(tmp_path, monkeypatch, name="checkout"):
    """A copy of the package, which counts as the present sources from now on."""
    copy = tmp_path / name / "kinematics"
    shutil.copytree(cache._PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(cache, "_PACKAGE", copy)
    monkeypatch.setattr(cache, "_COMPILER", copy / "compiled" / "compiler.py")
    forget()
    return copy


def changed(source):
    source.write_text(source.read_text() + "\n# changed\n")
    forget()


def test_it_is_not_ready_before_it_was_compiled_and_ready_after(home):
    assert not readiness.ready()
    cache.mark_complete()
    assert readiness.ready()


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
    first = cache.folder()
    checkout(tmp_path, monkeypatch)

    assert cache.folder() == first
    assert readiness.ready()


def test_a_checkout_with_other_sources_takes_nothing_away(home, monkeypatch, tmp_path):
    cache.mark_complete()
    mine = cache.folder()
    with monkeypatch.context() as other:
        changed(checkout(tmp_path, other) / "timing" / "timing_kernel.py")
        assert not readiness.ready()
        cache.mark_complete()

        assert cache.folder() != mine
        assert readiness.ready()
    forget()
    assert readiness.ready()


class TestKey:
    """What names the folder: all sources of compiled code and all that they import, wherever they lie."""

    def test_an_edit_of_any_compiled_source_or_of_what_it_imports_changes_it(
        self, home, monkeypatch, tmp_path
    ):
        copy = checkout(tmp_path, monkeypatch)
        present = CompiledSources([copy], copy / "compiled" / "compiler.py")
        sources = present.made_from(present.compiled())
        plain = cache.source_key()
        kept_it = []
        for source in sources:
            text = source.read_text()
            changed(source)
            if cache.source_key() == plain:
                kept_it.append(source)
            source.write_text(text)

        assert len(sources) > 40
        assert kept_it == []

    @pytest.mark.parametrize(
        "name",
        ["kernel/judge.py", "distance/solids.py", "compiled/compiler.py", "timing/timing_kernel.py",
         "checking/compiled_effort.py", "walking/body/attitude.py", "geometry/poses.py", "errors.py"],
    )  # fmt: skip
    def test_it_covers_every_folder(self, home, monkeypatch, tmp_path, name):
        copy = checkout(tmp_path, monkeypatch)
        before = cache.source_key()
        changed(copy / name)

        assert cache.source_key() != before

    @pytest.mark.parametrize(
        "name", ["kernel/collision_kernel.py", "model/robot_model.py", "walking/route/room.py"]
    )
    def test_what_only_calls_compiled_code_is_not_part_of_it(self, home, monkeypatch, tmp_path, name):
        copy = checkout(tmp_path, monkeypatch)
        before = cache.source_key()
        changed(copy / name)

        assert cache.source_key() == before

    def test_it_covers_sources_that_were_moved_to_another_folder(self, home, monkeypatch, tmp_path):
        copy = checkout(tmp_path, monkeypatch)
        (copy / "distance").rename(copy / "core")
        for source in copy.rglob("*.py"):
            source.write_text(source.read_text().replace("kinematics.distance", "kinematics.core"))
        forget()
        before = cache.source_key()
        changed(copy / "core" / "solids.py")
        after = cache.source_key()
        changed(copy / "core" / "separation.py")

        assert len({before, after, cache.source_key()}) == 3

    @pytest.mark.parametrize(
        "imports",
        [
            "from kinematics.compiled.compiler import compiled\nfrom kinematics.far.away import NUMBER",
            "from .compiled.compiler import compiled\nfrom .far import away",
            "from kinematics.compiled import compiler\nimport kinematics.far.away as numbers",
            "from kinematics.compiled.compiler import (\n    compiled,  # it\n)\n"
            "from kinematics.far import (\n"
            "    # far, far\n    away,\n)",
        ],
    )
    def test_it_follows_imports_however_they_are_written(self, home, monkeypatch, tmp_path, imports):
        copy = checkout(tmp_path, monkeypatch)
        (copy / "far").mkdir()
        (copy / "far" / "__init__.py").write_text("")
        (copy / "far" / "deep.py").write_text("NUMBER = 1.0\n")
        (copy / "far" / "away.py").write_text("from kinematics.far.deep import NUMBER\n")
        (copy / "new.py").write_text(f"{imports}\n")
        forget()
        before = cache.source_key()
        (copy / "far" / "deep.py").write_text("NUMBER = 2.0\n")
        forget()

        assert cache.source_key() != before

    def test_a_source_of_another_package_has_a_stamp_of_all_that_it_imports(
        self, home, monkeypatch, tmp_path
    ):
        copy = checkout(tmp_path, monkeypatch)
        robots = copy.parent / "robots"
        robots.mkdir()
        (robots / "__init__.py").write_text("")
        (robots / "gain.py").write_text("GAIN = 1.0\n")
        source = robots / "law.py"
        source.write_text(
            "from kinematics.compiled.compiler import compiled\nfrom robots.gain import GAIN\n"
            "from kinematics.model.support_polygon import SupportPolygon\n"
        )
        stamps = [cache.stamp_of(source)]
        for other in (robots / "gain.py", copy / "model" / "support_polygon.py"):
            changed(other)
            stamps.append(cache.stamp_of(source))

        assert len(set(stamps)) == 3

    def test_every_source_of_compiled_code_of_this_project_is_found_by_following_imports(self):
        folders = [cache._PACKAGE.parent / name for name in ("kinematics", "robots")]
        everything = sorted(source for folder in folders for source in folder.rglob("*.py"))
        named = [s for s in everything if "kinematics.compiled.compiler import" in s.read_text()]

        assert CompiledSources(folders, cache._COMPILER).compiled() == named


def doubled(x):
    return 2.0 * x


def kept_code():
    """The files that a function was compiled to."""
    assert compiled(doubled)(2.0) == 4.0
    files = sorted(cache.folder().rglob("*.nb?"))
    assert [file.suffix for file in files] == [".nbc", ".nbi"]
    return files


def cut(file):
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])


def emptied(file):
    file.write_bytes(b"")


def flipped(file):
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 0x10
    file.write_bytes(content)


def replaced(file):
    file.write_bytes(b"<html>not found</html>" * 100)


class TestDamage:
    """A file of compiled code that is not as it was written is compiled anew."""

    @pytest.mark.parametrize("suffix", [".nbc", ".nbi"])
    @pytest.mark.parametrize("damage", [cut, emptied, flipped, replaced])
    def test_a_damaged_file_is_compiled_anew(self, home, suffix, damage):
        (file,) = (file for file in kept_code() if file.suffix == suffix)
        damage(file)

        assert cache.damaged() == [file]
        assert compiled(doubled)(3.0) == 6.0
        assert cache.damaged() == []

    def test_a_whole_file_is_loaded_not_compiled(self, home):
        kept_code()
        again = compiled(doubled)

        assert again(3.0) == 6.0
        assert sum(again.stats.cache_hits.values()) == 1

    @pytest.mark.parametrize("damage", [cut, emptied, replaced, lambda file: file.unlink()])
    def test_a_file_that_was_cut_or_is_gone_is_not_ready(self, home, damage):
        file = cache.folder() / "kinematics.kernel" / "f-1.py311.1.nbc"
        file.parent.mkdir()
        whole_file.write_whole(file, bytes(1000))
        cache.mark_complete()
        assert readiness.ready()
        damage(file)

        assert not readiness.ready()
        assert cache.damaged() == [file]

    def test_what_was_damaged_and_dropped_is_not_ready(self, home):
        file = cache.folder() / "kinematics.kernel" / "f-1.py311.1.nbc"
        file.parent.mkdir()
        whole_file.write_whole(file, bytes(1000))
        cache.mark_complete()
        flipped(file)
        assert readiness.ready()
        cache.drop_damaged()

        assert not file.exists()
        assert not readiness.ready()

    @pytest.mark.parametrize("damage", [cut, emptied, flipped, replaced])
    def test_a_damaged_note_of_completeness_is_not_ready(self, home, damage):
        cache.mark_complete()
        damage(cache.folder() / cache._MARKER)

        assert not readiness.ready()

    def test_code_that_cannot_be_kept_is_used_all_the_same(self, home, monkeypatch):
        def full(file, content):
            raise OSError(28, "No space left on device")

        monkeypatch.setattr("kinematics.compiled.compiler.write_whole", full)

        assert compiled(doubled)(3.0) == 6.0
