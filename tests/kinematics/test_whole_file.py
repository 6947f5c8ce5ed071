import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.whole_file import has_its_end, read_whole, write_whole


@given(st.binary(max_size=200))
def test_what_was_written_is_read_back(tmp_path_factory, content):
    file = tmp_path_factory.mktemp("kept") / "file"
    write_whole(file, content)

    assert read_whole(file) == content
    assert has_its_end(file)
    assert [one.name for one in file.parent.iterdir()] == ["file"]


@given(st.binary(min_size=1, max_size=60), st.data())
def test_no_changed_byte_and_no_missing_end_goes_unnoticed(tmp_path_factory, content, data):
    file = tmp_path_factory.mktemp("kept") / "file"
    write_whole(file, content)
    written = bytearray(file.read_bytes())
    at = data.draw(st.integers(0, len(written) - 1))
    written[at] ^= data.draw(st.integers(1, 255))
    file.write_bytes(written)
    assert read_whole(file) is None

    written[at:] = b""
    file.write_bytes(written)
    assert read_whole(file) is None
    assert not has_its_end(file)


def test_what_is_not_there_is_nothing(tmp_path):
    assert read_whole(tmp_path / "none") is None
    assert not has_its_end(tmp_path / "none")
    assert read_whole(tmp_path) is None


def test_what_cannot_be_written_leaves_nothing_behind(tmp_path):
    (tmp_path / "file" / "in the way").mkdir(parents=True)

    with pytest.raises(OSError):
        write_whole(tmp_path / "file", b"content")
    assert [one.name for one in tmp_path.iterdir()] == ["file"]
