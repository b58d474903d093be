"""The miniaudio player on its null device, which takes the sound at the right pace and throws it away.

How soon sound begins and ends is measured by ``benchmarks/sound.py``.
"""

from __future__ import annotations

import threading
from array import array
from collections.abc import Iterator

import pytest

from devices.audio.cues import SAMPLE_RATE, render_cue
from devices.audio.players import NO_DEVICE, NULL_DEVICE, MiniaudioPlayer, open_player
from devices.audio.supervisor import SILENCE_LIMIT
from devices.ports.audio import Cue
from tests.timeouts import TIMEOUT

pytest.importorskip("miniaudio", reason="has no wheel for this platform")


class Recorder:
    """Records the blocks that the device takes from a player's mixer."""

    def __init__(self, player: MiniaudioPlayer) -> None:
        self._mix = player.mix
        self._more = threading.Condition()
        self.blocks: list[array[int]] = []
        player.mix = self._record  # type: ignore[method-assign]

    def _record(self, frames: int) -> array[int]:
        with self._more:
            mixed = self._mix(frames)
            self.blocks.append(mixed)
            self._more.notify_all()
        return mixed

    def wait_for(self, sounds: bool) -> int:
        """Wait for a further block in which anything sounds, or nothing. Its number."""
        with self._more:
            begin = len(self.blocks)

            def found() -> list[int]:
                later = enumerate(self.blocks[begin:], begin)
                return [number for number, block in later if any(block) is sounds]

            assert self._more.wait_for(found, TIMEOUT)
            return found()[0]


@pytest.fixture
def player() -> Iterator[MiniaudioPlayer]:
    opened = open_player(NULL_DEVICE)
    assert isinstance(opened, MiniaudioPlayer)
    yield opened
    opened.close()


def test_no_device_is_no_player() -> None:
    assert open_player(NO_DEVICE) is None


def test_the_device_takes_frames_all_the_time(player: MiniaudioPlayer) -> None:
    recorder = Recorder(player)
    recorder.wait_for(sounds=False)

    assert player.frames
    assert not player.is_playing


def test_a_cue_and_a_sentence_reach_the_device_and_its_end_is_reported(player: MiniaudioPlayer) -> None:
    recorder, ended = Recorder(player), threading.Event()
    player.cue("found", render_cue(Cue("found")), 0.0)
    recorder.wait_for(sounds=True)
    player.silence(speech=False, cues=True)
    player.speak(array("h", [1000]) * (SAMPLE_RATE // 100), on_end=ended.set)

    assert ended.wait(TIMEOUT)
    assert any(1000 in block for block in recorder.blocks)


def test_a_sentence_that_is_silenced_does_not_sound_again_and_has_no_end(player: MiniaudioPlayer) -> None:
    recorder, ended = Recorder(player), threading.Event()
    player.speak(array("h", [1000]) * SAMPLE_RATE * 60, on_end=ended.set)
    recorder.wait_for(sounds=True)
    player.silence(speech=True, cues=False)
    silent = recorder.wait_for(sounds=False)
    recorder.wait_for(sounds=False)

    assert not any(any(block) for block in recorder.blocks[silent:])
    assert not player.is_playing
    assert not ended.is_set()


def test_a_block_is_short_enough_for_sound_and_silence_to_begin_in_time(player: MiniaudioPlayer) -> None:
    """Sound begins and ends with the next block. The rest of the limits is for the pipe to the worker."""
    recorder = Recorder(player)
    recorder.wait_for(sounds=False)

    assert max(len(block) for block in recorder.blocks) / 2 / SAMPLE_RATE <= 0.1
    assert SILENCE_LIMIT < 0.150
