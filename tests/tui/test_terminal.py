"""The real program on a real terminal (a pty), read by a terminal emulator."""

import fcntl
import os
import pty
import re
import select
import signal
import struct
import subprocess
import sys
import termios
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from statistics import median

import pyte
import pytest

from tests.patience import PATIENCE

ROOT = Path(__file__).resolve().parents[2]

_KITTY = re.compile(rb"\x1b\[[<>=][0-9;]*u")
"""Keyboard protocols that the emulator takes for text."""

F5, F8, F12, CTRL_Q, CTRL_S, CTRL_Z, CTRL_SPACE, TAB, ENTER = (
    "\x1b[15~",
    "\x1b[19~",
    "\x1b[24~",
    "\x11",
    "\x13",
    "\x1a",
    "\0",
    "\t",
    "\r",
)


class Terminal:
    """A program on a pty, and what its screen shows."""

    def __init__(
        self,
        arguments: list[str],
        state: Path,
        columns: int = 80,
        rows: int = 24,
        more: dict[str, str] | None = None,
        controls: bool = False,
    ) -> None:
        """``controls``: the line belongs to the program's session, which hears when it is lost."""
        self.screen = pyte.Screen(columns, rows)
        self._stream = pyte.ByteStream(self.screen)
        self.raw = b""
        self._master, slave = pty.openpty()
        fcntl.ioctl(self._master, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))
        self.attributes = termios.tcgetattr(slave)
        self._slave = slave
        self._open = [slave, self._master]
        environment = {
            name: value
            for name, value in os.environ.items()
            if not name.startswith(
                ("TEXTUAL", "DONNIE", "NO_COLOR", "COLORTERM", "LC_", "LANG", "COLUMNS", "LINES")
            )
        } | {
            "TERM": "xterm-256color",
            "HOME": str(state),
            "LANG": "C.UTF-8",
            "DONNIE_PLAIN": "off",
            "DONNIE_TOUR": "off",
        }
        environment |= more or {}
        environment.pop("XDG_STATE_HOME", None)
        environment.pop("XDG_CONFIG_HOME", None)
        self.process = subprocess.Popen(
            [sys.executable, "-m", "donnie_tui", *arguments, "--speech", "off", "--sound", "off"],
            stdin=slave,
            stdout=slave,
            stderr=slave,
            cwd=ROOT,
            env=environment,
            start_new_session=True,
            preexec_fn=(lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0)) if controls else None,
        )

    def type(self, text: str) -> None:
        os.write(self._master, text.encode())

    def read(self, seconds: float) -> bytes:
        """What comes within that time at most, given to the emulator too."""
        ready, _, _ = select.select([self._master], [], [], seconds)
        if not ready:
            return b""
        with suppress(OSError):
            data = os.read(self._master, 65536)
            self.raw += data
            self._stream.feed(_KITTY.sub(b"", data))
            return data
        return b""

    def until(self, condition: Callable[[], object], what: str) -> None:
        end = time.monotonic() + PATIENCE
        while not condition():
            assert time.monotonic() < end, f"never seen: {what}\n" + "\n".join(self.screen.display)
            self.read(0.2)

    def shows(self, text: str) -> None:
        self.until(lambda: text in "\n".join(self.screen.display), text)

    def ended(self) -> int:
        """Its exit code; what it still writes is read, so that it is not held up."""
        self.until(lambda: self.process.poll() is not None, "the end")
        while self.read(0.05):
            pass
        return self.process.returncode

    def attributes_now(self) -> list:
        return termios.tcgetattr(self._slave)

    def close(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.hang_up()

    def hang_up(self) -> None:
        """The line is lost: nobody reads any more, and nothing can be typed."""
        while self._open:
            os.close(self._open.pop())


@pytest.fixture
def terminal(tmp_path: Path) -> Iterator[Callable[..., Terminal]]:
    opened: list[Terminal] = []

    def open_one(
        *arguments: str, columns: int = 80, rows: int = 24, controls: bool = False, **environment: str
    ) -> Terminal:
        opened.append(Terminal(list(arguments), tmp_path, columns, rows, environment, controls))
        opened[-1].shows("Command line." if "--plain" in arguments else "Ready, speed")
        return opened[-1]

    yield open_one
    for each in opened:
        each.close()


def left_as_found(terminal: Terminal) -> bool:
    """The modes that were switched on were switched off again, and the line discipline is as before."""
    switched = {}
    for mode, switch in re.findall(rb"\x1b\[\?(\d+)([hl])", terminal.raw):
        switched[mode] = switch
    on = {mode for mode, switch in switched.items() if switch == b"h"} - {b"25", b"7"}
    has_keys = terminal.raw.count(b"\x1b[>25u") > terminal.raw.count(b"\x1b[<u")
    return (
        not on
        and not has_keys
        and switched.get(b"25") == b"h"
        and terminal.attributes_now() == terminal.attributes
    )


def test_a_procedure_is_typed_run_watched_stopped_and_left(terminal):
    donnie = terminal("--world", "living_room", "--speed", "20")
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
    assert len(places) >= 3
    donnie.shows("Waiting")
    donnie.type(F8)
    donnie.shows("Stopped at line 6.")
    donnie.type(CTRL_Q)
    donnie.shows("is not saved. Save it? yes or no:")
    donnie.type("no" + ENTER)

    assert donnie.ended() == 0
    assert left_as_found(donnie)


def test_the_terminal_s_cursor_is_visible_and_stands_at_the_focus(terminal):
    donnie = terminal()
    donnie.type("FW 1")
    donnie.shows("1  FW 1")
    donnie.until(
        lambda: (donnie.screen.cursor.x, donnie.screen.cursor.y) == (9, 1), "the cursor in the program"
    )
    donnie.type(TAB)
    donnie.shows(" Map. Donnie")
    donnie.until(lambda: under_the_cursor(donnie)[1] == "^", "the cursor at the robot")
    donnie.type(TAB)
    donnie.shows(" Log, line")
    donnie.until(lambda: under_the_cursor(donnie)[1] == ">", "the cursor at the row of the log")
    donnie.type(TAB)
    donnie.shows(" Command line.")

    donnie.until(lambda: under_the_cursor(donnie) == ("> ", " "), "the cursor in the command line")
    assert not donnie.screen.cursor.hidden


def falls_silent(donnie: Terminal, seconds: float) -> bool:
    """Wait until nothing was written for so long. False where something goes on writing."""
    end = time.monotonic() + PATIENCE
    while donnie.read(seconds):
        if time.monotonic() > end:
            return False
    return True


def test_an_idle_screen_writes_nothing(terminal):
    """A blinking cursor or a clock would write at least each second."""
    assert falls_silent(terminal(), 3.0)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_signal_halts_keeps_the_text_and_gives_the_terminal_back(terminal, tmp_path, number):
    donnie = terminal("--speed", "1")
    donnie.type("FW 1000")
    donnie.shows("1  FW 1000")
    donnie.type(F5)
    donnie.shows("Running")
    donnie.process.send_signal(number)

    assert donnie.ended() == 128 + number
    assert left_as_found(donnie)
    copies = list((tmp_path / ".local/state/donnie/unsaved").glob("*.gd"))
    assert [each.read_text(encoding="utf-8") for each in copies] == ["FW 1000"]


@pytest.mark.parametrize("controls", [True, False], ids=["heard", "unheard"])
def test_a_lost_line_halts_and_keeps_the_text(terminal, tmp_path, controls):
    """As when SSH breaks off: nobody reads, nothing comes; with and without the signal that tells it."""
    donnie = terminal("--speed", "1", controls=controls)
    donnie.type("FW 1000")
    donnie.shows("1  FW 1000")
    donnie.type(F5)
    donnie.shows("Running")
    donnie.hang_up()

    assert donnie.process.wait(PATIENCE) == 128 + signal.SIGHUP
    copies = list((tmp_path / ".local/state/donnie/unsaved").glob("*.gd"))
    assert [each.read_text(encoding="utf-8") for each in copies] == ["FW 1000"]


@pytest.mark.parametrize(("layout", "most"), [((), 1500), (("--plain",), 2500)], ids=["panes", "plain"])
def test_going_to_the_next_pane_writes_what_changes(terminal, layout, most):
    """Titles, the status line and the keys, not the whole screen; in the plain layout another pane."""
    donnie = terminal(*layout)
    donnie.type(TAB)  # where Textual paints styles for the first time
    assert falls_silent(donnie, 1.0)
    for _ in range(3):
        before = len(donnie.raw)
        donnie.type(TAB)
        donnie.until(lambda before=before: len(donnie.raw) > before, "an answer")
        assert falls_silent(donnie, 1.0)

        assert len(donnie.raw) - before < most


def test_ctrl_space_offers_words_and_ctrl_z_takes_back_what_was_chosen(terminal):
    """As the bytes that a terminal sends."""
    donnie = terminal()
    donnie.type("S" + CTRL_SPACE)
    donnie.shows("SCAN")
    donnie.type(ENTER)
    donnie.shows("1  SPEAK")
    donnie.type(CTRL_Z)
    donnie.shows("Line 1: S")


def test_the_size_of_the_terminal_may_change(terminal):
    donnie = terminal()
    for columns, rows in ((40, 12), (120, 40)):
        donnie.screen.resize(rows, columns)
        fcntl.ioctl(donnie._master, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))
        donnie.process.send_signal(signal.SIGWINCH)
        donnie.shows("Ready, speed")

    donnie.shows("No variables.")


