"""Messages of Player: bytes written by hand from its description, recorded sessions, and rubbish."""

import struct
import tracemalloc
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from devices.player.codec import (
    FORMS,
    HEADER_SIZE,
    LONGEST_REPLY,
    LONGEST_REQUEST,
    BadBody,
    Interface,
    MessageReader,
    MessageType,
    PlayerMessage,
    TooLong,
    banner,
    body_of,
    decode,
    encode,
    form_of,
    values_of,
)
from tests.effort import examples
from tests.player.recordings import NAMES, sides

BAD = {(Interface.POSITION2D, MessageType.REQUEST, 4)}
"""What the recorded server refused because the body is missing."""
PULL = bytes.fromhex(
    "00000000000000000000000100000000000000030000000541dac0bce6d249cf000000000000000400000002"
)
"""The first request of libplayerc."""


def read(data: bytes) -> list[PlayerMessage]:
    return list(MessageReader().feed(data))


def test_a_message_has_a_header_of_40_bytes_and_its_body() -> None:
    [message] = read(PULL)

    assert (message.interface, message.index, message.type, message.subtype) == (1, 0, 3, 5)
    assert values_of(message) == (2,)
    assert message.encoded() == PULL


def test_the_banner_is_32_bytes_and_the_last_is_a_nul() -> None:
    assert banner("3.1.1") == b"Player v.3.1.1" + bytes(18)
    assert banner("3" * 40)[-1:] == b"\0" and len(banner("3" * 40)) == 32


@pytest.mark.parametrize(
    ("form", "values", "hexadecimal"),
    [
        ("I", (2,), "00000002"),
        ("i", (-1,), "ffffffff"),
        ("d", (0.5,), "3fe0000000000000"),
        ("f", (0.5,), "3f000000"),
        ("t", ("alice",), "0000000600000006 616c696365000000"),
        ("t", ("",), "0000000000000000"),
        ("b", (b"\1\0\1\0\1",), "0000000500000005 0100010001000000"),
        ("[d]", ((0.5,),), "0000000100000001 3fe0000000000000"),
        ("[Ii]", (((1, -1), (2, -2)),), "0000000200000002 00000001ffffffff00000002fffffffe"),
        ("I [f] I", (7, (), 8), "00000007 0000000000000000 00000008"),
    ],
)
def test_values_are_big_endian_and_counts_stand_twice(
    form: str, values: tuple[object, ...], hexadecimal: str
) -> None:
    body = bytes.fromhex(hexadecimal)

    assert encode(form, values) == body
    assert decode(form, body) == values


@pytest.mark.parametrize(
    ("key", "values", "size"),
    [
        ((4, 1, 1), (0.0,) * 6 + (0,), 52),
        ((4, 2, 1), (0.0,) * 3 + (1,), 28),
        ((4, 2, 2), (0.0,) * 6 + (1,), 52),
        ((4, 4, 1), (0.0,) * 9, 72),
        ((62, 1, 1), ((1.0,) * 6,), 56),
        ((62, 4, 1), (0.0,) * 9 + (((0.0,) * 6,) * 6, ((0.0,) * 3,) * 6), 520),
        ((62, 4, 5), (0.0,) * 7, 56),
        ((14, 1, 1), (bytes(4),), 12),
        ((14, 4, 1), (((0.0,) * 8,) * 2,), 120),
        ((7, 1, 1), (80, 60, ((0,) * 9 + (0.0,),) * 2), 96),
        ((10, 1, 1), (((0,) + (0.0,) * 12,) * 2,), 208),
        ((10, 4, 1), (0.0,) * 11, 88),
        ((3, 1, 1), (1, 0, 0), 12),
        ((3, 4, 1), (0.0,) * 12 + (2, 0), 104),
        ((1, 4, 3), (0, 0, 4, 0, 1, "stage"), 36),
        ((1, 6, 3), (0, 0, 4, 0, 3, ""), 28),
        ((1, 4, 1), (((0, 0, 4, 0),) * 10,), 168),
        ((31, 4, 1), ("alice", 0.0, 0.0, 0.0), 40),
        ((31, 4, 3), ("alice", *(0.0,) * 7), 72),
        ((31, 4, 5), ("redbox", "color", 0, bytes(16)), 60),
        ((2, 1, 1), (0, 0.0, 0.0, 0.0, 0.0, 0), 24),
        ((20, 1, 1), (0, 0), 8),
        ((66, 2, 1), (b"bump.wav".ljust(64, b"\0"),), 64),
    ],
)
def test_bodies_have_the_sizes_of_the_real_ones(
    key: tuple[int, int, int], values: tuple[object, ...], size: int
) -> None:
    assert len(body_of(*key, *values)) == size
    assert decode(FORMS[key], body_of(*key, *values)) == values


