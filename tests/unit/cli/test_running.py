"""How ``donnie run`` waits for its programs, stops them and ends, on a session that only takes notes."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import count
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest

from donnie_tui.cli import run as run_module
from donnie_tui.cli.options import ExitCode
from donnie_tui.core.events import Answered, Outcome, Spoke, Stamped
from donnie_tui.core.runner import RunRequest
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.settings.settings import SettingSource
from donnie_tui.world import loading


class Ended(Exception):
    """Raised in place of the end of the process."""


class Running:
    """A session with runs that end as the test says."""

    def __init__(self, *outcomes: Outcome | None, ends_after: int = 0, has_run_away: bool = False) -> None:
        self.did: list[Any] = []
        self.runs = [self._run(each, ends_after) for each in outcomes]
        self.donnie: Any = Part(
            team=Part(stop=lambda: self.did.append("stopped"), start_together=self._start),
            connection=Part(
                has_run_away=has_run_away,
                wait_until_standing=lambda: self.did.append("stands"),
                close=lambda: self.did.append("connection closed"),
            ),
            outlets=Part(audible=Part(is_still_within=lambda _: self.did.append("is silent") or True)),
            stop_real_robot=bool,
            words=Words(),
            close=lambda: self.did.append("closed"),
        )
        self.output: Any = Part(
            on_broken=None, complaint=self.did.append, line=self.did.append, is_stuck=lambda: False
        )

    def _run(self, outcome: Outcome | None, ends_after: int) -> Any:
        waits = list[float]()

        def wait(seconds: float) -> bool:
            waits.append(seconds)
            return len(waits) > ends_after

        return Part(outcome=outcome, wait=wait, waits=waits)

    def _start(self, programs: object, options: Any) -> list[Any]:
        self.did.append((programs, options.trace, options.hooked))
        return self.runs


@pytest.mark.parametrize(
    ("outcomes", "code"),
    [
        ((Outcome.COMPLETED,), ExitCode.DONE),
        ((Outcome.QUIT,), ExitCode.DONE),
        ((Outcome.FAILED,), ExitCode.FAILED),
        ((Outcome.STOPPED,), ExitCode.STOPPED),
        ((None,), ExitCode.FAILED),
        ((Outcome.COMPLETED, Outcome.FAILED, Outcome.QUIT), ExitCode.FAILED),
        ((Outcome.FAILED, Outcome.STOPPED), ExitCode.STOPPED),
    ],
)
def test_the_worst_program_is_the_exit_code(outcomes: tuple[Outcome | None, ...], code: ExitCode) -> None:
    it = Running(*outcomes)

    assert run_module._run_to_the_end(it.donnie, {}, it.output, trace=True) is code
    assert it.did == [({}, True, False), "is silent", "closed"]
    assert it.output.on_broken == it.donnie.team.stop
    assert [each.waits for each in it.runs] == [[0.5]] * len(outcomes)


def test_a_run_is_waited_for_in_steps_until_it_ends() -> None:
    it = Running(Outcome.COMPLETED, ends_after=3)
    run_module._await_end(it.runs[0], threading.Event(), it.donnie, it.output)

    assert (it.runs[0].waits, it.did) == ([0.5] * 4, [])


@pytest.mark.parametrize("has_stopped", [True, False])
def test_what_a_suspension_did_is_a_complaint(has_stopped: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    it, stopped = Running(Outcome.COMPLETED), threading.Event()

    @contextmanager
    def suspended(stop: Callable[[], bool], refuse: Callable[[], object]) -> Iterator[threading.Event]:
        assert stop is it.donnie.stop_real_robot
        refuse()
        if has_stopped:
            stopped.set()
        yield stopped

    monkeypatch.setattr(run_module, "stopped_by_suspension", suspended)
    run_module._run_to_the_end(it.donnie, {}, it.output, trace=True)

    refused, said = Words()("suspend-impossible"), Words()("suspended-stopped")
    assert it.did == [refused, ({}, True, False), "is silent", "closed", *[said] * has_stopped]


@pytest.fixture
def codes(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The exit codes with which the process was left at once."""
    left = list[int]()

    def leave(code: int) -> None:
        left.append(code)
        raise Ended

    monkeypatch.setattr(run_module.os, "_exit", leave)
    return left


