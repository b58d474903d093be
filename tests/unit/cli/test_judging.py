"""Programs and challenges on the command line: robots, totals, processes and faults."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest

from donnie_tui.cli import programs
from donnie_tui.cli.options import ExitCode, WrongUsage
from donnie_tui.cli.programs import by_robot, robot_and_file
from donnie_tui.i18n.words import Unusable, Words

# --- the robot of a program


@pytest.mark.parametrize(
    ("argument", "found"),
    [
        ("a.gd", (None, "a.gd")),
        ("ana=a.gd", ("ana", "a.gd")),
        ("ana=b=c.gd", ("ana", "b=c.gd")),
        ("=a.gd", (None, "=a.gd")),
        ("rui=there.gd", (None, "rui=there.gd")),
    ],
)
def test_a_file_may_be_named_after_its_robot(
    argument: str, found: tuple[str | None, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("rui=there.gd").touch()

    assert robot_and_file(argument) == found


def test_a_robot_without_its_file_is_reported() -> None:
    with pytest.raises(WrongUsage, match="usage-missing") as wrong:
        robot_and_file("ana=")
    assert wrong.value.values == {"what": "ana=FILE"}


NAMES = ("ana", "bia", "eva", "ivo", "leo", "rui")


def test_each_robot_has_what_is_given_for_it_and_the_first_what_is_for_none() -> None:
    assert by_robot([("RUI", 1), (None, 2)], NAMES, Words()) == {"rui": 1, "ana": 2}
    assert by_robot([], NAMES, Words()) == {}


@pytest.mark.parametrize(
    ("given", "names", "sentence"),
    [
        ([("x", 1)], NAMES[:5], "There is no robot x here. There are ana, bia, eva, ivo and leo."),
        ([("x", 1)], NAMES, "There is no robot x here. There are ana, bia, eva, ivo, leo and …."),
        ([(None, 1), ("Ana", 2)], NAMES, "The robot ana has two programs. One is enough."),
    ],
)
def test_a_robot_that_is_unknown_or_named_twice_is_refused(
    given: list[tuple[str | None, int]], names: Sequence[str], sentence: str
) -> None:
    with pytest.raises(Unusable) as refused:
        by_robot(given, names, Words())
    assert refused.value.sentence == sentence


# --- totals


@pytest.mark.parametrize(
    ("codes", "sentence"),
    [
        ([ExitCode.DONE, ExitCode.FAILED, ExitCode.DONE], "3 programs. 1 with mistakes, 2 without."),
        (
            [ExitCode.DONE, ExitCode.UNUSABLE, ExitCode.FAILED, ExitCode.FAILED],
            "4 programs. 2 with mistakes, 1 without, 1 unreadable.",
        ),
    ],
)
def test_the_totals_count_what_is_right_wrong_and_unread(codes: list[int], sentence: str) -> None:
    assert programs._totals(codes, Words()) == sentence


# --- how many processes judge


@pytest.mark.parametrize(
    ("count", "processors", "processes"),
    [(1, 4, None), (49, 4, None), (50, 4, 2), (99, 4, 3), (1000, 4, 4), (1000, 2, 2), (1000, 1, None)],
)
def test_a_process_is_worth_its_start_for_twenty_five_programs(
    count: int, processors: int, processes: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun = list[int]()

    def in_processes(
        work: Callable[[Any], Any], given: Sequence[Any], processes: int, instead: Any
    ) -> Iterator[Any]:
        begun.append(processes)
        yield from map(work, given)

    monkeypatch.setattr(programs, "in_processes", in_processes)
    monkeypatch.setattr(programs, "processors", lambda: processors)
    monkeypatch.setattr(programs, "_read", lambda _judge, pupil: (("donnie", f"FW {pupil.name}"),))
    monkeypatch.setattr(programs, "_judged", lambda _judge, texts: record(verdict=texts[0][1]))
    pupils = [programs._Pupil(str(number), {}) for number in range(count)]

    found = [*programs._records(Part(words=Words()), pupils)]  # type: ignore[arg-type]

    assert [(each.file, each.verdict) for each in found] == [(str(at), f"FW {at}") for at in range(count)]
    assert begun == ([] if processes is None else [processes])


def record(*, verdict: str, solved: bool | None = True) -> programs._Record:
    return programs._Record("", solved, verdict=verdict)


def test_programs_that_are_unread_or_end_their_process_have_a_verdict_each(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    read: dict[str, Any] = {"a": (("donnie", "FW 1"),), "b": "No text.", "c": (("donnie", "FW 2"),)}
    read["d"] = read["c"]
    outcomes = iter([record(verdict="Solved."), record(verdict="", solved=None)])
    monkeypatch.setattr(programs, "_read", lambda _judge, pupil: read[pupil.name])
    monkeypatch.setattr(programs, "_judged", lambda *_: next(outcomes))
    pupils = [programs._Pupil(name, {}) for name in read]

    found = [*programs._records(Part(words=Words()), pupils)]  # type: ignore[arg-type]

    assert [(each.file, each.solved, each.verdict) for each in found] == [
        ("a", True, "Solved."),
        ("b", None, "No text."),
        ("c", None, "I can't judge c: it ended the process that ran it."),
        ("d", None, "I can't judge d: it ended the process that ran it."),
    ]


@pytest.mark.parametrize(
    ("name", "folder", "label"),
    [("a/b.gd", "", "b.gd"), ("a/ana/b.gd", "a/ana", "ana/b.gd"), ("a/ana", "", "ana")],
)
def test_a_pupil_is_called_as_its_folder_and_file(name: str, folder: str, label: str) -> None:
    assert programs._Pupil(name, {}, folder).label == label


# --- tests of a challenge


def texts_of(title: str = "T", task: str = "Do.", hints: Sequence[str] = ()) -> Any:
    return Part(title=title, sentences=(task,), hint=[Part(text=each) for each in hints])


def faults(monkeypatch: pytest.MonkeyPatch, sentences: int = 2, **texts: Any) -> list[str]:
    monkeypatch.setattr(programs, "task_in_words", lambda *_: ["."] * sentences)
    found: Any = Part(name="it", texts=texts, text=texts.get)
    return [*programs._faults_of_words(found, Words())]


@pytest.mark.parametrize("where", ["title", "task", "hint"])
@pytest.mark.parametrize(("length", "is_long"), [(80, False), (81, True)])
def test_a_spoken_line_has_eighty_characters_at_most(
    where: str, length: int, is_long: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    line = "x" * length
    text = texts_of(hints=[line]) if where == "hint" else texts_of(**{where: line})

    said = f"it: {length} characters are too long to hear, at most 80: {line}"
    assert faults(monkeypatch, en=text) == [said] * is_long


@pytest.mark.parametrize(("sentences", "is_long"), [(5, False), (6, True)])
def test_a_task_has_four_sentences_after_its_title_at_most(
    sentences: int, is_long: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    said = "it: with its limits the task has 5 sentences in en, at most 4."
    assert faults(monkeypatch, sentences, en=texts_of()) == [said] * is_long


def test_each_language_has_as_many_hints_as_english(monkeypatch: pytest.MonkeyPatch) -> None:
    texts = {
        "en": texts_of(hints="a"),
        "pt": texts_of(hints="ab"),
        "es": texts_of(hints="c"),
        "de": texts_of(),
    }
    assert faults(monkeypatch, **texts) == [
        "it: pt has 2 hints, English has 1.",
        "it: de has 0 hints, English has 1.",
    ]


@pytest.mark.parametrize(
    ("needed", "lines"),
    [
        (
            "FW 1",
            ["it: the solution does not need its line 2.", "it.rui: the solution does not need its line 1."],
        ),
        (
            "TR 90",
            ["it: the solution does not need its line 1.", "it.rui: the solution does not need its line 1."],
        ),
        (
            "FW 2",
            ["it: the solution does not need its line 1.", "it: the solution does not need its line 2."],
        ),
    ],
)
def test_a_command_is_spare_if_the_rest_of_all_solutions_solves_the_challenge(
    needed: str, lines: list[str]
) -> None:
    tried = list[dict[str, str]]()

    def judged(texts: dict[str, str]) -> list[Any]:
        tried.append(texts)
        return [Part(is_solved=False), Part(is_solved=any(needed in each for each in texts.values()))]

    scene = Part(robot_names=("ana", "rui"))
    judge: Any = Part(words=Words(), world=Part(scene=scene), challenge=Part(name="it"), programs=judged)
    assert [*programs._spare_lines(judge, {"ana": "FW 1\nTR 90", "rui": "FW 2"})] == lines
    assert tried[0] == {"ana": "\nTR 90", "rui": "FW 2"}
