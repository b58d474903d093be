"""Tries random input on everything that reads what others wrote. ``make fuzz SEED=1 COUNT=1000``.

Not part of the check. Each kind of input has a generator, which takes a ``Random`` made of the seed, the kind
and the number of the case, and a check, which raises. So ``--only NUMBER`` with the same seed tries one case
again. A case that fails or takes longer than its limit is made smaller as long as it fails in the same way,
and printed; the input lies in ``.fuzz`` afterwards.

The generators are those of the tests, which try a few of the same cases in each check.
"""

from __future__ import annotations

import argparse
import io
import os
import random
import re
import signal
import sys
import tempfile
import time
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING

import worlds
from donnie_tui.core.events import as_line
from donnie_tui.core.recording import NoRecordingError, Recording
from donnie_tui.core.timeline import Timeline, redone_in_words, undone_in_words
from donnie_tui.core.transcript import printed_lines
from donnie_tui.i18n.mistakes import world_mistake, world_note
from donnie_tui.i18n.words import Words
from language.checker import check
from language.formatter import formatted
from language.keywords import all_words, folded_word
from language.locales import languages
from language.outline import block_depth, outline
from language.parser import parse
from language.source import HARMFUL
from sim.picture import picture
from sim.worldfile import WorldError, load_text
from tests.conftest import ROOT
from tests.properties import test_language_garbage as garbage
from tests.properties.random_programs import ProgramWriter, mixed
from tests.properties.test_language_compiler import compare
from tests.sessions.command import QUIET, donnie
from tests.tools import fuzz_files, fuzz_screens, fuzz_serial, fuzz_sockets
from tests.tools.fuzz_files import Input
from tests.worlds import test_garbage as damaged_worlds

if TYPE_CHECKING:
    from donnie_tui.core.events import Stamped

FOLDER = ROOT / ".fuzz"
LONGEST_SHOWN = 2000
"""Characters of a failing input that are printed."""
MOST_FAILURES = 10
"""Of one kind; then the next kind is tried."""
SHRINKING = 20.0
"""Seconds that a failing input is made smaller."""


@dataclass(frozen=True)
class Kind:
    """A kind of input."""

    make: Callable[[random.Random], Input]
    check: Callable[[Input], None]
    seconds: float = 2.0
    """Of processor time, after which a case counts as failed; four times as long by the clock."""
    share: float = 1.0
    """Of the cases that were asked for: some cases are many in one."""


# --- programs -----------------------------------------------------------------------------------------


def _program(chance: random.Random) -> str:
    kind = chance.randrange(7)
    if kind < 2:
        program = ProgramWriter(chance.getrandbits(32)).program()
        return mixed(program, chance) if kind else program
    if kind == 2:
        return repeated(chance, (*garbage.WORDS, *garbage.HEADS, *garbage.LINES, *_MARKS))
    make = (garbage.soup, garbage.broken_program, garbage.any_bytes, _signs)[kind - 3]
    return make(chance)


_MARKS = (
    "-",
    "--",
    "\u2014",
    "\u2018",
    "\u201c",
    "'",
    '"',
    "=",
    "[",
    "]",
    "(",
    ")",
    "1",
    "a",
    " ",
    "\u0300",
    "\n",
)


def repeated(chance: random.Random, pieces: Sequence[str]) -> str:
    """A few pieces, then some of them many times: what takes more time than it is long."""
    begin, middle, end = ("".join(chance.choices(pieces, k=chance.randrange(4))) for _ in range(3))
    blank = chance.choice(("", "", " ", "\n"))
    return f"{begin}{blank}{(middle + blank) * chance.randrange(20, 2000)}{end}"


def _signs(chance: random.Random) -> str:
    """Any characters between words."""
    pieces = [chance.choice(("IF", "1", "x", "=", "THEN", "FW", '"', "--", " ", "\n")) for _ in range(12)]
    return "".join(
        piece + chr(chance.choice((chance.randrange(0x20, 0x3000), chance.randrange(0x110000)))) * (at % 2)
        for at, piece in enumerate(pieces)
    )


def _check_program(text: Input) -> None:
    assert isinstance(text, str)
    parsed = parse(text)
    garbage.hold(text, parsed)
    for diagnostic in parsed.diagnostics:
        for language in languages():
            _is_harmless(Words(language).mistake(diagnostic))
            _is_harmless(Words(language).hint(diagnostic) or "")
    assert 0 <= block_depth(text) <= sum(not each.is_closed for each in outline(text))
    if parsed.program is None:
        return
    check(parsed.program)
    for to in (None, *languages()):
        once = formatted(text, to).text
        assert once is not None
        assert formatted(once, to).text == once, f"formatted twice, to {to}"
        assert formatted(once).text == once, f"formatted to {to}, then once more"


