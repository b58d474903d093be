"""The full screen on a real terminal: lessons from typing to leaving, signals, lost lines, bursts of keys."""

import re
import signal

import pytest

from tests.timeouts import TIMEOUT
from tests.tui.terminal import (
    BACKSPACE,
    CTRL_Q,
    CTRL_S,
    CTRL_SPACE,
    CTRL_Z,
    ENTER,
    F5,
    F8,
    SHIFT_TAB,
    TAB,
    Terminal,
    falls_silent,
    left_as_found,
    under_the_cursor,
)

pytestmark = pytest.mark.slow


def test_a_procedure_is_typed_run_watched_stopped_and_left(terminal):
    donnie = terminal("--world", "living_room", "--speed", "5")
    donnie.type("PROCEDURE WALK: n DO" + ENTER + "FW n TR 90" + ENTER + "END PROCEDURE" + ENTER)
    donnie.type("WALK [6]" + ENTER + "WALK [9]" + ENTER + "WAIT 100000")
    donnie.shows("6  WAIT 100000")
    donnie.type(F5)

    places = set()

    def robot_was_seen_on_its_way() -> bool:
        for row, line in enumerate(donnie.screen.display[1:14]):
            column = line[40:].find(">")
            if column >= 0 and "o" in line[40:]:
                places.add((row, column))
        return "I walked 9 steps" in "\n".join(donnie.screen.display)

    donnie.until(robot_was_seen_on_its_way, "the second walk")
    assert len(places) >= 2
    donnie.shows("Waiting")
    donnie.type(F8)
    donnie.shows("Stopped at line 6.")
    donnie.type(CTRL_Q)
    donnie.shows("6 lines are not saved. Save first, y or n?")
    donnie.type("no" + ENTER)

    assert donnie.ended() == 0
    assert left_as_found(donnie)


def test_linear_and_visual_change_the_mode_and_keep_the_program_and_the_robot(terminal):
    donnie = terminal()
    donnie.type("FW 2" + ENTER + "TR 90")
    donnie.shows("2  TR 90")
    donnie.type(F5)
    donnie.shows("The program is done.")
    donnie.type(SHIFT_TAB + "LINEAR" + ENTER)
    donnie.shows("Always begin in linear mode, y or n?")
    donnie.type("n" + ENTER + "LIST" + ENTER)
    donnie.shows("2: TR 90")
    donnie.type("WHERE" + ENTER)
    donnie.shows("Position 0, 2.")
    donnie.type("VISUAL" + ENTER)
    donnie.shows("Always begin in the full screen, y or n?")
    donnie.type("n" + ENTER)
    donnie.shows("2  TR 90")
    donnie.shows("Donnie at 0, 2 facing east.")


def test_bytes_of_another_encoding_are_signs_like_others(terminal):
    """As from a terminal of Latin letters, or a half of a letter."""
    donnie = terminal()
    donnie.types_bytes(b"SPEAK 1\xe9\xff")
    donnie.shows("1  SPEAK 1\ufffd\ufffd")
    donnie.type(BACKSPACE * 2 + F5)

    donnie.shows("The program is done.")


def test_a_terminal_that_does_not_say_its_size_has_an_ordinary_screen(terminal):
    donnie = terminal(has_size=False)

    donnie.shows("F5 Run")
    assert falls_silent(donnie, 1.0)


def test_an_idle_screen_writes_nothing(terminal):
    """Neither a cursor that blinks nor a clock. That nothing is due later is a test of the event loop."""
    donnie = terminal()
    assert falls_silent(donnie, 1.0)

    assert donnie.read(10.0) == b""


def test_an_idle_list_writes_nothing_and_a_key_in_it_only_what_it_changes(terminal):
    """Two rows of the list, with the sequences that place and colour them."""
    donnie = terminal()
    donnie.type("\x10")
    donnie.shows("Type what to do")
    assert falls_silent(donnie, 1.0)
    before = len(donnie.raw)
    donnie.type("\x1b[B")
    donnie.shows(">AGAIN")
    assert falls_silent(donnie, 1.0)

    assert len(donnie.raw) - before < 2 * 80 * 2
    assert "All" not in donnie.screen.display[-1] and "Enter takes it" in donnie.screen.display[-1]


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_signal_halts_keeps_the_text_and_gives_the_terminal_back(terminal, tmp_path, number):
    donnie = terminal("--speed", "1")
    donnie.type("FW 1000")
    donnie.shows("1  FW 1000")
    donnie.type(F5)
    donnie.shows("RUNNING")
    donnie.process.send_signal(number)

    assert donnie.ended() == 128 + number
    assert left_as_found(donnie)
    copies = list((tmp_path / ".local/state/donnie/unsaved").glob("*.gd"))
    assert [each.read_text(encoding="utf-8") for each in copies] == ["FW 1000\n"]


