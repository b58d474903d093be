"""``donnie check``, ``donnie format`` and ``donnie challenge``, and reading programs.

``check`` prints every mistake of form and every hint, a line each; nothing runs, and no world is needed. Of
several programs everything is on standard output, with the totals as its last line.
``format`` writes the canonical layout to standard output or in place, and translates keywords on request.
``challenge`` lists, makes and tests challenges, and judges programs by one. An endless program ends by
robot time and by the number of its statements, so a busy machine changes no verdict.
"""

from __future__ import annotations

import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import partial
from itertools import chain, count, groupby, islice
from pathlib import Path
from typing import TypeAlias, TypeVar

import msgspec
from msgspec import Struct
from msgspec.structs import astuple, replace

from donnie_tui.bootstrap import Judge
from donnie_tui.cli.options import ExitCode, Order, WrongUsage
from donnie_tui.cli.streams import Output
from donnie_tui.core.describe import task_in_words, verdict_in_words
from donnie_tui.core.events import RunStarted, Stamped
from donnie_tui.core.goals import folded
from donnie_tui.core.program_files import (
    LARGEST,
    STANDARD_OUTPUT,
    checked_path,
    decode,
    exists,
    is_link,
    is_same_file,
    read_program,
    read_to_the_end,
    write_program,
)
from donnie_tui.core.reports import Section, as_csv
from donnie_tui.core.wording import no_such_robot, robot_called
from donnie_tui.i18n.mistakes import remark
from donnie_tui.i18n.words import Unusable, Words, as_unusable
from donnie_tui.outlets.files import heading_of_answer, may_be_replaced
from donnie_tui.process import in_processes, processors
from donnie_tui.process.confinement import is_allowed, make_folder, part_below, real_path
from donnie_tui.settings.settings import SettingSource
from donnie_tui.world.loading import choose_challenge, solution_of
from language.checker import check as hints_for
from language.diagnostics import MOST_MISTAKES, Diagnostic, Severity
from language.formatter import formatted
from language.locales import ENGLISH
from language.parser import parse
from language.source import printable
from language.syntax import walk
from worlds import challenges

MOST_NAMES = 5
"""Robots that are named where one is unknown."""


class Source(Struct, frozen=True):
    """A program's text, and what it is called."""

    name: str
    text: str
    path: Path | None
    """None for standard input."""


def read_source(name: str, words: Words) -> Source:
    """Raises ``Unusable``."""
    with as_unusable(words):
        if name == "-":
            return Source("-", _standard_input(), None)
        path = checked_path(Path(name))
        return Source(name, read_to_the_end(path), path)


def path_given(name: str, words: Words) -> Path:
    """The path of an output. Raises ``Unusable`` for one that a confined session must not use."""
    with as_unusable(words):
        return checked_path(Path(name))


def robot_and_file(argument: str) -> tuple[str | None, str]:
    """``ROBOT=FILE``, or a file of exactly that name for no robot in particular.

    Raises ``WrongUsage`` for a robot without a file.
    """
    robot, equals, file = argument.partition("=")
    if not (robot and equals) or exists(Path(argument)):
        return None, argument
    if not file:
        raise WrongUsage("usage-missing", what=f"{robot}=FILE")
    return robot, file


_Given = TypeVar("_Given")


def by_robot(
    given: Sequence[tuple[str | None, _Given]], names: Sequence[str], words: Words
) -> dict[str, _Given]:
    """What is given for each robot, by name; without a name it is for the first. Raises ``Unusable``."""
    found: dict[str, _Given] = {}
    for robot, each in given:
        typed = names[0] if robot is None else robot
        name = robot_called(typed, names)
        if name is None:
            raise Unusable(no_such_robot(typed, names, MOST_NAMES, words))
        if name in found:
            raise Unusable(words("robot-twice", name=name))
        found[name] = each
    return found


def _standard_input() -> str:
    if sys.stdin is None:
        return ""
    return decode(sys.stdin.buffer.read(LARGEST + 1), "-")


