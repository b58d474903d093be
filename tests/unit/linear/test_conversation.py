"""How a conversation begins, what it hands over, and what it keeps however it ends; on a scripted console."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest

from donnie_tui.commands.interaction import EnterWorld, SwitchMode
from donnie_tui.linear.console import Gone
from donnie_tui.linear.conversation import Conversation
from donnie_tui.linear.greeting import Greeting
from donnie_tui.linear.line_editor import Act, KeyPress
from tests.timeouts import TIMEOUT
from tests.unit.linear import test_pace
from tests.unit.linear.test_pace import conversation

LEARNER: set[int] = {0, 1}
SCRIPT: set[int] = set()


@pytest.fixture
def talks(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[Callable[..., Any]]:
    """``with talks(LEARNER) as talk``."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    yield lambda terminals: conversation(monkeypatch, tmp_path, terminals)


def printed(talk: Conversation) -> list[str]:
    """The lines that wait to be printed."""
    talk.ctx.donnie.session.hub.wait_until_delivered(TIMEOUT)
    return talk.streams.queue.take()


def without_talking(talk: Conversation, monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """Notes how lines would be taken, and takes none."""
    taken = list[Any]()
    monkeypatch.setattr(talk, "_take_lines", lambda *, is_shown: taken.append(is_shown) or 0)
    monkeypatch.setattr(
        talk.leaving, "offer_to_remember", lambda *, linear: taken.append(f"offered {linear}")
    )
    return taken


# --- the beginning


def test_the_program_of_the_full_screen_is_taken_over(
    talks: Callable[..., Any], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    (tmp_path / "a.gd").write_text("FW 1\nFW 2\n")
    for text, file, is_saved, said in (
        ("FW 1\nFW 2\n", "a.gd", True, ["Your program has 2 lines."]),
        ("FW 9\n", "a.gd", False, ["Your program has 1 line."]),
        ("FW 9\n", None, False, ["Your program has 1 line."]),
        ("", None, True, []),
    ):
        with talks(LEARNER) as talk:
            taken = without_talking(talk, monkeypatch)
            talk._greeting.lines, talk._greeting.has_prompt = ("Hello.",), True
            assert talk.begin(file, text) == 0
            program = talk.ctx.program
            assert (program.lines, program.path, program.is_saved) == (
                *(tuple(text.splitlines()), Path(file) if file else None, is_saved),
            )
            assert printed(talk) == said
            assert taken == [True], "the prompt is shown"


def test_a_file_is_opened_and_one_that_is_missing_is_reported(
    talks: Callable[..., Any], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    (tmp_path / "a.gd").write_text("FW 1\n")
    for file, said in (("a.gd", "Opened a.gd, 1 line."), ("b.gd", "There is no file b.gd.")):
        with talks(LEARNER) as talk:
            taken = without_talking(talk, monkeypatch)
            assert talk.begin(file, offers_to_remember=True) == 0
            assert printed(talk) == [said]
            assert taken == ["offered True", False]


def test_what_is_missing_is_said_and_about_the_robot_at_once(
    talks: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    for about_devices, is_urgent in ((("No robot.",), True), ((), False)):
        with talks(LEARNER) as talk:
            without_talking(talk, monkeypatch)
            notices = Part(all=("A notice.", *about_devices), about_devices=about_devices)
            monkeypatch.setattr(talk, "_donnie", Part(notices=notices, outlets=talk._donnie.outlets))
            talk.begin(None)
            assert printed(talk) == ["A notice.", *about_devices]
            assert talk.console.has_news is is_urgent


@pytest.mark.parametrize(
    ("terminals", "is_reported", "says_so"),
    [(LEARNER, False, True), (LEARNER, True, False), (SCRIPT, False, False)],
)
def test_a_rescued_program_is_reported_once_to_a_learner(
    talks: Callable[..., Any],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    terminals: set[int],
    is_reported: bool,
    says_so: bool,
) -> None:
    copies = tmp_path / "donnie" / "unsaved"
    copies.mkdir(parents=True)
    (copies / "unsaved-99999999-1.gd").write_text("FW 9\n")
    with talks(terminals) as talk:
        without_talking(talk, monkeypatch)
        talk._greeting.has_reported_rescue = is_reported
        talk.begin(None)

        assert ["rescued" in each or "RECOVER" in each for each in printed(talk)] == [True] * says_so


def test_lines_are_taken_until_there_is_a_code_and_the_prompt_is_shown_only_once(
    talks: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    with talks(LEARNER) as talk:
        asked, taken = list[tuple[str, bool]](), list[str]()

        def read(prompt: str, *, shown: bool) -> str:
            asked.append((prompt, shown))
            return f"line {len(asked)}"

        def take(typed: str) -> None:
            taken.append(typed)
            if len(taken) == 1:
                talk.ctx.program.add("REPEAT 2 TIMES")
            elif len(taken) == 3:
                talk.leaving.code = 7

        monkeypatch.setattr(talk.prompter, "read", read)
        monkeypatch.setattr(talk, "_take", take)
        monkeypatch.setattr(talk.leaving, "say_goodbye", lambda: taken.append("goodbye"))
        talk._greeting.has_prompt = True

        assert talk.begin(None) == 7
        assert asked == [("> ", True), ("1> ", False), ("1> ", False)]
        assert taken == ["line 1", "line 2", "line 3", "goodbye"]
        assert len(talk.console.once_idle) == 1, "what the first movement needs is loaded"
    with talks(SCRIPT) as talk:
        monkeypatch.setattr(talk.leaving, "say_goodbye", lambda: None)
        talk.leaving.code = 0
        assert talk.begin(None) == 0
        assert talk.console.once_idle == []


def test_in_another_world_it_is_described_and_the_lines_of_the_program_are_counted(
    talks: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    with talks(LEARNER) as talk:
        taken = without_talking(talk, monkeypatch)
        talk.ctx.program.add("FW 1")
        assert talk.resume() == 0
        said = printed(talk)

        assert said[0].startswith("This is the world open_floor")
        assert said[-1] == "Your program has 1 line."
        assert taken == [False]


# --- what is handed over


def test_the_next_conversation_has_the_state_of_this_one(
    talks: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    with talks(SCRIPT) as talk:
        talk.ctx.runs.watched.append("speed")
        talk.ctx.refuse(2)
        state = talk.state_for_next_world()
        assert (state.watched, state.script_code, state.workspace) == (("speed",), 2, talk.ctx.workspace)
        assert state.is_silent is not talk._donnie.outlets.audible.is_on
        other = Conversation(talk._donnie, talk.console, talk.ctx.preferences, talk._greeting, state)
        assert [*other.ctx.runs.watched] == ["speed"]
        assert (other.ctx.past, other.ctx.answers) == (talk.ctx.past, talk.ctx.answers)
        assert other.state_for_next_world().script_code == 2
        other.close()


def test_the_console_knows_what_to_stop_and_what_to_keep(
    talks: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    for terminals in (LEARNER, SCRIPT):
        with talks(terminals) as talk:
            console, donnie = talk.console, talk._donnie
            assert console.before_suspending == donnie.stop_real_robot
            assert console.last == (donnie.stop_real_robot, talk.ctx.workspace.write_copies)
            assert console.has_run_away() is donnie.connection.has_run_away is False
            hush = donnie.outlets.audible.hush
            assert (console.on_key == hush) is (terminals == LEARNER)
            console.on_not_suspended()
            (said,) = printed(talk)
            assert "Ctrl+Z" in said
            assert talk.streams.is_attended is talk.streams.is_terminal is (terminals == LEARNER)
            assert talk.streams.output.paced is (terminals == LEARNER)


@pytest.mark.parametrize(
    ("terminals", "sums_up"), [(LEARNER, True), ({0}, False), ({1}, False), (SCRIPT, False)]
)
def test_quick_movements_are_summed_up_where_a_learner_types_and_reads(
    talks: Callable[..., Any], terminals: set[int], sums_up: bool
) -> None:
    with talks(terminals) as talk:
        talk._donnie.session.speed = 5.0

        assert talk._listener._summing_up._is_wanted() is sums_up


def test_a_closed_conversation_prints_and_copies_nothing_more(
    talks: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    with talks(LEARNER) as talk:
        talk.console.when_idle = lambda: None
        talk.close()
        talk.ctx.say("Hello.")

        assert printed(talk) == []
        assert talk.console.when_idle is None
        monkeypatch.setattr(talk, "close", lambda: None)


def test_a_page_of_the_tour_is_turned_only_where_it_waits_for_enter(talks: Callable[..., Any]) -> None:
    from donnie_tui.i18n.help import STEP_PAGE

    with talks(LEARNER) as talk:
        for continuation, page, turns in (
            (None, STEP_PAGE, False),
            (int, STEP_PAGE, True),
            (int, STEP_PAGE + 1, False),
        ):
            talk.typed_lines.continuation, talk.ctx.tour_page = continuation, page
            assert talk.run_loop.turns_page() is turns


# --- whatever ends it


@pytest.mark.parametrize(
    ("end", "terminals", "did"),
    [
        (EnterWorld("maze"), LEARNER, ["copies", "shown", "trimmed"]),
        (EnterWorld("maze"), SCRIPT, ["copies", "shown", "voice ends", "trimmed"]),
        (SwitchMode("", None), LEARNER, ["handed over", "trimmed"]),
        (Gone(), LEARNER, ["copies", "world rescued", "trimmed"]),
        (ZeroDivisionError(), LEARNER, ["copies", "world rescued", "trimmed"]),
        (KeyboardInterrupt(), LEARNER, ["copies", "world rescued", "trimmed"]),
    ],
)
def test_no_program_is_lost_however_it_ends(
    talks: Callable[..., Any],
    monkeypatch: pytest.MonkeyPatch,
    end: BaseException,
    terminals: set[int],
    did: list[str],
) -> None:
    with talks(terminals) as talk:
        happened = list[str]()

        def note(what: str) -> Callable[[], None]:
            return lambda: happened.append(what)

        def talk_on() -> int:
            raise end

        workspace = Part(write_copies=note("copies"), hand_over=note("handed over"))
        monkeypatch.setattr(talk, "_state", Part(workspace=workspace, past=Part(trim=note("trimmed"))))
        monkeypatch.setattr(talk, "_donnie", Part(rescue_world=note("world rescued")))
        monkeypatch.setattr(talk.printer, "show", note("shown"))
        monkeypatch.setattr(talk.leaving, "let_speak", note("voice ends"))
        talk.console.leaving = 15
        if isinstance(end, Gone):
            assert talk._guarded(talk_on) == 143
        else:
            with pytest.raises(type(end)):
                talk._guarded(talk_on)

        assert happened == did
        happened.clear()
        assert talk._guarded(lambda: 3) == 3
        assert happened == ["trimmed"]


# --- with a terminal that edits lines, and in a script


def test_keys_are_said_and_words_completed_where_lines_are_edited(
    talks: Callable[..., Any], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    greeting = Greeting()
    greeting.terminal = object()  # type: ignore[assignment] # it is not used here
    monkeypatch.setattr(test_pace, "Greeting", lambda: greeting)
    with talks(LEARNER) as talk:
        editing, said = talk.streams.editing, list[Any]()
        assert editing is talk.streams.reader
        assert editing.complete("REPEA") == ("REPEAT",)
        monkeypatch.setattr(talk, "_key_echo", lambda key, before: said.append((key, before)))
        audible, key = type(talk._donnie.outlets.audible), KeyPress(Act.TEXT, "a")
        for echoes in (False, True):
            monkeypatch.setattr(audible, "echoes", property(lambda _, echoes=echoes: echoes))
            editing.on_key(key, "FW")
        assert said == [(key, "FW")]
        talk.take_again("FW 1")
        assert (talk.ctx.past.lines, talk.ctx.program.lines) == (["FW 1"], ("FW 1",))
    assert (tmp_path / "donnie" / "history").read_text() == "FW 1\n"
    greeting.terminal = None
    with talks(SCRIPT) as talk:
        talk.take_again("FW 2")
        assert (talk.streams.editing, talk.ctx.past.lines) == (None, ["FW 2"])
    assert (tmp_path / "donnie" / "history").read_text() == "FW 1\n", "a script is not kept"


def test_the_printed_greeting_is_said(talks: Callable[..., Any], monkeypatch: pytest.MonkeyPatch) -> None:
    with talks(LEARNER) as talk:
        without_talking(talk, monkeypatch)
        said = list[str]()
        audible: Any = Part(say_printed=lambda *lines: said.extend(lines), hush=bool)
        monkeypatch.setattr(
            talk, "_donnie", Part(notices=talk._donnie.notices, outlets=Part(audible=audible))
        )
        talk._greeting.lines = ("One.", "Two.")
        talk.begin(None)

        assert said == ["One.", "Two."]


def test_a_copy_that_can_not_be_kept_is_answered_and_a_robot_that_drives_is_known(
    talks: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    with talks(LEARNER) as talk:
        talk.ctx.workspace.report_failure(Part(reason="the disk is full"))
        (said,) = printed(talk)
        assert "the disk is full" in said
        connection = type(talk._donnie.connection)
        monkeypatch.setattr(connection, "has_run_away", property(lambda _: True))
        assert talk.console.has_run_away()
        monkeypatch.setattr(connection, "has_run_away", property(lambda _: False))
        assert [*talk.ctx.workspace.by_robot()] == [talk._donnie.session.name]


def test_a_script_has_no_depth_in_its_prompt_and_reports_its_worst_line(
    talks: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    with talks(SCRIPT) as talk:
        asked = list[str]()

        def read(prompt: str, *, shown: bool) -> str:
            asked.append(prompt)
            return "line"

        def take(_: str) -> None:
            talk.leaving.code = 0
            talk.ctx.refuse(2)

        monkeypatch.setattr(talk.prompter, "read", read)
        monkeypatch.setattr(talk, "_take", take)
        monkeypatch.setattr(talk.leaving, "say_goodbye", lambda: None)
        talk.ctx.program.add("REPEAT 2 TIMES")

        assert talk.begin(None) == 2
        assert asked == ["> "]