def _run(chance: random.Random) -> str:
    """A right program, which may fail when it runs: in one language, or mixed, and perhaps mutated."""
    text = ProgramWriter(chance.getrandbits(32)).program()
    kind = chance.randrange(4)
    if kind % 2:
        text = mixed(text, chance)
    return mutated(text, chance) if kind >= 2 else text


_WORD = re.compile(r"\w+|[^\w\s]+|\n")


def mutated(program: str, chance: random.Random) -> str:
    """With a few words or signs that another one of the program replaces, or that are gone or doubled; what
    is no program any more is not changed so."""
    for _ in range(chance.randrange(1, 9)):
        places = [found.span() for found in _WORD.finditer(program)] or [(0, 0)]
        (start, end), (first, last) = chance.choice(places), chance.choice(places)
        old, other = program[start:end], program[first:last]
        new = chance.choice((other, other, other, "", f"{old} {old}", f"{old} {other}"))
        changed = program[:start] + new + program[end:]
        if parse(changed).program is not None:
            program = changed
    return program


def _check_run(text: Input) -> None:
    """The compiled and the interpreted program do the same."""
    assert isinstance(text, str)
    if parse(text).program is not None:
        compare([text])


# --- worlds -------------------------------------------------------------------------------------------

_WORLD = Path(worlds.MANUAL) / "garbage.world"


def _world(chance: random.Random) -> str:
    if chance.randrange(5) == 0:
        return repeated(chance, (*damaged_worlds.PIECES, *_WORLD_PIECES))
    return damaged_worlds.damaged(chance.choice(_world_sources()), chance)


_WORLD_PIECES = (
    "position",
    "sensor ( )",
    "ranger (",
    "block (",
    " ",
    "1",
    "1.",
    "e",
    "-",
    "name",
    "a",
    "size",
    '"',
)


@cache
def _world_sources() -> list[str]:
    return damaged_worlds.sources()


def _check_world(text: Input) -> None:
    assert isinstance(text, str)
    try:
        scene = load_text(text, _WORLD)
    except WorldError as mistake:
        assert mistake.line >= 1
        assert mistake.column >= 1
        for language in languages():
            _is_harmless(world_mistake(mistake, Words(language)))
        return
    for note in scene.report.notes:
        _is_harmless(world_note(note, Words()))
    for robot in (None, *(scene.models[index].spoken_name for index in scene.robots[:2])):
        picture(scene, robot)


# --- recordings ---------------------------------------------------------------------------------------

_RECORDED = """VAR n = 2 REPEAT n TIMES FW n TR 90 END REPEAT SPEAK "olá"
STATE SCAN WAIT 1 SPEAK DISTANCE F SPEAK x"""
_PIECES = (
    b"9",
    b"-",
    b"e",
    b"\xff",
    b"{",
    b"",
    b'"',
    b"\\u0000",
    b"null",
    b"1e999",
    b"[",
    b"\xc2\x9b",
    b"\n",
)


@cache
def _recording() -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "a.gd").write_text(_RECORDED, encoding="utf-8")
        options = (*QUIET, "--speed", "max", "--record", "a.rec", "--world", "object_field")
        donnie(Path(folder), "run", "a.gd", *options)
        return Path(folder, "a.rec").read_bytes()


def _damaged_recording(chance: random.Random) -> bytes:
    damaged = bytearray(_recording())
    first = damaged.index(b"\n") + 1 if chance.randrange(4) else 0
    for _ in range(chance.choice((1, 1, 2, 20))):
        at = chance.randrange(first, len(damaged))
        damaged[at : at + chance.choice((0, 1, 1, 3, 90))] = chance.choice(_PIECES)
    return bytes(damaged)


def _check_recording(data: Input) -> None:
    assert isinstance(data, bytes)
    try:
        recording = Recording(io.BytesIO(data))
    except NoRecordingError:
        return
    words = Words()
    is_read_again = len(data) % 10 == 0  # each event whenever it is asked for, as in a replay, which is slow
    timeline = Timeline(recording.events if is_read_again else [*recording.events])
    while step := timeline.step():
        redone_in_words(step, words)
        for stamped in step:
            _is_harmless_event(stamped, words)
    while undone := timeline.step_back():
        undone_in_words(undone, timeline, words)


