"""The files that a session writes: its events, its recording, its sounds, and the log.

A file that can't be opened prevents the start. A file that fails later is reported once, and the run
continues without it. ``--sound wav:FILE`` has the cues at their robot times and no voice, so that the bytes
are the same on every machine; of several runs each begins where the one before ended. Writers are loaded on
request. ``may_be_replaced`` knows the files of an option by how they begin.
"""

from __future__ import annotations

import errno
import os
import threading
from collections import deque
from collections.abc import Callable, Mapping
from contextlib import ExitStack, suppress
from stat import S_ISFIFO
from typing import TYPE_CHECKING, TextIO, cast

from msgspec import Struct
from msgspec.structs import replace

import worlds
from devices.ports.audio import Cue
from donnie_tui import __version__
from donnie_tui.core.events import Answered, CueSounded, RunEnded, SoundSwitched, Stamped
from donnie_tui.core.hub import Hub
from donnie_tui.core.voice import SpeechWait
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets.audible import Audible
from donnie_tui.outlets.belt import BeltAnnouncer, belt_settings
from donnie_tui.process import HIGHEST_STANDARD
from donnie_tui.process.confinement import OutsideError, make_folder, open_bytes, open_text
from donnie_tui.settings.settings import Settings
from donnie_tui.world.loading import ChosenWorld, files_of
from language.locales import languages

if TYPE_CHECKING:
    from pathlib import Path

    from donnie_tui.core.recording import Header
    from donnie_tui.world.recorded import WorldBundle


class SoundFile:
    """Listens to the stream and writes. A failure is reported once."""

    def __init__(self, path: str, tell: Callable[[OSError], None]) -> None:
        """Raises ``OSError`` if the file can't be written."""
        from devices.audio.mixer import WavCueWriter

        self._renderer, self._tell = WavCueWriter(open_bytes(path, "wb")), tell
        self._on = True
        self._began = 0.0
        self._failed = False

    def __call__(self, stamped: Stamped) -> None:
        if self._failed:
            return
        try:
            self._on_event(stamped)
        except OSError as problem:
            self._failed = True
            self._tell(problem)

    def _on_event(self, stamped: Stamped) -> None:
        at = self._began + stamped.t
        match stamped.event:
            case SoundSwitched(on=on):
                self._on = on
            case CueSounded(name=cue, bearing=bearing, steps=steps) if self._on:
                self._renderer.add(Cue(cue, bearing, steps), at)
            case RunEnded():
                self._renderer.write_until(at)
                self._began = at

    def close(self) -> None:
        """Finish the file."""
        try:
            self._renderer.close()
        except OSError as problem:
            if not self._failed:
                self._tell(problem)


class SessionFiles:
    """The files of one session, closed with it. Every method raises ``Unusable``."""

    def __init__(self, settings: Settings, hub: Hub, words: Words, closing: ExitStack) -> None:
        self.lost: list[str] = []
        """The files that could not be written to their end."""
        self.paths: list[str] = []
        """The files that are written during the session."""
        self._settings = settings
        self._hub = hub
        self._words = words
        self._closing = closing

    @property
    def of_this_session(self) -> str | None:
        """The first file that another session would overwrite, or None."""
        return self._settings.record or self._settings.events or self._sounds

    def events(self, standard_output: TextIO | None) -> None:
        """Write events as JSON lines, to standard output or a file, if requested."""
        name = self._settings.events
        if name is None:
            return
        out = standard_output if name == "-" else self._open(name)
        if out is None:
            raise Unusable(self._words("events-need-run"))
        self._subscribe_lines(self._not_waited_for(out), name)

    def recording(self, world: ChosenWorld) -> None:
        """Write the recording, to replay the session or run it again, if requested."""
        name = self._settings.record
        if name is None:
            return
        header = self._header(world)
        out = self._open(name)
        try:
            header.write(out)
        except OSError as problem:
            raise self._unwritable(name, problem) from None
        self._subscribe_lines(out, name, whole=True)

    @property
    def _sounds(self) -> str | None:
        return self._settings.sound if isinstance(self._settings.sound, str) else None

    def sounds(self) -> None:
        """Write the cues as a WAV file, if requested."""
        if self._sounds is None:
            return

        try:
            sounds = SoundFile(self._sounds, self._loss_reporter(self._sounds))
        except OSError as problem:
            raise self._unwritable(self._sounds, problem) from None
        self._closing.callback(sounds.close)
        self.paths.append(self._sounds)
        self._hub.subscribe(sounds)

    def _subscribe_lines(self, out: TextIO, name: str, *, whole: bool = False) -> None:
        from donnie_tui.core.events import JsonLines

        self._hub.subscribe(JsonLines(out, self._loss_reporter(name), whole=whole))

    def log(self) -> None:
        """Write ``Log/log_001.txt`` and so on, as the original GoDonnie did."""
        if not self._settings.log:
            return

        from pathlib import Path

        from donnie_tui.core.transcript import TranscriptLog, next_log

        try:
            make_folder("Log")
            name = str(next_log(Path("Log")))
            out = self._open(name)
        except OSError as problem:
            raise self._unwritable("Log", problem) from None
        self._hub.subscribe(TranscriptLog(out, self._words, self._loss_reporter(name)))

    def _not_waited_for(self, out: TextIO) -> TextIO:
        """Wrap a named pipe, whose reader may not read, so that no run waits for it."""
        if not is_named_pipe(out):
            return out

        reader = SlowReader(out.fileno())
        self._closing.callback(reader.close)
        return cast(TextIO, reader)

    def _header(self, world: ChosenWorld) -> Header:
        from donnie_tui.core.recording import Header
        from donnie_tui.world.recorded import BundleError

        belt = belt_settings(self._settings)
        try:
            bundle = bundle_of(world, self._settings)
        except BundleError as error:
            raise Unusable(self._words(error.code, **error.values)) from None
        return Header(
            __version__,
            self._settings.seed,
            self._settings.robot,
            {
                "steps": [belt.strong, belt.medium, belt.weak],
                "columns": {str(bearing.value): list(columns) for bearing, columns in belt.columns.items()},
            },
            bundle.as_record(),
        )

    def _open(self, name: str) -> TextIO:
        """Open a text file; lone surrogates become JSON's escapes."""
        try:
            out = open_text(name, "w", errors="backslashreplace")
        except (OSError, ValueError) as problem:
            raise self._unwritable(name, problem) from None
        self._closing.callback(_close_quietly, out)
        self.paths.append(name)
        return out

    def _unwritable(self, name: str, problem: OSError | ValueError) -> Unusable:
        if isinstance(problem, OutsideError):
            return Unusable(self._words(problem.code, path=name))
        return Unusable(self._words("file-unwritable", path=name, reason=_reason(problem)))

    def _loss_reporter(self, name: str) -> Callable[[OSError], None]:
        def report(problem: OSError) -> None:
            self.lost.append(name)
            sentence = self._words("file-unwritable", path=name, reason=_reason(problem))
            self._hub.publish(Answered(sentence))

        return report


