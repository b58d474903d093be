"""``donnie doctor`` prints what works, what was chosen and why, and a remedy for each problem."""

from __future__ import annotations

import io
import itertools
import os
import sys
import wave
from argparse import Namespace
from collections.abc import Iterable
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import pytest

import devices.serial_ports
from devices.audio import service, supervisor
from devices.audio.channel import SpeakPlace, SpeechOption, choose_channel
from devices.audio.players import NO_DEVICE
from devices.audio.service import AudioService
from devices.board_reset import GpioReset, PinFault
from devices.serial_ports import FoundPort
from donnie_tui.cli import doctor
from donnie_tui.cli.doctor import (
    Finding,
    look_at_camera,
    look_at_chosen_ports,
    look_at_packages,
    look_at_ports,
    look_at_reset,
    look_at_settings,
    look_at_speech,
    look_at_terminal,
    look_at_world,
)
from donnie_tui.cli.options import Invocation, Order
from donnie_tui.cli.streams import Output
from donnie_tui.i18n.words import Words
from donnie_tui.process.confinement import Confinement, confine
from donnie_tui.settings.settings import Settings, resolve
from tests.timeouts import TIMEOUT
from tests.unit.audio.known_environment import KnownEnvironment
from tests.unit.devices.pictures import GREEN, drawn, save
from tests.unit.i18n.sentences import CODES

YES_NO = (False, True)


def sentences(findings: list[Finding]) -> list[str]:
    words = Words()
    return [words(each.code, **each.values) for each in findings]


def all_facts() -> list[KnownEnvironment]:
    return [
        KnownEnvironment(terminal, ssh, reader, voice, device, ssip, linear, robot)
        for terminal, ssh, reader, voice, device, ssip, linear, robot in itertools.product(
            YES_NO, YES_NO, (None, "orca"), YES_NO, YES_NO, YES_NO, YES_NO, YES_NO
        )
    ]


