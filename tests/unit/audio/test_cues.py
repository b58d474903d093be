"""How the cues sound, without a device."""

from __future__ import annotations

import itertools
import math
from array import array

import numpy as np
import pytest

from devices.audio import cues
from devices.audio.cues import CUE_NAMES, SAMPLE_RATE, pitch_of_level, render_cue, seconds_of
from devices.ports.audio import Cue

TICKS = ("step-forward", "step-back", "turn-right", "turn-left")
OF_GRIPPER = ("grip", "release", "nothing")
WITH_PLACE = ("obstacle", "scan", "found", "belt", "block-opened", "block-closed")


def sides(samples: array[int]) -> tuple[float, float]:
    """Energy on the left and on the right."""
    return float(sum(x * x for x in samples[0::2])), float(sum(x * x for x in samples[1::2]))


def decibels_to_the_right(cue: Cue) -> float:
    left, right = sides(render_cue(cue))
    return 10 * math.log10((right + 1) / (left + 1))


def crossings(cue: Cue) -> int:
    """How often the sound changes its sign: pitch, for cues of one length."""
    left = render_cue(cue)[0::2]
    return sum((a < 0) != (b < 0) for a, b in itertools.pairwise(left))


def test_the_cues_have_their_agreed_names() -> None:
    assert set(CUE_NAMES) == {
        *TICKS,
        *WITH_PLACE,
        *OF_GRIPPER,
        "bump",
        "done",
        "goal",
        "solved",
        "error",
        "waiting",
    }


@pytest.mark.parametrize("name", CUE_NAMES)
def test_a_cue_has_its_length_and_is_loud_enough(name: str) -> None:
    samples = render_cue(Cue(name))
    seconds = len(samples) / 2 / SAMPLE_RATE

    assert seconds == pytest.approx(seconds_of(name), abs=0.001)
    assert seconds <= (0.060 if name in TICKS else 0.350)
    assert 4_000 < max(samples) < 20_000


@pytest.mark.parametrize("name", CUE_NAMES)
def test_a_cue_begins_and_ends_without_a_click(name: str) -> None:
    samples = render_cue(Cue(name, bearing=30.0, steps=10.0))

    assert max(abs(sample) for sample in samples[:4] + samples[-4:]) < 2_000


@pytest.mark.parametrize("name", CUE_NAMES)
def test_a_cue_that_is_computed_again_is_the_same_bytes(name: str) -> None:
    first = render_cue(Cue(name, 20.0, 5.0))
    cues._computed.cache_clear()

    assert render_cue(Cue(name, 20.0, 5.0)) == first


def test_a_cached_cue_is_not_mistaken_for_another() -> None:
    sounds = [
        render_cue(Cue(name, bearing, steps)).tobytes()
        for name in ("scan", "found")
        for bearing in (0.0, 45.0, 135.0, 180.0)
        for steps in (None, 5.0, 10.0)
    ]

    assert len({*sounds}) == len(sounds)


def test_turn_cues_have_their_own_side() -> None:
    assert decibels_to_the_right(Cue("turn-right")) > 12
    assert decibels_to_the_right(Cue("turn-left")) < -12


@pytest.mark.parametrize("name", CUE_NAMES)
@pytest.mark.parametrize("bearing", [45.0, 90.0, 135.0])
def test_left_and_right_are_twelve_decibels_apart(name: str, bearing: float) -> None:
    assert decibels_to_the_right(Cue(name, bearing)) > 12
    assert decibels_to_the_right(Cue(name, -bearing)) < -12


def test_bearings_beyond_a_turn_are_the_same_as_within() -> None:
    assert render_cue(Cue("scan", 405.0)) == render_cue(Cue("scan", 45.0))


def test_left_and_right_differ_in_pitch_on_one_side_alone() -> None:
    assert render_cue(Cue("obstacle", 60.0))[0::2] != render_cue(Cue("obstacle", -60.0))[1::2]


@pytest.mark.parametrize("name", WITH_PLACE)
def test_nearer_is_higher(name: str) -> None:
    pitches = [crossings(Cue(name, 0.0, float(steps))) for steps in range(0, 61, 5)]

    assert pitches == sorted(pitches, reverse=True)
    assert len(set(pitches)) == len(pitches)


def test_behind_is_duller() -> None:
    def sharpness(cue: Cue) -> float:
        left = render_cue(cue)[0::2]
        steepness = sum((b - a) ** 2 for a, b in itertools.pairwise(left))
        return steepness / sum(a * a for a in left)

    assert sharpness(Cue("bump", 180.0)) < 0.7 * sharpness(Cue("bump", 0.0))


@pytest.mark.parametrize(
    ("bearing", "steps", "expected"),
    [
        (math.nan, 3.0, Cue("scan", 0.0, 3.0)),
        (math.inf, 3.0, Cue("scan", 0.0, 3.0)),
        (0.0, math.nan, Cue("scan", 0.0, None)),
        (0.0, math.inf, Cue("scan", 0.0, 60.0)),
        (0.0, -math.inf, Cue("scan", 0.0, 0.0)),
        (-270.0, 3.3, Cue("scan", 90.0, 3.5)),
    ],
)
def test_a_place_without_a_meaning_still_sounds(bearing: float, steps: float, expected: Cue) -> None:
    cue = Cue("scan", bearing, steps)

    assert cues.normalized(cue) == expected
    assert render_cue(cue) == render_cue(expected)
    assert max(render_cue(cue)) > 1_000


