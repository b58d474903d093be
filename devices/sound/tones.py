"""The cues, made from nothing but arithmetic: the same bytes every time, on every machine.

A cue is a sequence of gliding tones with a soft start and end. Where it has a distance, nearer is higher.
Where it has a bearing, it is panned, and glides up to the right and down to the left, so that one ear is
enough; what is behind the robot is duller. Samples are 16-bit, stereo, interleaved.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Mapping
from functools import lru_cache
from types import MappingProxyType

from devices.ports.audio import Cue
from devices.ports.values import Frozen, replace

SAMPLE_RATE = 22_050
"""Frames a second, the rate of espeak-ng's voices."""

FARTHEST = 60.0
"""Steps beyond which farther does not sound lower."""

_LOUDNESS = 0.5
"""Of full scale, so that two cues and a voice rarely clip."""

_FADE = 0.004
"""Seconds of fading in and out; without them every tone would click."""

_TURN_BEARING = 60.0
_OCTAVES_OF_DISTANCE = 2.0
_GLIDE_OF_BEARING = 4 / 12
"""Octaves: a third up for full right, a third down for full left."""

_DULLNESS = 0.9
"""Of the low-pass for what is straight behind; 0 would let everything through."""


class _Tone(Frozen):
    start: float
    """Hertz; 0 is silence."""
    end: float
    seconds: float
    partials: tuple[float, ...] = (1.0, 0.3)
    """Strengths of the fundamental and its overtones."""


class _Recipe(Frozen):
    tones: tuple[_Tone, ...]
    bearing: float = 0.0
    """The side that the cue has by itself, where the event gives none."""
    tells_place: bool = False
    """Distance is heard as pitch, and bearing as a glide."""


_HARSH = (1.0, 0.7, 0.5, 0.4, 0.3)
_RECIPES: Mapping[str, _Recipe] = MappingProxyType(
    {
        "step-forward": _Recipe((_Tone(620, 780, 0.045),)),
        "step-back": _Recipe((_Tone(420, 330, 0.050),)),
        "turn-right": _Recipe((_Tone(700, 1050, 0.055),), bearing=_TURN_BEARING),
        "turn-left": _Recipe((_Tone(1050, 700, 0.055),), bearing=-_TURN_BEARING),
        "obstacle": _Recipe((_Tone(440, 440, 0.120, (1.0, 0.5, 0.25)),), tells_place=True),
        "bump": _Recipe((_Tone(140, 70, 0.180, _HARSH),)),
        "scan": _Recipe((_Tone(880, 880, 0.090, (1.0,)),), tells_place=True),
        "belt": _Recipe((_Tone(330, 330, 0.060, (1.0,)),), tells_place=True),
        "found": _Recipe((_Tone(660, 660, 0.100), _Tone(880, 880, 0.150)), tells_place=True),
        "done": _Recipe((_Tone(523, 523, 0.090), _Tone(659, 659, 0.090), _Tone(784, 784, 0.140))),
        "waiting": _Recipe(
            (_Tone(494, 494, 0.070, (1.0,)), _Tone(0, 0, 0.060), _Tone(494, 494, 0.070, (1.0,)))
        ),
        "block-opened": _Recipe((_Tone(392, 523, 0.080),), tells_place=True),
        "block-closed": _Recipe((_Tone(523, 392, 0.080),), tells_place=True),
        "error": _Recipe(
            (_Tone(220, 220, 0.130, _HARSH), _Tone(0, 0, 0.040), _Tone(165, 165, 0.160, _HARSH))
        ),
    }
)

CUE_NAMES = tuple(_RECIPES)


def seconds_of(name: str) -> float:
    """How long the cue of that name lasts. ``KeyError`` for a name that is not in ``CUE_NAMES``."""
    return sum(tone.seconds for tone in _RECIPES[name].tones)


def pitch_of_level(level: int) -> float:
    """The ``steps`` of a cue about a block: the deeper it lies (from 1), the higher it sounds."""
    return max(0.0, FARTHEST - 8.0 * level)


def render(cue: Cue, volume: float = 1.0) -> array[int]:
    """The sound of ``cue``. ``KeyError`` for a name that is not in ``CUE_NAMES``."""
    recipe = _RECIPES[cue.name]
    bearing = _wrapped(cue.bearing) or recipe.bearing
    steps = _known_distance(cue.steps) if recipe.tells_place else None
    glide = math.sin(math.radians(bearing)) if recipe.tells_place else 0.0
    mono = _mono(cue.name, steps, round(glide, 2), round(_behind(bearing), 2))
    return _panned(mono, bearing, min(max(volume, 0.0), 1.0))


def placed(mono: array[float], bearing: float, volume: float) -> array[int]:
    """Any sound, samples from -1 to 1, where ``bearing`` (degrees to the right) has it: panned and dulled."""
    wrapped = _wrapped(bearing)
    behind = _behind(wrapped)
    heard = _dulled(mono, behind * _DULLNESS) if behind else mono
    return _panned(heard, wrapped, min(max(volume, 0.0), 1.0))


@lru_cache(maxsize=128)
def _mono(name: str, steps: float | None, glide: float, behind: float) -> array[float]:
    raised = 2 ** (_OCTAVES_OF_DISTANCE * (0.5 - steps / FARTHEST)) if steps is not None else 1.0
    bent = 2 ** (glide * _GLIDE_OF_BEARING / 2)
    samples = array("d")
    for tone in _RECIPES[name].tones:
        start, end = tone.start * raised / bent, tone.end * raised * bent
        samples.extend(_samples(replace(tone, start=start, end=end)))
    return _dulled(samples, behind * _DULLNESS) if behind else samples


def _samples(tone: _Tone) -> array[float]:
    frames = round(tone.seconds * SAMPLE_RATE)
    scale = _LOUDNESS / sum(tone.partials)
    phase = 0.0
    samples = array("d")
    for frame in range(frames):
        phase += math.tau * (tone.start + (tone.end - tone.start) * frame / frames) / SAMPLE_RATE
        wave = sum(strength * math.sin(phase * (k + 1)) for k, strength in enumerate(tone.partials))
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


def _wrapped(degrees: float) -> float:
    """The same bearing between -180 and 180; what is no bearing is straight ahead."""
    return (degrees + 180.0) % 360.0 - 180.0 if math.isfinite(degrees) else 0.0


def _behind(bearing: float) -> float:
    """0 from the front to the sides, 1 straight behind."""
    return max(0.0, -math.cos(math.radians(bearing)))


def _known_distance(steps: float | None) -> float | None:
    """Half steps, so that few sounds are made; None where no distance is known."""
    if steps is None or math.isnan(steps):
        return None
    return round(min(max(steps, 0.0), FARTHEST) * 2) / 2
