"""How the cues sound: computed, the same bytes every time on every machine; or the learner's own files.

A cue is a sequence of gliding tones with a soft start and end. If it has a distance, nearer is higher. If it
has a bearing, it is panned, and glides up to the right and down to the left, so one ear is enough to
distinguish them. From behind the robot it sounds duller. Samples are 16-bit, stereo, interleaved.

Learners may replace a cue by ``NAME.wav`` in a folder of theirs. Their sounds are panned and dulled in the
same way, but keep their pitch. A file that is missing or no WAV changes nothing.
"""

from __future__ import annotations

import math
import os
import sys
from array import array
from collections.abc import Mapping
from contextlib import suppress
from functools import lru_cache
from pathlib import Path
from types import MappingProxyType

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.audio import Cue

SAMPLE_RATE = 22_050
"""Frames a second, the rate of espeak-ng's voices."""

FARTHEST = 60.0
"""Steps beyond which a cue sounds no lower."""

LONGEST_USER_SOUND = 1.0
"""Seconds of a learner's file that are played; a longer one would overlap with what follows."""

_LOUDNESS = 0.5
"""Of full scale, so two cues and a voice rarely clip."""

_FADE = 0.004
"""Seconds of fading in and out; without them every tone would click."""

_TURN_BEARING = 60.0
_OCTAVES_OF_DISTANCE = 2.0
_GLIDE_OF_BEARING = 4 / 12
"""Octaves: a third up for full right, a third down for full left."""

_DULLNESS = 0.9
"""Of the low-pass for what is straight behind; 0 would change nothing."""


class _Tone(Struct, frozen=True):
    start: float
    """Hertz; 0 is silence."""
    end: float
    seconds: float
    overtones: tuple[float, ...] = (0.3,)
    """Their strengths, that of the fundamental being 1."""


class _Recipe(Struct, frozen=True):
    tones: tuple[_Tone, ...]
    bearing: float = 0.0
    """The cue's own side, where the event gives none."""
    has_place: bool = False
    """Distance becomes pitch, and bearing becomes a glide."""


_HARSH = (0.7, 0.5, 0.4, 0.3)
_RECIPES: Mapping[str, _Recipe] = MappingProxyType(
    {
        "step-forward": _Recipe((_Tone(620, 780, 0.045),)),
        "step-back": _Recipe((_Tone(420, 330, 0.050),)),
        "turn-right": _Recipe((_Tone(700, 1050, 0.055),), bearing=_TURN_BEARING),
        "turn-left": _Recipe((_Tone(1050, 700, 0.055),), bearing=-_TURN_BEARING),
        "obstacle": _Recipe((_Tone(440, 440, 0.120, (0.5, 0.25)),), has_place=True),
        "bump": _Recipe((_Tone(140, 70, 0.180, _HARSH),)),
        "scan": _Recipe((_Tone(880, 880, 0.090, ()),), has_place=True),
        "belt": _Recipe((_Tone(330, 330, 0.060, ()),), has_place=True),
        "found": _Recipe((_Tone(660, 660, 0.100), _Tone(880, 880, 0.150)), has_place=True),
        "grip": _Recipe((_Tone(784, 523, 0.060), _Tone(523, 523, 0.090))),
        "release": _Recipe((_Tone(523, 523, 0.090), _Tone(523, 784, 0.060))),
        "nothing": _Recipe((_Tone(294, 262, 0.110, ()),)),
        "done": _Recipe((_Tone(523, 523, 0.090), _Tone(659, 659, 0.090), _Tone(784, 784, 0.140))),
        "goal": _Recipe((_Tone(659, 784, 0.120),)),
        "solved": _Recipe((_Tone(523, 523, 0.080), _Tone(784, 784, 0.080), _Tone(1047, 1047, 0.180))),
        "waiting": _Recipe((_Tone(494, 494, 0.070, ()), _Tone(0, 0, 0.060), _Tone(494, 494, 0.070, ()))),
        "block-opened": _Recipe((_Tone(392, 523, 0.080),), has_place=True),
        "block-closed": _Recipe((_Tone(523, 392, 0.080),), has_place=True),
        "error": _Recipe(
            (_Tone(220, 220, 0.130, _HARSH), _Tone(0, 0, 0.040), _Tone(165, 165, 0.160, _HARSH))
        ),
    }
)

CUE_NAMES = tuple(_RECIPES)

UserSounds = Mapping[str, "array[float]"]
"""Mono samples from -1 to 1 by the name of a cue."""

_NO_SOUNDS: UserSounds = MappingProxyType({})


def seconds_of(name: str) -> float:
    """How long the cue of that name lasts. ``KeyError`` for a name that is not in ``CUE_NAMES``."""
    return sum(tone.seconds for tone in _RECIPES[name].tones)


def pitch_of_level(level: int) -> float:
    """The ``steps`` of a cue about a block: the deeper it is nested (from 1), the higher it sounds."""
    return max(0.0, FARTHEST - 8.0 * level)


