"""Which channel an utterance takes, and how the facts for that are found."""

import os
import sys
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace

from devices.audio.channel import (
    Channel,
    ChannelReason,
    ChosenChannel,
    DetectedEnvironment,
    SpeakPlace,
    choose_channel,
    find_screen_reader,
    ssip_address,
)
from devices.audio.ssip import SsipAddress
from tests.unit.audio.known_environment import KnownEnvironment

ALL_WELL = KnownEnvironment(
    stdout_is_terminal=True, over_ssh=False, screen_reader=None, has_voice=True, has_sound_device=True
)
NO_TERMINAL = replace(ALL_WELL, stdout_is_terminal=False)
SSH = replace(ALL_WELL, over_ssh=True)
READER = replace(ALL_WELL, screen_reader="orca")
SSIP = replace(ALL_WELL, has_ssip=True)
SSIP_HOME = replace(SSIP, over_ssh=True)
FULL_SCREEN = replace(ALL_WELL, is_linear=False)
NO_VOICE = replace(ALL_WELL, has_voice=False)
NO_DEVICE = replace(ALL_WELL, has_sound_device=False)


@pytest.mark.parametrize(
    ("wanted", "facts", "channel", "reason"),
    [
        ("auto", ALL_WELL, Channel.TTS, ChannelReason.OWN_VOICE),
        ("auto", NO_TERMINAL, Channel.TEXT, ChannelReason.NOT_A_TERMINAL),
        ("auto", SSH, Channel.TEXT, ChannelReason.OVER_SSH),
        ("auto", READER, Channel.TEXT, ChannelReason.SCREEN_READER),
        ("auto", NO_VOICE, Channel.TEXT, ChannelReason.NO_VOICE),
        ("auto", NO_DEVICE, Channel.TEXT, ChannelReason.NO_SOUND_DEVICE),
        ("auto", replace(SSH, screen_reader="orca"), Channel.TEXT, ChannelReason.OVER_SSH),
        ("auto", replace(NO_VOICE, over_ssh=True), Channel.TEXT, ChannelReason.OVER_SSH),
        ("auto", replace(NO_DEVICE, has_voice=False), Channel.TEXT, ChannelReason.NO_VOICE),
        ("auto", SSIP, Channel.SSIP, ChannelReason.SPEECH_DISPATCHER),
        ("auto", SSIP_HOME, Channel.SSIP, ChannelReason.SPEECH_DISPATCHER),
        ("auto", replace(SSIP, screen_reader="orca"), Channel.TEXT, ChannelReason.SCREEN_READER),
        (
            "auto",
            replace(SSIP, screen_reader="orca", is_linear=False),
            Channel.SSIP,
            ChannelReason.READERS_VOICE,
        ),
        ("auto", replace(FULL_SCREEN, screen_reader="orca"), Channel.TEXT, ChannelReason.SCREEN_READER),
        ("auto", replace(SSIP, stdout_is_terminal=False), Channel.TEXT, ChannelReason.NOT_A_TERMINAL),
        ("ssip", SSIP, Channel.SSIP, ChannelReason.ASKED_FOR),
        ("ssip", ALL_WELL, Channel.TEXT, ChannelReason.NO_SPEECH_DISPATCHER),
        ("off", ALL_WELL, Channel.TEXT, ChannelReason.ASKED_FOR),
        ("text", ALL_WELL, Channel.TEXT, ChannelReason.ASKED_FOR),
        ("tts", ALL_WELL, Channel.TTS, ChannelReason.ASKED_FOR),
        ("tts", SSH, Channel.TTS, ChannelReason.ASKED_FOR),
        ("tts", READER, Channel.TTS, ChannelReason.ASKED_FOR),
        ("tts", NO_TERMINAL, Channel.TTS, ChannelReason.ASKED_FOR),
        ("tts", NO_VOICE, Channel.TEXT, ChannelReason.NO_VOICE),
        ("tts", NO_DEVICE, Channel.TEXT, ChannelReason.NO_SOUND_DEVICE),
    ],
)
def test_the_channel_of_the_answers(
    wanted: str, facts: KnownEnvironment, channel: Channel, reason: ChannelReason
) -> None:
    assert choose_channel(wanted, facts) == ChosenChannel(channel, reason)


AT_ROBOT = replace(SSH, has_real_robot=True)


