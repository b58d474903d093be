"""A signal ends the conversation without a question: it stops the robots, then saves the text."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing, nullcontext
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from donnie_tui.bootstrap import assemble
from donnie_tui.commands.interaction import EnterWorld, SwitchMode
from donnie_tui.core.program_files import DocumentError
from donnie_tui.linear.conversation import Conversation
from donnie_tui.linear.leaving import Leaving
from donnie_tui.linear.prompter import Prompter
from donnie_tui.linear.reader import How, Typed
from donnie_tui.settings.settings import Settings
from tests.unit.commands.scripted import Script


def leaving_of(done: list[str], leaving: int | None = None) -> Leaving:
    """Records its calls, and can ask no question."""
    ctx: Any = SimpleNamespace(
        donnie=SimpleNamespace(
            team=SimpleNamespace(stop=lambda: done.append("stop"), has_unstopped_run=False),
            site=SimpleNamespace(is_saved=True),
            rescue_world=lambda: None,
            session=SimpleNamespace(
                hub=SimpleNamespace(wait_until_delivered=lambda: done.append("delivered"))
            ),
        ),
        workspace=SimpleNamespace(
            write_copies=lambda: done.append("keep"),
            leave_copies=lambda everything: done.append("drop copies"),
            current_first=(),
        ),
        answer=done.append,
    )
    streams: Any = SimpleNamespace(console=SimpleNamespace(leaving=leaving), is_attended=True)
    printer: Any = SimpleNamespace(show=lambda: done.append("shown"))
    prompter: Any = SimpleNamespace(copying=SimpleNamespace(cancel=lambda: None))
    unused: Any = None
    return Leaving(ctx, streams, printer, prompter, unused, set())


def test_a_signal_stops_all_robots_and_then_keeps_the_programs() -> None:
    done: list[str] = []
    leaving = leaving_of(done)
    leaving.leave_by_signal(15)

    assert (done, leaving.code) == (["stop", "keep"], 128 + 15)


def test_a_signal_during_leaving_counts() -> None:
    done: list[str] = []
    leaving = leaving_of(done, leaving=1)
    leaving.leave(0)

    assert (done, leaving.code) == (["stop", "keep"], 128 + 1)


@pytest.mark.parametrize(
    ("code", "happens"),
    [
        (0, ["goodbye", "delivered", "shown", "drop copies", "keep", "speak"]),
        (143, ["delivered", "shown"]),
        (2, ["delivered", "shown"]),
    ],
)
def test_a_goodbye_and_the_end_of_the_copies_come_with_code_0_only(code: int, happens: list[str]) -> None:
    done: list[str] = []
    leaving = leaving_of(done)
    leaving.code = code
    leaving.let_speak = lambda: done.append("speak")  # type: ignore[method-assign]
    leaving.say_goodbye()

    assert done == happens


# --- the mode of the next start


def asking(
    monkeypatch: pytest.MonkeyPatch, answer: bool | None, *, is_attended: bool = True
) -> tuple[list[object], Leaving]:
    """What is asked, kept and said, and a session that answers so."""
    done: list[object] = []
    leaving = leaving_of([])
    leaving._streams.is_attended = is_attended  # type: ignore[misc]

    def confirm(question: str) -> bool | None:
        done.append(question)
        return answer

    leaving._prompter.confirm = confirm  # type: ignore[method-assign]
    leaving._ctx.words = lambda code: code  # type: ignore[misc, assignment]
    leaving._ctx.answer = lambda code, **values: done.append(code)  # type: ignore[method-assign, assignment]
    monkeypatch.setattr(
        "donnie_tui.linear.leaving.remember", lambda key, value, environment: done.append((key, value))
    )
    return done, leaving


@pytest.mark.parametrize(("linear", "question"), [(True, "mode-ask-linear"), (False, "mode-ask-visual")])
def test_each_mode_is_offered_once_as_the_one_to_begin_in(
    monkeypatch: pytest.MonkeyPatch, linear: bool, question: str
) -> None:
    done, leaving = asking(monkeypatch, True)
    leaving.offer_to_remember(linear=linear)
    assert done == [question, ("linear", linear), "mode-remembered"]

    leaving.offer_to_remember(linear=linear)
    assert len(done) == 3
    leaving.offer_to_remember(linear=not linear)
    assert len(done) == 6


@pytest.mark.parametrize("answer", [False, None])
def test_without_a_yes_no_mode_is_kept(monkeypatch: pytest.MonkeyPatch, answer: bool | None) -> None:
    done, leaving = asking(monkeypatch, answer)
    leaving.offer_to_remember(linear=True)

    assert done == ["mode-ask-linear"]


def test_a_script_is_not_asked_and_a_mode_that_cannot_be_kept_is_reported(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    done, leaving = asking(monkeypatch, True, is_attended=False)
    leaving.offer_to_remember(linear=True)
    assert done == []

    def refuse(*_: object) -> None:
        raise DocumentError("file-unwritable", "settings", "full")

    done, leaving = asking(monkeypatch, True)
    monkeypatch.setattr("donnie_tui.linear.leaving.remember", refuse)
    leaving.offer_to_remember(linear=False)
    assert done == ["mode-ask-visual", "file-unwritable"]


# --- the voice at the end


@pytest.mark.parametrize(
    ("is_attended", "quiet_after", "disturbed_after", "checks"),
    [
        (True, 3, 99, 3),
        (True, 99, 2, 2),
        (True, 9999, 9999, 40),  # two seconds
        (False, 9999, 9999, 2400),  # two minutes
    ],
)
def test_the_voice_may_end_for_a_moment_until_a_key(
    is_attended: bool, quiet_after: int, disturbed_after: int, checks: int
) -> None:
    looks: list[float] = []

    class Audible:
        speaks = True

        def is_quiet_within(self, seconds: float) -> bool:
            looks.append(seconds)
            return len(looks) >= quiet_after

    waits: list[tuple[float, bool]] = []

    def is_disturbed_within(seconds: float, *, reading: bool) -> bool:
        waits.append((seconds, reading))
        return len(waits) >= disturbed_after

    leaving = leaving_of([])
    leaving._streams.is_attended = is_attended  # type: ignore[misc]
    leaving._ctx.donnie.outlets = SimpleNamespace(audible=Audible())  # type: ignore[assignment]
    leaving._console.is_disturbed_within = is_disturbed_within  # type: ignore[method-assign, assignment]
    leaving.let_speak()

    assert len(looks) == checks
    assert set(looks) == {0}
    assert set(waits) <= {(0.05, is_attended)}

    looks.clear()
    Audible.speaks = False
    leaving.let_speak()
    assert looks == []


# --- lines that wait, and programs that are not saved


class Program(SimpleNamespace):
    """A program of four lines, of which some may wait."""

    lines, path, open_block = ("FW 1",) * 4, None, None
    waiting, is_saved, is_worth_saving, is_kept_unasked = 0, False, True, False

    @property
    def is_waiting(self) -> bool:
        return self.waiting > 0


def ending(
    program: Program, done: list[str], *, is_attended: bool = True, answers: bool | None = None
) -> Leaving:
    """Answers each question so."""
    leaving = leaving_of(done)
    ctx: Any = leaving._ctx
    ctx.program, ctx.workspace.current_first = program, (program,)
    ctx.answer = lambda code, **values: done.append(" ".join([code, *map(str, values.values())]))
    ctx.refuse = lambda code: done.append(f"refused {code}")
    ctx.errors = SimpleNamespace(all=())
    ctx.words = type(
        "Words", (), {"language": "pt", "__call__": lambda _, code, **values: f"{code} {values}"}
    )()
    ctx.runs = SimpleNamespace(stop_to_leave=lambda: done.append("runs stopped"))
    ctx.answer_entering = lambda name: done.append(f"entering {name}")
    leaving._streams.is_attended = is_attended  # type: ignore[misc]
    leaving._background = SimpleNamespace(stop=lambda: done.append("background"))  # type: ignore[assignment]
    leaving._prompter.confirm = lambda question: done.append(question) or answers  # type: ignore[method-assign,func-returns-value]
    leaving._prompter.has_ended = False
    return leaving


@pytest.mark.parametrize(
    ("waiting", "wrong_line", "block", "is_attended", "is_failure", "done"),
    [
        (0, 4, None, False, True, []),
        (2, None, None, True, True, ["lines-did-not-run 2 EXECUTAR"]),
        (2, None, "IF", True, True, ["lines-did-not-run 2 FIM SE"]),
        (2, 2, None, True, True, ["lines-did-not-run 2 EXECUTAR"]),
        (2, 3, None, True, True, ["lines-did-not-run-mistake 2"]),
        (1, 4, None, False, True, ["refused 1", "lines-did-not-run-mistake 1"]),
        (1, None, None, False, False, ["lines-did-not-run 1 EXECUTAR"]),
    ],
)
def test_lines_that_wait_at_the_end_are_reported(
    waiting: int,
    wrong_line: int | None,
    block: str | None,
    is_attended: bool,
    is_failure: bool,
    done: list[str],
) -> None:
    happened: list[str] = []
    opened = SimpleNamespace(kind=block) if block else None
    program = Program(waiting=waiting, is_saved=True, open_block=opened)
    leaving = ending(program, happened, is_attended=is_attended)
    if wrong_line is not None:
        leaving._ctx.errors.all = (SimpleNamespace(line=wrong_line),)  # type: ignore[misc,assignment]
    leaving.close(is_failure=is_failure)

    assert (happened, leaving.code) == (done, 0)


ASKED = "ask-save {'lines': 4}"


@pytest.mark.parametrize(
    ("program", "is_attended", "answers", "code", "done"),
    [
        ({"is_saved": True}, True, None, 0, []),
        ({"is_saved": True, "is_kept_unasked": True}, True, None, 0, ["left-kept 4"]),
        ({"is_kept_unasked": True}, False, None, 0, []),
        ({"is_worth_saving": False}, True, None, 0, []),
        ({"is_worth_saving": False, "waiting": 1}, True, False, 0, [ASKED, "left-unsaved"]),
        ({}, True, False, 0, [ASKED, "left-unsaved"]),
        ({}, True, None, None, [ASKED, "stays-unsaved"]),
        ({}, False, None, 0, []),
    ],
)
def test_a_program_that_would_be_missed_is_asked_about(
    program: dict[str, Any], is_attended: bool, answers: bool | None, code: int | None, done: list[str]
) -> None:
    happened: list[str] = []
    leaving = ending(Program(**program), happened, is_attended=is_attended, answers=answers)
    leaving.leave(0)

    assert (happened, leaving.code) == (done, code)


def test_where_the_input_ends_in_place_of_an_answer_all_is_kept() -> None:
    done: list[str] = []
    leaving = ending(Program(), done)
    leaving._prompter.has_ended = True
    leaving.leave(3)
    assert (done, leaving.code) == ([ASKED, "keep", "answer-rescued"], 3)

    done.clear()
    leaving.let_speak = lambda: done.append("speak")  # type: ignore[method-assign]
    leaving.code = 0
    leaving.say_goodbye()
    assert done == ["goodbye", "delivered", "shown", "speak"], "the copies stay as they are"


@pytest.mark.parametrize("is_saved", [True, False])
def test_a_program_that_the_learner_wants_to_keep_is_saved_to_its_file(
    monkeypatch: pytest.MonkeyPatch, is_saved: bool
) -> None:
    done: list[str] = []

    async def save(_: object, name: str) -> bool:
        done.append(f"saved {name}")
        return is_saved

    monkeypatch.setattr("donnie_tui.commands.files.save_document", save)
    for path, name in ((Path("a.gd"), "a.gd"), (None, "")):
        done.clear()
        leaving = ending(Program(path=path), done, answers=True)
        leaving._ctx.workspace.as_current = lambda _: nullcontext()  # type: ignore[method-assign,assignment,return-value]
        leaving.leave(0)

        assert done == [ASKED, f"saved {name}", *([] if is_saved else ["stays-unsaved"])]
        assert leaving.code == (0 if is_saved else None)


@pytest.mark.parametrize(
    ("is_program_saved", "may_leave", "code", "done"),
    [
        (True, True, 0, ["world asked"]),
        (True, False, None, ["world asked", "stays-unsaved"]),
        (False, True, None, [ASKED, "stays-unsaved"]),
    ],
)
def test_a_built_world_is_asked_about_after_the_programs(
    monkeypatch: pytest.MonkeyPatch,
    is_program_saved: bool,
    may_leave: bool,
    code: int | None,
    done: list[str],
) -> None:
    happened: list[str] = []

    async def ask(_: object) -> bool:
        happened.append("world asked")
        return may_leave

    monkeypatch.setattr("donnie_tui.commands.build.may_leave_built", ask)
    monkeypatch.setattr("donnie_tui.commands.build.keep_built", lambda _: happened.append("world kept"))
    leaving = ending(Program(is_saved=is_program_saved), happened)
    leaving._ctx.donnie.site.is_saved = False  # type: ignore[misc]
    leaving.leave(0)
    assert (happened, leaving.code) == (done, code)

    happened.clear()
    leaving._prompter.has_ended = True
    leaving.leave(0)
    if not is_program_saved:
        assert happened == [ASKED, "keep", "world kept", "answer-rescued"]
    elif not may_leave:
        assert happened == ["world asked", "keep", "world kept"]


@pytest.mark.parametrize(("was_opened", "is_failure"), [(True, False), (False, True)])
def test_quit_is_a_program_and_no_failure_of_a_script_that_opened_another(
    monkeypatch: pytest.MonkeyPatch, was_opened: bool, is_failure: bool
) -> None:
    done: list[str] = []

    async def run(_: object, line: str) -> None:
        done.append(line)

    monkeypatch.setattr("donnie_tui.linear.leaving.run_alone", run)
    leaving = ending(Program(waiting=1, is_saved=True, was_opened=was_opened), done, is_attended=False)
    leaving.quit()

    assert done == ["SAIR", *(["refused 1"] if is_failure else []), "lines-did-not-run 1 EXECUTAR"]
    assert leaving.code == 0


def test_the_learner_may_quit_while_a_client_drives_a_robot(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    donnie = assemble(Settings(world="two_robots", speech="off", sound=False), terminal=True)
    with closing(donnie), closing(Script(donnie)) as script:
        script.ctx.workspace.begin_with(donnie.session.name)
        donnie.session.is_taken = lambda: True
        others: Any = SimpleNamespace(
            console=SimpleNamespace(leaving=None), is_attended=True, is_running=False
        )
        leaving = Leaving(script.ctx, others, others, others, others, set())
        leaving.quit()

    assert (leaving.code, script.printed) == (0, [])


def test_robots_in_the_background_stop_only_when_nothing_keeps_the_learner() -> None:
    done: list[str] = []
    leaving = ending(Program(is_saved=True), done)
    leaving._ctx.donnie.team.has_unstopped_run = True  # type: ignore[misc]
    leaving.leave(0)
    assert done == ["background"]
    done.clear()
    leaving = ending(Program(), done)
    leaving._ctx.donnie.team.has_unstopped_run = True  # type: ignore[misc]
    leaving.leave(0)
    assert done == [ASKED, "stays-unsaved"]


@pytest.mark.parametrize(
    ("running", "is_attended", "line", "code", "done"),
    [
        (("alice",), True, "FW", None, ["background"]),
        (("alice",), False, "", None, ["background"]),
        ((), False, "FW", 130, []),
        ((), True, "FW", None, ["line-cleared"]),
        ((), True, "", None, ["nothing-to-stop"]),
    ],
)
def test_ctrl_c_at_the_prompt_stops_the_background_ends_a_script_or_clears_the_line(
    running: tuple[str, ...], is_attended: bool, line: str, code: int | None, done: list[str]
) -> None:
    happened: list[str] = []
    leaving = ending(Program(), happened, is_attended=is_attended)
    leaving._ctx.donnie.team.running = running  # type: ignore[misc,assignment]
    leaving.interrupt(line)

    assert (happened, leaving.code) == (done, code)


def test_another_world_is_entered_once_the_runs_are_stopped() -> None:
    done: list[str] = []
    leaving = ending(Program(), done)
    leaving.enter_world()
    assert done == []
    leaving.world = "maze"
    with pytest.raises(EnterWorld):
        leaving.enter_world()
    assert (done, leaving.world) == (["runs stopped", "entering maze"], "")


def test_the_screen_gets_the_program_and_its_name_unless_a_signal_comes(tmp_path: Path) -> None:
    done: list[str] = []
    leaving = ending(Program(text="FW 1", path=tmp_path / "a.gd"), done)
    leaving._offered.add(False)
    leaving._streams.editing = None  # type: ignore[misc]
    leaving.switch_to_screen()
    assert done == ["screen-needs-terminal"]
    leaving._streams.editing = object()  # type: ignore[misc,assignment]
    leaving._console.leaving = 15
    leaving.switch_to_screen()
    assert done == ["screen-needs-terminal"]
    leaving._console.leaving = None
    with pytest.raises(SwitchMode) as switch:
        leaving.switch_to_screen()
    assert (switch.value.text, switch.value.name) == ("FW 1", str(tmp_path / "a.gd"))
    assert switch.value.donnie is leaving._ctx.donnie
    assert done[1:] == ["runs stopped", "shown"]
    leaving._ctx.program.path = None
    with pytest.raises(SwitchMode) as switch:
        leaving.switch_to_screen()
    assert switch.value.name is None


# --- a question


@pytest.mark.parametrize(
    ("typed", "answer", "asked", "put_back"),
    [
        (["yes"], True, ["Save?"], None),
        (["sim"], True, ["Save?"], None),
        (["N"], False, ["Save?"], None),
        (["perhaps", "what", "y"], True, ["Save?", "yes-or-no", "yes-or-no"], None),
        ([None], None, ["Save?"], None),
        (["perhaps", None], None, ["Save?", "yes-or-no"], None),
        (["WHERE"], None, ["Save?"], "WHERE"),
        (["fw 3"], None, ["Save?"], "fw 3"),
        (["perhaps", "list 2"], None, ["Save?", "yes-or-no"], "list 2"),
    ],
)
def test_yes_or_no_is_asked_until_it_is_answered_or_a_command_is_typed(
    typed: list[str | None], answer: bool | None, asked: list[str], put_back: str | None
) -> None:
    questions: list[str] = []
    returned: list[Typed] = []

    def ask(question: str) -> str | None:
        questions.append(question)
        return typed.pop(0)

    prompter: Any = SimpleNamespace(
        ask=ask, put_back=returned.append, _ctx=SimpleNamespace(words=lambda code: code)
    )

    assert Prompter.confirm(prompter, "Save?") is answer
    assert questions == asked
    assert returned == ([] if put_back is None else [Typed(put_back, How.ENTER)])


@pytest.mark.parametrize(
    ("typed", "text", "has_ended"),
    [
        (lambda: Typed(" walk ", How.ENTER), "walk", False),
        (lambda: Typed("", How.ENTER), "", False),
        (lambda: Typed("walk", How.ESCAPE), "walk", False),
        (lambda: Typed(" ", How.ESCAPE), None, False),
        (lambda: Typed("walk", How.CLOSED), None, True),
    ],
)
def test_an_answer_is_what_enter_or_escape_with_a_text_ends(
    typed: Callable[[], Typed], text: str | None, has_ended: bool
) -> None:
    said: list[str] = []
    prompter: Any = SimpleNamespace(_ctx=SimpleNamespace(say=said.append), read=lambda prompt: typed())

    assert Prompter.ask(prompter, "Name?") == text
    assert (said, prompter.has_ended) == (["Name?"], has_ended)


# --- the exit code


@pytest.mark.parametrize(
    ("is_attended", "kept", "refused", "had_mistakes", "code"),
    [
        (True, 3, 1, True, 0),  # learners correct their mistakes
        (False, 0, 0, False, 0),
        (False, 0, 0, True, 1),
        (False, 0, 1, False, 1),
        (False, 2, 1, True, 2),
        (False, 1, 2, False, 2),
    ],
)
def test_a_script_reports_the_worst_that_happened_with_its_exit_code(
    is_attended: bool, kept: int, refused: int, had_mistakes: bool, code: int
) -> None:
    conversation: Any = SimpleNamespace(
        streams=SimpleNamespace(is_attended=is_attended),
        ctx=SimpleNamespace(script_code=refused, errors=SimpleNamespace(had_any=had_mistakes)),
        _state=SimpleNamespace(script_code=kept),
    )

    assert Conversation._code_of_script(conversation) == code


@pytest.mark.parametrize(
    ("typed", "leaving", "done"),
    [
        (Typed("FW 1", How.ENTER), 15, ["signal 15", "world"]),
        (Typed("", How.CLOSED), None, ["close", "world"]),
        (Typed("FW", How.INTERRUPTED), None, ["interrupt FW", "world"]),
        (Typed("x", How.TOO_LONG), None, ["program-too-long", "world"]),
        (Typed("FW 1", How.ENTER), None, ["again FW 1", "world"]),
        (Typed("FW 1", How.ESCAPE), None, ["remember FW 1", "run FW 1", "world"]),
    ],
)
def test_a_line_is_taken_by_how_it_ended(typed: Typed, leaving: int | None, done: list[str]) -> None:
    happened: list[str] = []

    def note(what: str) -> Callable[..., None]:
        return lambda *values: happened.append(" ".join([what, *map(str, values)]))

    lines = SimpleNamespace(continuation="REPEAT 2", take_and_run=note("run"))
    conversation: Any = SimpleNamespace(
        console=SimpleNamespace(leaving=leaving),
        leaving=SimpleNamespace(
            leave_by_signal=note("signal"), close=note("close"), interrupt=note("interrupt"),
            enter_world=note("world"),
        ),
        typed_lines=lines,
        ctx=SimpleNamespace(answer=happened.append),
        take_again=note("again"),
        _state=SimpleNamespace(past=SimpleNamespace(remember=note("remember"))),
    )  # fmt: skip
    Conversation._take(conversation, typed)

    assert happened == (done[:1] if leaving else done)
    assert lines.continuation == (None if typed.how is How.INTERRUPTED else "REPEAT 2")
