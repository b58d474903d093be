"""Blocks, rests, and the new line that is held back; with a clock that only moves during waits."""

from donnie_tui.linear.output import AFTER_STOP, REST, PacedOutput


class Paper:
    """Remembers what was written at which time. ``interrupt_at``: Ctrl+C comes then."""

    def __init__(self, rows: int = 24, interrupt_at: float | None = None) -> None:
        self.interrupted = False
        self.written: list[tuple[float, str]] = []
        self._rows = rows
        self._time = 0.0
        self._interrupt_at = interrupt_at

    def write(self, text: str) -> None:
        self.written.append((self._time, text))

    def wait(self, seconds: float) -> object:
        self._time += seconds
        self.interrupted = self._interrupt_at is not None and self._time >= self._interrupt_at
        return None

    def now(self) -> float:
        return self._time

    def rows(self) -> int:
        return self._rows

    @property
    def texts(self) -> list[str]:
        return [text for _, text in self.written]


def numbered(count: int) -> list[str]:
    return [f"line {number}" for number in range(1, count + 1)]


def test_an_answer_and_the_prompt_are_one_write() -> None:
    paper = Paper()
    output = PacedOutput(paper, paced=True)
    output.hold_newline()
    output.show(["one", "two"], "> ")

    assert paper.texts == ["\none\ntwo\n> "]


def test_a_line_without_an_answer_is_followed_by_the_prompt() -> None:
    paper = Paper()
    output = PacedOutput(paper, paced=True)
    output.hold_newline()
    output.show([], "2> ")

    assert paper.texts == ["\n2> "]


def test_a_long_answer_comes_in_blocks_of_eighteen_with_a_rest_between() -> None:
    paper = Paper()
    left_out = PacedOutput(paper, paced=True).show(numbered(40), "> ")

    assert left_out == 0
    assert [(time, text.count("\n")) for time, text in paper.written] == [
        (0.0, 18),
        (REST, 18),
        (2 * REST, 4),
    ]
    assert paper.texts[-1].endswith("line 40\n> ")


def test_lines_at_a_stop_need_no_rest_and_fit_on_the_screen_with_the_last_block() -> None:
    paper = Paper()
    output = PacedOutput(paper, paced=True)
    output.show(numbered(18))
    output.show(numbered(AFTER_STOP), "> ", to_the_end=True)

    assert [time for time, _ in paper.written] == [0.0, 0.0]
    assert len("".join(paper.texts).split("\n")) <= paper.rows()


def test_a_long_answer_at_a_stop_rests_after_its_first_lines() -> None:
    paper = Paper()
    output = PacedOutput(paper, paced=True)
    output.show(["before"] * 18)
    output.show(numbered(AFTER_STOP + 18), "> ", to_the_end=True)

    assert [time for time, _ in paper.written] == [0.0, 0.0, REST]


def test_a_block_of_nothing_but_numbers_ends_with_a_full_stop_and_nothing_is_added() -> None:
    """Orca is silent about digits alone."""
    paper = Paper()
    numbers = [str(number) for number in range(1, 41)]
    PacedOutput(paper, paced=True).show(numbers, "> ")

    assert (
        "".join(paper.texts)
        == "".join(f"{each}\n" for each in numbers).replace("18\n", "18.\n").replace("36\n", "36.\n") + "> "
    )
    assert [text.count("\n") for text in paper.texts] == [18, 18, 4]


def test_a_few_numbers_need_no_full_stop_nor_do_numbers_among_words_or_in_a_pipe() -> None:
    for lines, paced in ((["1", "2", "3"], True), (["1", "2", "-3", "4"], True), (["1"] * 50, False)):
        paper = Paper()
        PacedOutput(paper, paced=paced).show(lines)

        assert paper.texts == ["".join(f"{line}\n" for line in lines)]


def test_a_small_terminal_gets_smaller_blocks() -> None:
    paper = Paper(rows=10)
    PacedOutput(paper, paced=True).show(numbered(8))

    assert [text.count("\n") for text in paper.texts] == [4, 4]


def test_a_large_terminal_gets_no_larger_blocks_than_a_reader_keeps_up_with() -> None:
    paper = Paper(rows=50)
    PacedOutput(paper, paced=True).show(numbered(40))

    assert [text.count("\n") for text in paper.texts] == [18, 18, 4]


def test_lines_that_come_one_by_one_are_paced_too() -> None:
    paper = Paper()
    output = PacedOutput(paper, paced=True)
    for line in numbered(20):
        output.show([line])

    assert [time for time, _ in paper.written] == [0.0] * 18 + [REST] * 2


def test_a_prompt_never_waits() -> None:
    paper = Paper()
    output = PacedOutput(paper, paced=True)
    output.show(numbered(18))
    output.show([], "> ")

    assert paper.now() == 0


def test_a_pipe_gets_everything_at_once() -> None:
    paper = Paper()
    PacedOutput(paper, paced=False).show(numbered(1000))

    assert [text.count("\n") for text in paper.texts] == [1000]


def test_control_c_ends_a_long_answer() -> None:
    paper = Paper(interrupt_at=REST)
    left_out = PacedOutput(paper, paced=True).show(numbered(40), "> ")

    assert left_out == 22
    assert len(paper.texts) == 1


def test_the_end_of_a_stopped_program_is_printed_after_any_key() -> None:
    paper = Paper(interrupt_at=0.1)
    left_out = PacedOutput(paper, paced=True).show(numbered(40), "> ", to_the_end=True)

    assert left_out == 0
    assert "".join(paper.texts).endswith("line 40\n> ")
    assert paper.now() < 2 * REST


def test_a_block_is_followed_by_a_rest_of_three_tenths_of_a_second() -> None:
    """As long as a screen reader needs to notice that a block is one."""
    paper = Paper()
    PacedOutput(paper, paced=True).show(numbered(19))

    assert [time for time, _ in paper.written] == [0.0, 0.3]
