"""From the command line to the order that a command gets, and from its end to the exit code."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest

import worlds
from donnie_tui import __main__ as entry
from donnie_tui.cli import main as main_module
from donnie_tui.cli.main import handler_of, main
from donnie_tui.cli.options import SUBCOMMANDS, Order, understand
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.linear import greeting
from donnie_tui.robot import search
from donnie_tui.settings import folders
from donnie_tui.settings.settings import FRONT_END_SPEED


@pytest.fixture(autouse=True)
def isolated_settings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The settings of a test are in its own folder."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.delenv("DONNIE_WORLD", raising=False)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "donnie").mkdir()
    return tmp_path / "donnie" / "settings.toml"


@pytest.fixture
def ordered(monkeypatch: pytest.MonkeyPatch) -> Callable[..., Order]:
    """The order of a command line, which is not carried out."""

    def order_of(*arguments: str, **more: Any) -> Order:
        orders = list[Order]()

        def carry_out(order: Order) -> int:
            orders.append(order)
            return 7

        monkeypatch.setattr(main_module, "handler_of", lambda _: carry_out)
        assert main([*arguments], **more) == 7
        return orders[0]

    return order_of


@pytest.mark.parametrize(
    ("arguments", "speed"),
    [
        (("run", "a.gd"), None),
        (("-f", "a.gd"), None),
        (("world", "maze"), None),
        (("player", "a.cfg"), 1.0),
        (("player", "a.cfg", "--speed", "3"), 3.0),
        ((), FRONT_END_SPEED),
        (("--linear",), FRONT_END_SPEED),
        (("a.gd", "--speed", "max"), None),
    ],
)
def test_a_command_runs_as_fast_as_possible_and_a_front_end_so_that_it_is_followed(
    ordered: Callable[..., Order], arguments: tuple[str, ...], speed: float | None
) -> None:
    assert ordered(*arguments).settings.speed == speed


@pytest.mark.parametrize(("arguments", "is_command"), [(("run", "a.gd"), True), (("--linear",), False)])
def test_a_wrong_setting_is_reported_by_a_command_at_once_and_by_a_front_end_later(
    ordered: Callable[..., Order],
    isolated_settings: Path,
    capsys: pytest.CaptureFixture[str],
    arguments: tuple[str, ...],
    is_command: bool,
) -> None:
    isolated_settings.write_text('speed = "fast"\nnonsense = 1\nlang = "pt"\nverbosity = "brief"\n')
    order = ordered(*arguments)
    complaints = capsys.readouterr().err.splitlines()

    assert (len(complaints), len(order.settings.notices)) == ((2, 0) if is_command else (0, 2))
    assert (order.words.language, order.words.detail) == ("pt", "brief")
    assert (order.settings.language, order.invocation.command) == ("pt", "run" if is_command else "")


@pytest.mark.parametrize(
    ("arguments", "speech", "sound", "log"),
    [((), "text", True, False), (("-m",), "off", False, False), (("-l",), "text", True, True)],
)
def test_the_flags_of_the_original_mute_and_log(
    ordered: Callable[..., Order], arguments: tuple[str, ...], speech: str, sound: bool, log: bool
) -> None:
    settings = ordered(*arguments, "--speech", "text", "--sound", "on").settings

    assert (settings.speech, settings.sound, settings.log) == (speech, sound, log)


SERVER = "player://localhost:6665/0"


@pytest.mark.parametrize(
    ("arguments", "joins", "server", "robot", "world"),
    [
        ((), True, SERVER, SERVER, worlds.PLAYED),
        (("--world", "maze"), True, SERVER, SERVER, "maze"),
        (("--robot", "double"), True, SERVER, "double", None),
        (("--robot", "sim", "--world", "maze"), True, SERVER, "sim", "maze"),
        ((), True, None, "sim", None),
        ((), False, SERVER, "sim", None),
        (("world", "maze"), True, SERVER, "sim", None),
    ],
)
def test_a_server_that_runs_has_the_robot_unless_another_one_is_chosen(
    ordered: Callable[..., Order],
    monkeypatch: pytest.MonkeyPatch,
    arguments: tuple[str, ...],
    joins: bool,
    server: str | None,
    robot: str,
    world: str | None,
) -> None:
    monkeypatch.setattr(search, "running_server", lambda _environment: server)
    usual = ordered().settings.world
    settings = ordered(*arguments, joins_server=joins).settings

    assert (settings.robot, settings.world) == (robot, world or usual)


# --- the exit code


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("run", "a.gd", "--speed", "fast"), "The option --speed can't be fast. It takes 0.1-1000, max."),
        (
            ("run", "a.gd", "--lang", "x" * 41),
            f"The option --lang can't be {'x' * 39}…. It takes en, pt, es.",
        ),
        (("--foo",), "I do not understand --foo. The option --help says more."),
        (("rn", "a.gd"), "I do not know the command rn. Did you mean run?"),
    ],
)
def test_what_can_not_be_understood_is_one_sentence_and_takes_the_greeting_back(
    capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], sentence: str
) -> None:
    did = list[str]()
    greeting: Any = Part(withdraw=lambda: did.append("withdrawn"))

    assert main([*arguments], greeting) == 2
    assert (*capsys.readouterr(), did) == ("", f"{sentence}\n", ["withdrawn"])
    assert main([*arguments]) == 2


@pytest.mark.parametrize(
    ("problem", "code", "complaints"),
    [
        (KeyboardInterrupt(), 130, []),
        (Unusable("One.", "Two."), 2, ["One.", "Two."]),
    ],
)
def test_a_command_that_can_not_go_on_has_its_code_and_its_sentences(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    problem: BaseException,
    code: int,
    complaints: list[str],
) -> None:
    def fail(_order: Order) -> int:
        raise problem

    monkeypatch.setattr(main_module, "handler_of", lambda _: fail)
    assert main(["worlds"]) == code
    assert capsys.readouterr().err.splitlines() == complaints


def test_an_output_that_could_not_be_written_is_a_failure_whatever_the_command_says(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def lose_output(order: Order) -> int:
        order.output.problem = "the disk is full"
        return 0

    monkeypatch.setattr(main_module, "handler_of", lambda _: lose_output)
    assert main(["worlds"]) == 2
    assert "the disk is full" in capsys.readouterr().err


@pytest.mark.parametrize("command", sorted(SUBCOMMANDS))
def test_each_command_has_its_handler(command: str) -> None:
    file = ["a"] if command in ("run", "check", "format", "replay", "player") else []
    invocation = understand([*([command] if command else []), *file], Words())
    found = handler_of(invocation)

    assert f"{found.__module__.rpartition('.')[2]}.{found.__name__}" == SUBCOMMANDS[command].handler


def test_the_original_option_has_a_handler_of_its_own() -> None:
    assert handler_of(understand(["-f", "a.gd"], Words())).__name__ == "run_original"


# --- the entry points


@pytest.fixture
def entered(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """With what the command line is run; nothing is loaded, closed or watched."""
    made = list[Any]()

    def run(arguments: list[str], greeting: object, *, joins_server: bool) -> int:
        made.append((arguments, greeting, joins_server))
        if "interrupted" in arguments:
            raise KeyboardInterrupt
        return 5

    for name in ("load_undisturbed", "_open_what_is_closed", "watch_for_hang_up", "_load_libraries"):
        monkeypatch.setattr(entry, name, lambda name=name: made.append(name))
    monkeypatch.setattr(entry, "_greet_early", lambda: "a greeting")
    monkeypatch.setattr(main_module, "main", run)
    return made


PREPARED = ["load_undisturbed", "_open_what_is_closed", "watch_for_hang_up", "_load_libraries"]


@pytest.mark.parametrize(
    ("begin", "given", "arguments", "joins"),
    [
        ("main", ["run", "a.gd"], ["run", "a.gd"], False),
        ("godonnie", ["-f", "a.gd"], ["-f", "a.gd"], True),
        ("donnie_player", ["--port", "7"], ["player", worlds.PLAYER, "--port", "7"], False),
    ],
)
def test_each_program_is_a_command_line(
    monkeypatch: pytest.MonkeyPatch,
    entered: list[Any],
    begin: str,
    given: list[str],
    arguments: list[str],
    joins: bool,
) -> None:
    monkeypatch.setattr("sys.argv", ["donnie", *given])

    assert getattr(entry, begin)() == 5
    assert entered == [*PREPARED, (arguments, "a greeting", joins)]


def test_ctrl_c_before_anything_is_loaded_has_its_exit_code(
    monkeypatch: pytest.MonkeyPatch, entered: list[Any]
) -> None:
    monkeypatch.setattr("sys.argv", ["donnie", "interrupted"])
    assert entry.main() == 130


def test_the_greeting_comes_early_only_where_no_settings_may_change_it(
    monkeypatch: pytest.MonkeyPatch, isolated_settings: Path, tmp_path: Path
) -> None:
    begun = list[Any]()
    monkeypatch.setattr("sys.argv", ["donnie", "--linear"])
    monkeypatch.setattr(folders, "machine_settings_file", lambda: str(tmp_path / "machine.toml"))
    monkeypatch.setattr(greeting, "begin", lambda arguments, _: begun.append(arguments) or "a greeting")
    assert entry._greet_early() == "a greeting"
    for file in (isolated_settings, tmp_path / "machine.toml"):
        file.write_text("")
        assert entry._greet_early() is None
        file.unlink()
    assert begun == [["--linear"]]


@pytest.mark.parametrize(("number", "word"), [(0, "many"), (1, "one"), (2, "many")])
def test_complaints_of_argparse_are_counted_as_in_english(number: int, word: str) -> None:
    assert entry._as_in_english("one", "many", number) == word
