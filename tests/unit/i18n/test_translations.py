"""What translators edit is checked: each mistake has its file and its line, and is no danger to a session."""

import os
import re
import shutil
import struct
import subprocess
import sys
from collections.abc import Iterator
from gettext import GNUTranslations
from io import BytesIO
from pathlib import Path

import pytest

from donnie_tui.i18n import first_words, po, translations, words
from donnie_tui.i18n.po import Entry, Mistake
from donnie_tui.i18n.translations import ambiguous_keywords, compile_all, main, missing_in, mistakes
from donnie_tui.i18n.words import find
from language import locales
from language.locales import BUILT_IN, ENGLISH, languages
from tests.unit.i18n.pseudo_language import CODE, accented, pseudo, write_language

HEADER = 'msgid ""\nmsgstr ""\n"Plural-Forms: nplurals=2; plural=(n != 1);\\n"\n\n'


@pytest.fixture
def added(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """The folder of a language that is added."""
    folder = write_language(tmp_path)
    monkeypatch.setenv(locales.SEARCH_PATH, str(tmp_path))
    _forget()
    yield folder
    monkeypatch.undo()
    _forget()


def _forget() -> None:
    locales.forget()
    for each in (words._translations, words.codes, words._plural_rule, words._decimal_sign):
        each.cache_clear()


def entries_of(text: str, folder: Path) -> tuple[Path, tuple[Entry, ...]]:
    file = folder / "messages.po"
    file.write_text(text, encoding="utf-8")
    return file, po.read(file)


def test_a_mistake_in_an_english_table_is_reported_once(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Each language is compared with it."""
    english = tmp_path / ENGLISH
    shutil.copytree(Path(BUILT_IN, ENGLISH), english)
    (english / "commands.toml").write_text("run = [", encoding="utf-8")
    monkeypatch.setattr("donnie_tui.i18n.translations.BUILT_IN", str(tmp_path))

    assert [each.file for each in mistakes()] == [english / "commands.toml"]


def test_nothing_is_wrong_or_missing_in_the_languages_that_come_with_donnie() -> None:
    assert mistakes() == ()
    assert list(ambiguous_keywords()) == []
    assert {each: missing_in(each) for each in languages()} == dict.fromkeys(languages(), ())


@pytest.mark.parametrize("language", languages())
def test_a_file_is_written_as_it_is_read(language: str) -> None:
    """So ``update`` changes nothing but what it has to."""
    text = Path(BUILT_IN, language, "messages.po").read_text(encoding="utf-8")

    assert po.written(po.read(Path(BUILT_IN, language, "messages.po"))) == text


@pytest.mark.parametrize(
    ("translation", "what"),
    [
        ("Andei {passos}.", "{passos} is not in the English sentence"),
        ("Andei.", "{steps} is not here as often"),
        ("{steps} {steps} {steps:passo|passos}", "{steps} is not here as often"),
        ("{steps} {steps:passo|passos|passos}", "{steps:passo|passos|passos} has 3 forms and needs 2"),
        ("{steps} passos", None),
        ("{steps:d} {steps:passo|passos}", "is not here as often"),
        ("{steps} {steps:passo|passos", "a brace is missing or too many"),
        ("{steps} {steps:passo|passos}", None),
        ("", None),
    ],
)
def test_a_wrong_place_or_plural_is_refused_with_its_line(
    translation: str, what: str | None, tmp_path: Path
) -> None:
    text = f'{HEADER}msgctxt "a"\nmsgid "{{steps}} {{steps:step|steps}}"\nmsgstr "{translation}"\n'
    file, entries = entries_of(text, tmp_path)

    found = [str(mistake) for _, mistake in po.mistakes(file, entries)]
    if what is None:
        assert found == []
    else:
        (sentence,) = found
        assert sentence.startswith(f"{file}:5: ")
        assert what in sentence


@pytest.mark.parametrize(
    ("text", "line", "what"),
    [
        ('msgid "a"\nmsgstr "b\n', 2, "expected a comment"),
        ('"alone"\n', 1, "expected a comment"),
        ('msgfoo "a"\n', 1, "expected a comment"),
        ('msgctxt "a"\nmsgid "b"\n\n', 1, "this entry has no msgstr"),
        ('\nmsgstr "b"\n', 2, "this entry has no msgid"),
        ('msgctxt "a"\nmsgid "b"\nmsgstr "c" d\n', 3, "expected a comment"),
        ('msgid "a"\nmsgstr "\xe9"\n', 1, "this file is not in UTF-8"),
    ],
)
def test_what_is_no_entry_is_refused_with_its_line(text: str, line: int, what: str, tmp_path: Path) -> None:
    file = tmp_path / "messages.po"
    file.write_text(text, encoding="latin-1")

    with pytest.raises(Mistake, match=rf"messages.po:{line}: {what}"):
        po.read(file)


@pytest.mark.parametrize(
    "rule", ["", "nplurals=2", "nplurals=2; plural=", "nplurals=2; plural=(n", "n=1; m=2"]
)
def test_a_file_without_a_plural_rule_is_refused(rule: str, tmp_path: Path) -> None:
    header = f'msgid ""\nmsgstr "Plural-Forms: {rule}\\n"\n\nmsgctxt "a"\nmsgid "b"\nmsgstr "c"\n'
    file, entries = entries_of(header, tmp_path)

    assert {str(mistake) for _, mistake in po.mistakes(file, entries)} == {
        f"{file}:1: the header has no Plural-Forms with nplurals and plural"
    }


def test_a_code_that_is_there_twice_is_refused(tmp_path: Path) -> None:
    entry = 'msgctxt "a"\nmsgid "b"\nmsgstr "c"\n'
    file, entries = entries_of(f"{HEADER}{entry}\n{entry}", tmp_path)

    assert [str(each) for _, each in po.mistakes(file, entries)] == [f"{file}:9: a is here a second time"]


def test_what_translators_programs_write_is_read(tmp_path: Path) -> None:
    """Long texts in several lines, comments, old texts, no blank line between two entries."""
    text = f"""{HEADER}# by hand
#. a note
#: start
#, fuzzy
#| msgid "old"
msgctxt "a"
msgid ""
"one "
"two\\n"
msgstr "\\"x\\" \\\\ \\t"
msgctxt "b"
msgid "c"
msgstr ""
#~ msgid "gone"
#~ msgstr "d"
"""
    _, entries = entries_of(text, tmp_path)

    assert entries[1:] == (
        Entry("a", "one two\n", '"x" \\ \t', "start", ("a note",), 10, True),
        Entry("b", "c", "", "", (), 15, False),
    )


def test_comments_need_no_blank_and_unknown_escapes_stay(tmp_path: Path) -> None:
    """An editor may write a byte order mark, and other flags than ``fuzzy``."""
    file = tmp_path / "messages.po"
    file.write_text(
        '#.a note\n#:start\n#, c-format\nmsgctxt "a"\nmsgid "b"\nmsgstr "\\x \\\\x"\n', encoding="utf-8-sig"
    )

    assert po.read(file) == (Entry("a", "b", "\\x \\x", "start", ("a note",), 4, False),)


@pytest.mark.parametrize(
    ("length", "rows"),
    [
        (71, ['msgid "WORD"']),  # 79 columns
        (72, ['msgid ""', '"WORD"']),
        (77, ['msgid ""', '"WORD"']),
        (90, ['msgid ""', '"WORD"']),
    ],
)
def test_a_line_has_79_columns_or_one_word(length: int, rows: list[str]) -> None:
    """As gettext's own tools write it; a text that has ended lines has one for each."""
    word = "x" * length

    assert po.written([Entry("", word, "")]).splitlines()[:-1] == [
        each.replace("WORD", word) for each in rows
    ]


def test_long_texts_are_broken_after_blanks_and_line_ends() -> None:
    text = "a" * 38 + " " + "b" * 38 + " " + "c\n" + "d\n\te\\"

    assert po.written([Entry("x", text, "one\n", "start", ("n",), is_fuzzy=True)]).splitlines() == [
        *("#. n", "#: start", "#, fuzzy", 'msgctxt "x"', 'msgid ""'),
        f'"{"a" * 38} "',
        f'"{"b" * 38} c\\n"',
        *('"d\\n"', r'"\te\\"', r'msgstr "one\n"'),
    ]


@pytest.mark.parametrize(
    ("entry", "what"),
    [
        ('msgctxt "a"\nmsgid "b}"\nmsgstr ""\n', "a brace is missing or too many"),
        ('msgctxt "a"\nmsgid "{n}"\nmsgstr "{n:d}"\n', "{n} is not here as often as in the English sentence"),
        (
            'msgctxt "a"\nmsgid "{n} {n}"\nmsgstr "{n}"\n',
            "{n} is not here as often as in the English sentence",
        ),
        (
            'msgctxt "a"\nmsgid "{n:d}"\nmsgstr "{n:d} {n:d}"\n',
            "{n:d} is not here as often as in the English sentence",
        ),
        ('msgctxt "a"\nmsgid "{n:x|y}"\nmsgstr "{n:x|y} {n:z|w}"\n', None),
        ('msgctxt "a"\nmsgid "{n}"\nmsgstr "{z}{m}{n}"\n', "{m} is not in the English sentence"),
    ],
)
def test_an_entry_that_can_not_be_used_says_why(entry: str, what: str | None, tmp_path: Path) -> None:
    file, entries = entries_of(f"{HEADER}{entry}\n" + 'msgctxt "z"\nmsgid "y"\nmsgstr ""\n', tmp_path)

    assert [str(each) for _, each in po.mistakes(file, entries)] == ([f"{file}:5: {what}"] if what else [])
    assert [each.context for each in po.usable(file)] == ["", *([] if what else ["a"]), "z"]


def test_an_entry_without_a_code_is_refused_and_a_second_header(tmp_path: Path) -> None:
    """Only the header has none."""
    entry = 'msgid "b"\nmsgstr "c"\n'
    file, entries = entries_of(f"{HEADER}{entry}{HEADER}", tmp_path)

    assert [str(each) for _, each in po.mistakes(file, entries)] == [
        f"{file}:5: this entry has no msgctxt",
        f"{file}:7: the header is here a second time",
    ]


@pytest.mark.parametrize(
    ("rule", "forms"),
    [
        ("nplurals=2; plural=n != 1", 2),
        ("nplurals = 9 ; plural = 0;", 9),
        ("nplurals=1;plural=0;", 1),
        ("nplurals=0; plural=0", None),
        ("nplurals=10; plural=0", None),
        ("nplurals=2; plural=n; x", None),
    ],
)
def test_a_language_has_one_to_nine_plural_forms(rule: str, forms: int | None) -> None:
    if forms is None:
        with pytest.raises(ValueError, match="nplurals"):
            po.number_of_forms(rule)
    else:
        assert po.number_of_forms(rule) == forms


def test_a_compiled_file_begins_as_gettexts_manual_says() -> None:
    """Magic number, revision 0, number of texts, where their two tables begin, no hash table, its place."""
    content = po.compiled([Entry("", "", "Language: x\n"), Entry("a", "b", "")], "*", is_english=True)

    assert struct.unpack_from("<7I", content) == (0x950412DE, 0, 3, 28, 28 + 3 * 8, 0, 28 + 2 * 3 * 8)
    read = GNUTranslations(BytesIO(content))
    assert read.info() == {"language": "x", "content-type": "text/plain; charset=UTF-8"}
    assert (read.gettext("a"), read.gettext("*")) == ("b", "a")


@pytest.mark.parametrize(
    ("rule", "compiled"),
    [
        ("nplurals=2; plural=(n != 1);", "nplurals=2;plural=(n!=1);"),
        ("nplurals = 3 ; plural = n == 1 ? 0 : 2", "nplurals=3;plural=n==1?0:2"),
    ],
)
def test_blanks_around_the_equals_signs_of_a_plural_rule_are_left_out(rule: str, compiled: str) -> None:
    """As ``number_of_forms`` allows them; gettext looks for ``plural=``."""
    entries = (Entry("", "", f"Plural-Forms: {rule}\n"), Entry("a", "b", "c"))
    read = GNUTranslations(BytesIO(po.compiled(entries, "*", is_english=False)))

    assert po.number_of_forms(rule) == int(compiled[9])
    assert read.info()["plural-forms"] == compiled
    assert read.gettext("a") == "c"


def test_a_compiled_file_is_gettexts_with_the_codes_as_keys() -> None:
    entries = (
        Entry("", "", "Content-Type: text/plain; charset=UTF-8\n"),
        Entry("a", "b", "ç"),
        Entry("d", "e", ""),
    )
    read = GNUTranslations(BytesIO(po.compiled(entries, "*", is_english=False)))

    assert [read.gettext(each) for each in ("a", "d", "*")] == ["ç", "d", "a"]


def test_a_language_speaks_the_same_compiled_or_not(added: Path) -> None:
    before = [find(each, CODE) for each in ("walked-forward", "screen-start", "start-hint")]
    assert compile_all() == ()
    _forget()

    assert (added / "compiled" / "messages.mo").exists()
    assert [find(each, CODE) for each in ("walked-forward", "screen-start", "start-hint")] == before
    assert locales.words(CODE, "keywords", "keywords", "FW") == ("FWZU",)


def test_what_is_edited_after_it_was_compiled_counts(added: Path) -> None:
    compile_all()
    file = added / "messages.po"
    file.write_text(file.read_text("utf-8").replace(accented("Done."), "Finito."), encoding="utf-8")
    compiled = added / "compiled" / "messages.mo"
    later = compiled.stat().st_mtime_ns + 10**9
    os.utime(file, ns=(later, later))
    _forget()

    sentence = find("run-done", CODE)
    assert sentence is not None
    assert sentence.text == "Finito."


def test_a_mistake_in_a_folder_from_outside_is_a_warning(
    added: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = added / "messages.po"
    text = re.sub(r"-II\|[^}]*\}", "}", file.read_text("utf-8"), count=1)
    file.write_text(text, encoding="utf-8")

    assert main(["compile"]) == 0
    assert re.match(rf"{re.escape(str(file))}:\d+: .* has 2 forms and needs 3", capsys.readouterr().out)
    assert not (added / "compiled").exists()


def test_a_language_from_outside_that_is_older_than_english_does_not_stop_a_start(
    added: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = added / "messages.po"
    old = '\nmsgctxt "of-an-older-donnie"\nmsgid "Old."\nmsgstr "Vella."\n'
    file.write_text(file.read_text("utf-8") + old, encoding="utf-8")

    assert main(["compile"]) == 0
    assert "of-an-older-donnie is not in the English file" in capsys.readouterr().out


def test_a_mistake_in_a_built_in_language_keeps_everything_from_being_compiled(
    added: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mistake = Mistake(Path(BUILT_IN, "pt", "messages.po"), 1, "this is wrong")
    monkeypatch.setattr(translations, "mistakes", lambda: (mistake,))

    assert main(["compile"]) == 1
    assert not (added / "compiled").exists()


@pytest.fixture
def calls(request: pytest.FixtureRequest) -> Iterator[None]:
    """So many calls inside each other; programs raise Python's limit."""
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(request.param)
    yield
    sys.setrecursionlimit(limit)


DEEP = "x = " + "[" * 100_000
"""Deeper than Python's own stack."""


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("words.toml", DEEP),
        ("words.toml", "a." * 400_000 + "a = 1"),
        ("compiled/words.json", '{"a":' * 100_000),
        ("words.toml", "#" * (locales.LARGEST + 1)),
        ("compiled/words.json", " " * (locales.LARGEST + 1)),
    ],
    ids=("deep", "long key", "deep compiled", "large", "large compiled"),
)
@pytest.mark.parametrize("calls", [1000, 1_000_000], indirect=True, ids=("at a start", "after a program"))
@pytest.mark.usefixtures("calls")
def test_a_table_beyond_a_limit_has_no_words(added: Path, name: str, content: str) -> None:
    (added / "compiled").mkdir(exist_ok=True)
    (added / name).write_text(content, encoding="utf-8")
    _forget()
    assert locales.table(CODE, "words") == {}


@pytest.mark.parametrize(
    ("name", "content", "what"),
    [
        ("words.toml", DEEP, "this file has too many brackets in each other"),
        ("words.toml", "#" * (locales.LARGEST + 1), "this file has more than 1000000 bytes"),
        ("messages.po", "#" * (locales.LARGEST + 1), "this file has more than 1000000 bytes"),
    ],
    ids=("deep", "large", "large sentences"),
)
@pytest.mark.parametrize("calls", [1000], indirect=True)
@pytest.mark.usefixtures("calls")
def test_a_file_beyond_a_limit_is_refused_with_the_cause(
    added: Path, name: str, content: str, what: str
) -> None:
    (added / name).write_text(content, encoding="utf-8")

    assert [str(each) for each in mistakes()] == [f"{added / name}:1: {what}"]


def test_compiled_sentences_that_are_cut_off_are_english(added: Path) -> None:
    main(["compile"])
    file = added / "compiled" / "messages.mo"
    whole = file.read_bytes()
    for kept in (0, 3, 20, 40, 200):
        file.write_bytes(whole[:kept])
        _forget()

        sentence = find("answer-stopped-at", CODE)
        assert sentence is not None, kept
        assert sentence.language == "en", kept


@pytest.mark.parametrize("encoding", [b"Content-Type: text/plain", b"charset=UTF-9", b"charset=ascii"])
def test_a_damaged_encoding_in_the_header_costs_no_sentence(added: Path, encoding: bytes) -> None:
    """The file is UTF-8, whatever its header says. Before, gettext raised an ``IndexError`` at the start."""
    file = added / "messages.po"
    rest = b"" if encoding.startswith(b"Content") else b"Content-Type: text/plain; "
    header, others = file.read_bytes().split(b"\n\n", 1)
    damaged = re.sub(rb"Content-Type: [^\\\n]*", rest + encoding, header)
    assert damaged != header
    file.write_bytes(damaged + b"\n\n" + others)
    _forget()

    sentence = find("run-done", CODE)
    assert sentence is not None
    assert sentence.text == accented("Done.")


def test_compiled_sentences_of_an_unknown_encoding_are_english(added: Path) -> None:
    main(["compile"])
    file = added / "compiled" / "messages.mo"
    whole = file.read_bytes()
    for encoding in (b"charset=UTF-9", b"charset:UTF-8"):
        file.write_bytes(whole.replace(b"charset=UTF-8", encoding))
        _forget()

        sentence = find("run-done", CODE)
        assert sentence is not None, encoding
        assert sentence.text == "Done.", encoding


def test_a_sentence_with_a_mistake_is_english_in_a_session(added: Path) -> None:
    file = added / "messages.po"
    file.write_text(file.read_text("utf-8").replace(accented("Stopped at line ") + "{line}", "{x}"), "utf-8")
    _forget()

    sentence = find("answer-stopped-at", CODE)
    assert sentence is not None
    assert (sentence.text, sentence.language) == ("Stopped at line {line}.", "en")
    assert "messages.po answer-stopped-at" in missing_in(CODE)


def test_a_changed_msgctxt_is_refused_with_its_line(added: Path) -> None:
    file = added / "messages.po"
    file.write_text(file.read_text("utf-8").replace('"run-done"', '"run-dune"'), "utf-8")
    line = file.read_text("utf-8").splitlines().index('msgctxt "run-dune"') + 1

    what = "run-dune is not in the English file: msgctxt stays as it is there"
    assert [str(each) for each in mistakes()] == [f"{file}:{line}: {what}"]


def test_a_rank_of_another_language_is_refused_with_its_line(added: Path) -> None:
    file = added / "keywords.toml"
    file.write_text(file.read_text("utf-8").replace("rank = 9", "rank = 2"), "utf-8")
    _forget()

    assert [str(each) for each in mistakes()] == [f"{file}:6: rank 2 is that of pt already"]


def test_one_language_is_checked_by_its_code(added: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = (added / "words.toml").read_text("utf-8")
    (added / "words.toml").write_text(text.replace("northeast =", "# northeast ="), "utf-8")
    _forget()

    assert main(["check", CODE]) == 0
    assert capsys.readouterr().out == (
        f"{CODE} lacks words.toml northeast in [compass]\n{CODE}: 0 wrong, 1 missing\n"
    )
    assert main(["check", "xx"]) == 2
    assert capsys.readouterr().out == f"No folder xx in {BUILT_IN}, {added.parent}.\n"


def test_a_changed_english_sentence_makes_its_translation_fuzzy_and_unused(
    added: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    english = tmp_path / "en"
    english.mkdir()
    for each in Path(BUILT_IN, "en").glob("*.*"):
        (english / each.name).write_bytes(each.read_bytes())
    file = english / "messages.po"
    text = file.read_text("utf-8").replace('msgid "Done."', 'msgid "Finished."')
    file.write_text(f'{text}\n#: answers\nmsgctxt "new-one"\nmsgid "New."\nmsgstr ""\n', encoding="utf-8")
    monkeypatch.setattr(translations, "folders", lambda: {"en": str(english), CODE: str(added)})

    translations.update()
    entries = {each.context: each for each in po.read(added / "messages.po")}
    assert entries["run-done"].is_fuzzy
    assert entries["run-done"].text == pseudo("Done.")
    assert entries["new-one"].text == ""
    assert not entries["walked-forward"].is_fuzzy
    usable = {each.context: each.text for each in po.usable(added / "messages.po")}
    assert "run-done" not in usable
    assert usable.get("new-one", "") == ""


@pytest.mark.parametrize(
    ("name", "text", "line", "what"),
    [
        ("commands", 'run = ["CORRER"]\nrunn = ["X"]\n', 2, "runn is not in the English file"),
        ("commands", 'run = ["CORRER"]\nstop = ["correr"]\n', 2, "correr is a word of run already"),
        ("commands", 'run = "CORRER"\n', 1, "run is not in the English file, or has another form there"),
        ("commands", 'run = ["CORRER", ""]\n', 1, "run takes words in quotation marks"),
        ("keywords", "rank = 3\n[keywords]\nFW = [\n", 3, ""),
        ("words", '[compass]\nup = ["X"]\n', 2, "up is not in the English file"),
        ("words", '[languages]\neu = ["euskara"]\n[braille]\n"ñ" = ["]"]\n', 0, ""),
    ],
)
def test_a_wrong_table_is_refused_with_its_line(
    added: Path, name: str, text: str, line: int, what: str
) -> None:
    (added / f"{name}.toml").write_text(text, encoding="utf-8")

    found = [str(each) for each in mistakes()]
    assert len(found) == (1 if line else 0)
    assert all(each.startswith(f"{added / name}.toml:{line}: {what}") for each in found)


def test_a_word_that_means_something_else_in_another_language_is_reported(added: Path) -> None:
    file = added / "keywords.toml"
    file.write_text(file.read_text("utf-8").replace('WAIT = ["WAITZU"]', 'WAIT = ["PARA"]'), encoding="utf-8")
    _forget()

    found = _ambiguous_in_a_new_process(added.parent)
    assert re.fullmatch(r"\S+keywords\.toml:\d+: PARA means FOR in another language", found.splitlines()[0])


def _ambiguous_in_a_new_process(folder: Path) -> str:
    """The table of keywords is made once a process."""
    done = subprocess.run(
        [sys.executable, "-m", "donnie_tui.i18n.translations", "check"],
        env={**os.environ, locales.SEARCH_PATH: str(folder)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 1
    return done.stdout


@pytest.mark.parametrize("typed", [[], ["nonsense"], ["compile", "pt"], ["update", "pt"]])
def test_a_wrong_command_prints_how_it_is_used(typed: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(typed) == 2
    usage = "usage: python -m donnie_tui.i18n.translations check|compile|update\n"
    assert capsys.readouterr().out == usage


def test_a_language_with_a_mistake_is_wrong_and_what_it_lacks_is_listed_first(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    wrong = Mistake(tmp_path / "xx" / "messages.po", 7, "this is wrong")
    other = Mistake(tmp_path / "yy" / "words.toml", 1, "this, too")
    monkeypatch.setattr(
        translations, "folders", lambda: {each: str(tmp_path / each) for each in ("xx", "yy")}
    )
    monkeypatch.setattr(translations, "mistakes", lambda: (wrong, other))
    monkeypatch.setattr(translations, "ambiguous_keywords", lambda: ())
    monkeypatch.setattr(translations, "missing_in", lambda language: ("a", "b") if language == "xx" else ())

    assert main(["check", "xx"]) == 1
    assert capsys.readouterr().out == f"xx lacks a\nxx lacks b\n{wrong}\nxx: 1 wrong, 2 missing\n"
    assert main(["check"]) == 1
    assert capsys.readouterr().out.splitlines()[2:] == [
        *(str(wrong), str(other), "xx: 1 wrong, 2 missing", "yy: 1 wrong, 0 missing"),
    ]
    monkeypatch.setattr(translations, "mistakes", lambda: (other,))
    assert main(["check", "xx"]) == 0
    capsys.readouterr()
    monkeypatch.setattr(translations, "update", lambda: None)
    assert main(["update"]) == 1
    assert capsys.readouterr().out == f"{other}\nxx: 0 wrong, 2 missing\nyy: 1 wrong, 0 missing\n"


@pytest.mark.parametrize(
    ("has_changed", "text", "was_fuzzy", "is_fuzzy"),
    [
        (False, "b", False, False),
        (False, "b", True, True),
        (True, "b", False, True),
        (True, "", False, False),
        (True, "b", True, True),
    ],
)
def test_a_translation_is_doubted_once_its_english_sentence_has_changed(
    has_changed: bool, text: str, was_fuzzy: bool, is_fuzzy: bool
) -> None:
    english = Entry("a", "new" if has_changed else "old", "", "topic", ("note",), 3)
    updated = translations._updated(english, Entry("a", "old", text, "gone", (), 9, was_fuzzy))

    assert updated == english._replace(text=text, is_fuzzy=is_fuzzy)
    assert translations._updated(english, None) == english


@pytest.mark.parametrize(
    ("key", "line"), [("rank", 1), ("north", 4), ("compass", 3), ("no", 5), ("quoted", 6), ("unknown", 1)]
)
def test_a_key_of_a_table_is_found_by_its_line(key: str, line: int, tmp_path: Path) -> None:
    file = tmp_path / "words.toml"
    file.write_text('rank = 3\n# north = x\n[compass]\n  north=["n"]\nno = ["north"]\n"quoted" = 1\n')

    assert translations._line_of(key, file) == line


def test_the_words_that_a_language_lacks_are_listed_with_their_sections() -> None:
    english = {"rank": 1, "top": ["x"], "a": {"one": ["1"], "two": ["2"], "b": {"three": ["3"]}}}
    english |= {"languages": {"pt": ["Portuguese"]}}
    lacking = translations._without(english, {"a": {"one": ["um"]}})

    assert [*lacking] == ["top", "two in [a]", "three in [a.b]"]
    assert [*translations._without(english, english)] == []


def test_a_folder_that_can_not_be_written_is_left_as_it_is(
    monkeypatch: pytest.MonkeyPatch, added: Path, tmp_path: Path
) -> None:
    (added / "compiled").write_text("a file")
    other = tmp_path / "other"
    other.mkdir()
    monkeypatch.setattr(translations, "folders", lambda: {CODE: str(added), "xx": str(other)})
    monkeypatch.setattr(translations, "mistakes", lambda: ())

    assert compile_all() == ()
    assert ((added / "compiled").read_text(), (other / "compiled").is_dir()) == ("a file", True)
    monkeypatch.setattr(translations, "BUILT_IN", str(added.parent))
    with pytest.raises(FileExistsError):
        compile_all()


def test_the_words_of_a_start_are_compiled_by_themselves(added: Path) -> None:
    """A line for each sentence of that topic, which the first prompt reads without gettext."""
    (added / "compiled").mkdir()
    translations._compile(CODE, added)
    early = [each for each in po.read(added / "messages.po") if each.topic == "start"]

    assert early
    assert (added / "compiled" / first_words.FILE).read_text("utf-8") == "".join(
        f"{each.context}={each.text}\n" for each in early
    )
    tables = {file.name for file in (added / "compiled").glob("*.json")}
    assert tables == {f"{file.stem}.json" for file in added.glob("*.toml")}
    assert not [*(added / "compiled").glob("*.new")]
