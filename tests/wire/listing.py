"""An independent decoder of what a board sent, which shares nothing with the driver, to compare the driver
with.

It searches the whole recording at once, at each position for the longest frame, and computes the checksum bit
by bit from its definition (CRC-8/MAXIM: x^8 + x^5 + x^4 + 1, least significant bit first).
"""

from __future__ import annotations

ListedFrame = tuple[str, tuple[int, ...] | bytes]
"""A kind, and its values."""


def crc(data: bytes) -> int:
    """A shift register, one bit after the other; no table."""
    register = [0] * 8
    for bit in (byte >> place & 1 for byte in data for place in range(8)):
        out = register.pop(0) ^ bit
        register.append(0)
        for tap in (7, 3, 2):  # x^0, x^4, x^5 of the reflected register
            register[tap] ^= out
    return sum(bit << place for place, bit in enumerate(register))


def listed(said: bytes) -> list[ListedFrame]:
    """The frames in it, as kinds and values. A frame whose data don't fit its kind is skipped."""
    found: list[ListedFrame] = []
    at = 0
    while at < len(said):
        size = _whole(said[at : at + 54])
        if size and (values := _values(said[at + 3], said[at + 4 : at + size - 1])):
            found.append(values)
        at += size or 1
    return found


def _whole(piece: bytes) -> int:
    """The length of the frame that begins there; 0 for none."""
    if len(piece) < 5 or piece[0] != 0xAA or piece[1] != 0xBB or not 1 <= piece[2] <= 50:
        return 0
    size = piece[2] + 4
    return size if len(piece) >= size and crc(piece[3 : size - 1]) == piece[size - 1] else 0


def _values(kind: int, data: bytes) -> ListedFrame | None:
    size, first = len(data), data[0] if data else -1
    if kind == 0x81 and size == 8:
        return "encoders", (_signed(data[0], data[1]), _signed(data[2], data[3]))
    if kind == 0x68 and size == 8 and first == 7:
        return "ranges", tuple(data[1:])
    if kind == 0x42 and size == 7 and first == 6 and set(data[1:]) <= {0, 1}:
        return "bumpers", tuple(data[1:])
    if kind == 0x66 and size == 2:
        return "power", (_signed(data[1], data[0]),)
    if kind == 0x15 and size == 2 and first == 5:
        return "outputs", (data[1],)
    if kind == 0x73:
        return "message", data
    if kind in (0x41, 0xC7) and size == 1:
        return ("ping" if kind == 0x41 else "config", ())
    return None


def _signed(high: int, low: int) -> int:
    number = high * 256 + low
    return number - 65536 if number > 32767 else number