@pytest.mark.parametrize("name", NAMES)
def test_every_recorded_message_is_read_and_written_as_it_was(name: str, shared: Path) -> None:
    read_messages = 0
    for side in sides(shared, name):
        for message in side.messages():
            key = (message.interface, message.type, message.subtype)
            if (form := form_of(message)) is None or name == "garbage" or (name == "refused" and key in BAD):
                continue
            values = decode(form, message.body)
            assert encode(form, values) == message.body, message
            read_messages += 1
    assert read_messages > 10 or name == "garbage"


@pytest.mark.parametrize("name", [each for each in NAMES if each != "garbage"])
def test_the_form_of_every_recorded_message_is_known(name: str, shared: Path) -> None:
    unknown = {
        (message.interface, message.type, message.subtype)
        for side in sides(shared, name)
        for message in side.messages()
        if form_of(message) is None
    }

    assert unknown <= {(Interface.POSITION2D, MessageType.REQUEST, 77)}


@settings(max_examples=examples(100))
@given(st.data())
def test_any_chunking_gives_the_same_messages(data: st.DataObject) -> None:
    stream = PULL + PlayerMessage(4, 0, 2, 1, bytes(28)).encoded() + PULL + PULL[:17]
    cuts = sorted(data.draw(st.lists(st.integers(0, len(stream)), max_size=8)))
    reader = MessageReader()
    found = [
        each
        for start, end in zip([0, *cuts], [*cuts, len(stream)], strict=True)
        for each in reader.feed(stream[start:end])
    ]

    assert found == read(stream)
    assert len(found) == 3
    assert len(reader.held) == 17


@settings(max_examples=examples(300))
@given(st.binary(max_size=400))
def test_random_bytes_are_messages_or_too_long(data: bytes) -> None:
    try:
        found = read(data)
    except TooLong:
        return
    for message in found:
        if form_of(message) is not None:
            with suppress(BadBody):
                values_of(message)


@settings(max_examples=examples(300))
@given(st.sampled_from(sorted(FORMS.items())), st.binary(max_size=200))
def test_a_body_of_random_bytes_is_read_or_refused(
    key_and_form: tuple[tuple[int, int, int], str], body: bytes
) -> None:
    (interface, type_, subtype), _ = key_and_form
    try:
        values_of(PlayerMessage(interface, 0, type_, subtype, body))
    except BadBody as refused:
        assert str(refused)


def test_a_lying_size_is_refused_before_anything_is_held() -> None:
    reader = MessageReader()
    lying = struct.pack(">IIIIIIdII", 0, 0, 1, 0, 3, 5, 0.0, 0, LONGEST_REQUEST + 1)

    with pytest.raises(TooLong, match=str(LONGEST_REQUEST + 1)):
        list(reader.feed(PULL + lying + bytes(500)))
    assert len(reader.held) == 0


def test_messages_before_a_lying_size_are_read() -> None:
    lying = struct.pack(">IIIIIIdII", 0, 0, 1, 0, 3, 5, 0.0, 0, 2**32 - 1)
    found: list[int] = []

    with pytest.raises(TooLong):
        for message in MessageReader().feed(PULL + lying):
            found.append(message.subtype)
    assert found == [5]


@pytest.mark.parametrize(
    ("reader", "longest"), [(MessageReader(), 65_536), (MessageReader(LONGEST_REPLY), 8_388_608)]
)
def test_a_client_sends_64_kibibytes_at_most_and_a_server_eight_mebibytes(
    reader: MessageReader, longest: int
) -> None:
    def header(size: int) -> bytes:
        return struct.pack(">IIIIIIdII", 0, 0, 1, 0, 3, 5, 0.0, 0, size)

    assert list(reader.feed(header(longest))) == []
    assert len(reader.held) == 40
    reader.held.clear()
    with pytest.raises(TooLong, match=rf"^a body of {longest + 1} bytes; at most {longest} are read$"):
        list(reader.feed(header(longest + 1)))


