"""GIF: the first picture of the file."""

from __future__ import annotations

from collections.abc import Iterator

from sim.bitmap.pixels import BadPicture, Picture, checked_size, flags

_LONGEST_CODE = 12


def read(data: bytes) -> Picture:
    position = 13
    palette, position = _palette(data, position, data[10])
    while data[position] == 0x21:
        position = _after_blocks(data, position + 2)
    if data[position] != 0x2C:
        raise BadPicture("gif")
    width, height = (int.from_bytes(data[position + i : position + i + 2], "little") for i in (5, 7))
    checked_size(width, height)
    settings = data[position + 9]
    own, position = _palette(data, position + 10, settings)
    indices = _unpacked(_blocks(data, position + 1), data[position], width * height)
    rows = _rows(indices, width, height, interlaced=bool(settings & 0x40))
    reds = (own or palette)[::3]
    reds += bytes(256 - len(reds))
    return Picture(width, height, tuple(flags(row.translate(reds)) for row in rows))


def _palette(data: bytes, position: int, settings: int) -> tuple[bytes, int]:
    if not settings & 0x80:
        return b"", position
    length = 3 * (2 << (settings & 7))
    return data[position : position + length], position + length


def _after_blocks(data: bytes, position: int) -> int:
    while data[position]:
        position += data[position] + 1
    return position + 1


def _blocks(data: bytes, position: int) -> bytes:
    end = _after_blocks(data, position)
    body = bytearray()
    while position < end - 1:
        body += data[position + 1 : position + 1 + data[position]]
        position += data[position] + 1
    return bytes(body)


def _codes(body: bytes, smallest: int) -> Iterator[tuple[int, bool]]:
    """Codes, and whether the table starts anew; their width grows with the reader's table."""
    clear, width, entries = 1 << smallest, smallest + 1, (1 << smallest) + 1
    bits = held = position = 0
    while True:
        while held < width:
            if position >= len(body):
                return
            bits |= body[position] << held
            held, position = held + 8, position + 1
        code = bits & ((1 << width) - 1)
        bits, held = bits >> width, held - width
        if code == clear:
            width, entries = smallest + 1, clear + 1
        elif code == clear + 1:
            return
        else:
            entries += 1
            if entries == 1 << width and width < _LONGEST_CODE:
                width += 1
        yield code, code == clear


def _unpacked(body: bytes, smallest: int, count: int) -> bytes:
    if not 1 <= smallest <= 8:
        raise BadPicture("gif")
    first = [bytes((i,)) for i in range(1 << smallest)] + [b"", b""]
    table, before, out = list(first), b"", bytearray()
    for code, anew in _codes(body, smallest):
        if anew:
            table, before = list(first), b""
            continue
        word = table[code] if code < len(table) else before + before[:1]
        if before and len(table) < 1 << _LONGEST_CODE:
            table.append(before + word[:1])
        out += word
        before = word
        if len(out) >= count:
            break
    if len(out) < count:
        raise BadPicture("gif")
    return bytes(out[:count])


def _rows(indices: bytes, width: int, height: int, interlaced: bool) -> tuple[bytes, ...]:
    rows = [indices[y * width : (y + 1) * width] for y in range(height)]
    if not interlaced:
        return tuple(rows)
    order = [y for start, step in ((0, 8), (4, 8), (2, 4), (1, 2)) for y in range(start, height, step)]
    return tuple(row for _, row in sorted(zip(order, rows, strict=True)))
