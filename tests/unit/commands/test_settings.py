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
