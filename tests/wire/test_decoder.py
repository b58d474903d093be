"""Bytes in, reports out: any chunking gives the same, no input raises, and nothing accumulates."""

from itertools import accumulate, cycle, islice, pairwise
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from devices.wire.frames import (
    HEADER,
    Bumpers,
    ConfigWanted,
    Decoder,
    Encoders,
    Message,
    Outputs,
    Pinged,
    Power,
    Ranges,
    Report,
    encode_frame,
)
from tests.effort import examples
from tests.wire.listing import ListedFrame, crc, listed
from tests.wire.recordings import ROBOT_TRACES, recording

WHOLE = encode_frame(0x81, bytes.fromhex("00c800c000780078"))
PIECES = st.one_of(
    st.sampled_from(
        [
            WHOLE,
            encode_frame(0x42, bytes((6, 0, 1, 0, 0, 0, 0))),
            b"\nChecksum Error!",
            HEADER,
            b"\xaa",
            bytes(52),
        ]
    ),
    st.binary(max_size=70),
    st.binary(max_size=20).map(lambda data: encode_frame(0x73, data)),
)


def read(chunks: list[bytes]) -> tuple[list[Report], list[str], int]:
    texts: list[str] = []
    decoder = Decoder(texts.append)
    reports = [report for chunk in chunks for report in decoder.feed(chunk)]
    return reports, texts, decoder.bad_frames


def cut(data: bytes, at: list[int]) -> list[bytes]:
    ends = [0, *sorted(each % (len(data) + 1) for each in at), len(data)]
    return [data[a:b] for a, b in pairwise(ends)]


@given(st.lists(PIECES, max_size=12).map(b"".join), st.lists(st.integers(0, 1000), max_size=12))
def test_any_chunking_of_a_stream_gives_the_same_frames_text_and_counts(data: bytes, at: list[int]) -> None:
    assert read(cut(data, at)) == read([data])


@given(st.lists(st.binary(max_size=300), max_size=20))
def test_no_bytes_raise_and_never_more_than_a_frame_and_a_line_is_held(chunks: list[bytes]) -> None:
    decoder = Decoder(lambda _: None)

    for chunk in chunks:
        decoder.feed(chunk)

        assert decoder.held <= 54 + 200


def test_an_endless_line_of_text_is_split_and_not_kept() -> None:
    texts: list[str] = []
    decoder = Decoder(texts.append)

    decoder.feed(b"x" * 100_000)

    assert (len(texts), decoder.held) == (500, 0)


def as_listed(report: Report) -> ListedFrame:
    """The report, as the independent decoder writes it."""
    match report:
        case Encoders(right=right, left=left):
            return "encoders", (right, left)
        case Ranges(centimetres=values):
            return "ranges", values
        case Bumpers(pressed=pressed):
            return "bumpers", tuple(map(int, pressed))
        case Power(millivolts=value):
            return "power", (value,)
        case Outputs(bits=value):
            return "outputs", (value,)
        case Message(text=text):
            return "message", text
        case Pinged():
            return "ping", ()
        case ConfigWanted():
            return "config", ()


def test_the_independent_decoder_has_the_checksum_of_the_standard() -> None:
    assert crc(b"123456789") == 0xA1


RECORDED: dict[str, tuple[bytes, list[ListedFrame]]] = {}
"""Of each recording the bytes of the board, and the frames that the independent decoder finds in them."""


@settings(max_examples=examples(15))
@given(name=st.sampled_from(ROBOT_TRACES), sizes=st.lists(st.integers(1, 400), min_size=1, max_size=40))
def test_in_every_chunking_a_recording_has_the_frames_of_the_independent_decoder(
    shared: Path, name: str, sizes: list[int]
) -> None:
    """The sizes repeat to the end: bytes, pieces of frames, dozens of frames, in any combination."""
    if name not in RECORDED:
        sent = b"".join(row.data for row in recording(shared, name) if row.direction == "rx")
        RECORDED[name] = sent, listed(sent)
    sent, frames = RECORDED[name]
    ends = [0, *accumulate(islice(cycle(sizes), len(sent)))]
    chunks = [sent[a:b] for a, b in pairwise(ends) if a < len(sent)]

    assert b"".join(chunks) == sent
    assert [as_listed(each) for each in read(chunks)[0]] == frames


def test_the_independent_decoder_finds_the_known_numbers_of_frames(shared: Path) -> None:
    counts = {
        name: len(listed(b"".join(row.data for row in recording(shared, name) if row.direction == "rx")))
        for name in ROBOT_TRACES
    }
    assert counts["robot_boot_unanswered"] == 4
    assert min(count for name, count in counts.items() if name != "robot_boot_unanswered") > 500


def test_frames_are_decoded_to_values() -> None:
    reports, _, _ = read([bytes.fromhex("aabb02c72bd9 aabb0366401f33")])

    assert reports == [ConfigWanted(), Power(8000)]


def test_counts_are_signed_and_the_speeds_after_them_are_ignored() -> None:
    assert read([encode_frame(0x81, bytes.fromhex("fffe0003007b0078"))])[0] == [Encoders(-2, 3)]


