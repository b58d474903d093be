"""SET, LANGUAGE, DETAIL and the switches, in words of any language."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from language.locales import languages
from tests.unit.commands.scripted import Script

OpenScript = Callable[..., Script]


@pytest.mark.parametrize(
    ("typed", "answer"),
    [
        ("FEEL sí", "I will say what the belt shows."),
        ("SET wait ligado", "Set wait: on."),
        ("LANGUAGE inglés", "Language: English."),
        ("LANGUAGE espanhol", "Idioma: español."),
        ("DETAIL cheio", "Detail: full."),
        ("SET nonsense 3", "No setting is called nonsense. SET lists them."),
        ("SET spech off", "I do not know spech. Did you mean speech?"),
    ],
)
def test_words_of_any_language_switch_and_choose(open_script: OpenScript, typed: str, answer: str) -> None:
    assert open_script().answers_to(typed) == [answer]


def test_each_cue_has_a_volume_of_its_own_that_is_chosen_from_a_list(
    open_script: OpenScript, tmp_path: Path
) -> None:
    script = open_script(answers=["bump", "0", None])
    script.type("SET cue")

    assert "bump: A collision. Volume 100." in script.interaction.asked
    assert "bump: A collision. Off." in script.interaction.asked
    assert "Set cue bump: off." in script.printed
    assert script.answers_to("SET cue open 40") == ["Set cue open: 40."]
    assert script.donnie.outlets.audible.settings.cues == {"bump": 0, "block-opened": 40}
    assert 'cues = "bump 0, block-opened 40"' in (tmp_path / "donnie" / "settings.toml").read_text()


def test_the_names_of_the_cues_are_printed_where_sound_is_off(open_script: OpenScript) -> None:
    lines = open_script().answers_to("CUES")

    assert lines[0].startswith("Sounds are off here.")
    assert {"forward: A step forward.", "close: A block ends."} <= set(lines)


@pytest.mark.parametrize(
    ("typed", "answers", "changed"),
    [
        ("LANGUAGE pt", ["Idioma: português."], ["lang"]),
        ("LANGUAGE", ["Language: English."], []),
        ("FEEL", ["Belt: nothing near."], []),
        ("FEEL up", ["I did not understand. Type FEEL on."], []),
        ("LANGUAGE xx", ["Language: English.", f"Choose: {', '.join(languages())}."], []),
        ("DETAIL", ["Detail: normal."], []),
        ("DETAIL brief", ["Detail: brief."], ["verbosity"]),
        ("DETAIL x", ["Detail: normal.", "Choose: brief, normal, full."], []),
        ("SET page ask", ["Long answers, page: ask."], ["page"]),
        ("SET page", ["Long answers, page: rest.", "Choose: rest, ask, off."], []),
        ("SET page never", ["Long answers, page: rest.", "Choose: rest, ask, off."], []),
        ("SET volume 50", ["Set volume: 50."], ["volume"]),
        ("SET nothing 1", ["No setting is called nothing. SET lists them."], []),
        ("SET speech off", ["Set speech: off."], ["speech"]),
        ("SET sound on", ["Sound: on."], ["sound"]),
        ("SET speed 3", ["Speed: 3."], ["speed"]),
        ("SET keys", ["Only in the full screen: type VISUAL."], []),
    ],
)
def test_a_setting_is_changed_or_what_it_can_be_is_said(
    open_script: OpenScript, typed: str, answers: list[str], changed: list[str]
) -> None:
    script = open_script()

    assert script.answers_to(typed) == answers
    assert script.interaction.changed == changed


def test_all_settings_are_listed_with_their_values(open_script: OpenScript) -> None:
    assert open_script().answers_to("SET") == [
        *("Long answers, page: rest.", "Start of the line, prompt: short.", "Wait at each line, hold: off."),
        *("Typing, editor: own.", "Enter key, enter: waits.", "Progress reports, progress: 10 seconds."),
        *("Directions as a clock, clock: off.", "Free squares, free: dot."),
        *("Set speech: off.", "Set speak: here.", "Set rate: 180.", "Set pitch: 50.", "Set volume: 100."),
        *("Set punctuation: some.", "Set echo: none.", "Set wait: off."),
    ]


@pytest.mark.parametrize(
    ("typed", "options", "current"),
    [
        ("LANGUAGE", languages(), "en"),
        ("DETAIL", ("brief", "normal", "full"), "normal"),
        ("SET clock", ("on", "off"), "off"),
        ("SET enter", ("waits", "runs"), "waits"),
        ("SET cue bump", ("100", "75", "50", "25", "0"), "100"),
    ],
)
def test_the_present_value_is_marked_in_the_list(
    open_script: OpenScript, typed: str, options: tuple[str, ...], current: str
) -> None:
    script = open_script()
    script.type(typed)

    offered = script.interaction.offered
    assert tuple(each.value for each in offered) == options
    assert [each.value for each in offered if each.is_current] == [current]


LONG_NAME = 50 * "z"


@pytest.mark.parametrize(
    ("typed", "answers"),
    [
        ("SET cue zzz", ["No sound zzz. CUES lists all."]),
        (f"SET cue {LONG_NAME}", [f"No sound {39 * 'z'}…. CUES lists all."]),
        (f"CUES {LONG_NAME}", [f"No sound {39 * 'z'}…. CUES lists all."]),
        (f"SET {LONG_NAME}", [f"No setting is called {39 * 'z'}…. SET lists them."]),
        ("SET cue bump loud", ["Set cue bump: 100.", "Choose a number, 0 to 100."]),
        ("SET cue bump 101", ["Set cue bump: 100."]),
        ("SET cue bump on", ["Set cue bump: 100."]),
        ("SET cue bump off", ["Set cue bump: off."]),
        ("SET cue bump 60", ["Set cue bump: 60."]),
        ("SET speed max", ["Speed: max."]),
        ("SET speed", ["Speed: max."]),
        ("SET speed 0.01", ["Speed: max.", "A number from 0.1 to 1000, or max:"]),
        ("SET free x", ["Free squares, free: x."]),
        ("SET free", ["Free squares, free: dot.", "Choose: dot, f."]),
        ("SET prompt word", ["Start of the line, prompt: word."]),
        ("SET hold on", ["Wait at each line, hold: on."]),
        ("SET progress 0", ["Progress reports, progress: never."]),
        ("SET progress 30", ["Progress reports, progress: 30 seconds."]),
        ("SET plain on", ["Only in the full screen: type VISUAL."]),
        ("SET sound off", ["Sound: off."]),
        ("SET speech off", ["Set speech: off."]),
        ("SET speak robot", ["Set speak: robot."]),
        ("SET lang pt", ["Idioma: português."]),
    ],
)
def test_each_setting_has_its_answer(open_script: OpenScript, typed: str, answers: list[str]) -> None:
    assert open_script().answers_to(typed) == answers


@pytest.mark.parametrize("is_attended", [True, False])
def test_a_change_by_a_learner_is_kept_and_one_by_a_file_is_not(
    open_script: OpenScript, tmp_path: Path, is_attended: bool
) -> None:
    script = open_script(speed=2.0)
    script.interaction.is_attended = is_attended
    for typed in ("SET volume 30", "SET speed max", "SET clock on", "SET cue bump 60", "LANGUAGE pt"):
        script.type(typed)

    kept = tmp_path / "donnie" / "settings.toml"
    written = ["volume = 30", 'speed = "max"', 'clock = "on"', 'cues = "bump 60"', 'lang = "pt"']
    assert (kept.read_text().splitlines() if kept.exists() else []) == (written if is_attended else [])
    assert (script.donnie.session.speed, script.ctx.words.language) == (None, "pt")
    assert script.interaction.changed == ["volume", "speed", "clock", "cues", "lang"]
    assert script.donnie.outlets.audible.settings.volume == 30


def test_directions_are_those_of_a_clock_only_where_no_side_is_named(open_script: OpenScript) -> None:
    script = open_script()
    hours = [f"{hour} o'clock: free, 10 steps." for hour in (12, 3, 6, 9)]

    assert script.answers_to("SET clock on", "AROUND")[1:] == ["There is nothing within 10 steps.", *hours]
    assert not {*script.answers_to("AROUND north")} & {*hours}


@pytest.mark.parametrize(
    ("typed", "is_about_channels"),
    [
        ("SET speech off", True),
        ("SET speak robot", True),
        ("SET sound off", True),
        ("SET volume 30", False),
        ("SET clock on", False),
    ],
)
def test_what_is_missing_of_the_voice_is_said_when_its_channel_changes(
    open_script: OpenScript, monkeypatch: pytest.MonkeyPatch, typed: str, is_about_channels: bool
) -> None:
    script = open_script()
    outlets = script.donnie.outlets
    monkeypatch.setattr(
        type(outlets),
        "adjust_sound",
        lambda self, **_: setattr(self.audible, "notices", ("There is no voice here.",)),
    )

    assert script.answers_to(typed)[1:] == ["There is no voice here."] * is_about_channels
