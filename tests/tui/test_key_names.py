"""Keys have the names that are printed on the learner's keyboard."""

import re

import pytest

from donnie_tui.commands.keys import KEYS, MENU, PALETTE, KeyTable, key_label
from tests.conftest import ROOT


@pytest.mark.parametrize(
    ("key", "en", "pt", "es"),
    [
        ("f5", "F5", "F5", "F5"),
        ("ctrl+s", "Ctrl+S", "Ctrl+S", "Ctrl+S"),
        ("escape", "Esc", "Esc", "Esc"),
        ("ctrl+k shift+a", "Ctrl+K Shift+A", "Ctrl+K Shift+A", "Ctrl+K Mayús+A"),
        ("ctrl+@", "Ctrl+Space", "Ctrl+Espaço", "Ctrl+Espacio"),
        ("alt+up", "Alt+Up", "Alt+Seta acima", "Alt+Arriba"),
        ("ctrl+pagedown", "Ctrl+Page Down", "Ctrl+Page Down", "Ctrl+Av Pág"),
        ("shift+delete", "Shift+Delete", "Shift+Delete", "Mayús+Supr"),
        ("ctrl+k full_stop", "Ctrl+K .", "Ctrl+K .", "Ctrl+K ."),
    ],
)
def test_keys_have_the_names_that_the_learners_keyboard_has(key: str, en: str, pt: str, es: str) -> None:
    assert tuple(key_label(key, each) for each in ("en", "pt", "es")) == (en, pt, es)


def test_no_key_of_the_spanish_help_has_an_english_name() -> None:
    names = [KeyTable().labels(name, "es") for name in KEYS]

    assert any("Mayús+" in each for each in names)
    assert not any(english in each for each in names for english in ("Shift", "Space", "Page"))


@pytest.mark.parametrize(
    ("language", "page"),
    [("en", "full-screen.md"), ("pt", "pt/tela-cheia.md"), ("es", "es/pantalla-completa.md")],
)
def test_the_page_about_the_full_screen_names_keys_that_exist(language: str, page: str) -> None:
    text = (ROOT / "docs" / page).read_text(encoding="utf-8")
    named = set(re.findall(r"Ctrl\+K (?:(?:Shift|Mayús)\+)?[A-Z0-9]+\b|Ctrl\+\w+|\bF\d+\b", text))
    declared = {key_label(key, language) for keys in KEYS.values() for key in keys}

    assert len(named) > 20
    assert sorted(named - declared) == sorted(key_label(key, language) for key in (MENU, PALETTE))