def check(order: Order) -> int:
    """The worst of the files counts. A folder stands for the programs in it."""
    given = order.invocation.arguments.file
    found = {name: programs_in(name) for name in given}
    is_report = list(found.values()) != [(given[0],)]
    remark_on = order.output.line if is_report else order.output.complaint
    for name, programs in found.items():
        if not programs:
            remark_on(order.words("check-no-programs", path=name))
    colours = _colours(order)
    codes = [_check_file(order, each, colours, remark_on) for programs in found.values() for each in programs]
    if is_report and codes:
        order.output.line(_totals(codes, order.words))
    return max((*codes, *(ExitCode.UNUSABLE for programs in found.values() if not programs)))


def _totals(codes: Sequence[int], words: Words) -> str:
    counted = Counter(codes)
    unread = counted[ExitCode.UNUSABLE]
    return words(
        "check-total-unread" if unread else "check-total",
        programs=len(codes),
        wrong=counted[ExitCode.FAILED],
        right=counted[ExitCode.DONE],
        unread=unread,
    )


def programs_in(name: str) -> tuple[str, ...]:
    """The files of a folder that are named as programs are, by name; of anything else only itself."""
    found = _entries(
        name, lambda each: each.suffix.lower() == ".gd" and (each.is_file() or _leads_nowhere(each))
    )
    return (name,) if found is None else found


def _leads_nowhere(path: Path) -> bool:
    """Whether it is a link to something that is not there, which reading will report."""
    return path.is_symlink() and not path.exists()


def folders_in(name: str) -> tuple[str, ...]:
    """The folders in a folder, by name; none of anything else."""
    return _entries(name, Path.is_dir) or ()


def _entries(name: str, is_wanted: Callable[[Path], bool]) -> tuple[str, ...] | None:
    """What is in a folder, by name; None if there is none, or reading it will report why."""
    folder = Path(name)
    try:
        if is_allowed(folder) and folder.is_dir():
            return tuple(
                sorted(str(each) for each in folder.iterdir() if is_allowed(each) and is_wanted(each))
            )
    except (OSError, ValueError):
        pass
    return None


def _check_file(
    order: Order, name: str, colours: frozenset[str] | None, remark_on: Callable[[str], None]
) -> int:
    """``remark_on`` prints what is no mistake or hint."""
    try:
        source = read_source(name, order.words)
    except Unusable as unusable:
        remark_on(unusable.sentence)
        return ExitCode.UNUSABLE
    found = diagnostics_of(source.text, colours)
    for each in found:
        order.output.line(line_for(each, source, order.words))
    is_wrong = any(each.severity is Severity.ERROR for each in found)
    if is_wrong and len(found) >= MOST_MISTAKES:
        remark_on(order.words("more-mistakes", limit=MOST_MISTAKES))
    if not found:
        remark_on(order.words("check-clean", file=source.name))
    return ExitCode.FAILED if is_wrong else ExitCode.DONE


def diagnostics_of(text: str, colours: frozenset[str] | None) -> tuple[Diagnostic, ...]:
    """The mistakes of form, or the hints about a program that has none."""
    parsed = parse(text, colours=colours)
    return parsed.diagnostics if parsed.program is None else hints_for(parsed.program)


def line_for(diagnostic: Diagnostic, source: Source, words: Words) -> str:
    """``FILE:LINE:COLUMN: kind: message``; the kind of a hint is ``hint``."""
    is_hint = diagnostic.severity is Severity.HINT
    kind = "hint" if is_hint else diagnostic.kind.value
    place = f"{source.name}:{diagnostic.span.line}:{diagnostic.span.column}"
    return f"{place}: {kind}: {remark(diagnostic, words)}"


def complain(diagnostics: tuple[Diagnostic, ...], source: Source, words: Words, output: Output) -> None:
    """Print mistakes as complaints, where they are not what was asked for."""
    for each in diagnostics:
        output.complaint(line_for(each, source, words))


def _colours(order: Order) -> frozenset[str] | None:
    """What the robot sees, if a world was named; every colour of the language otherwise."""
    if order.settings.source_of("world") is not SettingSource.OPTION:
        return None
    from donnie_tui.bootstrap import colours_of_world

    return colours_of_world(order.settings, order.words)


def format_files(order: Order) -> int:
    """The exit code is that of the worst file; a file with mistakes is reported and left as it is."""
    return max(_format_file(order, name) for name in order.invocation.arguments.file)


