"""Reads WAV files: 16-bit, any rate, the left side of any number."""

from __future__ import annotations

import sys
import wave
from array import array
from pathlib import Path

from devices.sound.tones import SAMPLE_RATE


class NotWav(Exception):
    """No 16-bit WAV file, or one that can't be read."""


def read_mono(path: Path | str, seconds: float | None = None) -> array[int]:
    """The samples of its left side at ``SAMPLE_RATE``, the first ``seconds`` of them. Raises ``NotWav``."""
    try:
        with wave.open(str(path), "rb") as file:
            channels, width, rate, frames, *_ = file.getparams()
            if width != 2 or not 1_000 <= rate <= 400_000:
                raise NotWav
            most = frames if seconds is None else min(frames, round(seconds * rate))
            samples = array("h", file.readframes(most))
    except (wave.Error, EOFError, OSError, ValueError) as reason:
        raise NotWav from reason
    if sys.byteorder == "big":
        samples.byteswap()
    return _resampled(samples[::channels], rate)


def _resampled(samples: array[int], rate: int) -> array[int]:
    """The nearest sample will do for a voice or a cue; espeak-ng's rate is ours anyway."""
    if rate == SAMPLE_RATE:
        return samples
    length = len(samples) * SAMPLE_RATE // rate
    return array("h", (samples[frame * rate // SAMPLE_RATE] for frame in range(length)))
