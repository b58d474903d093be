"""What Orca takes for the client of speech-dispatcher: it writes down what it is asked to say.

Only once the file ``ORCA_READY`` exists: what Orca says of itself and of windows is no answer.
"""

from __future__ import annotations

import html
import json
import os
import re
import time
from collections.abc import Callable
from pathlib import Path

_TAG = re.compile(r"<[^>]*>")


class SSIPError(Exception): ...


class SSIPCommunicationError(SSIPError): ...


class SSIPCommandError(SSIPError): ...


class CallbackType:
    INDEX_MARK, BEGIN, END, CANCEL, PAUSE, RESUME = "index_marks", "begin", "end", "cancel", "pause", "resume"


class Scope:
    SELF, ALL = "self", "all"


class Priority:
    IMPORTANT, TEXT, MESSAGE, NOTIFICATION, PROGRESS = (
        "important",
        "text",
        "message",
        "notification",
        "progress",
    )


class PunctuationMode:
    ALL, NONE, SOME, MOST = "all", "none", "some", "most"


class DataMode:
    TEXT, SSML = "text", "ssml"


class SSIPClient:
    """Knows no voices and refuses nothing."""

    def __init__(self, *_: object, **__: object) -> None: ...

    def speak(self, text: str, *_: object, **__: object) -> None:
        _write(html.unescape(_TAG.sub("", text)))

    def char(self, text: str) -> None:
        _write(text)

    def key(self, text: str) -> None: ...

    def sound_icon(self, name: str) -> None: ...

    def list_output_modules(self) -> tuple[str, ...]:
        return ("log",)

    def list_synthesis_voices(self, *_: object) -> tuple[str, ...]:
        return ()

    def get_rate(self) -> int:
        return 0

    def get_pitch(self) -> int:
        return 0

    def get_volume(self) -> int:
        return 100

    def get_language(self) -> str:
        return "en"

    def __getattr__(self, name: str) -> Callable[..., None]:
        if name.startswith(("set_", "pause", "resume", "close", "stop", "cancel")):
            return lambda *_, **__: None
        raise AttributeError(name)


def _write(text: str) -> None:
    ready = Path(os.environ["ORCA_READY"]).exists()
    if text.strip():
        log = Path(os.environ["SPEECH_LOG" if ready else "ORCA_START"])
        with log.open("a", encoding="utf-8") as file:
            file.write(json.dumps({"t": time.time(), "text": text}) + "\n")