@pytest.mark.parametrize(("has_run_away", "code"), [(False, 130), (True, 1)])
@pytest.mark.parametrize(
    ("ends_after", "waits"),
    [(9, [0.5, 1.0]), (1, [0.5, 1.0]), (0, [0.5])],
    ids=["never", "in time", "before the stop"],
)
def test_a_stopped_run_with_stuck_output_is_left_once_its_robot_stands(
    codes: list[int], has_run_away: bool, code: int, ends_after: int, waits: list[float]
) -> None:
    it, stopped = Running(None, ends_after=ends_after, has_run_away=has_run_away), threading.Event()
    it.output.is_stuck = lambda: True
    stopped.set()
    with pytest.raises(Ended):
        run_module._await_end(it.runs[0], stopped, it.donnie, it.output)

    assert it.did == [*["stands"] * (ends_after > 0), "stopped", "connection closed"]
    assert codes == [code]
    assert it.runs[0].waits == waits


def test_a_stopped_run_may_end_late_on_a_busy_computer(codes: list[int]) -> None:
    it, stopped = Running(Outcome.STOPPED, ends_after=5), threading.Event()
    stopped.set()
    run_module._await_end(it.runs[0], stopped, it.donnie, it.output)

    assert it.runs[0].waits == [0.5, *[1.0] * 5]
    assert (it.did, codes) == (["stands"], [])


