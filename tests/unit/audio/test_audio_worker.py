"""The audio worker as a process: it speaks, is silenced, dies, freezes, and leaves nothing running.

The device is miniaudio's null device, which takes the sound at the right pace and throws it away.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from array import array
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

from devices.audio import process, worker
from devices.audio.cues import CUE_NAMES
from devices.audio.process import AudioResponse, Say, Silence, Silenced, SpeechStarted, to_line
from devices.audio.service import AudioService, AudioSettings
from devices.audio.supervisor import WorkerState
from devices.audio.worker import AudioWorker
from devices.ports.audio import (
    AudioNotice,
    Cue,
    NoticeCode,
    Urgency,
    Utterance,
    VoiceSettings,
)
from donnie_tui.outlets.audible import spoken_languages
from tests.conftest import ROOT
from tests.timeouts import TIMEOUT

pytestmark = [pytest.mark.slow, pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")]


FAST = VoiceSettings(words_per_minute=450)


def eventually(is_so: Callable[[], bool]) -> bool:
    """Wait for ``is_so``."""
    end = time.monotonic() + TIMEOUT
    while not is_so() and time.monotonic() < end:
        time.sleep(0.005)
    return is_so()


def group_of(pid: int) -> set[int]:
    """The processes that run in that process group."""
    return {number for number in map(int, filter(str.isdigit, os.listdir("/proc"))) if in_group(number, pid)}  # noqa: PTH208


def in_group(number: int, group: int) -> bool:
    try:
        fields = Path(f"/proc/{number}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return False
    state, process_group = fields[0], int(fields[2])
    return process_group == group and state not in "ZX"


@contextmanager
def audio(device: str = "null", **settings: object) -> Iterator[tuple[AudioService, list[AudioNotice]]]:
    """A service whose worker is gone afterwards."""
    notices: list[AudioNotice] = []
    made = AudioSettings(voice=FAST, device=device, languages=spoken_languages(), **settings)  # type: ignore[arg-type]
    service = AudioService(made, notices.append)
    try:
        yield service, notices
    finally:
        service.close()


def warm(service: AudioService) -> int:
    """Wait until the worker is ready. Its process id."""
    service.warm_up()
    assert eventually(lambda: service.state is WorkerState.READY)
    assert service.worker_pid is not None
    return service.worker_pid


def say(service: AudioService, text: str, language: str = "en") -> None:
    service.say(Utterance(text, Urgency.PROGRAM, language))


def test_three_sentences_in_three_languages_are_spoken_to_their_end() -> None:
    with audio() as (service, notices):
        for language, text in (("en", "One."), ("pt", "Dois."), ("es", "Tres.")):
            say(service, text, language)

        assert service.wait_until_quiet(TIMEOUT)
        assert (service.state, notices) == (WorkerState.READY, [])


def test_every_cue_is_accepted_and_an_unknown_one_is_ignored() -> None:
    with audio() as (service, notices):
        pid = warm(service)
        for name in (*CUE_NAMES, "trumpet"):
            service.play(Cue(name, 45.0, 3.0))
        say(service, "A.")  # no silence before it: a busy worker that is silenced late is replaced

        assert service.wait_until_quiet(TIMEOUT)
        assert (service.worker_pid, notices) == (pid, [])


def test_silence_drops_all_sentences_and_keeps_the_worker_ready() -> None:
    with audio() as (service, _):
        warm(service)
        for number in range(1000):
            say(service, f"A sentence that would take a while, number {number}.")
        service.silence_speech()
        assert service.is_quiet

        say(service, "B.")
        assert service.wait_until_quiet(TIMEOUT)


def test_a_killed_worker_is_replaced_and_its_sentence_is_said() -> None:
    with audio() as (service, notices):
        pid = warm(service)
        say(service, "This is said after all.")
        os.killpg(pid, signal.SIGKILL)

        assert eventually(lambda: service.worker_pid not in (None, pid))
        assert service.wait_until_quiet(TIMEOUT)
        assert (service.state, notices) == (WorkerState.READY, [])


def test_a_frozen_worker_blocks_no_caller_and_is_replaced() -> None:
    with audio() as (service, _):
        pid = warm(service)
        os.kill(pid, signal.SIGSTOP)
        for number in range(2000):
            say(service, f"{number}.")
            service.play(Cue("bump"))

        assert eventually(lambda: service.worker_pid not in (None, pid))
        assert group_of(pid) == set()


def test_a_frozen_worker_that_should_be_silent_is_killed() -> None:
    with audio() as (service, _):
        pid = warm(service)
        say(service, "A sentence that takes a while to say.")
        assert eventually(lambda: service.is_speaking)
        os.kill(pid, signal.SIGSTOP)
        service.silence_speech()

        assert eventually(lambda: service.worker_pid not in (None, pid))
        assert group_of(pid) == set()


def test_a_worker_that_dies_three_times_is_given_up_and_reported() -> None:
    with audio() as (service, notices):
        service.warm_up()
        killed: set[int] = set()

        def kill_the_present_one() -> bool:
            pid = service.worker_pid
            if pid is not None and pid not in killed:
                killed.add(pid)
                os.killpg(pid, signal.SIGKILL)
            return service.state is WorkerState.GIVEN_UP

        assert eventually(kill_the_present_one)
        assert eventually(lambda: notices == [AudioNotice(NoticeCode.AUDIO_GAVE_UP)])
        assert len(killed) == 3
        say(service, "Nothing.")
        assert service.is_quiet


def test_a_worker_that_can_not_be_started_is_given_up_and_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "/nowhere/python")
    with audio() as (service, notices):
        say(service, "Hello.")

        assert service.wait_until_quiet(TIMEOUT)
        assert eventually(lambda: notices == [AudioNotice(NoticeCode.AUDIO_GAVE_UP)])


def test_a_missing_device_is_reported_once_and_no_process_stays() -> None:
    with audio(device="none") as (service, notices):
        say(service, "Hello.")

        assert service.wait_until_quiet(TIMEOUT)
        assert eventually(lambda: service.worker_pid is None)
        assert notices == [AudioNotice(NoticeCode.NO_SOUND_DEVICE)]


def test_after_closing_nothing_runs_and_every_method_may_still_be_called() -> None:
    with audio() as (service, notices):
        pid = warm(service)
        say(service, "A sentence that takes a while to say.")
        assert eventually(lambda: service.is_speaking)
        service.close()

        assert group_of(pid) == set()
        say(service, "Hello.")
        service.play(Cue("bump"))
        service.silence_speech()
        service.warm_up()
        service.close()
        assert (service.worker_pid, service.is_quiet, notices) == (None, True, [])


def test_closing_before_anything_was_played_starts_nothing() -> None:
    with audio() as (service, _):
        service.close()

        assert service.worker_pid is None


RENDER = """
import json, sys
from devices.audio.cues import SAMPLE_RATE
from devices.audio.worker import NoVoice, Renderer
from devices.ports.audio import VoiceSettings
try:
    renderer = Renderer(dict(en=("en", "en-gb"), pt=("pt-br",), es=("es",)), {bundled})
