"""``donnie doctor`` tells what works, what was chosen and why, and the remedy for what does not."""

from __future__ import annotations

import itertools
import os
import sys
from functools import partial
from pathlib import Path

import pytest

from devices import serial_port
from devices.audio_worker import service
from devices.audio_worker.service import AudioService
from devices.port_listing import FoundPort
from devices.reset_line import GpioReset, PinFault
from devices.sound.player import NO_DEVICE
from devices.speech.choose import Facts, SpeakPlace, SpeechWish, choose_channel
from donnie_tui.cli import examination
from donnie_tui.cli.examination import (
    Finding,
    look_at_chosen_ports,
    look_at_packages,
    look_at_ports,
    look_at_reset,
    look_at_settings,
    look_at_speech,
    look_at_terminal,
)
from donnie_tui.i18n.catalogue import SENTENCES
from donnie_tui.i18n.words import Words
from donnie_tui.settings.chosen import Settings, resolve

YES_NO = (False, True)


def told(findings: list[Finding]) -> list[str]:
    words = Words()
    return [words(each.code, **each.values) for each in findings]


def all_facts() -> list[Facts]:
    return [
        Facts(terminal, ssh, reader, voice, device, ssip, linear, robot)
        for terminal, ssh, reader, voice, device, ssip, linear, robot in itertools.product(
            YES_NO, YES_NO, (None, "orca"), YES_NO, YES_NO, YES_NO, YES_NO, YES_NO
        )
    ]


