"""A voice that writes down what a screen reader asks it to say: a speech server in Emacspeak's protocol.

Started by the reader, with the log as its argument. A line of the log is the time and the text as JSON.
"""

from __future__ import annotations

import json
import re
import sys
import time
from pathlib import Path

_COMMAND = re.compile(rb"(\w+)(?: \{(.*?)\}| ([^\n]*))?\s*\n", re.DOTALL)


def main() -> None:
    log = Path(sys.argv[1])
    waiting: list[str] = []
    rest = b""
    while data := sys.stdin.buffer.read1(65_536):
        rest += data
        while (found := _COMMAND.match(rest)) is not None:
            rest = rest[found.end() :]
            words = (found[2] or found[3] or b"").decode("utf-8", "replace")
            obey(found[1].decode(), words, waiting, log)


def obey(command: str, words: str, waiting: list[str], log: Path) -> None:
    """``q`` queues, ``d`` says what is queued, ``tts_say`` and ``l`` (a letter) say at once."""
    if command == "q":
        waiting.append(words)
    elif command == "d":
        write(log, " ".join(waiting))
        waiting.clear()
    elif command in ("tts_say", "l"):
        write(log, words)


def write(log: Path, text: str) -> None:
    if text.strip():
        with log.open("a", encoding="utf-8") as file:
            file.write(json.dumps({"t": time.time(), "text": text}) + "\n")


if __name__ == "__main__":
    main()