def _format_file(order: Order, name: str) -> int:
    try:
        source = read_source(name, order.words)
        result = formatted(source.text, order.invocation.arguments.to)
        if result.text is None:
            complain(result.diagnostics, source, order.words, order.output)
            return ExitCode.FAILED
        _put(result.text, source, order)
    except Unusable as unusable:
        order.output.complaint(unusable.sentence)
        return ExitCode.UNUSABLE
    return ExitCode.DONE


def _put(text: str, source: Source, order: Order) -> None:
    if not order.invocation.arguments.write or source.path is None:
        order.output.text(text)
    elif text != source.text:
        _write(source.path, text, order.words)


# --- challenges


def challenge(order: Order) -> int:
    """``donnie challenge``, and ``check``, ``test`` and ``new`` with a NAME."""
    match order.invocation.arguments.what:
        case []:
            return _list_challenges(order)
        case ["check", name, first, *others]:
            return check_challenge(order, name, [first, *others])
        case ["test", first, *others]:
            return _test_challenges(order, (first, *others))
        case ["new", name]:
            return _new_challenge(order, name)
    raise Unusable(order.words("challenge-usage"))


def _list_challenges(order: Order) -> int:
    numbers = {name: number for number, name in enumerate(challenges.names(), start=1)}
    for ladder, steps in groupby(numbers, challenges.ladders().get):
        order.output.line(order.words(f"ladder-{ladder}"))
        for found in map(challenges.find, steps):
            title = found.text(order.words.language).title
            level = order.words(f"difficulty-{found.rules.difficulty.value}")
            values = {"name": found.name, "title": title, "difficulty": level}
            order.output.line(order.words("challenge-listed", number=numbers[found.name], **values))
    return ExitCode.DONE


def _judge(order: Order, name: str) -> Judge:
    """What judges by a challenge. Raises ``Unusable``."""
    return Judge(choose_challenge(name, order.words), order.words, order.settings)


def check_challenge(order: Order, name: str, files: Sequence[str]) -> int:
    """Judge programs; 1 if one does not solve the challenge, 2 if one can't be read."""
    _refuse_without_effect(order)
    judge = _judge(order, name)
    pupils = _pupils(judge, files)
    if not pupils:
        raise Unusable(order.words("check-no-programs", path=files[0]))
    answers = _answers(order, pupils)
    is_json, records = getattr(order.invocation.arguments, "json", False), list[_Record]()
    is_table = getattr(order.invocation.arguments, "csv", None) == STANDARD_OUTPUT
    if is_json and is_table:
        raise Unusable(order.words("options-not-together", option="--csv", other="--json"))
    line = order.output.complaint if is_table else order.output.line
    for pupil, record in zip(pupils, _records(judge, pupils), strict=True):
        records.append(record)
        if not is_json:
            said = order.words("challenge-verdict", file=pupil.label, verdict=record.verdict)
            line(record.verdict if record.solved is None else said)
    _write_table(order, records)
    heading = heading_of_answer(judge.challenge.text(order.words.language).title, order.words)
    for answer, record in zip(answers, records, strict=False):
        if is_link(answer):  # perhaps a pupil's, to any other file
            answer.unlink()
        _write(answer, f"{heading}\n{record.verdict}\n", order.words)
    solved = [each.solved for each in records]
    if is_json:
        order.output.text(f"{msgspec.json.format(msgspec.json.encode(records), indent=2).decode()}\n")
    elif len(records) > 1:
        line(
            order.words(
                "challenge-total",
                programs=sum(bool(each.files) for each in pupils),
                solved=solved.count(True),
            )
        )
    return max(_CODES[each] for each in solved)


def _refuse_without_effect(order: Order) -> None:
    """Raises ``Unusable`` for an option of a run that judging doesn't have: its world and starts are the
    challenge's, and there may be several runs."""
    given, arguments = order.invocation.options, order.invocation.arguments
    without_effect = [f"--{each}" for each in ("world", "robot", "belt", "record", "events") if each in given]
    if "sound" in given and isinstance(order.settings.sound, str):
        without_effect.append("--sound")
    if getattr(arguments, "trace", False):
        without_effect.append("--trace")
    if without_effect:
        judging = "--challenge" if order.invocation.command == "run" else "challenge check"
        raise Unusable(order.words("options-not-together", option=without_effect[0], other=judging))


_CODES = {True: ExitCode.DONE, False: ExitCode.FAILED, None: ExitCode.UNUSABLE}
"""By what a record says about ``solved``."""