def test_every_channel_has_a_sentence_and_every_problem_a_remedy(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(doctor, "look_at_worker", lambda _: iter(()))
    for facts, wish in itertools.product(all_facts(), SpeechOption):
        monkeypatch.setattr(doctor, "DetectedEnvironment", lambda facts=facts, **_: facts)
        for finding in look_at_speech(Settings(speech=wish.value), facts.is_linear):
            assert finding.code in CODES
            assert finding.is_well or f"{finding.code}-remedy" in CODES


def test_without_standard_input_there_is_no_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", None)

    assert next(look_at_terminal({}, None)).code == "doctor-no-terminal"


@pytest.mark.parametrize(
    ("encoding", "complaint"),
    [("utf-8", []), ("UTF8", []), ("utf-8-sig", []), ("ascii", ["ascii"]), (None, ["?"])],
)
def test_an_output_that_takes_not_all_letters_is_named(
    encoding: str | None, complaint: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stdout", SimpleNamespace(encoding=encoding, isatty=lambda: False))

    found = [each for each in look_at_terminal({}, None) if each.code == "doctor-encoding"]
    assert [each.values["encoding"] for each in found] == complaint


def test_every_place_of_speak_has_a_sentence() -> None:
    places = {
        choose_channel(wish, facts, place).speak
        for facts, wish, place in itertools.product(all_facts(), SpeechOption, SpeakPlace)
    }
    assert places == set(SpeakPlace)
    assert all(f"doctor-speak-{place.value}" in CODES for place in places)


def test_every_reason_for_the_mode_has_a_sentence() -> None:
    causes = ("option", "variable", "settings", "no-terminal", "simple-terminal", "visual")
    assert all(f"doctor-mode-{cause}" in CODES for cause in causes)


def test_a_missing_package_is_a_problem_with_a_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(doctor, "PACKAGES", ("textual", "no-such-package-at-all"))
    (finding,) = look_at_packages()
    assert (finding.code, finding.is_well) == ("doctor-package-missing", False)


def test_a_package_that_hides_one_of_donnies_packages_is_named(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    hiding = tmp_path / "sim"
    hiding.mkdir()
    (hiding / "__init__.py").touch()
    places = {"sim": hiding}
    own_place = doctor._place_of
    monkeypatch.setattr(doctor, "_place_of", lambda room: places.get(room) or own_place(room))
    findings = [each for each in look_at_packages() if not each.is_well]
    assert [each.values["name"] for each in findings] == ["sim"]
    assert str(tmp_path) in sentences(findings)[0]


def test_a_missing_device_is_reported_with_the_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(service, "AudioSettings", partial(service.AudioSettings, device=NO_DEVICE))
    monkeypatch.setattr(supervisor, "START_LIMIT", float(TIMEOUT))
    monkeypatch.setattr(doctor, "_WORKER_SECONDS", float(TIMEOUT))
    (finding,) = doctor.look_at_worker("en")
    assert (finding.code, finding.is_well) == ("doctor-no-player", False)
    assert f"{finding.code}-remedy" in CODES


def test_a_hanging_sound_server_is_not_reported_as_a_missing_device(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The devices are unknown until the server answers."""
    monkeypatch.setattr(AudioService, "warm_up", lambda _: None)
    monkeypatch.setattr(doctor, "_WORKER_SECONDS", 0.01)

    assert [each.code for each in doctor.look_at_worker("en")] == ["doctor-worker-hangs"]


@pytest.mark.parametrize("group", ["dialout", None])
def test_a_forbidden_port_is_reported_with_the_group_or_the_person_to_ask(
    monkeypatch: pytest.MonkeyPatch, group: str | None
) -> None:
    monkeypatch.setattr(os, "access", lambda *_: False)
    monkeypatch.setattr(devices.serial_ports, "group_of", lambda _: group)
    (finding,) = look_at_ports(lambda: (FoundPort("/dev/ttyS0", "/dev/ttyS0", True),))
    assert not finding.is_well
    remedy = Words()(f"{finding.code}-remedy", **finding.values)
    assert ("usermod -aG dialout" in remedy) == (group is not None)


@pytest.mark.parametrize("settings", [{"robot": "serial:/dev/nowhere9"}, {"belt": "/dev/nowhere9"}])
def test_a_chosen_port_without_a_device_is_reported(settings: dict[str, str]) -> None:
    (finding,) = look_at_chosen_ports(Settings(**settings), lambda: ())  # type: ignore[arg-type]
    assert not finding.is_well
    assert "/dev/nowhere9" in sentences([finding])[0]


def test_a_chosen_port_that_exists_or_is_an_address_is_fine(tmp_path: Path) -> None:
    port = tmp_path / "ttyACM0"
    port.touch()
    settings = Settings(robot=f"serial:{port}", belt="socket://belt:4000")
    assert list(look_at_chosen_ports(settings, lambda: ())) == []


def test_the_port_of_a_board_and_a_missing_port_are_reported(tmp_path: Path) -> None:
    port = tmp_path / "ttyACM0"
    port.touch()
    found = FoundPort(str(port), str(port), True)
    assert [each.code for each in look_at_ports(lambda: (found,))] == ["doctor-port-board"]
    assert [each.code for each in look_at_ports(lambda: ())] == ["doctor-no-ports"]


@pytest.mark.parametrize("fault", [None, *PinFault])
def test_the_pin_that_restarts_the_board_is_reported_with_its_remedy(fault: PinFault | None) -> None:
    class Pin(GpioReset):
        def fault(self) -> PinFault | None:
            return fault

    settings = Settings(robot="serial:/dev/ttyAMA0")
    (finding,) = look_at_reset(settings, lambda *_: Pin())
    assert finding.is_well is (fault is None)
    assert "GPIO22" in sentences([finding])[0]
    assert finding.is_well or f"{finding.code}-remedy" in CODES


def test_nothing_is_reported_of_a_robot_without_such_a_pin() -> None:
    assert not list(look_at_reset(Settings(robot="serial:/dev/ttyACM0")))
    assert not list(look_at_reset(Settings()))


def test_the_winning_source_of_a_setting_is_reported(tmp_path: Path) -> None:
    environment = {"DONNIE_RATE": "200", "XDG_CONFIG_HOME": str(tmp_path), "HOME": str(tmp_path)}
    settings, _ = resolve(
        {"speech": "off"}, environment, {"rate": "90", "theme": "light", "cues": "step-forward 0, bump 50"}
    )
    lines = sentences(list(look_at_settings(settings, environment)))
    assert "speech is off, from the command line." in lines
    assert "rate is 200, from DONNIE_RATE." in lines
    assert "theme is light, from the settings file." in lines
    assert "cues is step-forward 0, bump 50, from the settings file." in lines
    assert lines[0].startswith("No settings file yet")
    assert not any(line.startswith("world ") for line in lines)


def test_a_chosen_world_in_which_donnie_can_not_start_is_a_problem() -> None:
    settings, _ = resolve({}, {}, {"world": "mase", "allow": f"/a{os.pathsep}/b"})
    assert said(look_at_world(settings)) == [
        "Problem: Donnie can't start in the chosen world: There is no world mase. Did you mean maze?",
        "Remedy: choose another one, with --world or with world in the settings.",
    ]
    assert f"allow is /a{os.pathsep}/b, from the settings file." in said(look_at_settings(settings, {}))
    for world in ({}, {"world": "maze"}):
        assert said(look_at_world(resolve({}, {}, world)[0])) == []


def test_an_unreadable_settings_folder_has_no_file(tmp_path: Path) -> None:
    (finding,) = look_at_settings(Settings(), {"XDG_CONFIG_HOME": f"{tmp_path}/{'x' * 300}"})
    assert finding.code == "doctor-no-settings-file"


def test_the_doctor_changes_no_file_of_donnie() -> None:
    before = dict(os.environ)
    list(look_at_packages())
    assert dict(os.environ) == before


# --- the camera


def printed(finding: Finding) -> tuple[str, ...]:
    return doctor._lines(finding, Words())


def test_without_a_camera_nothing_is_said_of_it() -> None:
    assert list(look_at_camera(Settings())) == []


def test_a_camera_that_gives_a_picture_is_well(tmp_path: Path) -> None:
    save(tmp_path, {"seen.png": drawn((10, 10, 60, 60, GREEN))})
    (finding,) = look_at_camera(Settings(camera=str(tmp_path / "seen.png")))

    assert finding.is_well
    (line,) = printed(finding)
    assert line.startswith(f"The camera {tmp_path}/seen.png gives a picture. I look for: ")
    assert "green" in line


def test_a_camera_without_a_picture_is_a_problem_with_a_remedy(tmp_path: Path) -> None:
    (finding,) = look_at_camera(Settings(camera=str(tmp_path / "missing.png")))

    assert printed(finding) == (
        f"Problem: There is no picture {tmp_path}/missing.png.",
        "Remedy: look at its cable, and at camera in the settings. COLOR says 0.",
    )


def test_without_opencv_the_package_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    save(tmp_path, {"seen.png": drawn((10, 10, 60, 60, GREEN))})
    monkeypatch.setitem(sys.modules, "cv2", None)
    (finding,) = look_at_camera(Settings(camera=str(tmp_path / "seen.png")))

    assert 'pip install "donnie-tui[camera]"' in printed(finding)[0]
    assert printed(finding)[1] == "Remedy: until then COLOR says 0 on the real robot."


@pytest.mark.parametrize("is_settled", [True, False])
def test_the_worker_that_was_looked_at_is_closed(monkeypatch: pytest.MonkeyPatch, is_settled: bool) -> None:
    closed = list[AudioService]()
    monkeypatch.setattr(AudioService, "warm_up", lambda _: None)
    monkeypatch.setattr(AudioService, "wait_until_ready", lambda *_: is_settled)
    monkeypatch.setattr(AudioService, "close", lambda audio: closed.append(audio))

    assert [*doctor.look_at_worker("en")]

    assert len(closed) == 1


# --- each finding in words


def said(findings: Iterable[Finding]) -> list[str]:
    return [line for each in findings for line in printed(each)]


class Terminal(SimpleNamespace):
    encoding = "utf-8"

    def isatty(self) -> bool:
        return True


SMALL = "Problem: terminal vt220 is small: {}."
ENLARGE = "Remedy: enlarge the window, or use donnie --linear."


@pytest.mark.parametrize(
    ("size", "lines"),
    [
        ((40, 12), ["Terminal vt220, 40 columns, 12 rows."]),
        ((39, 12), [SMALL.format("39 columns, 12 rows"), ENLARGE]),
        ((40, 11), [SMALL.format("40 columns, 11 rows"), ENLARGE]),
    ],
)
def test_a_terminal_has_at_least_forty_columns_and_twelve_rows(
    size: tuple[int, int], lines: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stdin", Terminal())
    monkeypatch.setattr(sys, "stdout", Terminal())
    monkeypatch.setattr("shutil.get_terminal_size", lambda _otherwise: size)

    found = look_at_terminal({"TERM": "vt220", "NO_COLOR": "1"}, "option")
    assert said(found) == [*lines, "NO_COLOR is set: no colours.", "donnie starts linear, from the option."]
    assert said(look_at_terminal({}, None))[-1] == "donnie starts the full screen."
    monkeypatch.setattr(sys, "stdout", SimpleNamespace(encoding="utf-8", isatty=lambda: False))
    assert said(look_at_terminal({}, None))[0] == "This is no terminal."


def test_packages_without_which_donnie_prints_are_no_more_than_missed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    optional = ("miniaudio", "espeakng-loader", "pyttsx3")
    monkeypatch.setattr(doctor, "_version_of", lambda name: None if name in optional else "1")
    assert {each.code for each in look_at_packages()} == {"doctor-package-optional"}
    monkeypatch.setattr(doctor, "_version_of", lambda name: None if name not in optional else "1")
    assert [each.values["name"] for each in look_at_packages() if each.code == "doctor-package-missing"] == [
        *("textual", "rich", "lark", "pymunk", "pillow", "pyserial")
    ]
    monkeypatch.setattr(doctor, "_version_of", lambda _name: "1")
    assert said(look_at_packages()) == ["All 9 packages are installed."]


@pytest.mark.parametrize(("count", "end"), [(1, ": t0."), (20, ", t19."), (21, ", t19, ….")])
def test_what_a_language_lacks_is_named_up_to_twenty_texts(
    count: int, end: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(doctor, "mistakes", lambda: ("es/words.toml, line 3: no such key",))
    missing = {"pt": tuple(f"t{number}" for number in range(count))}
    monkeypatch.setattr(doctor, "missing_in", lambda language: missing.get(language, ()))

    first, wrong, correct, lacks, translate = said(doctor.look_at_languages("en"))
    assert first == "Languages: English, Portuguese, Spanish."
    assert wrong == "Problem: es/words.toml, line 3: no such key."
    assert correct == "Remedy: correct that line; until then English is used."
    assert lacks.startswith(f"Problem: Portuguese lacks {count} text")
    assert lacks.endswith(end)
    assert translate == "Remedy: translate them, see docs/translating.md."


@pytest.mark.parametrize(
    ("player", "voices", "lines"),
    [
        ("", ("en",), ["Problem: no sound device works."]),
        ("pulse", (), ["Sound goes through pulse.", "Problem: no voice works."]),
        (
            "pulse",
            ("en", "es"),
            [
                "Sound goes through pulse.",
                "There is a voice for English.",
                "Problem: no voice for Portuguese.",
                "There is a voice for Spanish.",
            ],
        ),
    ],
)
def test_the_sound_device_and_the_voice_of_each_language_are_named(
    player: str, voices: tuple[str, ...], lines: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(AudioService, "warm_up", lambda _: None)
    monkeypatch.setattr(AudioService, "wait_until_ready", lambda *_: True)
    monkeypatch.setattr(AudioService, "player", player)
    monkeypatch.setattr(AudioService, "languages", voices)

    found = said(doctor.look_at_worker("en"))
    assert [each for each in found if not each.startswith("Remedy")] == lines
    assert len(found) == len(lines) + sum(each.startswith("Problem") for each in lines)


def test_the_reader_the_connection_the_voice_and_the_cues_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    facts = KnownEnvironment(
        stdout_is_terminal=True, over_ssh=True, screen_reader="orca", has_voice=True, has_sound_device=True
    )
    asked: list[dict[str, bool]] = []
    monkeypatch.setattr(doctor, "look_at_worker", lambda spoken: [Finding("doctor-player", {"name": spoken})])
    monkeypatch.setattr(doctor, "DetectedEnvironment", lambda **how: asked.append(how) or facts)

    there = said(look_at_speech(Settings(speech="off", robot="serial:x", language="pt"), True))
    assert there[:4] == [
        *("Screen reader: orca.", "You are here over SSH.", "No speech-dispatcher answers."),
        "Donnie's answers are in print, as you chose.",
    ]
    assert there[-2] == "Sound goes through pt."
    assert asked == [{"is_linear": True, "has_real_robot": True}]
    facts = KnownEnvironment(True, False, None, True, True, has_ssip=True)
    here = said(look_at_speech(Settings(speech="off", sound=False), False))
    assert here[:2] == ["No screen reader was found; one may run elsewhere.", "speech-dispatcher answers."]
    assert here[-1] == "Sound cues are off."
    assert said(look_at_speech(Settings(speech="off"), False))[-1] == "Sound cues are on."
    assert asked[1:2] == [{"is_linear": False, "has_real_robot": False}]


def test_a_voice_that_was_asked_for_and_is_not_there_is_a_problem(monkeypatch: pytest.MonkeyPatch) -> None:
    facts = KnownEnvironment(True, False, None, False, False)
    monkeypatch.setattr(doctor, "look_at_worker", lambda _: ())
    monkeypatch.setattr(doctor, "DetectedEnvironment", lambda **_: facts)
    problems = {
        speech: sum(not each.is_well for each in look_at_speech(Settings(speech=speech), True))
        for speech in ("auto", "off", "text", "tts", "ssip")
    }
    assert problems == {"auto": 0, "off": 0, "text": 0, "tts": 1, "ssip": 1}


def test_own_sounds_are_named_with_those_that_can_not_be_used(tmp_path: Path) -> None:
    with wave.open(str(tmp_path / "bump.wav"), "wb") as file:
        file.setparams((1, 2, 22_050, 0, "NONE", ""))
        file.writeframes(b"\0\0" * 10)
    for name in ("turn", "quack"):
        (tmp_path / f"{name}.wav").write_bytes(b"RIFF")

    lines = said(doctor.look_at_own_sounds(tmp_path))
    assert lines[0] == "1 sound of your own: bump."
    assert "Problem: no cue is called quack.wav, so your sound is not used." in lines
    assert said(doctor.look_at_own_sounds(tmp_path / "none")) == []


def test_a_port_is_looked_for_where_the_settings_say_it_is(tmp_path: Path) -> None:
    port = tmp_path / "ttyACM0"
    port.touch()
    listed = FoundPort("/dev/of-no-machine", "/dev/of-no-machine", is_board=False)
    assert said(look_at_ports(lambda: (FoundPort(str(port), "name", is_board=False),))) == [
        "Serial port name can be used."
    ]
    assert not [*look_at_chosen_ports(Settings(belt="/dev/of-no-machine"), lambda: (listed,))]
    assert not [*look_at_chosen_ports(Settings(robot="player://h:1"), lambda: ())]
    assert said(look_at_chosen_ports(Settings(belt="/dev/" + "y" * 50), lambda: (listed,)))[0] == (
        f"Problem: nothing is plugged in at /dev/{'y' * 34}…, where belt looks."
    )


def test_settings_are_named_as_they_are_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    environment = {"XDG_CONFIG_HOME": str(tmp_path), "HOME": str(tmp_path), "DONNIE_MOUSE": "NO"}
    folder = tmp_path / "donnie"
    folder.mkdir()
    (folder / "settings.toml").touch()
    file = {"speed": "max", "linear": True, "trail": False, "record": "r" * 50}
    settings, _ = resolve({}, environment, file)
    monkeypatch.chdir(tmp_path)
    confine(Confinement(str(tmp_path)))
    try:
        lines = said(look_at_settings(settings, environment))
    finally:
        confine(None)
    assert lines == [
        f"All files stay in {tmp_path}.",
        f"Settings file: {folder}/settings.toml",
        "speed is max, from the settings file.",
        f"record is {'r' * 39}…, from the settings file.",
        "linear is on, from the settings file.",
        "mouse is NO, from DONNIE_MOUSE.",
        "trail is off, from the settings file.",
    ]


@pytest.mark.parametrize(("wrong", "last"), [(0, "All is well."), (1, "1 problem."), (2, "2 problems.")])
def test_the_last_line_says_how_much_is_wrong_and_the_command_succeeds(
    wrong: int, last: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[object] = []
    findings = [*[doctor.amiss("doctor-no-voice")] * wrong, doctor.well("doctor-no-ports")]
    monkeypatch.setattr(doctor, "examine", lambda *given: asked.append(given[2]) or findings)
    out = io.StringIO()
    made = Order(
        Invocation("doctor", {}, Namespace()), Settings(linear=True), Words(), Output(out, io.StringIO()), {}
    )

    assert doctor.doctor(made) == 0
    problem = ["Problem: no voice works.", "Remedy: install espeak-ng, or pip install espeakng-loader."]
    assert out.getvalue().splitlines() == [*problem * wrong, "No serial port is plugged in.", last]
    assert asked == ["settings"]
