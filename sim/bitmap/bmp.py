"""BMP without compression: 1, 4, 8, 24 or 32 bits a pixel."""

from __future__ import annotations

from struct import error, unpack_from

from sim.bitmap.pixels import BadPicture, Picture, checked_size, flags


def read(data: bytes) -> Picture:
    try:
        offset, header = unpack_from("<II", data, 10)
        width, height, _, bits, packing = unpack_from("<iiHHI", data, 18)
    except error:
        raise BadPicture("bmp") from None
    checked_size(width, abs(height))
    if header < 40 or bits not in (1, 4, 8, 24, 32) or packing not in ((0, 3) if bits == 32 else (0,)):
        raise BadPicture("bmp")
    palette = data[14 + header : offset][2::4]
    length = (width * bits + 31) // 32 * 4
    rows = [data[offset + y * length : offset + (y + 1) * length] for y in range(abs(height))]
    if len(rows[-1]) < (width * bits + 7) // 8:
        raise BadPicture("bmp")
    solid = tuple(flags(_reds(row, bits, palette)[:width]) for row in rows)
    return Picture(width, abs(height), solid if height < 0 else solid[::-1])


def _reds(row: bytes, bits: int, palette: bytes) -> bytes:
    if bits >= 24:
        return row[2 :: bits // 8]
    mask, shifts = (1 << bits) - 1, range(8 - bits, -1, -bits)
    samples = bytes(byte >> shift & mask for byte in row for shift in shifts)
    return samples.translate(palette + bytes(256 - len(palette)))
