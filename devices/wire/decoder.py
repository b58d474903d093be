"""Bytes in, reports out: the host's half of the codec.

Any chunking of a stream gives the same reports. What is no frame is text for the log; after a bad checksum
one byte is dropped and the search begins anew; no more than one frame is ever held. Nothing that comes in
raises anything.
"""

from __future__ import annotations

from collections.abc import Callable

from devices.wire.checksum import checksum
from devices.wire.commands import HEADER, LONGEST
from devices.wire.reports import Report, read

LONGEST_TEXT = 200
"""Characters of text that are kept for one line of the log."""

_NEWLINE = 0x0A
_AROUND = 4
"""Bytes of a frame that LEN doesn't count."""


class Decoder:
    """A stream of bytes from the board."""

    def __init__(self, on_text: Callable[[str], None] | None = None) -> None:
        """``on_text`` is told whole lines of the board's debug text, 200 characters at most."""
        self.bad_frames = 0
        """Frames with a wrong LEN or checksum, or with data that don't fit their type."""
        self._on_text = on_text
        self._held = b""
        self._text = bytearray()
        self._last_frame = b""
        self._last_report: Report | None = None

    @property
    def held(self) -> int:
        """Bytes that wait for the rest of their frame or of their line; never more than a few hundred."""
        return len(self._held) + len(self._text)

    def feed(self, data: bytes) -> list[Report]:
        """What ``data`` completes, in order."""
        held = self._held + data
        reports: list[Report] = []
        at = 0
        while True:
            begins = held.find(HEADER, at)
            if begins < 0:
                self._held = self._rest_without_frame(held, at)
                return reports
            self._take_text(held[at:begins])
            ends = self._end_of_frame(held, begins)
            if ends > len(held):
                self._held = held[begins:]
                return reports
            at = self._take_frame(held, begins, ends, reports)

    def _rest_without_frame(self, held: bytes, at: int) -> bytes:
        """Text, but for a last byte that may begin a frame."""
        keeps = 1 if held[at:].endswith(HEADER[:1]) else 0
        self._take_text(held[at : len(held) - keeps])
        return held[len(held) - keeps :]

    def _end_of_frame(self, held: bytes, begins: int) -> int:
        """Where the frame that begins there ends, if its LEN is a LEN."""
        if len(held) < begins + 3:
            return len(held) + 1
        length = held[begins + 2]
        return begins + length + _AROUND if 1 <= length <= LONGEST else begins

    def _take_frame(self, held: bytes, begins: int, ends: int, reports: list[Report]) -> int:
        """Read a frame, and answer where to go on."""
        whole = held[begins:ends]
        if whole and whole == self._last_frame and self._last_report is not None:
            self._end_line()
            reports.append(self._last_report)
            return ends
        if not whole or checksum(whole[3:-1]) != whole[-1]:
            self.bad_frames += 1
            self._take_text(held[begins : begins + 1])
            return begins + 1
        self._end_line()
        report = read(whole[3], whole[4:-1])
        if report is None:
            self.bad_frames += 1
        else:
            reports.append(report)
            self._last_frame, self._last_report = whole, report
        return ends

    def _take_text(self, data: bytes) -> None:
        if self._on_text is None:
            return
        for byte in data:
            if byte == _NEWLINE:
                self._end_line()
            else:
                self._text.append(byte)
                if len(self._text) >= LONGEST_TEXT:
                    self._end_line()

    def _end_line(self) -> None:
        """A line ends with itself, or where a frame begins: the board puts its newlines in front."""
        if self._text and self._on_text is not None:
            self._on_text(self._text.decode("ascii", "backslashreplace"))
            self._text.clear()
