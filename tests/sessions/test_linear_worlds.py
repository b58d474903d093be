"""Going to another world in the linear mode: by a word, with the program and all that was told."""

from pathlib import Path

from tests.sessions.command import QUIET, donnie
from tests.sessions.learner import Learner


def told(folder: Path, typed: str, *options: str) -> list[str]:
    """What the linear mode prints between its first lines and the goodbye.

    But for what is said of a world that takes long: on a busy machine each may.
    """
    done = donnie(folder, "--linear", *QUIET, "--speed", "max", *options, typed=typed)

    assert done.returncode == 0, done.stderr
    assert done.stderr == b""
    lines = done.stdout.decode().splitlines()[2:-1]
    return [line for line in lines if not line.startswith(("Loading the world ", "Carregando o mundo "))]


def test_worlds_lists_them_and_a_name_goes_there_with_the_program(tmp_path: Path) -> None:
    lines = told(tmp_path, "FW 2\n\nWORLDS\nWORLDS maze\nLIST\nWHERE\nAGAIN\nLAST 4\n")

    assert lines[:3] == [
        "I walked 2 steps forward.",
        "22 worlds. WORLD with a name goes there.",
        "open_floor: Open floor, easy. You are here.",
    ]
    assert lines[24:] == [
        "I go to maze.",
        "This is the world maze: Maze.",
        "49 by 41 steps, walls included.",
        "1 thing. WORLD tells more.",
        "1 line.",
        "1: FW 2",
        "Position 0, 0. Facing north.",
        "I walked 2 steps forward.",
        "This is the world maze: Maze.",
        "49 by 41 steps, walls included.",
        "1 thing. WORLD tells more.",
        "1 line.",
    ]


def test_what_was_switched_and_watched_goes_along(tmp_path: Path) -> None:
    lines = told(tmp_path, "SOUND OFF\n\nWATCH x\nWORLD maze\nVAR x = 3\n\nCUES bump\n")

    assert "x is 3." in lines
    assert lines.index("Sound off.") < lines.index("This is the world maze: Maze.")


def test_a_world_is_meant_by_its_title_in_any_language_too(tmp_path: Path) -> None:
    lines = told(tmp_path, "MUNDO Labirinto\nWORLD living-room\nworld LivingRoom\n", "--lang", "pt")

    assert [line for line in lines if "mundo" in line] == [
        "Este é o mundo maze: Labirinto.",
        "Não existe o mundo living-room. Você quis dizer living_room?",
        "Este é o mundo living_room: Sala de estar.",
    ]


def test_a_world_that_is_not_there_is_told_and_nobody_goes(tmp_path: Path) -> None:
    (tmp_path / "bad.world").write_text("this is no world {", encoding="utf-8")

    lines = told(
        tmp_path, "WORLD nowhere\nWORLD x.world\nWORLD bad.world\nWORLD maze\nWHERE\n", "--world", "maze"
    )

    assert lines[0] == "There is no world nowhere. WORLDS lists them."
    assert lines[1] == "There is no file x.world."
    assert "bad.world" in lines[2]
    assert lines[-2:] == ["You are in maze already. RESET goes to the start.", "Position 0, 0. Facing north."]


def test_a_world_of_ones_own_is_gone_to_by_its_file(tmp_path: Path) -> None:
    (tmp_path / "my.world").write_text(
        'include "donnie.inc"\ndonnie( pose [ 0 0 0 90 ] )\n', encoding="utf-8"
    )

    assert told(tmp_path, "WORLD my.world\nFW 1\n\n")[:2] == [
        "I go to my.world.",
        "This is the world my.world.",
    ]


def test_robots_that_run_are_stopped_first_and_that_is_told(tmp_path: Path) -> None:
    lines = told(tmp_path, "REPEAT 9999 TIMES\nWAIT 1\nEND REPEAT\nSTART\nWORLD maze\n", "--speed", "1")

    assert "All stopped." in lines
    assert lines.index("All stopped.") < lines.index("I go to maze.")


def test_a_program_that_is_held_is_stopped_for_another_world(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters("FW 2", "FW 3", "STEP", "WORLD nowhere")
    learner.sees("There is no world nowhere. WORLDS lists them.")
    learner.enters("WORLD maze")
    learner.sees("Stopped at line 1.")
    learner.sees("This is the world maze: Maze.")
    learner.sees("2 lines.")
    learner.enters("WHERE")
    learner.sees("Position 0, 0. Facing north.")
    learner.enters("QUIT")

    assert learner.leaves() == 0


def test_other_robots_programs_wait_for_them(tmp_path: Path) -> None:
    typed = "FW 1\nROBOT bob\nFW 5\nROBOT alice\nWORLD maze\nWORLD two_robots\nLIST\nROBOT bob\nLIST\n"

    lines = told(tmp_path, typed, "--world", "two_robots")

    assert [line for line in lines if ": FW" in line] == ["1: FW 1", "1: FW 5"]


def test_whoever_records_a_world_stays_in_it(tmp_path: Path) -> None:
    lines = told(tmp_path, "WORLD maze\nWHERE\n", "--events", "e.jsonl")

    assert lines[0].startswith("I stay in this world: e.jsonl is being written")
    assert lines[1:] == ["Position 0, 0. Facing north."]


def test_a_word_that_takes_nothing_says_so(tmp_path: Path) -> None:
    assert told(tmp_path, "WHERE 3\nAGAIN x\n") == [
        "WHERE takes nothing behind it. Type WHERE alone.",
        "AGAIN takes nothing behind it. Type AGAIN alone.",
    ]


def test_lines_typed_before_and_the_chosen_language_go_along(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters("FW 2", "", "LANGUAGE pt", "WORLD maze")
    learner.sees("Este é o mundo maze: Labirinto.")
    learner.sees_prompt()
    learner.types("\x1b[A\x1b[A\x1b[A\r\r")
    learner.sees("Andei 2 passos para frente.")
    learner.enters("SAIR")

    assert learner.leaves() == 0
