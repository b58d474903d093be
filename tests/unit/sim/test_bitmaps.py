"""Pictures as floor plans: solid pixels of each kind of file, and the shapes that they become."""

import errno
import os
import struct
import zlib
from io import BytesIO
from pathlib import Path
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from donnie_tui.i18n.mistakes import world_mistake
from donnie_tui.i18n.words import Words
from sim.geometry import signed_area
from sim.scene import NoteKind, Scene
from sim.world import World
from sim.worldfile import Code, WorldError, floor_plans, load_text
from sim.worldfile.floor_plans import (
    MOST_PIXELS,
    MOST_PIXELS_OF_ALL,
    Bitmap,
    OversizedBitmapError,
    Rectangle,
    UnreadableBitmapError,
    count_outlines,
    read_bitmap,
    rectangles,
    scaled_down,
)
from tests.effort import examples
from tests.unit.sim.floors import IDEAL, Unpaced

ROWS = ("..##.", "#...#", "##.##")
"""The picture that every file below holds."""
SOLID = tuple(bytes(pixel == "#" for pixel in row) for row in ROWS)


def chunk(name: bytes, body: bytes) -> bytes:
    return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))


def png(kind: int, depth: int, rows: list[bytes], interlaced: bool = False, palette: bytes = b"") -> bytes:
    header = struct.pack(">IIBBBBB", 5, 3, depth, kind, 0, 0, interlaced)
    extra = chunk(b"PLTE", palette) if palette else b""
    body = zlib.compress(b"".join(rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra + chunk(b"IDAT", body) + chunk(b"IEND", b"")


def grey(level_of: dict[str, int], rows: tuple[str, ...] = ROWS) -> list[bytes]:
    return [bytes(level_of[pixel] for pixel in row) for row in rows]


def filtered(kind: int, rows: list[bytes], step: int) -> list[bytes]:
    """The rows as PNG's filter ``kind`` writes them."""
    before, out = bytes(len(rows[0])), []
    for row in rows:
        line = bytearray((kind,))
        for i, value in enumerate(row):
            a = row[i - step] if i >= step else 0
            b = before[i]
            c = before[i - step] if i >= step else 0
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            line.append((value - (0, a, b, (a + b) // 2, paeth)[kind]) % 256)
        out.append(bytes(line))
        before = row
    return out


def bits(rows: tuple[str, ...], depth: int, dark: int, light: int) -> list[bytes]:
    packed = []
    for row in rows:
        text = "".join(format(dark if pixel == "#" else light, f"0{depth}b") for pixel in row)
        text += "0" * (-len(text) % 8)
        packed.append(bytes(int(text[i : i + 8], 2) for i in range(0, len(text), 8)))
    return packed


def interlaced() -> list[bytes]:
    passes = (
        (0, 0, 8, 8),
        (4, 0, 8, 8),
        (0, 4, 4, 8),
        (2, 0, 4, 4),
        (0, 2, 2, 4),
        (1, 0, 2, 2),
        (0, 1, 1, 2),
    )
    rows = []
    for left, top, across, down in passes:
        for row in ROWS[top::down]:
            if row[left::across]:
                rows.append(b"\0" + bytes(0 if pixel == "#" else 255 for pixel in row[left::across]))
    return rows


LEVELS = {"#": 127, ".": 128}
GREY = grey(LEVELS)
RGB = [b"".join(bytes((level, 9, 200)) for level in row) for row in GREY]
RGBA = [b"".join(bytes((level, 9, 200, 0)) for level in row) for row in GREY]
DEEP = [b"".join(bytes((level, 77)) for level in row) for row in GREY]
PALETTE = bytes((255, 0, 0, 40, 255, 255))


def bmp(bit_count: int, rows: list[bytes], palette: bytes = b"", upside_down: bool = True) -> bytes:
    padded = b"".join(row + bytes(-len(row) % 4) for row in (rows[::-1] if upside_down else rows))
    height = 3 if upside_down else -3
    info = struct.pack("<IiiHHIIiiII", 40, 5, height, 1, bit_count, 0, 0, 0, 0, 0, 0)
    return b"BM" + struct.pack("<IHHI", 0, 0, 0, 54 + len(palette)) + info + palette + padded


BGR = [b"".join(bytes((1, 2, level)) for level in row) for row in GREY]
GIF = (
    b"GIF89a" + struct.pack("<HHBBB", 5, 3, 0x80, 0, 0) + bytes((0, 0, 0, 255, 255, 255))
    + b"\x21\xf9\x04\0\0\0\0\0" + b"," + struct.pack("<HHHHB", 0, 0, 5, 3, 0) + b"\x02"
)  # fmt: skip


def gif_codes() -> bytes:
    """Codes 3 bits wide, the table cleared before it can grow beyond them."""
    codes = [4]
    for i, pixel in enumerate("".join(ROWS)):
        if i and i % 2 == 0:
            codes.append(4)
        codes.append(0 if pixel == "#" else 1)
    codes.append(5)
    text = "".join(format(code, "03b")[::-1] for code in codes)
    text += "0" * (-len(text) % 8)
    body = bytes(int(text[i : i + 8][::-1], 2) for i in range(0, len(text), 8))
    return bytes((len(body),)) + body + b"\0;"


FILES = {
    "png grey": png(0, 8, filtered(0, GREY, 1)),
    **{f"png filter {kind}": png(2, 8, filtered(kind, RGB, 3)) for kind in range(5)},
    "png grey and alpha": png(4, 8, filtered(4, [b"".join(bytes((v, 0)) for v in r) for r in GREY], 2)),
    "png rgba": png(6, 8, filtered(3, RGBA, 4)),
    "png 16 bits": png(0, 16, filtered(1, DEEP, 2)),
    "png 1 bit": png(0, 1, filtered(0, bits(ROWS, 1, 0, 1), 1)),
    "png 2 bits": png(0, 2, filtered(2, bits(ROWS, 2, 1, 2), 1)),
    "png 4 bits": png(0, 4, filtered(0, bits(ROWS, 4, 7, 8), 1)),
    "png palette": png(3, 8, filtered(0, grey({"#": 1, ".": 0}), 1), palette=PALETTE),
    "png palette 1 bit": png(3, 1, filtered(0, bits(ROWS, 1, 1, 0), 1), palette=PALETTE),
    "png interlaced": png(0, 8, interlaced(), interlaced=True),
    "pgm": b"P5\n# a plan\n5 3\n255\n" + b"".join(GREY),
    "pgm of few levels": b"P5 5 3 15\n" + b"".join(grey({"#": 7, ".": 8})),
    "pgm as text": b"P2 5 3 255\n" + b" ".join(b"%d" % v for row in GREY for v in row),
    "ppm": b"P6 5 3 255\n" + b"".join(RGB),
    "bmp 24 bits": bmp(24, BGR),
    "bmp from the top": bmp(24, BGR, upside_down=False),
    "bmp 8 bits": bmp(8, grey({"#": 0, ".": 1}), bytes((0, 0, 9, 0, 0, 0, 200, 0))),
    "bmp 1 bit": bmp(1, bits(ROWS, 1, 0, 1), bytes((0, 0, 9, 0, 0, 0, 200, 0))),
    "gif": GIF + gif_codes(),
}


@pytest.mark.parametrize("kind", FILES)
def test_every_kind_of_picture_is_read(kind: str) -> None:
    assert read_bitmap(FILES[kind]) == Bitmap(5, 3, SOLID)


@settings(max_examples=examples(400))
@given(st.sampled_from(sorted(FILES)), st.integers(0, 200), st.binary(max_size=8), st.integers(0, 8))
def test_a_damaged_picture_is_read_or_refused(kind: str, at: int, piece: bytes, length: int) -> None:
    data = FILES[kind][:at] + piece + FILES[kind][at + length :]

    try:
        picture = read_bitmap(data)
    except UnreadableBitmapError:
        return
    assert picture.width * picture.height <= MOST_PIXELS
    assert [len(row) for row in picture.rows] == [picture.width] * picture.height


def blank_png(width: int, height: int, pixels: bytes = b"") -> bytes:
    """Without pixels, unless compressed ones are given: nothing may decode them."""
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", pixels or zlib.compress(b""))


@pytest.mark.parametrize(
    ("width", "height"), [(10_000, 10_001), (11_000, 10_000), (20_000, 10_000), (100_000, 100_000)]
)
def test_a_picture_with_too_many_pixels_is_refused_with_their_number(width: int, height: int) -> None:
    with pytest.raises(OversizedBitmapError) as refused:
        read_bitmap(blank_png(width, height))

    assert refused.value.code is Code.BITMAP_TOO_LARGE
    assert (refused.value.given, refused.value.limit) == (width * height, MOST_PIXELS)


def test_a_picture_whose_size_pillow_does_not_say_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    from PIL import Image

    def refuse(*_: object, **__: object) -> None:
        raise Image.DecompressionBombError("too large")

    monkeypatch.setattr(Image, "open", refuse)

    with pytest.raises(OversizedBitmapError) as refused:
        read_bitmap(blank_png(1, 1))
    assert (refused.value.given, refused.value.limit) == (100_000_001, 100_000_000)


def test_a_floor_plan_of_eighty_million_pixels_is_read_with_its_thin_walls() -> None:
    from PIL import Image, ImageDraw

    plan = Image.new("1", (9000, 9000), 1)
    ImageDraw.Draw(plan).line((10, 4000, 8990, 4000), fill=0)
    out = BytesIO()
    plan.save(out, "PNG")

    assert list(rectangles(read_bitmap(out.getvalue()).rows)) == [(10, 4000, 8991, 4001)]


@given(st.integers(1, 12), st.integers(1, 12), st.integers(1, 5), st.randoms(use_true_random=False))
def test_a_pixel_of_a_scaled_plan_is_solid_where_one_of_its_pixels_is(
    width: int, height: int, cell: int, chance: Random
) -> None:
    rows = tuple(bytes(chance.random() < 0.2 for _ in range(width)) for _ in range(height))

    scaled = scaled_down(Bitmap(width, height, rows), cell)

    solid = {(x // cell, y // cell) for y in range(height) for x in range(width) if rows[y][x]}
    found = {(x, y) for y, row in enumerate(scaled.rows) for x, each in enumerate(row) if each}
    assert found == solid
    assert (scaled.width, scaled.height) == (-(-width // cell), -(-height // cell))


def test_a_plan_finer_than_the_grid_is_scaled_down_where_it_is_too_detailed(tmp_path: Path) -> None:
    from PIL import Image

    dots = Image.new("1", (1000, 1000), 1)
    dots.putdata([not (x % 4 == 0 and y % 4 == 0) for y in range(1000) for x in range(1000)])
    dots.save(tmp_path / "dots.png")

    def loaded(size: int) -> Scene:
        return load_text(f'model ( bitmap "dots.png" size [ {size} {size} 1 ] )', tmp_path / "a.world")

    fine = loaded(5)
    assert len(fine.models[0].polygons) == 1
    assert [note.code for note in fine.report.notes if note.kind is NoteKind.REPAIRED] == ["plan-scaled"]
    coarse = loaded(500)
    assert len(coarse.models[0].polygons) == 1
    notes = [
        (note.code, note.details["centimetres"]) for note in coarse.report.notes if "path" in note.details
    ]
    assert notes == [("plan-coarse", "200")]


@pytest.mark.parametrize(
    ("size", "notes"),
    [
        ("0.08 0.5 1", [("plan-scaled", None)]),
        ("0.5 0.08 1", [("plan-scaled", None)]),
        ("-0.08 0.5 1", [("plan-scaled", None)]),
        ("0.16 0.16 1", [("plan-coarse", "4")]),
        ("1.6 -1.7 1", [("plan-coarse", "40")]),
        ("-1.6 1.7 1", [("plan-coarse", "40")]),
        ("0 0.5 1", [("plan-coarse", "0")]),
    ],
)
def test_a_plan_of_too_many_rectangles_has_the_cells_of_the_grid_or_larger_ones(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, size: str, notes: list[tuple[str, str | None]]
) -> None:
    """16 dots in 16 pixels each way are one rectangle only in cells of four: a quarter of the shorter side.

    A negative side mirrors the plan.
    """
    from PIL import Image

    monkeypatch.setattr(floor_plans, "MOST_RECTANGLES", 4)
    dots = Image.new("1", (16, 16), 1)
    dots.putdata([not (x % 4 == 0 and y % 4 == 0) for y in range(16) for x in range(16)])
    dots.save(tmp_path / "dots.png")

    scene = load_text(f'model ( bitmap "dots.png" size [ {size} ] )', tmp_path / "a.world")

    about_the_plan = [each for each in scene.report.notes if each.code.startswith("plan-")]
    assert [(each.code, each.details.get("centimetres")) for each in about_the_plan] == notes
    assert len(scene.models[0].polygons) == 1


def test_a_wall_in_a_plan_with_too_many_details_stays_closed_and_a_wide_door_open(tmp_path: Path) -> None:
    """A speckled map, ten centimetres a pixel: 90 000 dots, and a wall with a door 4 m wide."""
    from PIL import Image, ImageDraw

    speckled = Image.new("1", (1000, 1000), 1)
    speckled.putdata([not (x % 3 == 0 and y % 3 == 0 and y < 810) for y in range(1000) for x in range(1000)])
    ImageDraw.Draw(speckled).line((0, 900, 999, 900), fill=0)
    ImageDraw.Draw(speckled).line((480, 900, 519, 900), fill=1)
    speckled.save(tmp_path / "map.png")

    scene = load_text('model ( bitmap "map.png" size [ 100 100 1 ] )', tmp_path / "a.world")

    wall = sorted(points for points in scene.models[0].outlines() if max(y for _, y in points) < -49)
    edges_of_the_door = max(x for x, _ in wall[0]), min(x for x, _ in wall[1])
    assert len(wall) == 2
    assert edges_of_the_door == pytest.approx((-2, 2), abs=0.4)


def test_the_pictures_of_a_world_together_have_a_limit() -> None:
    with pytest.raises(OversizedBitmapError) as refused:
        read_bitmap(blank_png(1000, 1000), room=999_999)

    assert refused.value.code is Code.BITMAPS_TOO_LARGE
    assert refused.value.given == MOST_PIXELS_OF_ALL + 1


def test_a_photograph_of_too_many_layers_is_refused_before_they_are_decoded() -> None:
    from PIL import Image

    out = BytesIO()
    Image.new("L", (2000, 2000), 200).save(out, "JPEG", progressive=True)
    whole = out.getvalue()
    layer = whole[whole.index(b"\xff\xda") : -2]

    with pytest.raises(OversizedBitmapError) as refused:
        read_bitmap(whole[:-2] + layer * 1000 + whole[-2:])

    assert refused.value.code is Code.BITMAP_TOO_MANY_LAYERS
    assert refused.value.given > 1000


def test_a_world_with_a_picture_that_is_too_large_says_so(tmp_path: Path) -> None:
    (tmp_path / "plan.png").write_bytes(blank_png(11_000, 10_000))
    with pytest.raises(WorldError) as refused:
        load_text('model ( bitmap "plan.png" )', tmp_path / "t.world")

    assert world_mistake(refused.value, Words()).endswith(
        "The picture has 110 000 000 pixels, 100 000 000 are allowed."
    )


def test_a_picture_file_that_is_too_large_says_so(tmp_path: Path) -> None:
    with (tmp_path / "plan.png").open("wb") as file:
        file.truncate(100_100_001)
    with pytest.raises(WorldError) as refused:
        load_text('model ( bitmap "plan.png" )', tmp_path / "t.world")

    assert world_mistake(refused.value, Words()).endswith("plan.png is too large, at most 100 100 000 bytes.")


def test_the_pictures_of_a_world_are_counted_together(tmp_path: Path) -> None:
    from PIL import Image

    Image.new("1", (5000, 4100), 1).save(tmp_path / "0.png")
    (tmp_path / "1.png").write_bytes(blank_png(10_000, 10_000))
    models = "\n".join(f'model ( bitmap "{number}.png" )' for number in range(2))

    with pytest.raises(WorldError) as refused:
        load_text(models, tmp_path / "t.world")

    assert refused.value.code is Code.BITMAPS_TOO_LARGE
    assert refused.value.line == 2


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("damaged.png", "The picture damaged.png is damaged."),
        ("plan.svg", "I can't read the picture plan.svg. It should be PNG, JPEG, PGM, PPM, BMP or GIF."),
        ("locked.png", "I can't read locked.png: you have no permission."),
    ],
)
def test_a_picture_that_cannot_be_used_says_the_true_cause(
    name: str, sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    damaged = zlib.compress(bytes(101 * 100))[:-9]
    (tmp_path / "damaged.png").write_bytes(blank_png(100, 100, damaged))
    (tmp_path / "plan.svg").write_text("<svg/>")
    (tmp_path / "locked.png").write_bytes(FILES["png grey"])

    def locked(path: Path) -> object:
        if Path(path).name == "locked.png":
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        return path.open("rb")

    monkeypatch.setattr("sim.worldfile.floor_plans.open_bytes", locked)
    with pytest.raises(WorldError) as refused:
        load_text(f'model ( bitmap "{name}" )', tmp_path / "t.world")

    assert world_mistake(refused.value, Words()).endswith(sentence)
    assert (refused.value.line, refused.value.column) == (1, 16)


@settings(max_examples=examples(200))
@given(st.lists(st.lists(st.booleans(), min_size=7, max_size=7), min_size=1, max_size=8))
def test_rectangles_cover_the_solid_pixels_once_and_nothing_else(pixels: list[list[bool]]) -> None:
    picture = Bitmap(7, len(pixels), tuple(bytes(row) for row in pixels))

    covered = [
        (x, y)
        for left, top, right, bottom in rectangles(picture.rows)
        for y in range(top, bottom)
        for x in range(left, right)
    ]

    assert sorted(covered) == sorted((x, y) for y, row in enumerate(pixels) for x, on in enumerate(row) if on)


def test_equal_runs_become_one_rectangle() -> None:
    picture = Bitmap(4, 3, (b"\1\1\0\0", b"\1\1\0\1", b"\1\1\0\0"))

    assert sorted(rectangles(picture.rows)) == [Rectangle(0, 0, 2, 3), Rectangle(3, 1, 4, 2)]


def test_the_dark_part_of_a_picture_is_fitted_to_the_size(tmp_path: Path) -> None:
    rows = ("......", ".####.", ".#..#.", ".####.", "......")
    body = b"".join(grey({"#": 0, ".": 255}, rows))
    (tmp_path / "ring.pgm").write_bytes(b"P5 6 5 255\n" + body)

    scene = load_text(
        IDEAL + 'model ( bitmap "ring.pgm" size [ 4 3 1 ] ) ideal ( pose [ 0 0 0 90 ] )', tmp_path / "t.world"
    )
    robot = World(scene).robot(pace=Unpaced())

    assert sum(abs(signed_area(polygon.points)) for polygon in scene.models[0].polygons) == pytest.approx(10)
    assert {x for polygon in scene.models[0].polygons for x, _ in polygon.points} == {-2, -1, 1, 2}
    assert "margin-cropped" in [note.code for note in scene.report.notes]
    assert robot.forward(100).walked == 9  # half a metre to the wall, a step before it


def test_a_photograph_is_read() -> None:
    from PIL import Image

    out = BytesIO()
    Image.new("RGB", (8, 8), (10, 200, 200)).save(out, "JPEG")

    assert read_bitmap(out.getvalue()) == Bitmap(8, 8, (b"\1" * 8,) * 8)


@pytest.mark.parametrize(
    ("rows", "count"),
    [
        (("...",), 0),
        (("###", "###"), 1),
        (("#.#", "#.#"), 2),
        (("###", "#.#", "###"), 2),
        (("#.", ".#"), 2),
        ((".#", "#."), 1),
        (("#####", "#.#.#", "#####"), 3),
        (("###", "#.#", "##.", "..#"), 2),
    ],
)
def test_stage_follows_the_border_of_every_dark_patch_and_hole(rows: tuple[str, ...], count: int) -> None:
    """Patches that touch at a corner are one or two, as their borders are sorted."""
    picture = Bitmap(len(rows[0]), len(rows), tuple(bytes(pixel == "#" for pixel in row) for row in rows))

    assert count_outlines(picture) == count


def test_the_borders_of_a_picture_full_of_dots_are_not_counted() -> None:
    row = b"\1\0" * 300

    assert count_outlines(Bitmap(600, 400, (row, bytes(600)) * 200)) is None


@pytest.mark.parametrize(
    ("rows", "is_cropped"),
    [
        *(
            (("##", "##"), False),
            (("#.", ".#"), False),
            ((".#.", "###", ".#."), False),
            (("..", ".."), False),
        ),
        *(((".#", ".#"), True), (("#.", "#."), True), (("..", "##"), True), (("##", ".."), True)),
    ],
)
def test_a_margin_at_any_side_of_a_picture_is_cropped_and_remarked(
    rows: tuple[str, ...], is_cropped: bool, tmp_path: Path
) -> None:
    (tmp_path / "it.pgm").write_bytes(
        b"P5 %d %d 255\n" % (len(rows[0]), len(rows)) + b"".join(grey({"#": 0, ".": 255}, rows))
    )
    notes = load_text('\n model ( bitmap "it.pgm" )', tmp_path / "t.world").report.notes

    found = [
        (each.kind, each.line, each.column, each.details) for each in notes if each.code == "margin-cropped"
    ]
    assert found == ([(NoteKind.REPAIRED, 2, 10, {"path": "it.pgm"})] if is_cropped else [])


def test_the_first_row_of_a_picture_is_in_the_north_and_a_picture_is_read_once(tmp_path: Path) -> None:
    (tmp_path / "it.pgm").write_bytes(b"P5 2 2 255\n" + bytes([0, 0, 0, 255]))
    text = 'model ( bitmap "it.pgm" size [ 2 2 1 ] ) '
    scene = load_text(text * 2, tmp_path / "t.world")

    boxes = [
        tuple(side for axis in zip(*each.points, strict=True) for side in (min(axis), max(axis)))
        for each in scene.models[0].polygons
    ]
    assert sorted(boxes) == [(-1, 0, -1, 0), (-1, 1, 0, 1)]
    assert scene.models[0].polygons == scene.models[1].polygons
    assert scene.report.pictures == (str(tmp_path / "it.pgm"),)


@pytest.mark.parametrize(
    ("mode", "level", "is_solid"),
    [
        *(("L", 127, True), ("L", 128, False), ("RGB", (127, 255, 255), True), ("RGB", (128, 0, 0), False)),
        *(("RGBA", (127, 0, 0, 0), True), ("RGBA", (255, 0, 0, 255), False), ("1", 0, True), ("1", 1, False)),
        *(("I;16", 127 * 256 + 255, True), ("I;16", 128 * 256, False), ("LA", (127, 0), True)),
    ],
)
def test_a_pixel_is_solid_where_its_red_is_at_most_127(mode: str, level: object, is_solid: bool) -> None:
    from PIL import Image

    out = BytesIO()
    Image.new(mode, (1, 1), level).save(out, "PNG")  # type: ignore[arg-type]

    assert read_bitmap(out.getvalue()).rows == (bytes([is_solid]),)


def test_a_picture_may_fill_all_the_room_that_is_left() -> None:
    plan = b"P5 100 100 255\n" + bytes(10_000)
    assert read_bitmap(plan, room=10_000).width == 100
    with pytest.raises(OversizedBitmapError) as refused:
        read_bitmap(plan, room=9_990)
    assert (refused.value.given, refused.value.limit) == (MOST_PIXELS_OF_ALL + 10, MOST_PIXELS_OF_ALL)
    assert str(refused.value) == "bitmaps-too-large"