def test_every_choice_of_a_channel_has_a_sentence_and_every_problem_a_remedy(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(examination, "look_at_worker", lambda: iter(()))
    for facts, wish in itertools.product(all_facts(), SpeechWish):
        monkeypatch.setattr(examination, "look_around", lambda facts=facts, **_: facts)
        for finding in look_at_speech(Settings(speech=wish.value), facts.is_linear):
            assert finding.code in SENTENCES
            assert finding.is_well or f"{finding.code}-remedy" in SENTENCES


def test_without_standard_input_there_is_no_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", None)

    assert next(look_at_terminal({}, None)).code == "doctor-no-terminal"


def test_every_place_of_speak_has_a_sentence() -> None:
    places = {
        choose_channel(wish, facts, place).speak
        for facts, wish, place in itertools.product(all_facts(), SpeechWish, SpeakPlace)
    }
    assert places == set(SpeakPlace)
    assert all(f"doctor-speak-{place.value}" in SENTENCES for place in places)


def test_every_cause_of_the_mode_has_a_sentence() -> None:
    causes = ("option", "variable", "settings", "no-terminal", "simple-terminal", "visual")
    assert all(f"doctor-mode-{cause}" in SENTENCES for cause in causes)


def test_a_missing_package_is_a_problem_with_a_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(examination, "PACKAGES", ("textual", "no-such-package-at-all"))
    (finding,) = look_at_packages()
    assert (finding.code, finding.is_well) == ("doctor-package-missing", False)


def test_a_package_that_hides_one_of_our_rooms_is_named(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    hiding = tmp_path / "sim"
    hiding.mkdir()
    (hiding / "__init__.py").touch()
    places = {"sim": hiding}
    own_place = examination._place_of
    monkeypatch.setattr(examination, "_place_of", lambda room: places.get(room) or own_place(room))
    findings = [each for each in look_at_packages() if not each.is_well]
    assert [each.values["name"] for each in findings] == ["sim"]
    assert str(tmp_path) in told(findings)[0]


def test_a_device_that_is_missing_is_told_with_the_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(service, "AudioSettings", partial(service.AudioSettings, device=NO_DEVICE))
    (finding,) = examination.look_at_worker()
    assert (finding.code, finding.is_well) == ("doctor-no-player", False)
    assert f"{finding.code}-remedy" in SENTENCES


def test_a_sound_server_that_hangs_is_told_and_not_that_there_is_no_device(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """S6: what is there nobody knows until it answers."""
    monkeypatch.setattr(AudioService, "warm_up", lambda _: None)
    monkeypatch.setattr(examination, "_WORKER_SECONDS", 0.01)

    assert [each.code for each in examination.look_at_worker()] == ["doctor-worker-hangs"]


@pytest.mark.parametrize("group", ["dialout", None])
def test_a_port_that_we_may_not_use_names_the_group_or_who_to_ask(
    monkeypatch: pytest.MonkeyPatch, group: str | None
) -> None:
    monkeypatch.setattr(os, "access", lambda *_: False)
    monkeypatch.setattr(serial_port, "group_of", lambda _: group)
    (finding,) = look_at_ports(lambda: (FoundPort("/dev/ttyS0", "/dev/ttyS0", True),))
    assert not finding.is_well
    remedy = Words()(f"{finding.code}-remedy", **finding.values)
    assert ("usermod -aG dialout" in remedy) == (group is not None)


@pytest.mark.parametrize("settings", [{"robot": "serial:/dev/nowhere9"}, {"belt": "/dev/nowhere9"}])
def test_a_chosen_port_where_nothing_is_plugged_in_is_told(settings: dict[str, str]) -> None:
    (finding,) = look_at_chosen_ports(Settings(**settings), lambda: ())  # type: ignore[arg-type]
    assert not finding.is_well
    assert "/dev/nowhere9" in told([finding])[0]


def test_a_chosen_port_that_is_there_or_is_an_address_is_well(tmp_path: Path) -> None:
    port = tmp_path / "ttyACM0"
    port.touch()
    settings = Settings(robot=f"serial:{port}", belt="socket://belt:4000")
    assert list(look_at_chosen_ports(settings, lambda: ())) == []


def test_a_port_of_a_board_and_no_port_at_all_are_told(tmp_path: Path) -> None:
    port = tmp_path / "ttyACM0"
    port.touch()
    found = FoundPort(str(port), str(port), True)
    assert [each.code for each in look_at_ports(lambda: (found,))] == ["doctor-port-board"]
    assert [each.code for each in look_at_ports(lambda: ())] == ["doctor-no-ports"]


@pytest.mark.parametrize("fault", [None, *PinFault])
def test_the_pin_that_restarts_the_board_is_told_with_its_remedy(fault: PinFault | None) -> None:
    class Pin(GpioReset):
        def fault(self) -> PinFault | None:
            return fault

    settings = Settings(robot="serial:/dev/ttyAMA0")
    (finding,) = look_at_reset(settings, lambda *_: Pin())
    assert finding.is_well is (fault is None)
    assert "GPIO22" in told([finding])[0]
    assert finding.is_well or f"{finding.code}-remedy" in SENTENCES


def test_of_a_robot_without_such_a_pin_nothing_is_told() -> None:
    assert not list(look_at_reset(Settings(robot="serial:/dev/ttyACM0")))
    assert not list(look_at_reset(Settings()))


def test_it_is_told_which_source_of_a_setting_won(tmp_path: Path) -> None:
    environment = {"DONNIE_RATE": "200", "XDG_CONFIG_HOME": str(tmp_path), "HOME": str(tmp_path)}
    settings, _ = resolve(
        {"speech": "off"}, environment, {"rate": "90", "theme": "light", "cues": "step-forward 0, bump 50"}
    )
    lines = told(list(look_at_settings(settings, environment)))
    assert "speech is off, from the command line." in lines
    assert "rate is 200, from DONNIE_RATE." in lines
    assert "theme is light, from the settings file." in lines
    assert "cues is step-forward 0, bump 50, from the settings file." in lines
    assert lines[0].startswith("No settings file yet")
    assert not any(line.startswith("world ") for line in lines)


def test_a_settings_folder_that_nobody_may_look_into_has_no_file(tmp_path: Path) -> None:
    (finding,) = look_at_settings(Settings(), {"XDG_CONFIG_HOME": f"{tmp_path}/{'x' * 300}"})
    assert finding.code == "doctor-no-settings-file"


def test_nothing_of_ours_changes_by_looking() -> None:
    before = dict(os.environ)
    list(look_at_packages())
    assert dict(os.environ) == before