def written_over(donnie: Terminal) -> tuple[str, ...]:
    """What the idle screen showed, before something else wrote into all of its rows."""
    assert falls_silent(donnie, 1.0)
    before = tuple(donnie.screen.display)
    donnie._stream.feed(b"".join(b"\x1b[%d;1HMessage from root" % row for row in range(1, 25)))
    return before


def test_what_something_else_wrote_over_the_screen_goes_away_when_it_is_painted_anew(terminal):
    donnie = terminal()
    before = written_over(donnie)
    donnie.type("\x0b\x1b[15~")
    donnie.shows("The screen is painted anew.")

    donnie.until(lambda: "Message from root" not in "\n".join(donnie.screen.display), "the screen anew")
    assert donnie.screen.display[:14] == list(before[:14])


def test_a_process_that_goes_on_paints_the_whole_screen(terminal):
    donnie = terminal()
    donnie.process.send_signal(signal.SIGTSTP)
    os.waitpid(donnie.process.pid, os.WUNTRACED)
    before = written_over(donnie)
    donnie.process.send_signal(signal.SIGCONT)

    donnie.until(lambda: tuple(donnie.screen.display) == before, "the screen as it was")
    assert not donnie.screen.cursor.hidden


def test_after_a_change_of_size_nothing_is_left_that_something_else_wrote(terminal):
    donnie = terminal()
    written_over(donnie)
    donnie.screen.resize(24, 90)
    fcntl.ioctl(donnie._master, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 90, 0, 0))
    donnie.process.send_signal(signal.SIGWINCH)

    donnie.until(lambda: "Message from root" not in "\n".join(donnie.screen.display), "the screen anew")