@pytest.mark.parametrize(
    ("wanted", "place", "facts", "spoken"),
    [
        ("auto", "here", SSH, SpeakPlace.HERE),
        ("auto", "here", AT_ROBOT, SpeakPlace.ROBOT),
        ("auto", "here", replace(SSIP, has_real_robot=True), SpeakPlace.HERE),
        ("auto", "here", replace(READER, has_real_robot=True), SpeakPlace.HERE),
        ("text", "here", AT_ROBOT, SpeakPlace.HERE),
        ("text", "robot", SSH, SpeakPlace.ROBOT),
        ("auto", "both", SSIP_HOME, SpeakPlace.BOTH),
        ("robot", "here", SSH, SpeakPlace.ROBOT),
        ("robot", "here", replace(SSH, has_voice=False), SpeakPlace.HERE),
        ("off", "robot", SSH, SpeakPlace.HERE),
        ("tts", "both", ALL_WELL, SpeakPlace.HERE),
    ],
)
def test_speak_is_spoken_where_the_learner_wants_it(
    wanted: str, place: str, facts: KnownEnvironment, spoken: SpeakPlace
) -> None:
    assert choose_channel(wanted, facts, place).speak is spoken


def test_over_ssh_only_a_forwarded_speech_dispatcher_is_used() -> None:
    here = {"XDG_RUNTIME_DIR": "/nowhere"}
    forwarded = {"SSH_CONNECTION": "1 2 3 4", "SPEECHD_ADDRESS": "unix_socket:/tmp/forwarded.sock"}
    assert ssip_address({**here, "SSH_CONNECTION": "1 2 3 4"}) is None
    assert ssip_address(forwarded) == SsipAddress(path="/tmp/forwarded.sock")


def test_an_unknown_option_is_an_error() -> None:
    with pytest.raises(ValueError, match="loud"):
        choose_channel("loud", ALL_WELL)


def fake_process(root: Path, number: int, *arguments: str, comm: str = "") -> None:
    folder = root / "proc" / str(number)
    folder.mkdir(parents=True)
    (folder / "cmdline").write_bytes(b"".join(os.fsencode(argument) + b"\0" for argument in arguments))
    (folder / "comm").write_text(comm + "\n")


@pytest.mark.parametrize(
    ("arguments", "comm", "found"),
    [
        (("/usr/bin/yasr", "-c", "bash"), "yasr", "yasr"),
        (("/usr/bin/python3", "/usr/bin/orca"), "python3", "orca"),
        (("python3", "-u", "/opt/fenrir.py"), "python3", "fenrir"),
        (("/usr/libexec/reader",), "orca", "orca"),
        (("tclsh", "/usr/share/emacs/site-lisp/emacspeak/servers/espeak"), "tclsh", "emacspeak"),
        (("vim", "orca"), "vim", None),
        (("python3", "game.py", "orca"), "python3", None),
        (("brltty",), "brltty", None),
        ((), "kthread", None),
        ((), "speakup", None),  # a thread of the kernel, with a synthesiser or without
    ],
)
def test_a_screen_reader_is_found_by_its_program(
    tmp_path: Path, arguments: tuple[str, ...], comm: str, found: str | None
) -> None:
    fake_process(tmp_path, 7, "bash", comm="bash")
    fake_process(tmp_path, 12, *arguments, comm=comm)

    assert find_screen_reader({}, str(tmp_path)) == found