def test_a_stopped_run_that_never_ends_is_left_in_the_end(
    codes: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    it, stopped, seconds = Running(None, ends_after=99), threading.Event(), count(0.0, 1.0)
    monkeypatch.delenv("DONNIE_ROBOT_TIMEOUTS", raising=False)
    monkeypatch.setattr(run_module.time, "monotonic", lambda: next(seconds))
    stopped.set()
    with pytest.raises(Ended):
        run_module._await_end(it.runs[0], stopped, it.donnie, it.output)

    assert codes == [130]
    assert it.runs[0].waits == [0.5, *[1.0] * 11]


def test_what_programs_say_is_the_output_and_what_donnie_says_a_complaint() -> None:
    said, ours = Stamped(1, 0.0, Spoke("hello")), Stamped(2, 0.0, Answered("Careful."))
    for with_words, lines in ((True, ["hello"]), (False, [])):
        out, err = list[str](), list[str]()
        output: Any = Part(line=out.append, complaint=err.append)
        donnie: Any = Part(words=Words())
        show = run_module._printer(donnie, output, with_words=with_words)
        show(said)
        show(ours)
        assert (out, err) == (lines, ["Careful."])


@pytest.mark.parametrize(
    ("source", "printed"),
    [
        (SettingSource.DEFAULT, ["the world", "the robot"]),
        (SettingSource.OPTION, ["the world", "a setting", "the voice", "the robot"]),
    ],
)
def test_what_is_missing_of_the_voice_is_said_only_if_it_was_asked_for(
    source: SettingSource, printed: list[str]
) -> None:
    lines = list[str]()
    notices = Part(
        all=("the world", "a setting", "the voice", "the robot"),
        about_world=("the world",),
        about_devices=("the robot",),
    )
    settings: Any = Part(source_of=lambda key: source if key == "speech" else SettingSource.ENVIRONMENT)
    run_module._print_notices(settings, Part(notices=notices), Part(complaint=lines.append))  # type: ignore[arg-type]

    assert lines == printed


class Assembling:
    """Signals that come while a session is made; the search for a robot ends if it is one."""

    def __init__(self, patched: pytest.MonkeyPatch, *, signals: int, searches: bool = False) -> None:
        self.did: list[str] = []
        self.signals = signals
        self.problem: BaseException | None = None
        patched.setattr(run_module, "Search", lambda: Part(give_up=lambda: self._give_up(searches)))
        patched.setattr(run_module, "on_signals", self._on_signals)
        patched.setattr(run_module, "assemble", self._assemble)

    def _give_up(self, searches: bool) -> bool:
        self.did.append("search given up")
        return searches

    def _on_signals(self, give_up: Callable[[], None]) -> Any:
        from contextlib import nullcontext

        self.give_up = give_up
        return nullcontext()

    def _assemble(self, settings: object, **named: Any) -> Any:
        assert named["terminal"] is False
        for _ in range(self.signals):
            self.give_up()
        if self.problem is not None:
            raise self.problem
        return Part(close=lambda: self.did.append("closed"))

    def make(self) -> Any:
        order: Any = Part(settings="settings", output=Part())
        return run_module._assembled(order)


def test_without_a_signal_the_session_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    it = Assembling(monkeypatch, signals=0)
    assert it.make().close
    it.problem = Unusable("It is damaged.")
    with pytest.raises(Unusable):
        it.make()
    assert it.did == []


def test_a_signal_ends_the_search_or_else_the_start(monkeypatch: pytest.MonkeyPatch) -> None:
    it = Assembling(monkeypatch, signals=2, searches=True)
    it.problem = Unusable("There is no robot.")
    with pytest.raises(KeyboardInterrupt):
        it.make()
    assert it.did == ["search given up"], "the second signal must not end the closing"

    it = Assembling(monkeypatch, signals=1, searches=True)
    with pytest.raises(KeyboardInterrupt):
        it.make()
    assert it.did == ["search given up", "closed"], "it came too late for the search"

    it = Assembling(monkeypatch, signals=1)
    with pytest.raises(KeyboardInterrupt):
        it.make()
    assert it.did == ["search given up"]


# --- which programs and which files


@pytest.fixture
def lessons(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("sub").mkdir()
    Path("a.gd").write_text("FW 1\n")
    Path("sub", "b.gd").write_text("FW 2\n")


@pytest.mark.usefixtures("lessons")
def test_each_program_is_called_as_its_file_without_the_folder() -> None:
    ana, rui = RunRequest("FW 1\n", "a.gd"), RunRequest("FW 2\n", "b.gd")

    assert run_module.read_programs(["a.gd"], Words()) == ((None, ana),)
    assert run_module.read_programs(["ana=a.gd", "rui=sub/b.gd"], Words()) == (("ana", ana), ("rui", rui))


@pytest.mark.usefixtures("lessons")
@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        (["ana=a.gd", "sub/b.gd"], "Which robot runs sub/b.gd? Write ROBOT=sub/b.gd."),
        (["-", "-"], "Which robot runs -? Write ROBOT=-."),
        (["ana=-", "rui=-"], "Only one robot can take its program from standard input."),
        (["c.gd"], "There is no file c.gd."),
    ],
)
def test_programs_that_can_not_be_read_or_belong_to_no_robot_are_refused(
    given: list[str], sentence: str
) -> None:
    with pytest.raises(Unusable) as refused:
        run_module.read_programs(given, Words())
    assert refused.value.sentence == sentence


@pytest.mark.parametrize(
    ("arguments", "files"),
    [
        ({}, []),
        ({"file": "a.gd"}, ["a.gd"]),
        ({"file": None, "run": None}, []),
        ({"file": ["ana=a.gd", "b.gd"]}, ["ana=a.gd", "a.gd", "b.gd"]),
        ({"file": "a.gd", "run": "x=y=z"}, ["a.gd", "x=y=z", "y=z"]),
    ],
)
def test_no_file_that_may_be_a_program_is_written(arguments: dict[str, Any], files: list[str]) -> None:
    order: Any = Part(invocation=Part(arguments=Part(**arguments)))

    assert [*run_module._programs(order)] == files