def judge_recording(order: Order, name: str, recorded: Sequence[Stamped], *, is_simulated: bool) -> int:
    """Judge a recording, of a real robot only what it can sense; 1 if it does not solve the challenge."""
    judge = _judge(order, name)
    wanted, path = judge.world.name, order.invocation.arguments.file
    for world in (each.event.world for each in recorded if isinstance(each.event, RunStarted)):
        if world != wanted:
            raise Unusable(order.words("challenge-other-world", path=path, world=world, wanted=wanted))
    verdicts = judge.events(recorded, None if is_simulated else {})
    order.output.line(verdict_in_words(verdicts, order.words))
    return _CODES[all(each.is_solved for each in verdicts)]


class _Record(Struct, frozen=True, omit_defaults=True):
    """What the table says about a pupil's program."""

    file: str
    solved: bool | None
    """None for a program that can't be judged; the verdict then says why, and names it."""
    goals: int | None = None
    met: int | None = None
    commands: int | None = None
    steps: int | None = None
    bumps: int | None = None
    verdict: str = ""


class _Pupil(Struct, frozen=True):
    """What one pupil handed in."""

    name: str
    """The file, or the folder with a program for each robot."""
    files: Mapping[str, str]
    """By robot."""
    folder: str = ""
    """The pupil's own, where the file is in one."""
    given: str = ""
    """What was given as an argument, where the files are in that."""

    @property
    def label(self) -> str:
        """Its name as the table prints it."""
        return "/".join(filter(None, (Path(self.folder).name, Path(self.name).name)))


def _answers(order: Order, pupils: Sequence[_Pupil]) -> Sequence[Path]:
    """The files that ``--feedback`` asks for, in its folder: one for each pupil, or none.

    Raises ``Unusable`` if one of them, or ``--csv``, would destroy something. ``donnie run`` has neither.
    """
    table, given = (getattr(order.invocation.arguments, each, None) for each in ("csv", "feedback"))
    read = {real_path(file) for each in pupils for file in each.files.values()}
    if table not in (None, STANDARD_OUTPUT) and real_path(table) in read:
        raise Unusable(order.words("challenge-csv-program", path=table))
    if given is None:
        return ()
    folder, names = path_given(given, order.words), dict[str, None]()
    for pupil in pupils:
        stem = (
            Path(printable(pupil.label).replace("/", "-"))
            .stem.encode()[:_LONGEST_STEM]
            .decode("utf-8", "ignore")
        )
        possible = chain((f"{stem}.txt",), (f"{stem}-{number}.txt" for number in count(2)))
        names[next(each for each in possible if each not in names)] = None
    answers = [path_given(str(folder / each), order.words) for each in names]
    for answer in answers:
        if table is not None and is_same_file(Path(table), answer):
            raise Unusable(order.words("output-twice", option="--csv", other="--feedback", path=table))
        if is_link(answer):
            continue
        if real_path(answer) in read:
            raise Unusable(order.words("output-is-input", option="--feedback", path=answer))
        if (exists(answer) and not answer.is_file()) or not may_be_replaced("--feedback", answer):
            raise Unusable(order.words("output-is-other", option="--feedback", path=answer))
    _make_folder(folder, order.words)
    try:
        tempfile.TemporaryFile(dir=folder).close()
    except OSError as problem:
        raise Unusable(order.words("file-unwritable", path=str(folder), reason=problem.strerror)) from None
    return answers


_LONGEST_STEM = 200
"""Bytes of a label in the name of an answer; the names of files have 255."""


def _write_table(order: Order, records: Sequence[_Record]) -> None:
    """What ``--csv`` asks for. Raises ``Unusable``."""
    table = getattr(order.invocation.arguments, "csv", None)
    content = as_csv([Section("", rows=(_Record.__struct_fields__, *map(astuple, records)))])
    if table == STANDARD_OUTPUT:
        order.output.text(content)
    elif table is not None:
        _write(Path(table), content, order.words)


def _write(path: Path, text: str, words: Words) -> None:
    """Raises ``Unusable``."""
    with as_unusable(words):
        write_program(path, text)


def _make_folder(folder: Path, words: Words) -> None:
    """Raises ``Unusable``."""
    try:
        make_folder(folder)
    except OSError as problem:
        raise Unusable(words("challenge-new-failed", path=str(folder), reason=problem.strerror)) from None