@pytest.mark.parametrize(
    ("form", "body", "reason"),
    [
        ("[d]", "00000001", "it ends within a count"),
        ("t", "0000000100000002" + "00" * 4, "1 and 2 are counts of one array"),
        ("II", "00000001", "4 bytes, and its form has more"),
        ("t", "0000000500000005" + "00" * 7, "15 bytes, and its form has more"),
        ("I", "0000000100000002", "8 bytes, and 4 in its form"),
    ],
)
def test_a_body_that_is_not_of_its_form_is_refused_with_the_reason(form: str, body: str, reason: str) -> None:
    with pytest.raises(BadBody, match=f"^{reason}$"):
        decode(form, bytes.fromhex(body))


@pytest.mark.parametrize(
    ("form", "values", "number"),
    [("IdI", (1, 2.0), 3), ("[Ii] t", ((), "a", 1), 2), ("", (1,), 0), ("b", (), 1)],
)
def test_a_form_takes_as_many_values_as_it_has(form: str, values: tuple[object, ...], number: int) -> None:
    with pytest.raises(BadBody, match=f"^{len(values)} values, and {number} in its form$"):
        encode(form, values)


@pytest.mark.parametrize(
    ("key", "form"),
    [
        ((4, 4, 77), ""),  # a reply that is not known has no body
        ((4, 6, 77), ""),
        ((4, 1, 77), None),
        ((4, 2, 77), None),
        ((4, 3, 77), None),
        ((4, 3, 255), "II"),
        ((4, 2, 255), None),
        ((4, 3, 6), ""),
    ],
)
def test_the_form_of_what_is_not_known(key: tuple[int, int, int], form: str | None) -> None:
    interface, type_, subtype = key

    assert form_of(PlayerMessage(interface, 0, type_, subtype)) == form
    assert values_of(PlayerMessage(interface, 0, type_, subtype)) == (() if form == "" else None)


def test_a_text_ends_at_its_nul_and_what_is_no_text_is_replaced() -> None:
    assert decode("t", bytes.fromhex("0000000400000004") + b"a\0bc") == ("a",)
    assert decode("t", bytes.fromhex("0000000200000002") + b"\xff\0\0\0") == ("\ufffd",)
    assert encode("t", ("\udc80",)) == bytes.fromhex("0000000200000002") + b"?\0\0\0"


@pytest.mark.parametrize(
    "hexadecimal",
    [
        "",
        "00000001",
        "0000000100000002" + "00" * 16,
        "0000000200000001" + "00" * 16,
        "0000000200000002" + "00" * 8,
        "7fffffff7fffffff" + "00" * 8,
        "ffffffffffffffff",
        "0000000100000001" + "00" * 12,
    ],
    ids=["empty", "half", "more", "less", "short", "huge", "hugest", "rest"],
)
def test_counts_that_do_not_fit_are_refused(hexadecimal: str) -> None:
    with pytest.raises(BadBody):
        decode("[d]", bytes.fromhex(hexadecimal))


def test_a_text_of_which_the_padding_is_missing_is_refused() -> None:
    with pytest.raises(BadBody):
        decode("t", bytes.fromhex("0000000500000005") + b"abcd\0")


def test_a_huge_count_takes_no_memory() -> None:
    body = bytes.fromhex("0fffffff0fffffff") + bytes(32)
    tracemalloc.start()
    try:
        with pytest.raises(BadBody):
            decode("[dddddd]", body)
        with pytest.raises(BadBody):
            decode("t", body)
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()

    assert most < 100_000


def test_a_stream_of_half_messages_holds_no_more_than_one() -> None:
    reader = MessageReader()
    header = struct.pack(">IIIIIIdII", 0, 0, 4, 0, 2, 1, 0.0, 0, LONGEST_REQUEST)
    most = 0
    for _ in range(20):
        assert list(reader.feed(header)) == []
        for _ in range(16):
            list(reader.feed(bytes(LONGEST_REQUEST // 16)))
            most = max(most, len(reader.held))

    assert most <= HEADER_SIZE + LONGEST_REQUEST
    assert len(reader.held) == 0


def test_a_request_of_can_you_is_known_of_every_interface() -> None:
    assert values_of(PlayerMessage(31, 0, 3, 255, bytes.fromhex("0000000300000001"))) == (3, 1)