@pytest.mark.usefixtures("lessons")
@pytest.mark.parametrize(
    ("command", "arguments", "world", "outputs", "files"),
    [
        ("run", {}, "my.world", ["a.gd"], ("my.world", "my.inc")),
        ("run", {"name": None}, "my.world", ["new", "a.gd"], ("my.world", "my.inc")),
        ("world", {"name": ["your.world"]}, "my.world", ["a.gd"], ("your.world", "your.inc")),
        ("world", {"name": []}, "my.world", ["a.gd"], ("my.world", "my.inc")),
        ("run", {}, "my.world", ["new", "sub"], ()),
        ("run", {}, "my.world", [], ()),
        ("run", {}, "maze", ["a.gd"], ()),
        ("replay", {}, "my.world", ["a.gd"], ()),
    ],
)
def test_the_files_of_a_world_are_looked_for_only_where_one_of_them_may_be_replaced(
    command: str,
    arguments: dict[str, Any],
    world: str,
    outputs: list[str],
    files: tuple[str, ...],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(loading, "choose_world", lambda name, _words, folders: (name, folders))
    monkeypatch.setattr(loading, "files_of", lambda world: (f"{world[0].partition('.')[0]}.{world[1]}",))
    order: Any = Part(
        invocation=Part(command=command, arguments=Part(**arguments)),
        settings=Part(world=world, include_folders="inc"),
        words=Words(),
    )

    found = run_module._files_of_world(order, tuple(("--record", Path(each)) for each in outputs))
    assert found == files


# --- the whole command


@pytest.mark.parametrize(
    ("has_run_away", "lost", "code", "expected"),
    [
        (False, [], ExitCode.DONE, ExitCode.DONE),
        (False, [], ExitCode.STOPPED, ExitCode.STOPPED),
        (True, [], ExitCode.STOPPED, ExitCode.FAILED),
        (True, ["a.rec"], ExitCode.DONE, ExitCode.UNUSABLE),
    ],
)
@pytest.mark.parametrize(("events", "with_words"), [(None, True), ("-", False), ("b.jsonl", True)])
def test_a_run_ends_with_its_code_unless_the_robot_or_a_file_was_lost(
    has_run_away: bool,
    lost: list[str],
    code: ExitCode,
    expected: ExitCode,
    events: str | None,
    with_words: bool,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    did = list[Any]()
    donnie: Any = Part(
        team=Part(names=("ana",)),
        session=Part(hub=Part(subscribe=did.append)),
        connection=Part(has_run_away=has_run_away),
        outlets=Part(written=Part(lost=lost)),
        close=lambda: did.append("closed"),
    )
    program = RunRequest("FW 1", "a.gd")
    monkeypatch.setattr(run_module, "read_programs", lambda files, _words: ((None, program),))
    monkeypatch.setattr(run_module, "_assembled", lambda _order: donnie)
    monkeypatch.setattr(run_module, "_print_notices", lambda *_: did.append("notices"))
    monkeypatch.setattr(run_module, "_printer", lambda *_, with_words: ("printer", with_words))
    monkeypatch.setattr(run_module, "_run_to_the_end", lambda *given: did.append(given[1:]) or code)
    order: Any = Part(
        words=Words(),
        output="output",
        settings=Part(events=events),
        invocation=Part(arguments=Part(run="a.gd", file=["a.gd"], trace=True, challenge=None)),
    )

    for command, trace in ((run_module.run, True), (run_module.run_original, False)):
        did.clear()
        assert command(order) is expected
        assert did == [
            *("notices", ("printer", with_words), ({"ana": program}, "output", trace)),
            "closed",
        ]


def test_a_run_with_a_challenge_is_only_judged(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("donnie_tui.cli.programs.check_challenge", lambda *given: given[1:])
    order: Any = Part(invocation=Part(arguments=Part(challenge="1", file=["a.gd"])))

    assert run_module.run(order) == ("1", ["a.gd"])