def _is_harmless_event(stamped: Stamped, words: Words) -> None:
    for line in printed_lines(stamped, words):
        _is_harmless(line)
    _is_harmless(as_line(stamped, whole=True).removesuffix("\n"))


# --- typed sessions -----------------------------------------------------------------------------------

_LINES = 60
"""In one session."""


def _session(chance: random.Random) -> str:
    """Typed lines: commands in any language, GoDonnie, and neither. No path leads out of its folder."""
    return "\n".join(_line(chance) for _ in range(_LINES)) + "\n"


def _line(chance: random.Random) -> str:
    kind = chance.randrange(10)
    if kind < 4:
        word = chance.choice(_command_words())
        return f"{word} {chance.choice(_ARGUMENTS)}".rstrip()
    if kind < 6:
        return chance.choice(_GODONNIE)
    if kind < 9:
        return _one_line(garbage.soup(chance) if kind < 8 else garbage.broken_program(chance))
    if chance.randrange(2):
        return _one_line(repeated(chance, (*_command_words(), *_GODONNIE, *_MARKS)))
    return _one_line(garbage.any_bytes(chance))


_ARGUMENTS = (
    *("", "", "", "", "1", "2", "0", "-1", "99999999999", "a", "a.gd", "b", "x", "FW", "red", "on", "off"),
    *(
        "map",
        "map map.html",
        "all",
        "next",
        "1 2",
        "1-3",
        "north",
        "\x1b[2J",
        "\u009b2J",
        "é",
        "~",
        "yes",
        "no",
    ),
    *("living_room", "maze", "pt", "es", "en", "help", "'", '"', "\u202eabc", "max", "brief", "." * 3000),
    *("loop.gd", "loop.world", "a\0b", "a\0b.world"),
)
_GODONNIE = (
    "FW 1",
    "TR 90",
    "VAR a = 1",
    "SPEAK a",
    "SCAN",
    "HISTORY",
    "STATE",
    "RUN",
    "",
    "yes",
    "no",
    "1",
    "2",
)


@cache
def _command_words() -> tuple[str, ...]:
    from donnie_tui.commands.declarations import COMMANDS
    from donnie_tui.commands.lookup import words_of

    return tuple(
        word for each in COMMANDS for language in languages() for word in words_of(each.name, language)
    )


def _one_line(text: str) -> str:
    """Without what would end the session's input or leave its folder, and without endless loops."""
    line = " ".join(text.replace("/", "").replace("\0", "").splitlines())
    loops = {word for language in languages() for word in all_words(language) if folded_word(word) in _LOOPS}
    return " ".join(word for word in line.split(" ") if word.upper() not in loops)


_LOOPS = {folded_word(word) for word in ("WHILE", "ENQUANTO", "MIENTRAS")}


def _check_session(text: Input) -> None:
    assert isinstance(text, str)
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "work").mkdir()
        for name in ("loop.gd", "loop.world"):
            Path(folder, "work", name).symlink_to(name)
        # A room with walls: an example that walks up to the wall never ends on the open floor.
        options = ("--linear", *QUIET, "--speed", "max", "--robot", "sim", "--world", "first_room")
        done = donnie(Path(folder, "work"), *options, typed=text.encode("utf-8", "replace"))
    errors = done.stderr.decode("utf-8", "replace")
    assert "Traceback" not in errors, errors[-3000:]
    assert done.returncode in (0, 1, 2), f"exit code {done.returncode}: {errors[-500:]}"
    for line in (done.stdout.decode("utf-8") + errors).split("\n"):
        _is_harmless(line)


def _screen(chance: random.Random) -> bytes:
    return fuzz_screens.make_keys(chance, _line, _LINES)


def _is_harmless(line: str) -> None:
    assert re.search(HARMFUL, line) is None, f"a control character in {line[:200]!r}"


