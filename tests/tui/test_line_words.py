"""The words about lines, settings, reports and what was typed, in the command line of the screen."""

import pytest

from donnie_tui.core.run_state import RunState

PROGRAM = "FW 1\nFW 2\nFW 3\nFW 4"


@pytest.fixture(autouse=True)
def own_folders(tmp_path, monkeypatch):
    """Settings and files of a test stay its own."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize(
    ("typed", "printed", "text"),
    [
        ("CHANGE 2 BK 2", "Line 2: BK 2", "FW 1\nBK 2\nFW 3\nFW 4"),
        ("INSERT 1 TR 90", "Line 1: TR 90", "TR 90\nFW 1\nFW 2\nFW 3\nFW 4"),
        ("INSERT 5 TR 90", "Line 5: TR 90", "FW 1\nFW 2\nFW 3\nFW 4\nTR 90"),
        ("DELETE 2 3", "Lines 2 to 3 deleted.", "FW 1\nFW 4"),
        ("DELETE 4", "Line 4 deleted.", "FW 1\nFW 2\nFW 3"),
        ("DELETE 1 4", "Lines 1 to 4 deleted.", ""),
        ("DELETE", "Line 1 deleted.", "FW 2\nFW 3\nFW 4"),
        ("MOVE 4 1", "Line 1: FW 4", "FW 4\nFW 1\nFW 2\nFW 3"),
        ("MOVE 1 2 5", "Line 4: FW 2", "FW 3\nFW 4\nFW 1\nFW 2"),
        ("CHANGE 9 FW 1", "There is no line 9. The last is 4.", PROGRAM),
        ("DELETE 0", "There is no line 0. The last is 4.", PROGRAM),
        ("LIST 2", "2: FW 2", PROGRAM),
        ("DELETE abc", "I did not understand. Type DELETE 2 5.", PROGRAM),
        ("FIND", "I did not understand. Type FIND wall.", PROGRAM),
    ],
)
async def test_a_word_changes_the_lines_and_undo_takes_it_back(work, typed, printed, text):
    async with work(PROGRAM) as desk:
        await desk.type_line(typed)
        await desk.shows(printed)
        assert desk.place.editor.text == text

        await desk.type_line("UNDO")
        await desk.until(lambda: desk.place.editor.text == PROGRAM, "the text as it was")


@pytest.mark.parametrize(
    ("typed", "printed"),
    [("CHANGE 2 BK 2", "Line 2: FW 2"), ("INSERT 5 TR 90", "4 lines."), ("REDO", "Nothing was changed.")],
)
async def test_undo_prints_the_first_changed_line(work, typed, printed):
    async with work(PROGRAM) as desk:
        await desk.type_line(typed)
        await desk.idle()
        await desk.type_line("UNDO")
        await desk.shows(printed)


async def test_an_end_of_line_behind_the_last_line_stays(work):
    async with work() as desk:
        desk.load("FW 1\nFW 2\n")
        await desk.type_line("DELETE 2")
        await desk.shows("Line 2 deleted.")
        assert desk.place.editor.text == "FW 1\n"

        await desk.type_line("INSERT 2 BK 1")
        await desk.shows("Line 2: BK 1")
        assert desk.place.editor.text == "FW 1\nBK 1\n"


async def test_a_line_without_its_text_is_offered_for_editing(work):
    async with work(PROGRAM) as desk:
        await desk.type_line("CHANGE 3")
        await desk.answer("FW 9")
        await desk.shows("Line 3: FW 9")

        assert desk.place.editor.text == "FW 1\nFW 2\nFW 9\nFW 4"


async def test_breakpoints_go_with_their_lines_when_lines_are_inserted_deleted_and_that_is_undone(work):
    async with work(PROGRAM) as desk:
        await desk.type_line("BREAK 3")
        await desk.shows("Breakpoint at line 3.")
        await desk.type_line("INSERT 1 TR 90")
        await desk.until(lambda: desk.place.editor.breakpoints == {4}, "line 4")
        await desk.type_line("DELETE 2")
        await desk.until(lambda: desk.place.editor.breakpoints == {3}, "line 3")
        await desk.type_line("UNDO")
        await desk.until(lambda: desk.place.editor.breakpoints == {4}, "line 4 again")
        await desk.type_line("INSERT 4 TR 90")
        await desk.until(lambda: desk.place.editor.breakpoints == {5}, "line 5")
        await desk.type_line("DELETE 4")
        await desk.until(lambda: desk.place.editor.breakpoints == {4}, "line 4, the line above being gone")


async def test_a_watched_variable_is_printed_at_each_change(work):
    async with work() as desk:
        await desk.type_line("WATCH a")
        await desk.shows("Watching a.")
        await desk.run("VAR a = 3\nVAR b = 1\na = a + 1\nFW 1")

        printed = [line for line in desk.log if line.startswith(("a is", "b is"))]
        assert printed == ["a is 3.", "a is 4."]


async def test_a_change_by_the_last_statement_is_printed_at_the_end(work):
    async with work() as desk:
        await desk.type_line("WATCH a")
        await desk.shows("Watching a.")
        await desk.run("VAR a = 3\nFW 1\na = a + 1")

        assert [line for line in desk.log if line.startswith("a is")] == ["a is 3.", "a is 4."]


async def test_a_variable_that_is_no_longer_watched_is_not_printed(work):
    async with work() as desk:
        await desk.type_line("WATCH a")
        await desk.type_line("WATCH a")
        await desk.shows("Not watching a now.")
        await desk.run("VAR a = 3")

        assert "a is 3." not in desk.log


async def test_find_counts_the_lines_with_the_word(work):
    async with work() as desk:
        await desk.type_line("SPEAK 71")
        await desk.shows("71")
        await desk.type_line("FIND 71")
        await desk.shows("1 line, the newest last.")


async def test_where_at_detail_full_names_the_last_move_too(work):
    async with work(verbosity="full") as desk:
        await desk.type_line("FW 2")
        await desk.idle()
        await desk.type_line("WHERE")
        await desk.shows("FW 2: 2 steps, to 0, 2.")


async def test_a_typed_line_is_chosen_and_repeated(work):
    async with work() as desk:
        await desk.type_line("FW 1")
        await desk.idle()
        await desk.type_line("WHERE")
        await desk.type_line("TYPED")
        await desk.until(lambda: desk.app.screen is not desk.place, "the list")
        await desk.press("down", "enter")
        await desk.until(lambda: desk.log.count("I walked 1 step forward.") == 2, "the second step")
        await desk.doing(RunState.READY)


@pytest.mark.parametrize("typed", ["SET theme light", "AJUSTAR Look light"])
async def test_set_changes_a_setting_by_its_name(work, typed):
    async with work() as desk:
        await desk.type_line(typed)
        await desk.shows("Look: light.")

        assert desk.app.controller.ctx.preferences.settings.theme == "light"


@pytest.mark.parametrize(
    ("typed", "printed"),
    [
        ("FEEL sí", "I say what the belt shows."),
        ("SET completion não", "Completion: off."),
        ("SET wait ligado", "Set wait: on."),
        ("LANGUAGE inglés", "Language: English."),
        ("DETAIL cheio", "Detail: full."),
    ],
)
async def test_words_of_any_language_switch_and_choose(work, typed, printed):
    async with work() as desk:
        await desk.type_line(typed)
        await desk.shows(printed)


@pytest.mark.parametrize(
    ("typed", "field", "value"),
    [
        ("SET speech own", "speech", "tts"),
        ("SET fala robô", "speech", "robot"),
        ("SET speech ssip", "speech", "ssip"),
        ("SET speech no", "speech", "off"),
        ("SET hablar ambos", "speak", "both"),
        ("SET pontuação toda", "punctuation", "all"),
        ("SET eco palavras", "key_echo", "words"),
    ],
)
async def test_set_understands_the_values_of_voice_and_sound_as_the_linear_mode_does(
    work, typed, field, value
):
    async with work() as desk:
        await desk.type_line(typed)
        await desk.until(lambda: getattr(desk.app.controller.ctx.preferences.settings, field) == value, value)


async def test_set_says_which_name_it_does_not_know(work):
    async with work() as desk:
        await desk.type_line("SET nonsense 3")
        await desk.shows("No setting is called nonsense.")


async def test_a_report_is_written_and_another_file_replaced_only_after_a_question(work, tmp_path):
    async with work(PROGRAM) as desk:
        await desk.type_line("REPORT list lines.csv")
        await desk.shows("Wrote lines.csv.")
        written = (tmp_path / "lines.csv").read_text()
        assert written.splitlines()[1:3] == ["1,0,FW 1", "2,0,FW 2"]

        await desk.type_line("REPORT map lines.csv")
        await desk.answer("no")
        await desk.shows("Nothing was changed.")
        assert (tmp_path / "lines.csv").read_text() == written


NUMBERED = (
    *("BREAK", "UNTIL", "READ", "GO TO", "LIST", "CHANGE", "INSERT", "DELETE", "MOVE", "MAP", "MAP ROW"),
    *("MAP COLUMN", "TRAIL", "LAST", "SPELL", "TYPED"),
)


async def test_a_wrong_argument_is_reported_and_changes_nothing(work):
    """As in the linear mode. Otherwise DELETE would delete the line of the cursor."""
    async with work(PROGRAM) as desk:
        for word in (*NUMBERED, "AROUND", "WATCH"):
            before = len(desk.log)
            await desk.type_line(f"{word} --3")
            await desk.until(lambda before=before: len(desk.log) > before + 1, f"an answer to {word}")
            assert desk.log[-1].startswith(f"I did not understand. Type {word}"), word

        assert desk.place.editor.text == PROGRAM
        assert not desk.place.editor.breakpoints


@pytest.mark.parametrize("typed", ["BREAK 99", "UNTIL 99", "READ 99", "GO TO 99"])
async def test_a_missing_line_is_reported_with_the_last_one(work, typed):
    async with work(PROGRAM) as desk:
        await desk.type_line(typed)
        await desk.shows("There is no line 99. The last is 4.")


@pytest.mark.parametrize(
    ("typed", "printed"),
    [
        ("listt 2", "I do not know listt. Did you mean LIST?"),
        ("ZOM IN", "I do not know ZOM IN. Did you mean ZOOM IN?"),
    ],
)
async def test_a_slip_in_a_word_of_the_screen_is_answered_with_that_word(work, typed, printed):
    async with work(PROGRAM) as desk:
        await desk.type_line(typed)
        await desk.shows(printed)
        assert desk.app.controller.ctx.runs.state is RunState.READY


async def test_a_slip_in_a_word_of_godonnie_is_answered_by_the_language(work):
    async with work(PROGRAM) as desk:
        await desk.type_line("FWW 2")
        await desk.shows("Error, line 1, column 1: I do not know FWW.")
        await desk.shows("Did you mean FW?")


async def test_a_name_of_the_program_is_no_slip(work):
    async with work("PROCEDURE LISTT DO\nFW 1\nEND PROCEDURE\nLISTT") as desk:
        await desk.type_line("LISTT")
        await desk.shows("Error, line 1, column 1: I do not know LISTT.")


async def test_mistakes_are_visited_and_explained_as_in_the_linear_mode(work):
    """After each run the cursor stands at the first one, whichever one was selected before."""
    async with work("FWD 1\nTRN 90") as desk:

        async def run():
            await desk.press("f5")
            await desk.until(lambda: desk.place.editor.line == 1 and desk.app.controller.ctx.errors.all)
            await desk.idle()

        await run()
        await desk.type_line("ERROR NEXT")
        await desk.until(lambda: desk.place.editor.line == 2, "the second mistake")
        await desk.type_line("ERROR NEXT")
        await desk.shows("No more errors. That is 2 of 2.")
        await desk.type_line("EXPLAIN")
        await desk.until(lambda: desk.log[-1] == "Line 2: TRN 90", "the line of the mistake")

        await run()
        before = len(desk.log)
        await desk.type_line("ERROR")
        await desk.until(lambda: any("Error, line 1" in line for line in desk.log[before:]), "the first one")
        assert desk.place.editor.line == 1


async def test_last_says_the_whole_answer_again_and_the_one_before_it(work):
    async with work() as desk:
        await desk.type_line("FW 1 SPEAK 7")
        await desk.shows("7")
        await desk.idle()
        await desk.type_line("BREAK 99")
        await desk.shows("No lines yet.")

        for _ in range(2):
            before = len(desk.log)
            await desk.type_line("LAST 2")
            await desk.until(
                lambda before=before: desk.log[before + 1 :] == ("I walked 1 step forward.", "7"),
                "both lines",
            )


async def test_the_last_word_is_spelled_and_a_missing_one_is_reported(work):
    async with work() as desk:
        await desk.type_line("SPELL 9")
        await desk.shows("Nothing was said yet.")
        await desk.type_line("LAST WORD")
        await desk.shows("y, e, t.")