def test_volume_ranges_from_nothing_to_all() -> None:
    assert not any(render_cue(Cue("bump"), 0.0))
    assert max(render_cue(Cue("bump"), 0.5)) == pytest.approx(max(render_cue(Cue("bump"), 1.0)) / 2, abs=2)
    assert render_cue(Cue("bump"), 9.0) == render_cue(Cue("bump"), 1.0)


def test_an_unknown_cue_can_not_be_rendered() -> None:
    with pytest.raises(KeyError):
        render_cue(Cue("trumpet"))


def test_a_deeper_block_sounds_higher() -> None:
    steps = [pitch_of_level(level) for level in range(1, 8)]
    assert steps == sorted(steps, reverse=True)
    assert steps[-1] >= 0
    assert pitch_of_level(100) == 0


# --- the tones


def tones_of(name: str, bearing: float = 0.0, steps: float | None = None) -> list[list[int]]:
    """The samples of each tone, of the louder side."""
    samples = render_cue(Cue(name, bearing, steps))
    side, ends = samples[bearing > 0 :: 2], 0
    tones = []
    for tone in cues._RECIPES[name].tones:
        begins, ends = ends, ends + round(tone.seconds * SAMPLE_RATE)
        tones.append([*side[begins:ends]])
    assert ends == len(side)
    return tones


def glide(tone: list[int]) -> tuple[float, float]:
    """The frequencies at the start and at the end of a tone, from the times at which its periods begin."""
    begins = [at + a / (a - b) for at, (a, b) in enumerate(itertools.pairwise(tone[:-1])) if a < 0 <= b]
    (slope, start, _) = np.polyfit([each / SAMPLE_RATE for each in begins], range(1, len(begins) + 1), 2)
    return start, start + 2 * slope * len(tone) / SAMPLE_RATE


def overtones(tone: list[int], hertz: float) -> list[float]:
    """How strong the fundamental and each of its overtones is."""
    seconds = np.arange(len(tone)) / SAMPLE_RATE
    return [
        abs(complex(np.dot(tone, np.exp(-2j * math.pi * hertz * (each + 1) * seconds)))) for each in range(6)
    ]


A, C, D, E, G, B = 0, 3, -7, 7, 10, 2
"""Semitones from the tone of 440 Hz; an octave has twelve."""


@pytest.mark.parametrize(
    ("name", "notes"),
    [
        *(("obstacle", [(A, A)]), ("scan", [(A + 12, A + 12)]), ("belt", [(E - 12, E - 12)])),
        *(("grip", [(G, C), (C, C)]), ("release", [(C, C), (C, G)]), ("nothing", [(D, C - 12)])),
        *(("done", [(C, C), (E, E), (G, G)]), ("goal", [(E, G)])),
        *(
            ("solved", [(C, C), (G, G), (C + 12, C + 12)]),
            ("error", [(A - 12, A - 12), None, (E - 24, E - 24)]),
        ),
        *(
            ("waiting", [(B, B), None, (B, B)]),
            ("block-opened", [(G - 12, C)]),
            ("block-closed", [(C, G - 12)]),
        ),
    ],
)
def test_the_tones_of_a_cue_are_notes(name: str, notes: list[tuple[int, int] | None]) -> None:
    tones = tones_of(name)
    for tone, note in zip(tones, notes, strict=True):
        if note is None:
            assert not any(tone)
        else:
            start, end = (round(440 * 2 ** (each / 12)) for each in note)
            assert glide(tone) == pytest.approx((start, end), abs=0.6)


@pytest.mark.parametrize(
    ("name", "hertz", "count"),
    [
        *(("belt", 330, 1), ("scan", 880, 1), ("waiting", 494, 1), ("done", 523, 2), ("obstacle", 440, 3)),
        ("error", 220, 5),
    ],
)
def test_each_overtone_is_weaker_than_the_one_below_it(name: str, hertz: float, count: int) -> None:
    strengths = overtones(tones_of(name)[0], hertz)

    assert all(second < 0.9 * first for first, second in itertools.pairwise(strengths[:count]))
    assert min(strengths[:count]) > 10 * max(strengths[count:])


@pytest.mark.parametrize(("bearing", "semitones"), [(90.0, 4), (-90.0, -4), (30.0, 2), (0.0, 0)])
def test_a_place_is_a_glide_of_a_third_up_at_the_right_and_down_at_the_left(
    bearing: float, semitones: float
) -> None:
    start, end = glide(tones_of("obstacle", bearing)[0])

    assert 12 * math.log2(end / start) == pytest.approx(semitones, abs=0.03)
    assert start * end == pytest.approx(440**2, rel=0.002)


@pytest.mark.parametrize(("steps", "hertz"), [(0.0, 1760), (30.0, 880), (60.0, 440), (15.0, 880 * 2**0.5)])
def test_the_distance_is_two_octaves_over_sixty_steps(steps: float, hertz: float) -> None:
    assert glide(tones_of("scan", 0.0, steps)[0]) == pytest.approx((hertz, hertz), abs=1)


@pytest.mark.parametrize(
    ("name", "ratio", "within"),
    [("turn-right", 3 / 2, 1e-3), ("turn-left", 2 / 3, 1e-3), ("bump", 1 / 2, 5e-3)],
)
def test_a_turn_is_a_fifth_up_or_down_and_a_bump_an_octave_down(
    name: str, ratio: float, within: float
) -> None:
    samples = render_cue(Cue(name, 1.0))
    start, end = glide([*samples[1::2]])

    assert end / start == pytest.approx(ratio, rel=within)


def test_what_was_found_sounds_as_two_tones_a_fourth_apart() -> None:
    first, second = tones_of("found")

    assert [b / a for a, b in zip(glide(first), glide(second), strict=True)] == pytest.approx(
        [4 / 3, 4 / 3], rel=5e-4
    )
