"""Sounds that learners put in the place of ours: ``NAME.wav`` in their folder, one for each cue's name.

They are panned and dulled like ours, so that a direction is still heard; pitch is left as it is. A file
that is none, or is missing, changes nothing: the cue is the usual one.
"""

from __future__ import annotations

import os
from array import array
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from devices.ports.audio import Cue
from devices.sound.tones import CUE_NAMES, placed, render
from devices.sound.wav_file import NotWav, read_mono

LONGEST = 1.0
"""Seconds of a file that are played; what is longer would talk over what comes next."""

OwnSounds = Mapping[str, "array[float]"]
"""Mono samples from -1 to 1 by the name of a cue."""


def load(folder: Path | None) -> tuple[OwnSounds, tuple[str, ...]]:
    """What is in the folder, and the names of the files that are no 16-bit WAV."""
    found: dict[str, array[float]] = {}
    broken = []
    for name in CUE_NAMES if folder is not None else ():
        path = Path(str(folder), f"{name}.wav")
        if os.path.isfile(path):  # noqa: PTH113 -- pathlib's raises where one may not look
            try:
                found[name] = array("d", (sample / 32_768 for sample in read_mono(path, LONGEST)))
            except NotWav:
                broken.append(path.name)
    return found, tuple(broken)


def unknown_names(folder: Path) -> tuple[str, ...]:
    """WAV files in the folder that are called like no cue."""
    with suppress(OSError):
        return tuple(sorted(file.name for file in folder.glob("*.wav") if file.stem not in CUE_NAMES))
    return ()


def sound_of(cue: Cue, volume: float, own: OwnSounds) -> array[int]:
    """The sound of ``cue``, stereo, interleaved: the learner's own if there is one."""
    mono = own.get(cue.name)
    return render(cue, volume) if mono is None else placed(mono, cue.bearing, volume)