def test_power_can_be_negative() -> None:
    assert read([encode_frame(0x66, b"\x9c\xff")])[0] == [Power(-100)]


def test_a_header_inside_the_data_does_not_begin_a_frame() -> None:
    inside = encode_frame(0x73, b"\xaa\xbb\x02\x41")

    assert read([inside + WHOLE])[0] == [Message(b"\xaa\xbb\x02\x41"), Encoders(200, 192)]


def test_after_a_bad_checksum_one_byte_is_dropped_and_the_next_frame_is_found() -> None:
    """The bad frame's LEN would have included the good one."""
    bad = HEADER + bytes((20, 0x81))

    reports, _, bad_frames = read([bad + WHOLE + WHOLE])

    assert (reports, bad_frames) == ([Encoders(200, 192)] * 2, 1)


def test_text_between_frames_goes_to_the_log_a_line_at_a_time() -> None:
    text = b"\nFOUND S0\nFOUND S1\nPayload reveived"

    _, texts, bad = read([text, WHOLE, b"\nChecksum Error!", WHOLE])

    assert (texts, bad) == (["FOUND S0", "FOUND S1", "Payload reveived", "Checksum Error!"], 0)


@pytest.mark.parametrize("length", [0, 51, 255])
def test_an_invalid_length_begins_no_frame(length: int) -> None:
    assert read([HEADER + bytes((length,)) + bytes(60) + WHOLE])[0] == [Encoders(200, 192)]


@pytest.mark.parametrize(
    "body",
    [
        bytes((0x81, 0, 0)),
        bytes((0x68, 6)) + bytes(6),
        bytes((0x68, 7)) + bytes(6),
        bytes((0x42, 6)) + bytes(7),
        bytes((0x42, 6, 0, 0, 2, 0, 0, 0)),
        bytes((0x66, 1)),
        bytes((0xC7, 1, 2)),
        bytes((0x41,)),
        bytes((0x15, 4, 0)),
        bytes((0x93, 1)),
    ],
    ids=[
        "enc",
        "six-sonars",
        "short",
        "seven-bumpers",
        "bumper-2",
        "power",
        "config",
        "ping",
        "dio",
        "unknown",
    ],
)
def test_a_good_checksum_over_data_that_do_not_fit_their_type_is_counted_and_ignored(body: bytes) -> None:
    assert read([encode_frame(body[0], body[1:]) + encode_frame(0x41, b"\x42")]) == ([Pinged()], [], 1)


def test_bumpers_and_ranges_keep_the_boards_order() -> None:
    bumpers, ranges = (
        encode_frame(0x42, bytes((6, 0, 1, 0, 0, 0, 1))),
        encode_frame(0x68, bytes((7, 1, 2, 3, 4, 5, 6, 7))),
    )

    assert read([bumpers + ranges])[0] == [
        Bumpers((False, True, False, False, False, True)),
        Ranges((1, 2, 3, 4, 5, 6, 7)),
    ]


def test_bytes_that_begin_no_frame_are_text() -> None:
    """As the board's own lines are, after a frame that was cut."""
    reports, texts, bad_frames = read([HEADER + b"\0hello\n" + WHOLE, HEADER + b"\x33" + WHOLE])

    assert (reports, bad_frames) == ([Encoders(200, 192)] * 2, 2)
    assert texts == ["\\xaa\\xbb\0hello", "\\xaa\\xbb3"]


@pytest.mark.parametrize(
    ("length", "lines"), [(199, [199]), (200, [200]), (201, [200, 1]), (400, [200, 200])]
)
def test_a_line_has_two_hundred_characters_at_most(length: int, lines: list[int]) -> None:
    """An empty line is none."""
    _, texts, _ = read([b"\n\n" + b"x" * length + b"\n"])

    assert [len(each) for each in texts] == lines


def test_a_frame_has_fifty_bytes_at_most() -> None:
    longest = encode_frame(0x73, b"x" * 49)
    assert (len(longest), longest[2]) == (54, 50)
    assert read([longest + encode_frame(0x73, b"")])[0] == [Message(b"x" * 49), Message(b"")]
    with pytest.raises(ValueError, match=r"^too long for a frame$"):
        encode_frame(0x73, b"x" * 50)


def test_a_repeated_frame_is_reported_each_time_and_a_changed_one_is_read() -> None:
    other = encode_frame(0x81, bytes.fromhex("00c900c000780078"))
    broken = WHOLE[:-1] + bytes((WHOLE[-1] ^ 1,))
    reports, texts, bad_frames = read([b"a", WHOLE, b"b", WHOLE, broken, other, other, b"c\n"])

    assert reports == [Encoders(200, 192)] * 2 + [Encoders(201, 192)] * 2
    assert (bad_frames, texts[:2], texts[-1]) == (1, ["a", "b"], "c")


def test_a_byte_that_may_begin_a_frame_waits_for_the_next_ones() -> None:
    decoder = Decoder(None)
    assert decoder.feed(b"text" + WHOLE[:1]) == []
    assert decoder.held == 1
    assert decoder.feed(WHOLE[1:5]) == []
    assert decoder.held == 5
    assert decoder.feed(WHOLE[5:] + b"text") == [Encoders(200, 192)]
    assert decoder.held == 0
