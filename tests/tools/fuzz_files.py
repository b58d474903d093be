"""Random challenges, settings, translations, pictures and messages of a page, for ``tests.tools.fuzz``.

Each kind damages something right: bytes are left out, doubled, or exchanged for what is hard to read.
"""

from __future__ import annotations

import asyncio
import json
import random
import tempfile
from functools import cache
from gettext import GNUTranslations
from io import BytesIO
from pathlib import Path
from typing import Any

from PIL import Image

from donnie_tui.cli.page_session import PageLimits, PageSession
from donnie_tui.i18n import po
from donnie_tui.i18n.translations import SOURCE
from donnie_tui.i18n.words import CODES, Words
from donnie_tui.settings.parsing import read_file
from donnie_tui.settings.settings import KEYS, resolve
from language.locales import languages
from sim.worldfile.floor_plans import MOST_PIXELS, UnreadableBitmapError, read_bitmap
from tests.conftest import ROOT
from worlds.challenges import LADDERS, BadChallenge, read

Input = str | bytes

_PIECES = (
    *(
        b"",
        b"[",
        b"]",
        b"[[",
        b"{",
        b"}",
        b'"',
        b"'",
        b"=",
        b"\n",
        b"\\",
        b"#",
        b"\xff",
        b"\x00",
        b"\xc2\x9b",
    ),
    *(b"-", b"0", b"9" * 40, b"1e999", b"nan", b"inf", b"true", b"null", b"\xe2\x80\xae", b"\x1b[2J"),
)


def damaged(data: bytes, chance: random.Random) -> bytes:
    """A few places are left out, doubled, or exchanged for something else."""
    changed = bytearray(data)
    for _ in range(chance.choice((1, 1, 2, 5, 20))):
        at, length = chance.randrange(len(changed) + 1), chance.choice((0, 1, 1, 4, 30, 200))
        part = bytes(changed[at : at + length])
        changed[at : at + length] = chance.choice((*_PIECES, part * 2, chance.randbytes(3)))
    return bytes(changed)


# --- challenges ---------------------------------------------------------------------------------------


@cache
def _challenges() -> list[bytes]:
    return [each.read_bytes() for each in sorted(Path(LADDERS).glob("*.toml"))]


def make_challenge(chance: random.Random) -> bytes:
    return damaged(chance.choice(_challenges()), chance)


def check_challenge(data: Input) -> None:
    """It is read, or refused with a place in it."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "some.toml")
        file.write_bytes(_as_bytes(data))
        Path(folder, "some.solution.gd").write_text("FW 1", encoding="utf-8")
        try:
            read(file)
        except BadChallenge as refused:
            for each in refused.mistakes:
                assert 0 <= each.line <= _as_bytes(data).count(b"\n") + 1
                assert all(Words(language).knows(each.code) for language in languages())


# --- settings -----------------------------------------------------------------------------------------

_VALUES = (
    '"a"',
    '""',
    "0",
    "-1",
    "1e999",
    "nan",
    "true",
    "[]",
    "{}",
    '["a"]',
    "1979-05-27",
    '"\\u009b2J"',
    '"max"',
)


def make_settings(chance: random.Random) -> bytes:
    lines = [f"{chance.choice(KEYS).key} = {chance.choice(_VALUES)}" for _ in range(chance.randrange(12))]
    text = "\n".join(lines).encode()
    return damaged(text, chance) if chance.randrange(2) else text


def check_settings(data: Input) -> None:
    """Donnie starts, with the values that can be used and a sentence about each other."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "settings.toml")
        file.write_bytes(_as_bytes(data))
        values, notices = read_file(str(file))
    settings, others = resolve({}, {}, values)
    words = Words(settings.language)
    for each in (*notices, *others):
        words(each.code, **each.values)


# --- translations -------------------------------------------------------------------------------------


@cache
def _translations() -> list[bytes]:
    files = sorted((ROOT / "donnie_tui/i18n/locales").glob(f"*/{SOURCE}"))
    return [piece for each in files for piece in _some_entries(each.read_bytes())]


def _some_entries(content: bytes) -> list[bytes]:
    """The header with forty entries each: a whole file takes a second."""
    header, *entries = content.split(b"\n\n")
    return [b"\n\n".join((header, *entries[at : at + 40])) for at in range(0, len(entries), 40)]


def make_translation(chance: random.Random) -> bytes:
    return damaged(chance.choice(_translations()), chance)


def check_translation(data: Input) -> None:
    """The entries without a mistake can be used, and each mistake has its line."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, SOURCE)
        file.write_bytes(_as_bytes(data))
        try:
            entries = po.usable(file)
        except po.Mistake:
            return
    GNUTranslations(BytesIO(po.compiled(entries, CODES, is_english=False)))


# --- pictures -----------------------------------------------------------------------------------------


@cache
def _pictures() -> list[bytes]:
    made, chance = [], random.Random(1)
    for kind, mode in (
        ("PNG", "1"),
        ("PNG", "RGBA"),
        ("PNG", "P"),
        ("JPEG", "RGB"),
        ("PPM", "L"),
        ("GIF", "P"),
    ):
        picture = Image.new(mode, (24, 17))
        for _ in range(60):
            picture.putpixel((chance.randrange(24), chance.randrange(17)), 1)
        stream = BytesIO()
        picture.save(stream, kind)
        made.append(stream.getvalue())
    return made


def make_picture(chance: random.Random) -> bytes:
    return damaged(chance.choice(_pictures()), chance)


def check_picture(data: Input) -> None:
    """It is a picture within its limits, or none."""
    try:
        picture = read_bitmap(_as_bytes(data))
    except UnreadableBitmapError:
        return
    assert picture.width * picture.height <= MOST_PIXELS
    assert len(picture.rows) == picture.height
    assert {len(row) for row in picture.rows} <= {picture.width}


# --- messages of a page -------------------------------------------------------------------------------

_MESSAGES = (
    ["stdin", "FW 2\r"],
    ["resize", {"width": 80, "height": 24}],
    ["focus"],
    ["blur"],
    ["ping", "1"],
    ["resize", {"width": -1, "height": 10**30}],
    ["stdin", 1],
    [[[["stdin"]]]],
)


def make_messages(chance: random.Random) -> bytes:
    """Frames of a page, a line each."""
    frames = [json.dumps(chance.choice(_MESSAGES)).encode() for _ in range(chance.randrange(1, 20))]
    if chance.randrange(10) == 0:
        frames.append(b"[" * chance.randrange(5000))
    return b"\n".join(damaged(each, chance).replace(b"\n", b" ") for each in frames)


class _Page:
    """A page that only takes."""

    async def take(self, *_: Any, **__: Any) -> None: ...

    send_bytes = send_str = send_json = close = take


def check_messages(data: Input) -> None:
    """Nothing is raised, and what waits for the process has a limit."""
    limits = PageLimits(frame=2000)

    async def feed() -> None:
        session = PageSession((), _Page(), Words(), limits, lambda: None)  # type: ignore[arg-type] # as much of one as is used
        for frame in _as_bytes(data).split(b"\n"):
            await session._take(frame.decode("utf-8", "replace"))
            assert sum(map(len, session._held)) <= limits.frame + 6 * len(frame) + 100

    asyncio.run(feed())


def _as_bytes(data: Input) -> bytes:
    assert isinstance(data, bytes)
    return data