def test_a_reader_of_another_user_does_not_count(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    fake_process(tmp_path, 12, "orca", comm="orca")
    monkeypatch.setattr(os, "getuid", lambda: tmp_path.stat().st_uid + 1)

    assert find_screen_reader({}, str(tmp_path)) is None


def test_the_systems_console_reader_counts_for_every_user(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fake_process(tmp_path, 12, "python3", "/usr/bin/fenrir", comm="fenrir")
    monkeypatch.setattr(os, "getuid", lambda: tmp_path.stat().st_uid + 1)

    assert find_screen_reader({}, str(tmp_path)) == "fenrir"


def test_a_reader_can_be_declared_in_the_environment(tmp_path: Path) -> None:
    assert find_screen_reader({"DONNIE_READER": "1"}, str(tmp_path)) == "DONNIE_READER"


@pytest.mark.parametrize(
    ("answer", "found"),
    [
        ("0", None),
        ("Off", None),
        ("no", None),
        ("FALSE", None),
        ("", "orca"),
        ("maybe", "orca"),
    ],
)
def test_a_running_reader_can_be_denied_in_the_environment(
    answer: str, found: str | None, tmp_path: Path
) -> None:
    fake_process(tmp_path, 12, "orca", comm="orca")
    synth = tmp_path / "sys/accessibility/speakup/synth"

    assert find_screen_reader({"DONNIE_READER": answer}, str(tmp_path)) == found
    synth.parent.mkdir(parents=True)
    synth.write_text("soft")
    assert find_screen_reader({"DONNIE_READER": answer}, str(tmp_path)) == (found and "speakup")


def test_speakup_with_a_synthesiser_is_a_reader(tmp_path: Path) -> None:
    synth = tmp_path / "sys/accessibility/speakup/synth"
    synth.parent.mkdir(parents=True)
    synth.write_text("none\n")
    assert find_screen_reader({}, str(tmp_path)) is None

    synth.write_text("soft\n")
    assert find_screen_reader({}, str(tmp_path)) == "speakup"


def test_the_files_of_the_system_are_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    looked: list[str] = []

    def look(found: object, path: str) -> object:
        looked.append(path)
        return found

    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr("devices.audio.channel._read", partial(look, ""))
    monkeypatch.setattr(os, "scandir", partial(look, ()))
    assert DetectedEnvironment({}).screen_reader is None
    assert find_screen_reader({}) is None
    assert not DetectedEnvironment({}).has_sound_device

    assert looked == ["/sys/accessibility/speakup/synth", "/proc"] * 2 + ["/dev/snd"]


@pytest.mark.parametrize(
    ("arguments", "found"),
    [
        (("emacs", "-q", "--load", "x", "y", "/usr/share/emacspeak/lisp/emacspeak-setup.el"), "emacspeak"),
        (("emacs", "-q", "--load", "x", "y", "z", "/usr/share/emacspeak/lisp/a.el"), None),
        (("emacs", "/home/emacspeak"), None),
        (("python3", "-" * 4082, "/orca"), "orca"),
        (("python3", "-" * 4083, "/orca"), None),  # it ends after the first 4096 bytes
        (("python3", "/home/josé/orca"), "orca"),
        (("python3", "/home/jos\udce9/orca"), "orca"),
        (("python3", "a.py", "/usr/bin/orca"), None),
        (("python3", "-u"), None),
    ],
)
def test_the_beginning_of_a_command_line_names_the_reader(
    tmp_path: Path, arguments: tuple[str, ...], found: str | None
) -> None:
    fake_process(tmp_path, 12, *arguments, comm="other")

    assert find_screen_reader({}, str(tmp_path)) == found


def test_only_numbered_folders_are_processes_and_their_files_are_closed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fake_process(tmp_path, 12, "bash", comm="bash")
    (tmp_path / "proc" / "12").rename(tmp_path / "proc" / "self")
    (tmp_path / "proc" / "self" / "cmdline").write_bytes(b"orca\0")
    fake_process(tmp_path, 13, "vim", comm="vim")
    opened, closed = list[int](), list[int]()
    open_file, close_file = os.open, os.close

    def opening(path: str, *how: Any) -> int:
        file = open_file(path, *how)
        if str(path).startswith(str(tmp_path)):
            opened.append(file)
        return file

    def closing(file: int) -> None:
        if file in opened:
            closed.append(file)
        close_file(file)

    with monkeypatch.context() as patch:
        patch.setattr(os, "open", opening)
        patch.setattr(os, "close", closing)
        found = find_screen_reader({}, str(tmp_path))

    assert found is None
    assert len(opened) == 2
    assert closed == opened


def test_a_process_that_has_ended_meanwhile_is_no_reader(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fake_process(tmp_path, 12, "orca", comm="orca")
    (tmp_path / "proc" / "13").mkdir()
    (tmp_path / "proc" / "self").mkdir()
    assert find_screen_reader({}, str(tmp_path)) == "orca"

    def ended(_path: str) -> None:
        raise FileNotFoundError

    monkeypatch.setattr(os, "stat", ended)
    assert find_screen_reader({}, str(tmp_path)) is None


@pytest.mark.skipif("sys.platform != 'linux'", reason="sound cards are looked for on Linux")
@pytest.mark.parametrize(
    ("file", "environment", "found"),
    [
        ("dev/snd/pcmC0D0p", {}, True),
        ("dev/snd/pcmC0D0c", {}, False),
        ("dev/snd/timer", {}, False),
        ("dev/snd/midiC0p", {}, False),
        ("run/pulse/native", {"XDG_RUNTIME_DIR": "run"}, True),
        ("run/pipewire-0", {"XDG_RUNTIME_DIR": "run"}, True),
        ("run/bus", {"XDG_RUNTIME_DIR": "run"}, False),
        ("nothing", {"PULSE_SERVER": "tcp:elsewhere"}, True),
    ],
)
def test_a_sound_device_is_a_card_that_plays_or_a_server(
    tmp_path: Path, file: str, environment: Mapping[str, str], found: bool
) -> None:
    place = tmp_path / file
    place.parent.mkdir(parents=True, exist_ok=True)
    place.touch()
    variables = {
        key: str(tmp_path / value) if key == "XDG_RUNTIME_DIR" else value
        for key, value in environment.items()
    }

    assert DetectedEnvironment(variables, str(tmp_path)).has_sound_device is found


def test_without_a_runtime_folder_there_is_no_sound_server(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "None" / "pulse" / "native").mkdir(parents=True)
    monkeypatch.chdir(tmp_path)

    assert DetectedEnvironment({}, str(tmp_path)).has_sound_device is False


def test_a_runtime_folder_without_permission_has_no_sound_server(tmp_path: Path) -> None:
    """As after ``su``, which leaves the variable at another user's folder; here the system refuses a name."""
    variables = {"XDG_RUNTIME_DIR": f"{tmp_path}/{'x' * 300}"}

    assert not DetectedEnvironment(variables, str(tmp_path)).has_sound_device


def test_ssh_is_detected_in_the_environment(tmp_path: Path) -> None:
    assert DetectedEnvironment({"SSH_CONNECTION": "1.2.3.4 5 6.7.8.9 22"}, str(tmp_path)).over_ssh
    assert DetectedEnvironment({"SSH_TTY": "/dev/pts/1"}, str(tmp_path)).over_ssh
    assert not DetectedEnvironment({}, str(tmp_path)).over_ssh
    assert ssip_address({"SSH_TTY": "/dev/pts/1"}) is None


def test_what_only_the_caller_knows_is_taken_from_it() -> None:
    known = [
        (each.is_linear, each.has_real_robot)
        for each in (
            DetectedEnvironment({}),
            DetectedEnvironment({}, is_linear=False),
            DetectedEnvironment({}, has_real_robot=True),
        )
    ]
    assert known == [(True, False), (False, False), (True, True)]


def test_nothing_is_detected_where_the_voice_is_off(monkeypatch: pytest.MonkeyPatch) -> None:
    looked: list[str] = []
    for module, name in (("channel", "find_screen_reader"), ("ssip", "is_reachable")):
        monkeypatch.setattr(f"devices.audio.{module}.{name}", lambda *_, name=name: looked.append(name))
    for name in ("has_voice", "has_sound_device"):
        monkeypatch.setattr(DetectedEnvironment, name, property(lambda _, name=name: looked.append(name)))

    for wish in ("off", "text"):
        choose_channel(wish, DetectedEnvironment({}))
    assert "find_screen_reader" not in looked

    looked.clear()
    choose_channel("off", DetectedEnvironment({}))
    assert looked == []


@pytest.mark.parametrize("name", ["orca", "fenrir", "yasr", "tdsr", "emacspeak", "speakup"])
def test_each_reader_that_speaks_is_found_by_the_name_of_its_process(tmp_path: Path, name: str) -> None:
    fake_process(tmp_path, 12, f"/usr/bin/{name}", comm=name)

    assert find_screen_reader({}, str(tmp_path)) == name


@pytest.mark.parametrize("interpreter", ["python3", "perl", "bash", "dash", "sh", "env", "tclsh"])
def test_a_reader_is_found_behind_its_interpreter(tmp_path: Path, interpreter: str) -> None:
    fake_process(tmp_path, 12, f"/usr/bin/{interpreter}", "/usr/local/bin/yasr", comm=interpreter)

    assert find_screen_reader({}, str(tmp_path)) == "yasr"


@pytest.mark.parametrize("name", ["libespeak-ng.so.1", "libespeak-ng.1.dylib"])
@pytest.mark.parametrize("between", ["", "x86_64-linux-gnu"])
@pytest.mark.parametrize(
    "folder", ["usr/lib", "usr/lib64", "lib", "usr/local/lib", "opt/homebrew/lib", "home/lib"]
)
def test_a_voice_needs_a_library_in_one_of_the_systems_folders(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, folder: str, between: str, name: str
) -> None:
    """Without the bundled one."""
    monkeypatch.setattr("importlib.util.find_spec", lambda name: name == "pyttsx3" or None)
    monkeypatch.setattr("sys.platform", "linux")
    assert not DetectedEnvironment({}, f"{tmp_path}/").has_voice
    place = tmp_path / folder / between
    place.mkdir(parents=True)
    (place / name).touch()

    assert DetectedEnvironment({}, f"{tmp_path}/").has_voice is (folder != "home/lib")


def test_a_voice_needs_its_module_and_elsewhere_the_system_has_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = {"pyttsx3"}
    monkeypatch.setattr("importlib.util.find_spec", lambda name: name in found or None)
    monkeypatch.setattr("sys.platform", "darwin")
    assert DetectedEnvironment({}, str(tmp_path)).has_voice
    monkeypatch.setattr("sys.platform", "linux")
    assert not DetectedEnvironment({}, str(tmp_path)).has_voice
    found.add("espeakng_loader")
    assert DetectedEnvironment({}, str(tmp_path)).has_voice
    found.remove("pyttsx3")
    assert not DetectedEnvironment({}, str(tmp_path)).has_voice