def normalized(cue: Cue) -> Cue:
    """The same sound with a bearing between -180 and 180, and half steps, so few sounds are computed.

    A bearing that is no number is straight ahead; a distance that is no number is unknown.
    """
    bearing = (cue.bearing + 180.0) % 360.0 - 180.0 if math.isfinite(cue.bearing) else 0.0
    steps = cue.steps
    if steps is not None:
        steps = None if math.isnan(steps) else round(min(max(steps, 0.0), FARTHEST) * 2) / 2
    return Cue(cue.name, bearing, steps)


def render_cue(cue: Cue, volume: float = 1.0, user_sounds: UserSounds = _NO_SOUNDS) -> array[int]:
    """The sound of ``cue``: the learner's own if there is one. ``KeyError`` for an unknown name."""
    volume = min(max(volume, 0.0), 1.0)
    cue = normalized(cue)
    user_sound = user_sounds.get(cue.name)
    if user_sound is not None:
        behind = _behind(cue.bearing)
        dulled = _dulled(user_sound, behind * _DULLNESS) if behind else user_sound
        return _panned(dulled, cue.bearing, volume)
    recipe = _RECIPES[cue.name]
    bearing = cue.bearing or recipe.bearing
    steps = cue.steps if recipe.has_place else None
    glide = math.sin(math.radians(bearing)) if recipe.has_place else 0.0
    return _panned(_computed(cue.name, steps, round(glide, 2), round(_behind(bearing), 2)), bearing, volume)


@lru_cache(maxsize=128)
def _computed(name: str, steps: float | None, glide: float, behind: float) -> array[float]:
    """Mono samples from -1 to 1."""
    raised = 2 ** (_OCTAVES_OF_DISTANCE * (0.5 - steps / FARTHEST)) if steps is not None else 1.0
    bent = 2 ** (glide * _GLIDE_OF_BEARING / 2)
    samples = array("d")
    for tone in _RECIPES[name].tones:
        start, end = tone.start * raised / bent, tone.end * raised * bent
        samples.extend(_samples(replace(tone, start=start, end=end)))
    return _dulled(samples, behind * _DULLNESS) if behind else samples


def _samples(tone: _Tone) -> array[float]:
    frames = round(tone.seconds * SAMPLE_RATE)
    partials = (1.0, *tone.overtones)
    scale = _LOUDNESS / sum(partials)
    phase = 0.0
    samples = array("d")
    for frame in range(frames):
        phase += math.tau * (tone.start + (tone.end - tone.start) * frame / frames) / SAMPLE_RATE
        wave = sum(strength * math.sin(phase * (k + 1)) for k, strength in enumerate(partials))
        samples.append(scale * _envelope(frame, frames) * wave if tone.start else 0.0)
    return samples


def _envelope(frame: int, frames: int) -> float:
    fade = _FADE * SAMPLE_RATE
    return min(1.0, frame / fade, (frames - 1 - frame) / fade)


def _dulled(samples: array[float], strength: float) -> array[float]:
    """A one-pole low-pass."""
    level, dulled = 0.0, array("d")
    for sample in samples:
        level += (1.0 - strength) * (sample - level)
        dulled.append(level)
    return dulled


def _panned(mono: array[float], bearing: float, volume: float) -> array[int]:
    """Equal power: 45 degrees to a side is 12 dB, 90 degrees is that side alone."""
    angle = (math.sin(math.radians(bearing)) + 1.0) * math.pi / 4
    stereo = array("h", bytes(4 * len(mono)))
    for side, gain in enumerate((math.cos(angle), math.sin(angle))):
        scale = 32_767 * gain * volume
        stereo[side::2] = array("h", (round(scale * sample) for sample in mono))
    return stereo


def _behind(bearing: float) -> float:
    """0 from the front to the sides, 1 straight behind."""
    return max(0.0, -math.cos(math.radians(bearing)))


# --- the learner's own sounds


class NotWav(Exception):
    """No 16-bit WAV file, or one that can't be read."""


def load_user_sounds(folder: Path | None) -> tuple[UserSounds, tuple[str, ...]]:
    """The sounds in the folder, and the names of the files that are no 16-bit WAV."""
    found: dict[str, array[float]] = {}
    broken = []
    for name in CUE_NAMES if folder is not None else ():
        path = Path(str(folder), f"{name}.wav")
        if os.path.isfile(path):  # noqa: PTH113 -- pathlib's raises in a folder without permission
            try:
                found[name] = array("d", (sample / 32_768 for sample in read_mono(path, LONGEST_USER_SOUND)))
            except NotWav:
                broken.append(path.name)
    return found, tuple(broken)


def unknown_sound_files(folder: Path) -> tuple[str, ...]:
    """The WAV files in the folder that have no cue's name."""
    with suppress(OSError):
        return tuple(sorted(file.name for file in folder.glob("*.wav") if file.stem not in CUE_NAMES))
    return ()


def read_mono(path: Path | str, seconds: float | None = None) -> array[int]:
    """The first ``seconds`` of a 16-bit WAV file's left side, at ``SAMPLE_RATE``. Raises ``NotWav``."""
    import wave  # every start loads this module for the names of the cues

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
    """The nearest sample is good enough for a voice or a cue, and espeak-ng's rate is already right."""
    if rate == SAMPLE_RATE:
        return samples
    length = len(samples) * SAMPLE_RATE // rate
    return array("h", (samples[frame * rate // SAMPLE_RATE] for frame in range(length)))