KINDS: dict[str, Kind] = {
    "programs": Kind(_program, _check_program, 4.0),
    "runs": Kind(_run, _check_run, 4.0),
    "worlds": Kind(_world, _check_world),
    "recordings": Kind(_damaged_recording, _check_recording),
    "sessions": Kind(_session, _check_session, 30.0, share=1 / _LINES),
    "screens": Kind(_screen, fuzz_screens.check_keys, 30.0, share=1 / _LINES),
    "serial": Kind(fuzz_serial.make_serial, fuzz_serial.check_serial),
    "challenges": Kind(fuzz_files.make_challenge, fuzz_files.check_challenge),
    "settings": Kind(fuzz_files.make_settings, fuzz_files.check_settings),
    "translations": Kind(fuzz_files.make_translation, fuzz_files.check_translation),
    "pictures": Kind(fuzz_files.make_picture, fuzz_files.check_picture),
    "messages": Kind(fuzz_files.make_messages, fuzz_files.check_messages),
    "packets": Kind(fuzz_sockets.make_packets, fuzz_sockets.check_packets),
    "frames": Kind(
        fuzz_sockets.make_frames, fuzz_sockets.check_frames, 20.0, share=1 / fuzz_sockets.CONNECTIONS
    ),
}


# --- trying -------------------------------------------------------------------------------------------


class TooSlow(Exception):
    """A case took longer than its limit."""


@contextmanager
def _limited(seconds: float) -> Iterator[None]:
    def expire(number: int, frame: FrameType | None) -> None:
        raise TooSlow

    before = signal.signal(signal.SIGALRM, expire)
    signal.setitimer(signal.ITIMER_REAL, 4 * seconds)
    began = time.process_time()
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    if time.process_time() - began > seconds:
        raise TooSlow


def failure_of(kind: Kind, case: Input) -> BaseException | None:
    """What a case raises; None if all is well."""
    try:
        with _limited(kind.seconds):
            kind.check(case)
    except Exception as error:  # noqa: BLE001 -- any failure is what is looked for
        return error
    return None


def _signature(error: BaseException) -> tuple[str, str]:
    """Two failures are the same if their kind and the line that raised them are."""
    frames = traceback.extract_tb(error.__traceback__)
    return type(error).__name__, f"{frames[-1].filename}:{frames[-1].lineno}" if frames else ""


def smaller(kind: Kind, case: Input, error: BaseException) -> Input:
    """A part of the input that fails in the same way."""
    until, wanted = time.monotonic() + SHRINKING, _signature(error)
    size = len(case) // 2
    while size and time.monotonic() < until:
        at = 0
        while at < len(case) and time.monotonic() < until:
            shorter = case[:at] + case[at + size :]  # type: ignore[operator] # both of one type
            found = failure_of(kind, shorter)
            if found is not None and _signature(found) == wanted:
                case = shorter
            else:
                at += size
        size //= 2
    return case


def fuzz(name: str, seed: int, numbers: Sequence[int]) -> int:
    """Try those cases of a kind, print what failed, and return the number of failures."""
    kind, failed, tried = KINDS[name], 0, 0
    try:
        for number in numbers:
            case = kind.make(random.Random(f"{seed} {name} {number}"))
            error = failure_of(kind, case)
            tried += 1
            if error is not None:
                failed += 1
                _report(name, seed, number, smaller(kind, case, error), error)
            if failed >= MOST_FAILURES:
                break
    finally:  # also when it is interrupted
        print(f"{name}: seed {seed}, {tried} cases, {failed} failed", flush=True)
    return failed


def _report(name: str, seed: int, number: int, case: Input, error: BaseException) -> None:
    FOLDER.mkdir(exist_ok=True)
    file = FOLDER / f"{name}-{seed}-{number}"
    file.write_bytes(case if isinstance(case, bytes) else case.encode("utf-8", "surrogatepass"))
    shown = "".join(traceback.format_exception(error)[-3:])
    print(f"{name} {number} failed: {shown}{case[:LONGEST_SHOWN]!r}", flush=True)
    print(f"Again: python -m tests.tools.fuzz --kind {name} --seed {seed} --only {number}", flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--kind", choices=sorted(KINDS), action="append")
    parser.add_argument("--first", type=int, default=0, metavar="NUMBER", help="begin with this case")
    parser.add_argument("--only", type=int, metavar="NUMBER", help="try this one case")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    failed = 0
    with tempfile.TemporaryDirectory() as home:
        os.environ["HOME"] = home
        for name in options.kind or KINDS:
            count = max(1, round(options.count * KINDS[name].share))
            numbers = range(options.first, count) if options.only is None else [options.only]
            failed += fuzz(name, options.seed, numbers)
    return 1 if failed else 0


if __name__ == "__main__":
    with suppress(KeyboardInterrupt):
        sys.exit(main())