def test_what_is_typed_before_the_session_is_loaded_is_kept_at_a_signal_in_the_same_moment(
    terminal, tmp_path
):
    donnie = terminal(until="Screen reader?")
    donnie.type("FW 123")
    donnie.process.send_signal(signal.SIGHUP)

    assert donnie.ended() == 128 + signal.SIGHUP
    copies = list((tmp_path / ".local/state/donnie/unsaved").glob("*.gd"))
    assert [each.read_text(encoding="utf-8") for each in copies] == ["FW 123\n"]


def test_what_is_typed_on_the_way_to_another_world_is_typed_there(terminal):
    """All in one burst, as from a script; then letter by letter while the screen changes."""
    donnie = terminal()
    donnie.type(SHIFT_TAB + "WORLDS living room" + ENTER + "WHERE" + ENTER)
    donnie.shows("Position 0, 0. Facing north.")
    donnie.shows("living_room")
    donnie.type("WORLDS maze" + ENTER)
    typed = "HELP SPEAK"
    for letter in typed:
        donnie.type(letter)
        donnie.read(0.05)
    donnie.shows("maze")
    donnie.shows(f"> {typed}")


@pytest.mark.parametrize("controls", [True, False], ids=["heard", "unheard"])
def test_a_lost_line_halts_and_keeps_the_text(terminal, tmp_path, controls):
    """As when SSH breaks off: no reader and no keys, with and without the hang-up signal."""
    donnie = terminal("--speed", "1", controls=controls)
    donnie.type("FW 1000")
    donnie.shows("1  FW 1000")
    donnie.type(F5)
    donnie.shows("RUNNING")
    donnie.hang_up()

    assert donnie.process.wait(TIMEOUT) == 128 + signal.SIGHUP
    copies = list((tmp_path / ".local/state/donnie/unsaved").glob("*.gd"))
    assert [each.read_text(encoding="utf-8") for each in copies] == ["FW 1000\n"]


def test_an_idle_screen_ends_when_its_connection_is_lost_without_a_signal(terminal):
    donnie = terminal(controls=False)
    donnie.hang_up()

    assert donnie.process.wait(TIMEOUT) == 128 + signal.SIGHUP


def test_ctrl_space_offers_words_and_ctrl_z_takes_back_what_was_chosen(terminal):
    """As the bytes that a terminal sends."""
    donnie = terminal()
    donnie.type("S" + CTRL_SPACE)
    donnie.shows("SCAN")
    donnie.type(ENTER)
    donnie.shows("1  SPEAK")
    donnie.type(CTRL_Z)
    donnie.shows("Line 1: S")


def test_a_world_that_is_not_there_is_one_sentence_and_code_2(tmp_path):
    donnie = Terminal(["--world", "none_such"], tmp_path)
    try:
        assert donnie.ended() == 2
        assert left_as_found(donnie)
        assert b"none_such" in donnie.raw.split(b"\x1b[?1049l")[-1]
        assert b"Traceback" not in donnie.raw
    finally:
        donnie.close()


def test_the_last_lines_of_the_log_stay_on_the_normal_screen(terminal):
    donnie = terminal()
    donnie.type(TAB * 3)
    donnie.shows(" Command line.")
    donnie.type('SPEAK "kept for reading"' + ENTER)
    donnie.until(lambda: "\n".join(donnie.screen.display).count("kept for reading") > 1, "the answer")
    donnie.type(CTRL_Q)

    assert donnie.ended() == 0
    after = donnie.raw.split(b"\x1b[?1049l")[-1].decode()
    assert "kept for reading" in after
    assert "\x1b[" not in after.split("kept for reading")[-1]


def test_mouse_reports_can_be_switched_off(terminal):
    with_mouse = terminal()
    without = terminal(DONNIE_MOUSE="off")

    assert re.search(rb"\x1b\[\?100[0236]h", with_mouse.raw)
    assert not re.search(rb"\x1b\[\?100[0236]h", without.raw)


