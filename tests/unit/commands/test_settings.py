"""SET, LANGUAGE, DETAIL and the switches, in words of any language."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

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
        ("LANGUAGE xx", ["I did not understand. Type LANGUAGE pt."], []),
        ("DETAIL", ["Detail: normal."], []),
        ("DETAIL brief", ["Detail: brief."], ["verbosity"]),
        ("DETAIL x", ["I did not understand. Type DETAIL brief."], []),
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