def test_a_world_that_is_not_there_is_one_sentence_and_code_2(tmp_path):
    donnie = Terminal(["--world", "none_such"], tmp_path)
    try:
        assert donnie.ended() == 2
        assert left_as_found(donnie)
        assert b"none_such" in donnie.raw.split(b"\x1b[?1049l")[-1]
        assert b"Traceback" not in donnie.raw
    finally:
        donnie.close()


def under_the_cursor(donnie: Terminal) -> tuple[str, str]:
    """What stands before the cursor in its row, and at it."""
    row = donnie.screen.display[donnie.screen.cursor.y]
    return row[: donnie.screen.cursor.x], row[donnie.screen.cursor.x]


def test_the_cursor_stands_right_after_what_is_typed(terminal):
    donnie = terminal()
    donnie.type("x" + TAB * 3)
    donnie.shows(" Command line.")
    donnie.type("FW 12")
    donnie.shows("> FW 12")
    donnie.until(lambda: under_the_cursor(donnie) == ("> FW 12", " "), "the cursor after the command")
    donnie.type("\x1b[D")
    donnie.until(lambda: under_the_cursor(donnie) == ("> FW 1", "2"), "the cursor at the last letter")
    donnie.type(CTRL_Q)
    donnie.shows("yes or no:")
    donnie.type("maybe")
    donnie.until(lambda: under_the_cursor(donnie) == ("maybe", " "), "the cursor after the answer")


def test_a_typed_key_costs_few_bytes(terminal):
    donnie = terminal()
    donnie.type(TAB * 3)
    donnie.shows(" Command line.")
    costs = []
    for letter in "SPEAK 12345":
        while donnie.read(0.3):
            pass
        donnie.type(letter)
        costs.append(len(donnie.read(5.0)))
        while donnie.read(0.2):
            costs[-1] += 1

    assert median(costs) <= 100  # on a busy machine something late may fall into one of them


