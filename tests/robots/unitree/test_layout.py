"""Bytes and check sums of the low-level messages."""

import struct

import numpy as np
import pytest

from robots.unitree.layout import LOW_COMMAND, LOW_STATE, crc_of, empty, is_whole, record_of, seal


def sum_bit_by_bit(words):
    """CRC-32/MPEG-2 as its definition has it: one word after the other, high bit first."""
    crc = 0xFFFFFFFF
    for word in words:
        for bit in range(31, -1, -1):
            carried = (crc >> 31) ^ (word >> bit & 1)
            crc = (crc << 1 & 0xFFFFFFFF) ^ (0x04C11DB7 if carried else 0)
    return crc


def random_message(kind, seed):
    rng = np.random.default_rng(seed)
    return np.frombuffer(rng.bytes(kind.itemsize), dtype=kind)[0].copy()


def test_the_sum_of_the_usual_nine_digits_is_that_of_the_catalogue():
    assert crc_of(b"123456789") == 0x0376E6E7


@pytest.mark.parametrize(("kind", "size"), [(LOW_COMMAND, 1004), (LOW_STATE, 2092)])
def test_a_message_is_as_long_as_its_packed_struct(kind, size):
    formats = {
        1004: "<2B2x" + "B3x5fI" * 35 + "5I",
        2092: "<2I2B2xI" + "13fh2x" + "B3x4f2hf7I" * 35 + "40B5I",
    }

    assert kind.itemsize == size == struct.calcsize(formats[size])


@pytest.mark.parametrize("kind", [LOW_COMMAND, LOW_STATE])
@pytest.mark.parametrize("seed", range(3))
def test_the_sum_is_that_over_the_words_bit_by_bit(kind, seed):
    message = random_message(kind, seed)

    seal(message)

    assert int(message["crc"]) == sum_bit_by_bit(np.frombuffer(message.tobytes()[:-4], "<u4").tolist())


@pytest.mark.parametrize("kind", [LOW_COMMAND, LOW_STATE])
def test_one_flipped_bit_anywhere_is_found(kind):
    message = empty(kind)
    seal(message)
    whole = message.tobytes()

    for place in np.random.default_rng(0).integers(0, 8 * len(whole), 200).tolist():
        data = bytearray(whole)
        data[place // 8] ^= 1 << place % 8
        assert not is_whole(record_of(bytes(data), kind))
    assert is_whole(record_of(whole, kind))


def test_bytes_of_another_length_are_no_message():
    assert record_of(b"\0" * 1003, LOW_COMMAND) is None