RECTANGLE = (
    "PROCEDURE RECTANGLE: base, height DO",
    "REPEAT 2 TIMES",
    "FW base TR 90",
    "FW height TR 90",
    "END REPEAT",
    "END PROCEDURE",
    "RECTANGLE [9, 3]",
)


CTRL_K, F6, F7 = "\x0b", "\x1b[17~", "\x1b[18~"


def steps_walked(donnie: Terminal) -> int:
    """How many steps north of its start the robot is, by the status line; -1 where it doesn't say."""
    places = re.findall(r"Donnie at 0, (\d+) facing north", "\n".join(donnie.screen.display))
    return int(places[0]) if len(places) == 1 else -1


def test_a_lesson_from_typing_to_leaving(terminal):
    """Of a procedure of the manual: it is stopped while the robot is on its way."""
    donnie = terminal("--world", "living_room", "--speed", "2")
    donnie.type(ENTER.join(RECTANGLE))
    donnie.shows("7  RECTANGLE [9, 3]")
    donnie.type(F5)
    donnie.until(lambda: 1 <= steps_walked(donnie) < 9, "the robot on its way along the base")
    donnie.type(F8)
    donnie.shows("I was stopped.")
    donnie.shows("Stopped at line 3.")
    printed = re.search(
        r"I walked only (\d) steps? forward. I was stopped.", "\n".join(donnie.screen.display)
    )
    assert printed
    assert 1 <= int(printed[1]) < 9
    assert steps_walked(donnie) == int(printed[1])
    donnie.type(F7)
    donnie.shows("Line 1: PROCEDURE RECTANGLE")
    donnie.type(F7)
    donnie.shows("Line 7: RECTANGLE [9, 3]")
    donnie.type(F7)
    donnie.shows("Line 2, level 1: REPEAT 2 TIMES")
    donnie.type(F8)
    donnie.shows("STOPPED")
    donnie.type(CTRL_K + "2")
    donnie.shows("Map. Donnie")
    donnie.type("\x1b[C")
    donnie.shows("Map, 4, 0: free. 4 right.")
    donnie.until(lambda: under_the_cursor(donnie)[1] == ".", "the cursor on the square")
    donnie.type("n")
    donnie.shows("Map, -1, 28: small sofa, blue.")
    donnie.type(TAB + TAB)
    donnie.shows(" Command line.")
    donnie.type("LANGUAGE pt" + ENTER)
    donnie.shows("Idioma: português.")
    donnie.shows("Linha de comando.")
    donnie.type("SAIR" + ENTER)
    donnie.shows("Salvar, s ou n?")
    donnie.type("não" + ENTER)

    assert donnie.ended() == 0
    assert left_as_found(donnie)


def test_keys_in_one_burst_keep_their_order(terminal):
    """Over a slow line they come at once: arrows, Home, Backspace and Tab are not overtaken by letters."""
    left, home, end, up, down, back = "\x1b[D", "\x1b[H", "\x1b[F", "\x1b[A", "\x1b[B", "\x7f"
    donnie = terminal()
    donnie.type(
        f"W 34{back * 2}1{home}F{end}2{ENTER}FX 3{left * 2}{back}W{end}5{up}6{down}7"
        f"{TAB * 3}SPEAK 5{ENTER}SPEAK 6"
    )
    donnie.shows("> SPEAK 6")

    donnie.shows("1  FW 126")
    donnie.shows("2  FW 357")


def test_what_comes_in_one_burst_with_the_key_of_a_question_is_the_answer(terminal, tmp_path):
    donnie = terminal()
    donnie.type("FW 1" + ENTER + "TR 90")
    donnie.shows("2  TR 90")
    donnie.type(CTRL_S + str(tmp_path / "lesson") + ENTER)
    donnie.shows("Saved lesson.gd, 2 lines.")
    donnie.type("\x071" + ENTER + "BW 1" + ENTER + CTRL_Q + "no" + ENTER)

    assert donnie.ended() == 0
    assert (tmp_path / "lesson.gd").read_text(encoding="utf-8") == "FW 1\nTR 90\n"


def test_a_capital_behind_the_menu_key_is_a_letter_with_shift(terminal):
    donnie = terminal()
    donnie.type(CTRL_K + "T")
    donnie.shows("Tour 1 of 9.")
    donnie.type(ENTER)
    donnie.shows("You begin in the program.")