def _new_challenge(order: Order, name: str) -> int:
    """A folder with a challenge that works, to be changed. Raises ``Unusable`` if it is there already."""
    folder, stem = path_given(name, order.words), Path(name).name
    if not stem or exists(folder):
        raise Unusable(order.words("challenge-new-there", path=name))
    _make_folder(folder, order.words)
    try:
        for suffix in (challenges.SUFFIX, challenges.SOLUTION):
            pattern = Path(challenges.LADDERS, "new", f"challenge{suffix}")
            _write(folder / f"{stem}{suffix}", read_program(pattern), order.words)
    except Unusable:  # a half challenge would keep the name from the next one
        with suppress(OSError):
            (folder / f"{stem}{challenges.SUFFIX}").unlink(missing_ok=True)
            folder.rmdir()
        raise
    order.output.line(order.words("challenge-new", path=str(folder / f"{stem}{challenges.SUFFIX}")))
    return ExitCode.DONE


def _test_challenges(order: Order, given: Sequence[str]) -> int:
    """Tests each challenge, of a folder all. One that can't be used doesn't keep the others from it."""
    codes = []
    for name in (each for one in given for each in (*map(str, challenges.files_in(one)),) or (one,)):
        try:
            judge = _judge(order, name)
            faults = [*_faults(judge)]
        except Unusable as unusable:
            order.output.complaint(*unusable.sentences)
            codes.append(ExitCode.UNUSABLE)
            continue
        good = order.words("challenge-test-good", name=judge.challenge.name, starts=len(judge.starts))
        for line in faults or (good,):
            order.output.line(line)
        codes.append(ExitCode.FAILED if faults else ExitCode.DONE)
    return max(codes)


def _faults(judge: Judge) -> Iterator[str]:
    """What is wrong with a challenge: its words in each language, its starts, and what solves it.

    The solution must solve it from every start; the empty program, and the solution without one of its
    commands, must not.
    """
    words, name = judge.words, judge.challenge.name
    yield from _faults_of_words(judge.challenge, words)
    yield from _faults_of_starts(judge)
    solution = solution_of(judge.world, words)
    verdicts = judge.programs(solution)
    is_easy = any(judge.programs("", (each,))[0].is_solved for each in judge.starts)
    if not verdicts[-1].is_solved:
        yield words("challenge-test-unsolved", name=name)
        yield verdict_in_words(verdicts, words)
    if is_easy:
        yield words("challenge-test-empty", name=name)
    elif verdicts[-1].is_solved:
        yield from islice(_spare_lines(judge, solution), 1)


def _spare_lines(judge: Judge, solution: Mapping[str, str]) -> Iterator[str]:
    """The commands that a solution does not need."""
    for robot, text in solution.items():
        program = parse(text).program
        for span in (each.span for each in walk(program.body if program is not None else ())):
            shorter = text[: span.start] + text[span.end :]
            if not parse(shorter).diagnostics and judge.programs({**solution, robot: shorter})[-1].is_solved:
                is_of_first = robot == judge.world.scene.robot_names[0]
                name = judge.challenge.name + ("" if is_of_first else f".{robot}")
                yield judge.words("challenge-test-spare", name=name, line=span.line)


def _faults_of_starts(judge: Judge) -> Iterator[str]:
    """Robots that begin inside something."""
    from sim.worldfile import standing_inside  # loads the parser

    words = judge.words
    for number, start in enumerate(judge.starts, start=1):
        for note in standing_inside(start.world.scene):
            said = f"{words('challenge-start', number=number)} {words(f'note-{note.code}', **note.details)}"
            yield words("challenge-verdict", file=judge.challenge.name, verdict=said)


MOST_SENTENCES = 5
"""On arrival: title and world, the task, and its limits."""
LONGEST_LINE = 80
"""Characters of a line that is spoken at once."""


