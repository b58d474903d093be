"""``donnie calibrate colour``: a person shows things to the camera, and says what is to be replaced."""

from __future__ import annotations

import io
import sys
from argparse import Namespace
from pathlib import Path

import numpy as np
import pytest

from donnie_tui.cli.calibrate import calibrate
from donnie_tui.cli.options import ExitCode, Invocation, Order
from donnie_tui.cli.streams import Output
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets.audible import Audible
from donnie_tui.settings.folders import account_settings_file
from donnie_tui.settings.parsing import read_file
from donnie_tui.settings.settings import Settings, resolve
from tests.unit.devices.pictures import drawn, save

PINK_RED, GREEN, BLUE, YELLOW = (230, 20, 90), (20, 160, 40), (20, 60, 200), (230, 220, 0)


def held(colour: tuple[int, int, int]) -> np.ndarray:
    return drawn((150, 100, 500, 400, colour))


class Calibration:
    """One start of the command in a folder of its own, with a folder of pictures as its camera."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.environment = {"XDG_CONFIG_HOME": str(folder / "config"), "HOME": str(folder)}
        self.pictures = folder / "pictures"
        self.pictures.mkdir()
        self._monkeypatch = monkeypatch

    def run(self, typed: str, language: str = "en", what: str = "colour", **settings: object) -> int:
        self._monkeypatch.setattr(sys, "stdin", io.StringIO(typed))
        given = {"camera": str(self.pictures), "speech": "off", "sound": False, **settings}
        order = Order(
            Invocation("calibrate", {}, Namespace(what=what)),
            Settings(**given),  # type: ignore[arg-type]
            Words(language),
            Output(),
            self.environment,
        )
        return calibrate(order)

    @property
    def kept(self) -> object:
        return resolve({}, {}, read_file(account_settings_file(self.environment))[0])[0].colours


@pytest.fixture
def calibration(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Calibration:
    return Calibration(tmp_path, monkeypatch)


def test_the_measured_colours_are_kept_once_the_person_agrees(
    calibration: Calibration, capsys: pytest.CaptureFixture[str]
) -> None:
    save(calibration.pictures, {"1.png": held(PINK_RED), "2.png": held(GREEN), "3.png": held(BLUE)})

    assert calibration.run("\nyes\n\nno\n\nyes\n") == ExitCode.DONE

    said = capsys.readouterr().out.splitlines()
    show = "Show the camera something {}, close and in the middle. Enter measures it, NO skips it."
    assert said[:2] == ["I will measure colors. Use the light of the lesson.", show.format("red")]
    # pure hues: (230, 20, 90) is 170, (20, 160, 40) is 64, (20, 60, 200) is 113 of 180
    assert said[2].startswith("Measured red: hue 164 to 176, saturation from ")
    assert said[2].endswith("I see 1 thing of that color.")
    assert said[3] == "Replace what counts as red now? Yes or no."
    assert show.format("green") in said
    assert not any("Some of it counts as red" in each for each in said)
    assert said[-1] == "I saved it in the settings."
    kept = calibration.kept
    assert isinstance(kept, dict)
    assert [kept[each][:2] for each in ("red", "green", "blue")] == [(164, 176), (56, 99), (107, 119)]


def test_what_is_skipped_or_refused_changes_nothing(
    calibration: Calibration, capsys: pytest.CaptureFixture[str]
) -> None:
    save(calibration.pictures, {"1.png": held(PINK_RED)})

    assert calibration.run("no\n\nno\nno\n") == ExitCode.FAILED

    assert capsys.readouterr().out.splitlines()[-1] == "Nothing was measured. Nothing has changed."
    assert calibration.kept is None


def test_an_answer_that_is_none_is_asked_again(
    calibration: Calibration, capsys: pytest.CaptureFixture[str]
) -> None:
    save(calibration.pictures, {"1.png": held(PINK_RED)})

    assert calibration.run("\nperhaps\nyes\n") == ExitCode.DONE
    assert capsys.readouterr().out.count("Replace what counts as red now?") == 2


def test_without_one_colour_in_the_middle_it_asks_for_another_look(
    calibration: Calibration, capsys: pytest.CaptureFixture[str]
) -> None:
    save(calibration.pictures, {"1.png": drawn(), "2.png": held(PINK_RED)})

    assert calibration.run("\n\nyes\n") == ExitCode.DONE
    assert "I see no single color in the middle." in capsys.readouterr().out


def test_only_enter_alone_measures(calibration: Calibration, capsys: pytest.CaptureFixture[str]) -> None:
    save(calibration.pictures, {"1.png": held(PINK_RED)})

    assert calibration.run("yes\nred\nno\n") == ExitCode.FAILED

    said = capsys.readouterr().out
    assert said.count("Show the camera something red") == 3
    assert "Measured" not in said


def test_an_overlap_with_another_colour_is_named(
    calibration: Calibration, capsys: pytest.CaptureFixture[str]
) -> None:
    """The blue thing is shown where red is asked for."""
    save(calibration.pictures, {"1.png": held(BLUE)})

    assert calibration.run("\nno\n") == ExitCode.FAILED
    assert "Some of it counts as blue too." in capsys.readouterr().out.splitlines()


def test_the_colours_of_the_settings_are_those_that_are_measured(
    calibration: Calibration, capsys: pytest.CaptureFixture[str]
) -> None:
    save(calibration.pictures, {"1.png": held(YELLOW)})
    before = {"yellow": (1, 2, 3, 4, 5, 6)}

    assert calibration.run("\nsim\n", language="pt", colours=before) == ExitCode.DONE

    said = capsys.readouterr().out
    assert "Mostre à câmera um objeto amarelo" in said
    kept = calibration.kept
    assert isinstance(kept, dict)
    assert (list(kept), kept["yellow"][:2]) == (["yellow"], (23, 35))


def test_a_sentence_is_spoken_too(calibration: Calibration, monkeypatch: pytest.MonkeyPatch) -> None:
    spoken: list[str] = []
    monkeypatch.setattr(Audible, "say_printed", lambda self, *lines: spoken.extend(lines))
    save(calibration.pictures, {"1.png": held(PINK_RED)})

    calibration.run("no\nno\nno\n")

    assert spoken[0] == "I will measure colors. Use the light of the lesson."
    assert spoken[-1] == "Nothing was measured. Nothing has changed."


@pytest.mark.parametrize(
    ("settings", "sentence"),
    [
        ({"camera": None}, "Name the camera: donnie calibrate colour --camera 0."),
        ({}, "There is no picture to see in {}."),
        ({"camera": "/dev/video-of-no-machine"}, "Nothing is plugged in at /dev/video-of-no-machine."),
    ],
)
def test_without_a_camera_that_works_nothing_is_asked(
    settings: dict[str, object], sentence: str, calibration: Calibration
) -> None:
    with pytest.raises(Unusable) as caught:
        calibration.run("\n", **settings)

    assert caught.value.sentence.startswith(sentence.format(calibration.pictures))
    assert calibration.kept is None


@pytest.mark.parametrize("what", ["color", "Cor", "COLOUR"])
def test_the_end_of_the_input_ends_the_calibration(
    what: str, calibration: Calibration, capsys: pytest.CaptureFixture[str]
) -> None:
    save(calibration.pictures, {"1.png": held(PINK_RED)})
    assert calibration.run("", what=what) == ExitCode.FAILED

    assert capsys.readouterr().out.count("Show the camera") == 1


def test_an_end_instead_of_an_answer_replaces_nothing(
    calibration: Calibration, capsys: pytest.CaptureFixture[str]
) -> None:
    save(calibration.pictures, {"1.png": held(PINK_RED)})

    assert calibration.run("\n") == ExitCode.FAILED
    said = capsys.readouterr().out
    assert (said.count("Show the camera"), said.count("Replace what counts")) == (1, 1)


class Interrupted(io.StringIO):
    def readline(self, _size: int | None = -1) -> str:
        raise KeyboardInterrupt


def test_control_c_ends_it_with_a_sentence(
    calibration: Calibration, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    save(calibration.pictures, {"1.png": held(PINK_RED)})
    monkeypatch.setattr(io, "StringIO", Interrupted)
    with pytest.raises(KeyboardInterrupt):
        calibration.run("")
    assert capsys.readouterr().out.splitlines()[-1] == "I have stopped here. Nothing has changed."


def test_another_word_is_not_understood(calibration: Calibration) -> None:
    with pytest.raises(Unusable) as caught:
        calibration.run("", what="w" * 50)
    assert caught.value.sentence.startswith(f"I do not understand {'w' * 39}….")
