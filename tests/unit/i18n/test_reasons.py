"""The system's reason why a file or a port can't be used is in the learner's language."""

import errno
import os

import pytest

from donnie_tui.i18n.words import Words

NUMBERS = ("ENOENT", "EACCES", "ENOSPC", "EISDIR", "EROFS", "ENAMETOOLONG", "ENOTDIR")


@pytest.mark.parametrize("name", NUMBERS)
@pytest.mark.parametrize("language", ["pt", "es"])
def test_the_usual_reasons_have_words_in_each_language(name: str, language: str) -> None:
    reason = os.strerror(getattr(errno, name))
    found = Words(language)("file-unreadable", path="x", reason=reason)

    assert reason not in found
    assert found.startswith(("Não consigo ler x: ", "No puedo leer x: "))


def test_a_missing_folder_is_named_when_a_file_can_not_be_written() -> None:
    reason = os.strerror(errno.ENOENT)
    found = [Words(each)("file-unwritable", path="a/b", reason=reason) for each in ("en", "pt", "es")]

    assert found == [
        "I can't write a/b: there is no such folder.",
        "Não consigo gravar a/b: essa pasta não existe.",
        "No puedo escribir a/b: esa carpeta no existe.",
    ]


def test_an_unknown_reason_stays_as_it_is() -> None:
    assert Words("pt")("file-unreadable", path="x", reason="odd") == "Não consigo ler x: odd."