KINDS = {"xterm-256color": 256, "linux": 16, "screen": 16, "tmux-256color": 256, "vt100": 16}
"""Kinds of terminal, and how many colours they know at most."""

CONTROL = re.compile(
    rb"\x1b(?:\[[0-?]*[ -/]*[@-~]|[\]P_^X][^\x07\x1b]*(?:\x07|\x1b\\)|[^\[\]P_^X])"
    rb"|[\x00-\x08\x0b\x0c\x0e-\x1a\x1c-\x1f]"
)
"""A control sequence, or a sign that moves nothing."""
PLAIN_CONTROL = re.compile(rb"\x1b\[\??[0-9;]*[A-Za-z]")
"""One that every terminal since the VT100 takes as one, whether it knows what it asks for or not."""
ASKED = (b"\x1b[?2026$p", b"\x1b[?2048$p")
"""What Textual asks before the first frame, which covers what a terminal might make of them."""


@pytest.mark.parametrize("name", KINDS)
def test_it_works_on_this_kind_of_terminal(terminal, name):
    donnie = terminal("--world", "living_room", TERM=name)
    if name != "xterm-256color":
        assert {each for each in CONTROL.findall(donnie.raw) if not PLAIN_CONTROL.fullmatch(each)} <= {*ASKED}
    assert b"8;2;" not in donnie.raw
    assert (b"8;5;" in donnie.raw) is (KINDS[name] == 256)
    donnie.shows("F5 runs the program.")
    donnie.shows("Living room")
    donnie.type('SPEAK "here"' + ENTER)
    donnie.shows("SPEAK")
    donnie.type("\x1b[15~" if name != "linux" else "\x1b[[E")
    donnie.shows("The program is done.")
    donnie.type(CTRL_Q)
    donnie.shows("yes or no:")
    donnie.type("no" + ENTER)

    assert donnie.ended() == 0
    assert left_as_found(donnie)
    what_is_left = "\n".join(line.rstrip() for line in donnie.screen.display).strip()
    assert what_is_left.startswith("Screen reader?")  # the emulator has no other screen to leave for
    assert what_is_left.endswith("The program is done.")


def test_the_plain_layout_asks_for_no_mouse_and_no_key_reports(terminal):
    donnie = terminal("--plain", DONNIE_PLAIN="")

    assert not re.search(rb"\x1b\[\?100[0236]h", donnie.raw)
    assert not _KITTY.search(donnie.raw)


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
    """How many squares north of its trail's first one the robot is on the map; -1 where it is not seen."""
    rows = [line[39:] for line in donnie.screen.display[1:14]]
    robots = [(row, line.index("^")) for row, line in enumerate(rows) if "^" in line]
    return sum(line[robots[0][1]] == "o" for line in rows[robots[0][0] :]) if len(robots) == 1 else -1


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
    told = re.search(r"I walked only (\d) steps? forward. I was stopped.", "\n".join(donnie.screen.display))
    assert told
    assert 1 <= int(told[1]) < 9
    assert steps_walked(donnie) == int(told[1])
    donnie.type(F7)
    donnie.shows("Line 1: PROCEDURE RECTANGLE")
    donnie.type(F7)
    donnie.shows("Line 7: RECTANGLE [9, 3]")
    donnie.type(F7)
    donnie.shows("Line 2: REPEAT 2 TIMES")
    donnie.type(F8)
    donnie.shows("Ready")
    donnie.type(CTRL_K + "2")
    donnie.shows("Map. Donnie")
    donnie.type("\x1b[C")
    donnie.shows("Map, 1, 0: free. 1 right.")
    donnie.until(lambda: under_the_cursor(donnie)[1] == ".", "the cursor on the square")
    donnie.type("n")
    donnie.shows("Map, -1, 28: small sofa, blue.")
    donnie.type(TAB + TAB)
    donnie.shows(" Command line.")
    donnie.type("LANGUAGE pt" + ENTER)
    donnie.shows("Idioma: português.")
    donnie.shows("Linha de comando.")
    donnie.type("SAIR" + ENTER)
    donnie.shows("sim ou não:")
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