def bundle_of(world: ChosenWorld, settings: Settings) -> WorldBundle:
    """All files of the world. Raises ``BundleError``."""
    from pathlib import Path

    from donnie_tui.world.recorded import pack

    robots = list(world.scene.robot_names)
    folders = [*map(Path, (*settings.include_folders, worlds.SCENES))]
    bundle = pack(world.name, Path(world.path), files_of(world), folders, robots)
    moves = ((at, each.x, each.y, each.z, each.yaw) for at, each in world.moves.items())
    return replace(bundle, moves=tuple(moves))


def is_named_pipe(out: TextIO) -> bool:
    """Whether it is a pipe opened by its name, and not standard output, whose reader wants every event."""
    try:
        return out.fileno() > HIGHEST_STANDARD and S_ISFIFO(os.fstat(out.fileno()).st_mode)
    except (OSError, AttributeError, ValueError):  # no file at all
        return False


def _reason(problem: OSError | ValueError) -> str:
    return getattr(problem, "strerror", None) or str(problem)


def _close_quietly(out: TextIO) -> None:
    """Close a file, and ignore failures, which were reported earlier."""
    with suppress(OSError):
        out.close()


MOST_WAITING = 4_000_000
"""Bytes that may wait, plus the line that exceeds them."""
LONGEST_STALL = 1.0
"""Seconds without progress after which, at the end, the reader counts as gone."""


class SlowReader:
    """A text output for a pipe. ``number`` is an open file, which its owner closes."""

    def __init__(self, number: int) -> None:
        self._number = os.dup(number)  # the owner's may be closed, and used again, while this thread writes
        self._changed = threading.Condition()
        self._waiting: deque[bytes] = deque()
        self._bytes = 0
        """Bytes in the queue."""
        self._is_over = False
        self._problem: OSError | None = None
        threading.Thread(target=self._work, name="slow reader", daemon=True).start()

    @property
    def closed(self) -> bool:
        return self._is_over

    def write(self, text: str) -> int:
        """Queues text and returns at once. Raises ``OSError`` if the reader takes nothing."""
        data = text.encode("utf-8", "backslashreplace")
        with self._changed:
            if self._problem is None and self._bytes >= MOST_WAITING:
                self._give_up(_too_slow())
            if self._problem is not None:
                raise self._problem
            self._waiting.append(data)
            self._bytes += len(data)
            self._changed.notify_all()
        return len(text)

    def flush(self) -> None:
        """Does nothing: the thread writes."""

    def close(self) -> None:
        """Waits until all is written, or the reader takes no more."""
        with self._changed:
            self._is_over = True
            self._changed.notify_all()
            while self._waiting and self._changed.wait(LONGEST_STALL):
                pass  # something was taken
            if self._waiting:
                self._give_up(_too_slow())

    def _give_up(self, problem: OSError) -> None:
        """Ends the writing. Called under the lock."""
        self._problem = problem
        self._waiting.clear()
        self._bytes = 0
        self._changed.notify_all()

    # --- the thread

    def _work(self) -> None:
        try:
            while (data := self._next()) is not None:
                self._write(data)
        except OSError as problem:
            with self._changed:
                self._give_up(problem)
        finally:
            os.close(self._number)

    def _next(self) -> bytes | None:
        """The next bytes. They stay queued until they are written, as the end waits for them."""
        with self._changed:
            self._changed.wait_for(lambda: self._waiting or self._is_over or self._problem)
            return self._waiting[0] if self._waiting else None

    def _write(self, data: bytes) -> None:
        """Writes all. A line of which the reader has had a part is not cut off."""
        left = memoryview(data)
        while left:
            left = left[os.write(self._number, left) :]
            with self._changed:
                self._changed.notify_all()
        with self._changed:
            if self._problem is None:
                self._waiting.popleft()
                self._bytes -= len(data)
            self._changed.notify_all()