except NoVoice:
    sys.exit("no voice")
def seconds(text, language, words_per_minute=180):
    return len(renderer.render(text, language, VoiceSettings(words_per_minute))) / SAMPLE_RATE
def refuses(language):
    try:
        seconds("Bonjour.", language)
    except NoVoice:
        return True
    return False
facts = dict(
    languages=renderer.languages,
    seconds=[seconds("I walked 10 steps.", language) for language in renderer.languages],
    loudest=max(renderer.render("Hello.", "en", VoiceSettings())),
    slow=seconds("I walked 10 steps.", "en", 80), fast=seconds("I walked 10 steps.", "en", 400),
    quiet=max(renderer.render("Hello.", "en", VoiceSettings(volume=0.1))),
    nothing=seconds("  ", "en"), signs=seconds("...", "en"),
    twice=[seconds("Hi.", "en"), seconds("Hi.", "en")],
    french=refuses("fr"),
    changing=[seconds("Ten steps.", "en", rate) for rate in (80, 400) * 20],
)
print("facts", json.dumps(facts))
"""


@pytest.mark.parametrize("bundled", [False, True], ids=["the system's", "the bundled"])
def test_a_sentence_is_rendered_to_sound_by_the_voice_of_its_language(bundled: bool) -> None:
    """In a process of its own: pyttsx3 is never loaded into Donnie."""
    done = subprocess.run(
        (sys.executable, "-c", RENDER.format(bundled=bundled)),
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=TIMEOUT,
    )
    if "no voice" in done.stderr:
        pytest.skip("needs espeak-ng")
    facts = json.loads(done.stdout.rpartition("facts")[2])

    assert facts["languages"] == ["en", "pt", "es"]
    assert all(0.5 < seconds < 5.0 for seconds in facts["seconds"])
    assert facts["slow"] > 1.5 * facts["fast"]
    assert facts["loudest"] > 3 * facts["quiet"] > 0
    assert facts["nothing"] == 0.0
    assert facts["twice"][0] == pytest.approx(facts["twice"][1], abs=0.01)
    assert facts["french"]
    assert min(facts["changing"][0::2]) > 1.5 * max(facts["changing"][1::2])


def test_after_every_kind_of_trouble_the_worker_speaks_again() -> None:
    """Flooded with a thousand sentences, silenced a hundred times, killed and stopped."""
    with audio() as (service, notices):
        pid = warm(service)
        for number in range(1000):
            say(service, f"{number}.")
            if number % 10 == 0:
                service.silence_speech()
        os.killpg(pid, signal.SIGKILL)
        assert eventually(lambda: service.worker_pid not in (None, pid))
        frozen = warm(service)
        os.kill(frozen, signal.SIGSTOP)
        say(service, "It is frozen.")
        assert eventually(lambda: service.is_speaking)
        service.silence_speech()
        assert eventually(lambda: service.worker_pid not in (None, frozen))

        say(service, "Heard.")
        assert service.wait_until_quiet(TIMEOUT)
        assert (service.state, notices) == (WorkerState.READY, [])
        assert group_of(pid) == group_of(frozen) == set()


GROWTH = """
import os, sys
from pathlib import Path
from devices.audio.worker import NoVoice, Renderer
from devices.ports.audio import VoiceSettings
def resident():
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")
try:
    renderer = Renderer(dict(en=("en", "en-gb")))
