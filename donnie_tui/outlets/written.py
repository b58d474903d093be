"""What a session writes into files as it goes: its events, recording and sounds, the log of what was told.

A file that can't be opened keeps everything from starting; one that takes no more is told once, and the run
goes on without it. What writes is loaded for who asked for it: few do.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import ExitStack, suppress
from stat import S_ISFIFO

import worlds
from devices.ports.hints import TYPE_CHECKING, TextIO, cast
from donnie_tui import __version__
from donnie_tui.core.events import Answered
from donnie_tui.core.hub import Hub
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets.tangible import belt_settings
from donnie_tui.process import HIGHEST_STANDARD
from donnie_tui.settings.chosen import Settings
from donnie_tui.world.choice import ChosenWorld, files_of

if TYPE_CHECKING:
    from donnie_tui.core.recording import Header
    from donnie_tui.world.bundle import WorldBundle


class Written:
    """The files of one session, closed with it. Every method raises ``Unusable``."""

    def __init__(self, settings: Settings, hub: Hub, words: Words, closing: ExitStack) -> None:
        self.lost: list[str] = []
        """Those that could not be written to their end."""
        self.paths: list[str] = []
        """All that are written as it goes."""
        self._settings = settings
        self._hub = hub
        self._words = words
        self._closing = closing

    @property
    def of_this_session(self) -> str | None:
        """The file that another session would begin anew, if there is one."""
        return self._settings.record or self._settings.events or self._sounds

    def events(self, standard_output: TextIO | None) -> None:
        """As JSON lines, to standard output or a file; nowhere if nobody asked."""
        name = self._settings.events
        if name is None:
            return
        out = standard_output if name == "-" else self._open(name)
        if out is None:
            raise Unusable(self._words("events-need-run"))
        self._subscribe_lines(self._not_waited_for(out), name)

    def recording(self, world: ChosenWorld) -> None:
        """Everything that is needed to tell it again and to run it again, if somebody asked."""
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
        """The cues of what happens, as a WAV file, if somebody asked."""
        if self._sounds is None:
            return
        from donnie_tui.outlets.sound_file import SoundFile

        try:
            sounds = SoundFile(self._sounds, self._teller_of_loss(self._sounds))
        except OSError as problem:
            raise self._unwritable(self._sounds, problem) from None
        self._closing.callback(sounds.close)
        self.paths.append(self._sounds)
        self._hub.subscribe(sounds)

    def _subscribe_lines(self, out: TextIO, name: str, *, whole: bool = False) -> None:
        from donnie_tui.core.event_stream import JsonLines

        self._hub.subscribe(JsonLines(out, self._teller_of_loss(name), whole=whole))

    def log(self) -> None:
        """``Log/log_001.txt`` and so on, as the original GoDonnie did."""
        if not self._settings.log:
            return
        from pathlib import Path

        from donnie_tui.core.told_log import ToldLog, next_log

        try:
            Path("Log").mkdir(exist_ok=True)
            name = str(next_log(Path("Log")))
            out = self._open(name)
        except OSError as problem:
            raise self._unwritable("Log", problem) from None
        self._hub.subscribe(ToldLog(out, self._words, self._teller_of_loss(name)))

    def _not_waited_for(self, out: TextIO) -> TextIO:
        """A pipe with a name may have a reader that does not read: nobody waits for that one."""
        if not is_named_pipe(out):
            return out
        from donnie_tui.core.slow_reader import SlowReader

        reader = SlowReader(out.fileno())
        self._closing.callback(reader.close)
        return cast(TextIO, reader)

    def _header(self, world: ChosenWorld) -> Header:
        from donnie_tui.core.recording import Header
        from donnie_tui.world.bundle import BundleError

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
        """Lone surrogates become the escapes that JSON has for them."""
        from pathlib import Path  # slow to load, as all that writes

        try:
            out = Path(name).open(  # noqa: SIM115 -- closed with the session
                "w", encoding="utf-8", errors="backslashreplace", newline="\n"
            )
        except (OSError, ValueError) as problem:
            raise self._unwritable(name, problem) from None
        self._closing.callback(_close_quietly, out)
        self.paths.append(name)
        return out

    def _unwritable(self, name: str, problem: OSError | ValueError) -> Unusable:
        return Unusable(self._words("file-unwritable", path=name, reason=_reason(problem)))

    def _teller_of_loss(self, name: str) -> Callable[[OSError], None]:
        def tell(problem: OSError) -> None:
            self.lost.append(name)
            sentence = self._words("file-unwritable", path=name, reason=_reason(problem))
            self._hub.publish(Answered(sentence))

        return tell


def bundle_of(world: ChosenWorld, settings: Settings) -> WorldBundle:
    """All that was read for the world. Raises ``BundleError``."""
    from pathlib import Path

    from donnie_tui.world.bundle import pack

    robots = list(world.scene.robot_names)
    folders = [*map(Path, (*settings.world_folders, worlds.SCENES))]
    return pack(world.name, Path(world.path), files_of(world), folders, robots)


def is_named_pipe(out: TextIO) -> bool:
    """Whether it was opened by its name, and not as our standard output: who reads a run there wants all."""
    try:
        return out.fileno() > HIGHEST_STANDARD and S_ISFIFO(os.fstat(out.fileno()).st_mode)
    except (OSError, AttributeError, ValueError):  # no file at all
        return False


def _reason(problem: OSError | ValueError) -> str:
    return getattr(problem, "strerror", None) or str(problem)


def _close_quietly(out: TextIO) -> None:
    """What could not be written was told when it was written."""
    with suppress(OSError):
        out.close()
