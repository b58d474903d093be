"""A language is a folder; what is missing in it is English."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from language import locales
from language.locales import language_of_locale, languages, words


@pytest.fixture
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An empty folder for languages of one's own, which is looked through anew."""
    monkeypatch.setenv(locales.SEARCH_PATH, str(tmp_path))
    locales.forget()
    yield tmp_path
    monkeypatch.undo()
    locales.forget()


def test_english_comes_first_and_portuguese_before_spanish() -> None:
    built_in = [each for each in languages() if each in ("en", "pt", "es")]

    assert languages()[0] == "en"
    assert built_in == ["en", "pt", "es"]


def test_a_folder_makes_a_language(own_folder: Path) -> None:
    built_in = languages()
    locales.forget()
    (own_folder / "zz").mkdir()
    (own_folder / ".git").mkdir()
    (own_folder / "README.md").touch()

    assert languages() == (*built_in, "zz")


def test_a_folder_of_ones_own_replaces_the_built_in_language(own_folder: Path) -> None:
    (own_folder / "pt").mkdir()
    (own_folder / "pt" / "commands.toml").write_text('run = ["CORRER"]\n')

    assert words("pt", "commands", "run") == ("CORRER",)


def test_a_missing_word_is_the_english_one(own_folder: Path) -> None:
    (own_folder / "eu").mkdir()
    (own_folder / "eu" / "keywords.toml").write_text('[keywords]\nFW = ["AURRERA"]\nBW = []\nTR = 5\n')

    found = [words("eu", "keywords", "keywords", each) for each in ("FW", "BW", "TR", "TL")]
    assert found == [("AURRERA",), ("BW",), ("TR",), ("TL",)]


@pytest.mark.parametrize("text", [b"run = [", b"\xff\xfe", b"run = 'STOP'"])
def test_a_table_that_cannot_be_read_is_as_if_it_were_missing(own_folder: Path, text: bytes) -> None:
    (own_folder / "eu").mkdir()
    (own_folder / "eu" / "commands.toml").write_bytes(text)

    assert words("eu", "commands", "run") == ("RUN",)


def test_a_word_that_english_lacks_is_a_mistake_of_the_caller() -> None:
    with pytest.raises(KeyError):
        words("pt", "commands", "no-such-command")


@pytest.mark.parametrize(
    ("locale", "language"),
    [("pt_BR.UTF-8", "pt"), ("es", "es"), ("en_GB", "en"), ("de_DE.UTF-8", None), ("C", None), ("", None)],
)
def test_a_locale_names_a_language(locale: str, language: str | None) -> None:
    assert language_of_locale(locale) == language