def _too_slow() -> OSError:
    return OSError(errno.EAGAIN, os.strerror(errno.EAGAIN))


class Outlets(Struct, frozen=True):
    """All outputs of a session; the bootstrap makes and closes them."""

    audible: Audible
    """The voice and the cues."""
    belt: BeltAnnouncer
    """The belt in words."""
    written: SessionFiles
    speech_wait: SpeechWait
    """Lets programs wait for the voice."""

    def adjust_sound(self, **changed: object) -> None:
        """Change settings of voice and cues, by the names of their fields."""
        self.audible.adjust(**changed)
        self.let_programs_wait()

    def let_programs_wait(self) -> None:
        """Let programs wait for the end of their sentences, if the learner wants that."""
        waits = self.audible.settings.wait_for_speech
        self.speech_wait.is_quiet_within = self.audible.is_quiet_within if waits else None


# --- what may be replaced

_ENOUGH = 4096
"""Bytes that are read of a file."""
_BRAILLE = frozenset(range(0x20, 0x60)) | frozenset(b"\r\n\f")
"""The characters of ASCII braille."""

_SVG = (b'<svg xmlns="http://www.w3.org/2000/svg" role="img" width="',)
_BEGINNINGS: Mapping[str, tuple[bytes, ...]] = {
    "--record": (b'{"donnie_recording"',),
    "--events": (b'{"seq"',),
    "--svg": _SVG,
    "--swell": _SVG,
    "--csv": (b"file,solved,",),
}


def may_be_replaced(option: str, path: Path) -> bool:
    """Whether ``path`` may be replaced: missing, empty, no file, or of the kind that ``option`` writes."""
    try:
        if not path.is_file():
            return True
        with open_bytes(path) as file:
            beginning = file.read(_ENOUGH)
    except FileNotFoundError:
        return True
    except (OSError, ValueError):
        return False
    return not beginning.strip() or _is_of_kind(option, beginning, path)


def _is_of_kind(option: str, beginning: bytes, path: Path) -> bool:
    if option == "--brf":
        is_braille = path.suffix.lower() in (".brf", ".brl") and _BRAILLE.issuperset(beginning)
        return is_braille and beginning.startswith(_titles_in_braille())
    if option == "--report":  # the file is what its name ends in
        option = f"--{path.suffix.lower().removeprefix('.')}"
    if option in ("--csv", "--html", "--htm"):
        return beginning.startswith((*_beginnings_of_reports(), *_BEGINNINGS.get(option, ())))
    if option == "--feedback":
        return beginning.startswith(_beginnings_of_answers())
    if option == "--png":
        return beginning.startswith(b"\x89PNG") and b"tEXtSoftware\0donnie" in beginning[:100]
    if option == "--gif":
        return beginning.startswith(b"GIF8") and b"\x06donnie\0" in beginning
    if option == "--sound":
        return _is_our_sound(beginning)
    return beginning.removeprefix(b"\xef\xbb\xbf").lstrip().startswith(_BEGINNINGS.get(option, ()))


def _is_our_sound(beginning: bytes) -> bool:
    """Whether it has the format of Donnie's sounds: uncompressed, two channels."""
    from devices.audio.cues import SAMPLE_RATE

    form = b"WAVEfmt \x10\0\0\0\x01\0\x02\0" + SAMPLE_RATE.to_bytes(4, "little")
    return beginning.startswith(b"RIFF") and beginning[8:].startswith(form)


def heading_of_answer(title: str, words: Words) -> str:
    """The first line of what ``--feedback`` writes, by which such a file is known."""
    return f"Donnie. {words('challenge-here', title=title)}"


def _beginnings_of_answers() -> tuple[bytes, ...]:
    """Their beginnings in each language."""
    headings = (heading_of_answer("|", Words(each)) for each in languages())
    return tuple(each.partition("|")[0].encode() for each in headings)


def _titles_in_braille() -> tuple[bytes, ...]:
    """The beginning of a world's first braille page, in each language."""
    from donnie_tui.core.chart import braille

    titles = ((each, Words(each)("paper-title", name="|").partition("|")[0]) for each in languages())
    return tuple(braille(title, each).encode("ascii") for each, title in titles)


def _beginnings_of_reports() -> tuple[bytes, ...]:
    """The beginnings of tables and pages that are reports, in each language."""
    from donnie_tui.core.reports import beginnings

    return tuple(each.encode() for language in languages() for each in beginnings(Words(language)))