except NoVoice:
    sys.exit("no voice")
fast = VoiceSettings(450)
def render(numbers):
    return sum(len(renderer.render(f"{number}.", "en", fast)) > 0 for number in numbers)
render(range(30))
before = resident()
print(render(range(300)), resident() - before)
"""


def test_speaking_makes_the_worker_grow_by_less_than_ten_megabytes_a_thousand_sentences() -> None:
    """Tested with three hundred; ``benchmarks/sound.py`` has the thousand."""
    done = subprocess.run(
        (sys.executable, "-c", GROWTH), cwd=ROOT, capture_output=True, text=True, timeout=TIMEOUT
    )
    if "no voice" in done.stderr:
        pytest.skip("needs espeak-ng")
    rendered, grown = map(int, done.stdout.split()[-2:])

    assert rendered == 300
    assert grown < 3 * 1024 * 1024


def test_a_worker_is_killed_with_the_player_that_it_started(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(process, "_MODULE", "tests.unit.audio.worker_with_a_player")
    started = process.WorkerProcess("null", False, None, None, {}, lambda _: None, lambda: None)
    try:
        assert eventually(lambda: len(group_of(started.pid)) == 2)
        started.kill()
        assert eventually(lambda: group_of(started.pid) == set())
    finally:
        with suppress(ProcessLookupError):
            os.killpg(started.pid, signal.SIGKILL)


class SilentPlayer:
    """Counts the sentences."""

    def __init__(self) -> None:
        self.spoken = 0

    def speak(self, mono: array[int], on_end: Callable[[], None]) -> None:
        self.spoken += 1

    def silence(self, speech: bool, cues: bool) -> None: ...


@pytest.mark.parametrize("is_silenced", [True, False])
def test_a_sentence_that_is_silenced_while_it_is_rendered_does_not_sound(
    monkeypatch: pytest.MonkeyPatch, is_silenced: bool
) -> None:
    def rendered(*_: object) -> array[int]:
        if is_silenced:
            made._obey(to_line(Silence(7, True, False)))
        return array("h", [0] * 22_050)

    answers: list[AudioResponse] = []
    made, player = AudioWorker(answers.append, "null", False, {}, {}), SilentPlayer()
    made._player = player  # type: ignore[assignment] # as far as it is asked
    monkeypatch.setattr(worker, "_rendered", rendered)
    made._speak(None, 0, Say(1, "Hello.", "en", 180, 50, 1.0))

    assert answers == ([Silenced(7)] if is_silenced else [SpeechStarted(1, 1.0)])
    assert player.spoken == (not is_silenced)