def _faults_of_words(found: challenges.Challenge, words: Words) -> Iterator[str]:
    """Hints that a language lacks, and lines that are too long."""
    wanted = len(found.text(ENGLISH).hint)
    for language, text in found.texts.items():
        fault = partial(words, name=found.name, language=language)
        if len(text.hint) != wanted:
            yield fault("challenge-test-hints", count=len(text.hint), wanted=wanted)
        count = len(task_in_words(found, Words(language)))
        if count > MOST_SENTENCES:
            yield fault("challenge-test-sentences", count=count - 1, most=MOST_SENTENCES - 1)
        for line in (text.title, *text.sentences, *(each.text for each in text.hint)):
            if len(line) > LONGEST_LINE:
                yield fault("challenge-test-long", count=len(line), most=LONGEST_LINE, text=line)


_Texts: TypeAlias = tuple[tuple[str, str], ...]
"""Robots and their programs."""
FEW = 25
"""Programs for which another process isn't worth its start."""


def _pupils(judge: Judge, given: Sequence[str]) -> tuple[_Pupil, ...]:
    """Those whose programs were given: files, folders, or a program for each robot.

    In a world with several robots a folder with files such as ``alice.gd`` is that of one pupil. Raises
    ``Unusable`` for a robot that is not there.
    """
    named = [robot_and_file(each) for each in given]
    if not named or any(robot is None for robot, _ in named):
        return tuple(replace(each, given=name) for name in given for each in _in_folder(judge, name))
    files = by_robot(named, [*judge.room.robots], judge.words)
    return (_Pupil(", ".join(Path(file).name for file in files.values()), files),)


def _in_folder(judge: Judge, name: str) -> Iterator[_Pupil]:
    """Those of a folder, or of a file alone. A folder in it without programs is that of a pupil who handed in
    nothing."""
    is_of_one, first = bool(_files_of_robots(judge, name)), next(iter(judge.room.robots))
    for folder in (name,) if is_of_one else (*folders_in(name), name):
        if own := _files_of_robots(judge, folder):
            yield _Pupil(folder, own)
        else:
            programs = programs_in(folder)
            if not programs and folder != name and not Path(folder).name.startswith("."):
                yield _Pupil(folder, {})
            yield from (_Pupil(each, {first: each}, "" if folder == name else folder) for each in programs)


def _files_of_robots(judge: Judge, folder: str) -> Mapping[str, str]:
    """Its programs that are called as the robots are, where there are several."""
    if len(judge.room.robots) < 2 or not is_allowed(Path(folder)):
        return {}
    named = {folded(Path(each).stem): each for each in programs_in(folder) if each != folder}
    return {each: named[folded(each)] for each in judge.room.robots if folded(each) in named}


def _records(judge: Judge, pupils: Sequence[_Pupil]) -> Iterator[_Record]:
    """That of each pupil, in their order. Equal programs, which many hand in, are judged once.

    Many are judged in as many processes as there are processors; see ``in_processes``.
    """
    read = [_read(judge, each) for each in pupils]
    different = [*dict.fromkeys(each for each in read if isinstance(each, tuple))]
    judged, processes = partial(_judged, judge), min(processors(), len(different) // FEW)
    outcomes: Iterator[_Record] = map(judged, different)
    if processes > 1:
        outcomes = in_processes(judged, different, processes, instead=_Record("", None))
    known = dict[_Texts, _Record]()
    for pupil, given in zip(pupils, read, strict=True):
        if isinstance(given, str):
            yield _Record(pupil.name, None, verdict=given)
            continue
        outcome = known.get(given) or known.setdefault(given, next(outcomes))
        died = "" if outcome.verdict else judge.words("challenge-died", path=pupil.name)
        yield replace(outcome, file=pupil.name, verdict=outcome.verdict or died)


def _read(judge: Judge, pupil: _Pupil) -> _Texts | str:
    """The programs, or why they can't be read. Refuses links, which could lead to any other file."""
    texts = list[tuple[str, str]]()
    if not pupil.files:
        return judge.words("check-no-programs", path=pupil.name)
    try:
        for robot, file in pupil.files.items():
            if pupil.given and part_below(real_path(pupil.given), real_path(file)) is None:
                return judge.words("check-leads-out", path=file)
            texts.append((robot, read_source(file, judge.words).text))
    except Unusable as unusable:
        return unusable.sentence
    return tuple(texts)


def _judged(judge: Judge, texts: _Texts) -> _Record:
    verdicts = judge.programs(dict(texts))
    shown = verdicts[0] if verdicts[-1].is_solved else verdicts[-1]
    return _Record("", shown.is_solved, **shown.counts, verdict=verdict_in_words(verdicts, judge.words))
