"""A language is a folder; what is missing in it is English."""

import os
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


def test_the_first_folder_that_has_a_language_is_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("one", "two"):
        (tmp_path / name / "eu").mkdir(parents=True)
    places = f"{tmp_path / 'one'}{os.pathsep}{os.pathsep}{tmp_path / 'two'}"
    monkeypatch.setenv(locales.SEARCH_PATH, places)
    locales.forget()

    assert locales.folders()["eu"] == f"{tmp_path / 'one'}/eu"
    monkeypatch.undo()
    locales.forget()


@pytest.mark.parametrize(
    ("name", "is_one"), [("pt-br", True), ("PT", False), ("pt_br", False), ("a.b", False)]
)
def test_the_code_of_a_language_is_small_letters(own_folder: Path, name: str, is_one: bool) -> None:
    (own_folder / name).mkdir()

    assert (name in languages()) is is_one


def test_a_language_of_ones_own_is_behind_the_ones_with_a_rank(own_folder: Path) -> None:
    for name, rank in (("ab", ""), ("zz", "rank = 0\n"), ("ba", 'rank = "first"\n'), ("ac", "rank = 999\n")):
        (own_folder / name).mkdir()
        (own_folder / name / "keywords.toml").write_text(rank)

    assert languages()[0] == "zz"
    assert languages()[-3:] == ("ac", "ab", "ba")


def test_what_is_compiled_is_used_where_the_source_is_not_newer(own_folder: Path) -> None:
    folder = own_folder / "eu"
    (folder / "compiled").mkdir(parents=True)
    (folder / "compiled" / "commands.json").write_text('{"run": ["BAI"]}')
    source = folder / "commands.toml"

    assert locales.compiled_file("eu", "commands.toml", "commands.json") == f"{folder}/compiled/commands.json"
    assert words("eu", "commands", "run") == ("BAI",)  # as in a wheel, which has no source

    source.write_text('run = ["JOAN"]')
    made = (folder / "compiled" / "commands.json").stat().st_mtime_ns
    os.utime(source, ns=(made, made))
    assert locales.compiled_file("eu", "commands.toml", "commands.json") is not None

    os.utime(source, ns=(made + 1, made + 1))
    assert locales.compiled_file("eu", "commands.toml", "commands.json") is None
    locales.forget()
    assert words("eu", "commands", "run") == ("JOAN",)


@pytest.mark.parametrize(
    "content",
    ["", "[1]", '{"run": ', '{"run": 1.5', '{"run": {"a": {"b": {"c": {"d": 1}}}}}', '{"run": [["BAI"]]}'],
)
def test_a_compiled_table_that_cannot_be_read_is_as_if_it_were_missing(
    own_folder: Path, content: str
) -> None:
    (own_folder / "eu" / "compiled").mkdir(parents=True)
    (own_folder / "eu" / "compiled" / "commands.json").write_text(content)

    assert locales.table("eu", "commands") == {}
    assert words("eu", "commands", "run") == ("RUN",)


def test_a_compiled_table_has_sections_in_sections(own_folder: Path) -> None:
    (own_folder / "eu" / "compiled").mkdir(parents=True)
    (own_folder / "eu" / "compiled" / "words.json").write_text(
        '{"a": {"b": {"c": ["BAI"], "d": 1}}, "e": null}'
    )

    assert locales.own_words("eu", "words", "a", "b", "c") == ("BAI",)
    assert locales.keys("eu", "words", "a", "b") == ("c", "d")
    assert locales.table("eu", "words")["e"] is None


def test_a_table_is_read_once_until_the_languages_are_looked_for_anew(own_folder: Path) -> None:
    file = own_folder / "eu" / "commands.toml"
    file.parent.mkdir()
    file.write_text('run = ["BAI"]')
    assert words("eu", "commands", "run") == ("BAI",)

    file.write_text('run = ["JOAN"]')
    (own_folder / "ab").mkdir()
    assert words("eu", "commands", "run") == ("BAI",)
    assert "ab" not in languages()

    locales.forget()
    assert words("eu", "commands", "run") == ("JOAN",)
    assert "ab" in languages()


def test_a_locale_with_a_country_is_a_language_of_its_own_if_there_is_one(own_folder: Path) -> None:
    (own_folder / "pt-br").mkdir()

    assert language_of_locale("pt_BR.UTF-8") == "pt-br"
    assert language_of_locale("pt_PT.UTF-8") == "pt"


def test_a_folder_that_is_missing_has_no_languages(own_folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    built_in = languages()
    monkeypatch.setenv(locales.SEARCH_PATH, f"{own_folder / 'none'}{os.pathsep}{own_folder}")
    locales.forget()

    assert languages() == built_in
    assert locales.search_path() == [str(own_folder / "none"), str(own_folder)]


def test_a_file_of_a_language_has_a_million_bytes_at_most(tmp_path: Path) -> None:
    file = tmp_path / "words.toml"
    file.write_bytes(b"#" * 1_000_000)
    assert len(locales.content_of(str(file))) == 1_000_000

    file.write_bytes(b"#" * 1_000_001)
    with pytest.raises(ValueError, match="more than 1000000 bytes"):
        locales.content_of(str(file))


def test_a_line_of_toml_has_two_hundred_dots_at_most() -> None:
    assert locales.toml_in("a = 1\n# " + "." * 200) == {"a": 1}

    with pytest.raises(ValueError, match=r"too many dots \(at line 2, column 1\)"):
        locales.toml_in("a = 1\n# " + "." * 201)


def test_the_keys_and_the_words_of_an_entry(own_folder: Path) -> None:
    (own_folder / "eu").mkdir()
    (own_folder / "eu" / "words.toml").write_text(
        '[values.speech]\non = ["BAI"]\noff = ["EZ", 1]\nall = "DENA"\n'
    )

    assert locales.keys("eu", "words", "values", "speech") == ("on", "off", "all")
    assert locales.keys("eu", "words", "values", "speech", "on") == ()
    assert locales.keys("eu", "words", "nothing") == ()
    own = [locales.own_words("eu", "words", "values", "speech", each) for each in ("on", "off", "all")]
    assert own == [("BAI",), (), ()]
    assert locales.own_words("eu", "words", "values", "speech", "on", "off") == ()


def test_the_document_for_beginners_is_that_of_the_language_or_the_english_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(locales, "DOCUMENTS", (str(tmp_path / "wheel"), str(tmp_path / "docs")))
    assert locales.first_page("pt") == ""

    for place in ("docs/en", "docs/pt", "wheel/en"):
        (tmp_path / place).mkdir(parents=True)
        (tmp_path / place / "README.md").touch()

    assert locales.first_page("pt") == f"{tmp_path}/docs/pt/README.md"
    assert locales.first_page("es") == f"{tmp_path}/wheel/en/README.md"
