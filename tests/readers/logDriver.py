"""Fenrir's voice in the tests: it writes down what it is asked to say, at the moment it is asked."""

from __future__ import annotations

import json
import os
import time
from pathlib import Path

from fenrirscreenreader.core.speechDriver import speechDriver  # type: ignore[import-not-found] # Debian's


class driver(speechDriver):  # type: ignore[misc] # noqa: N801 -- the name that Fenrir looks for
    def initialize(self, environment: object) -> None:
        self.env = environment
        self._isInitialized = True

    def shutdown(self) -> None:
        self._isInitialized = False

    def speak(self, text: str, queueable: bool = True) -> None:
        if text.strip():
            with Path(os.environ["SPEECH_LOG"]).open("a", encoding="utf-8") as file:
                file.write(json.dumps({"t": time.time(), "text": text}) + "\n")

    def cancel(self) -> None: ...

    def setCallback(self, callback: object) -> None: ...

    def clear_buffer(self) -> None: ...

    def setVoice(self, voice: object) -> None: ...

    def setPitch(self, pitch: object) -> None: ...

    def setRate(self, rate: object) -> None: ...

    def setModule(self, module: object) -> None: ...

    def setLanguage(self, language: object) -> None: ...

    def setVolume(self, volume: object) -> None: ...
