"""The editor beside the typing: completion, mistakes, breakpoints, programs; stepping back; settings."""

import tomllib

import pytest
from textual.app import App

from donnie_tui.core.session import Session
from donnie_tui.tui.running import Doing
from donnie_tui.tui.screens import workplace
from donnie_tui.tui.screens.completions import Completions
from donnie_tui.tui.terminal_app import TerminalApp


@pytest.fixture(autouse=True)
def own_settings(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))


def kept(tmp_path) -> dict:
    return tomllib.loads((tmp_path / "config" / "donnie" / "settings.toml").read_text())


# --- words


async def test_ctrl_space_lists_the_words_and_enter_takes_one(work):
    async with work() as desk:
        await desk.press(*"REP", "ctrl+@")
        await desk.until(lambda: isinstance(desk.app.screen, Completions), "the list")
        assert "REPEAT" in desk.screen
        await desk.press("enter")
        await desk.until(lambda: desk.app.work.text == "REPEAT", desk.app.work.text)


async def test_the_cursor_of_the_terminal_stands_on_the_chosen_word(work):
    async with work("FW 1 ") as desk:
        desk.place.editor.move_cursor((0, 5))
        await desk.press("ctrl+@")
        await desk.until(lambda: isinstance(desk.app.screen, Completions), "the list")
        await desk.press("down", "down")
        await desk.pilot.pause()
        x, y = desk.app.cursor_position
        option = desk.app.screen.list.get_option_at_index(2)

        assert desk.screen.splitlines()[y][x:].startswith(str(option.prompt))


async def test_a_letter_goes_on_typing_and_leaves_the_list(work):
    async with work() as desk:
        await desk.press(*"RE", "ctrl+@")
        await desk.until(lambda: isinstance(desk.app.screen, Completions), "the list")
        await desk.press("P")
        await desk.until(lambda: desk.app.work.text == "REP", "the letter")


async def test_the_likely_word_is_shown_behind_the_cursor_and_taken_with_the_right_arrow(work):
    async with work() as desk:
        await desk.press(*"REPE")
        await desk.pilot.pause()
        assert desk.place.editor.suggestion == "AT"
        await desk.press("right")

        assert desk.app.work.text == "REPEAT"


async def test_what_is_only_offered_is_underlined(work):
    """By colour alone it would be typed text where there are no colours."""
    async with work() as desk:
        await desk.press(*"REPE")
        await desk.pilot.pause()
        row = desk.place.editor.render_line(0)

        underlined = [each.text for each in row if each.style and each.style.underline]
        assert "".join(underlined) == "AT"


async def test_completion_can_be_switched_off_and_that_is_kept(work, tmp_path):
    async with work() as desk:
        desk.app.work.prefer("completion", "off")
        await desk.press(*"REPE")
        await desk.pilot.pause()

        assert desk.place.editor.suggestion == ""
        assert kept(tmp_path)["completion"] is False


# --- mistakes


async def test_a_mistake_is_marked_while_somebody_types_with_its_sentence(work):
    async with work(size=(120, 40)) as desk:
        await desk.press(*"FWD 3")
        await desk.until(lambda: "!1  FWD 3  ! I do not know FWD." in desk.screen, "the mark")

        assert "Ctrl+T puts FW." in desk.status


async def test_one_key_puts_what_was_meant(work):
    async with work("FW 1\nREPEAT 2 TIMS FW 1 END REPEAT") as desk:
        await desk.press("ctrl+t")
        await desk.told("Line 2: TIMES now.")

        assert desk.app.work.text == "FW 1\nREPEAT 2 TIMES FW 1 END REPEAT"
        assert desk.place.editor.next_mistake is None
        await desk.press("ctrl+z")
        assert "TIMS" in desk.app.work.text


async def test_after_mending_a_word_typing_goes_on_where_it_was(work):
    async with work("") as desk:
        await desk.press(*"FW 1 TRR 90")
        await desk.press("ctrl+t")
        await desk.told("Line 1: TR now.")
        await desk.press("enter", *"FW 2")
        await desk.until(lambda: desk.app.work.text == "FW 1 TR 90\nFW 2", desk.app.work.text)


async def test_ctrl_z_tells_what_it_took_back_and_ctrl_y_makes_it_again(work):
    async with work("FW 1\nFW 2") as desk:
        await desk.type_line("DELETE 1")
        await desk.told("Line 1 deleted.")
        desk.place.editor.focus()
        await desk.press("ctrl+z")
        await desk.told("Line 1: FW 1")
        assert desk.app.work.text == "FW 1\nFW 2"

        await desk.press("ctrl+y")
        await desk.told("Line 1: FW 2")
        assert desk.app.work.text == "FW 2"


async def test_what_nobody_can_guess_is_told(work):
    async with work('SPEAK "x') as desk:
        await desk.press("ctrl+t")
        await desk.told("I don't know what was meant.")


# --- breakpoints and going back


async def test_a_program_holds_at_its_breakpoints(work):
    async with work('FW 1\nSPEAK "two"\nFW 1\nSPEAK "four"') as desk:
        for line in (2, 4):
            desk.place.editor.go_to(line)
            await desk.press("ctrl+b")
        await desk.told("Line 4 has a breakpoint.")
        await desk.press("f5")
        await desk.told('Line 2: SPEAK "two"')
        assert ">B2" in desk.screen
        await desk.press("f6")
        await desk.told('Line 4: SPEAK "four"')
        assert not any(line == "four" for line in desk.log)
        desk.place.editor.go_to(4)
        await desk.press("ctrl+b", "f6")
        await desk.told("The program is done.")


async def test_a_breakpoint_that_is_set_while_the_program_holds_is_heeded(work):
    async with work('FW 1\nSPEAK "two"\nFW 1\nSPEAK "four"') as desk:
        desk.place.editor.go_to(2)
        await desk.press("ctrl+b", "f5")
        await desk.told('Line 2: SPEAK "two"')
        desk.place.editor.go_to(4)
        await desk.press("ctrl+b", "f6")
        await desk.told('Line 4: SPEAK "four"')
        await desk.press("f6")
        await desk.told("The program is done.")


async def test_a_breakpoint_goes_with_its_line(work):
    async with work("FW 1\nFW 2\nFW 3") as desk:
        desk.place.editor.set_breakpoints(frozenset({2, 3}))
        desk.place.editor.move_cursor((0, 4))
        await desk.press("enter")
        assert desk.place.editor.breakpoints == {3, 4}
        await desk.press("ctrl+a", "delete")
        assert desk.place.editor.breakpoints <= {1}


async def test_stepping_back_shows_where_the_robot_was_and_a_run_goes_on_from_where_it_is(work):
    async with work("FW 3\nTR 90\nFW 2") as desk:
        await desk.press("f5")
        await desk.told("The program is done.")
        assert desk.app.work.display.scene.robot == desk.app.work.display.scene.cell_at(2, 3)
        for _ in range(8):
            await desk.press("ctrl+k", "k")
            await desk.pilot.pause()
        await desk.told("Back: FW 3.")
        assert desk.app.work.display.scene.robot == desk.app.work.display.scene.cell_at(0, 0)
        await desk.type_line("FW 1")
        await desk.told("I walked 1 step forward.")
        await desk.idle()

        assert desk.app.work.display.scene.robot == desk.app.work.display.scene.cell_at(3, 3)


# --- the text as a whole


async def test_search_goes_to_the_next_place_and_round(work):
    async with work("FW 1\nTR 90\nfw 2") as desk:
        desk.place.editor.move_cursor((0, 1))
        await desk.type_line("SEARCH fw")
        await desk.until(lambda: desk.place.editor.line == 3, "the third line")
        await desk.type_line("SEARCH AGAIN")
        await desk.until(lambda: desk.place.editor.line == 1, "the first line")
        await desk.type_line("SEARCH XYZ")
        await desk.told("XYZ is not in the program.")


async def test_the_line_that_was_found_stays_in_the_status_line_until_a_key_moves_on(work):
    async with work("FW 1\nTR 90\nfw 2") as desk:
        desk.place.editor.move_cursor((0, 1))
        await desk.type_line("SEARCH fw")
        await desk.until(lambda: desk.place.editor.line == 3, "the third line")
        await desk.told("Line 3: fw 2")
        for _ in range(3):
            await desk.pilot.pause()
        assert "Line 3: fw 2." in desk.status
        await desk.press("up")
        await desk.until(lambda: "Line 3: fw 2." not in desk.status, "another line")


async def test_without_completion_a_word_is_still_listed_for_who_asks(work, tmp_path):
    async with work(completion=False) as desk:
        await desk.press(*"REPE")
        await desk.pilot.pause()
        assert desk.place.editor.suggestion == ""
        await desk.press("right")
        assert desk.app.work.text == "REPE"
        await desk.press("ctrl+space")
        await desk.until(lambda: desk.app.screen is not desk.place, "the list")


@pytest.mark.parametrize("wanted", ["olá", "OLA"])
async def test_a_word_is_found_without_its_accents_and_selected_where_it_stands(work, wanted):
    """Letters that are longer in capitals stand before it, and on its line."""
    async with work('SPEAK "ßßß"\nSPEAK "ß Olá"') as desk:
        await desk.type_line(f"SEARCH {wanted}")
        await desk.told('Line 2: SPEAK "ß Olá"')
        assert desk.place.editor.selected_text == "Olá"


async def test_what_stands_nowhere_is_not_asked_about(work):
    async with work("FW 1") as desk:
        await desk.type_line("REPLACE BK")
        await desk.told("BK is not in the program.")
        assert desk.app.screen is desk.place


async def test_replace_counts_and_is_one_thing_to_undo(work):
    async with work("FW 1 FW 2") as desk:
        await desk.type_line("REPLACE FW")
        await desk.answer("BW")
        await desk.told("2 times replaced.")
        assert desk.app.work.text == "BW 1 BW 2"
        await desk.type_line("UNDO")

        await desk.until(lambda: desk.app.work.text == "FW 1 FW 2", "the text before")


async def test_format_and_translate_change_the_text(work):
    async with work("repeat 2 times fw 1 end repeat") as desk:
        await desk.type_line("FORMAT")
        await desk.told("Laid out anew.")
        assert desk.app.work.text == "REPEAT 2 TIMES\n  FW 1\nEND REPEAT"
        await desk.type_line("TRANSLATE pt")
        await desk.until(lambda: "REPITA" in desk.app.work.text, "the keywords")
        desk.app.work.load("FW FW")
        await desk.type_line("FORMAT")
        await desk.told("There is a mistake in line 1")


async def test_several_programs_keep_their_texts_and_files(work, tmp_path):
    (tmp_path / "one.gd").write_text("FW 1\n")
    async with work(file=tmp_path / "one.gd") as desk:
        files = desk.app.work.files
        files.turn_to(None)
        await desk.press(*"FW 2")
        assert [name for name, _ in files.open_programs] == ["one.gd, 1 line", "new program, 1 line, changed"]
        files.turn_to(0)
        assert desk.app.work.text == "FW 1"
        files.turn_to(1)

        assert desk.app.work.text == "FW 2"
        assert files.document.path is None


async def test_leaving_asks_for_each_program_that_is_not_saved(work):
    async with work() as desk:
        await desk.press(*"FW 1")
        desk.app.work.files.turn_to(None)
        await desk.press("ctrl+q")
        await desk.answer("no")
        await desk.until(lambda: not desk.app.is_running or desk.app._exit, "the end")


async def test_what_was_opened_lately_is_offered(work, tmp_path):
    (tmp_path / "one.gd").write_text("FW 1\n")
    async with work() as desk:
        await desk.type_line(f"OPEN {tmp_path / 'one.gd'}")
        await desk.told("one.gd")
        await desk.type_line("RECENT")
        await desk.until(lambda: "Recent programs" in desk.screen, "the list")

        assert ">one.gd," in desk.screen


# --- settings


async def test_the_look_is_chosen_by_word_and_kept(work, tmp_path):
    async with work() as desk:
        await desk.type_line("THEME light")
        await desk.told("Look: light.")

        assert desk.app.theme == "donnie-light"
        assert kept(tmp_path)["theme"] == "light"


async def test_the_language_changes_everything_at_once(work):
    async with work() as desk:
        await desk.type_line("LANGUAGE pt")
        await desk.told("Idioma: português.")
        await desk.until(lambda: "Mapa:" in desk.screen and "Registro" in desk.screen, "the titles")

        assert "Executar" in desk.screen
        assert "Pronto" in desk.status


async def test_the_settings_list_changes_one_and_comes_back(work, tmp_path):
    async with work() as desk:
        await desk.press("ctrl+k", "comma")
        await desk.until(lambda: "Settings" in desk.screen and "Look: dark." in desk.screen, "the settings")
        await desk.press(*"detail", "enter")
        await desk.until(lambda: "normal" in desk.screen and "brief" in desk.screen, "the values")
        await desk.press(*"brief", "enter")
        await desk.until(lambda: "Detail: brief." in desk.screen, "the settings again")
        await desk.press("escape")

        assert kept(tmp_path)["verbosity"] == "brief"


async def test_another_key_works_at_once(work):
    async with work('SPEAK "by another key"') as desk:
        desk.app.work.prefer("keys", "run f9")
        await desk.press("f9")
        await desk.told("by another key")


async def test_the_plain_layout_is_one_column_with_the_command_line_first(work):
    async with work("FW 1", plain=True) as desk:
        assert desk.app.focused is desk.place.command_line
        assert "Map:" not in desk.screen
        assert not set("│─┌┐└┘▔▁") & set(desk.screen)
        order = []
        for _ in range(5):
            order.append(desk.app.focused.id)
            await desk.press("tab")
            await desk.pilot.pause()

        assert order == ["command", "editor", "log", "map", "inspector"]


async def test_the_plain_layout_shows_each_answer_once_and_nothing_else(work):
    """A reader tells what is written: no kind, no repeated command, no sentence again in the status line."""
    async with work("", plain=True) as desk:
        await desk.type_line("FW 3")
        await desk.told("I walked 3 steps forward.")
        await desk.idle()
        await desk.until(lambda: "I walked 3 steps forward." in desk.screen, "the answer")

        assert desk.status.strip() == "Command line."
        assert not any("FW 3" in line for line in desk.log)
        assert "moved" not in desk.screen


async def test_in_the_plain_layout_a_command_goes_as_its_answer_comes(work, monkeypatch):
    """In one picture: Fenrir says letters that go and leave nothing new."""
    monkeypatch.setattr(workplace, "LONGEST_HELD", 600.0)
    pictures = []
    display = TerminalApp._display

    async with work("", plain=True) as desk:
        monkeypatch.setattr(
            TerminalApp, "_display", lambda *given: pictures.append(desk.screen) or display(*given)
        )
        await desk.press(*"FW 3")
        await desk.until(lambda: "> FW 3" in "".join(pictures[-1:]), "what is typed")
        del pictures[:-1]
        await desk.press("enter")
        await desk.until(lambda: "I walked 3 steps forward." in pictures[-1], "the answer")

        shown = [("> FW 3" in each, "I walked" in each) for each in pictures]
        assert (False, False) not in shown


@pytest.mark.parametrize(
    ("typed", "seen"),
    [("WORLDS", "living_room"), ("SAVE LOG", "log.txt"), ("HELP", "F1"), ("SHOW MAP", "####")],
)
async def test_what_a_plain_command_opens_is_painted_at_once(work, monkeypatch, typed, seen):
    """It was left out while the command was held back, and the terminal showed the old screen."""
    monkeypatch.setattr(workplace, "LONGEST_HELD", 600.0)
    async with work("", plain=True, world="living_room") as desk:
        painted = []
        display = App._display

        def paint(app, screen, renderable):
            if renderable is not None and not app._batch_count:  # as Textual asks before it writes
                painted.append(desk.screen)
            display(app, screen, renderable)

        monkeypatch.setattr(App, "_display", paint)
        await desk.press(*typed, "enter")
        await desk.until(lambda: seen in "".join(painted[-1:]), seen)


async def test_a_command_that_takes_longer_goes_before_its_answer(work):
    async with work("", plain=True, speed=1.0) as desk:
        await desk.type_line("WAIT 1000")
        await desk.until(lambda: "WAIT" not in desk.screen, "an empty command line")
        await desk.press("x")
        await desk.until(lambda: "> x" in desk.screen, "what is typed")


async def test_the_plain_log_lets_no_row_go_by_unseen(work):
    async with work("", plain=True) as desk:
        seen = set()

        def all_told():
            seen.update(line.strip(" .") for line in desk.screen.splitlines())
            return "20" in seen

        await desk.type_line("REPEAT 1 TIMES FOR VAR i = 1; i <= 20; i = i + 1 DO SPEAK i END FOR END REPEAT")
        await desk.until(all_told, "the last number")

        assert {str(number) for number in range(1, 21)} <= seen


async def test_the_map_has_the_plain_screen_to_itself(work):
    async with work("FW 1", plain=True, world="living_room") as desk:
        await desk.type_line("SHOW MAP")
        await desk.until(lambda: "####" in desk.screen, "the map")

        assert desk.place.map.size.width == 80
        assert "FW 1" not in desk.screen


@pytest.mark.parametrize("size", [(80, 24), (40, 12)], ids=str)
async def test_at_the_plain_command_line_the_log_is_seen_from_wherever_one_comes(work, size):
    async with work("FW 1", plain=True, world="living_room", size=size) as desk:
        for pane in (desk.place.map_pane, desk.place.inspector_pane, desk.place.program_pane):
            desk.place.go_to(pane)
            await desk.pilot.pause()
            await desk.type_line("FW 3")
            await desk.until(lambda: desk.place.log_is_seen, "the log")
        await desk.until(lambda: "I walked 3 steps forward." in desk.screen, "the answer")
        desk.place.go_to(desk.place.map_pane)
        await desk.until(lambda: not desk.place.log_is_seen, "the map alone")


async def test_a_look_into_the_past_needs_nothing_to_run(work):
    async with work("WAIT 1000", speed=1.0) as desk:
        await desk.press("f5")
        await desk.doing(Doing.RUNNING)
        await desk.type_line("STEP BACK")
        await desk.told("A program is running.")
        assert isinstance(desk.app.work._donnie.session, Session)
        await desk.press("f8")


# --- breakpoints of each program


async def test_breakpoints_are_there_again_at_the_next_start(work, tmp_path):
    path = tmp_path / "walk.gd"
    path.write_text("FW 1\nFW 2\nFW 3\n", encoding="utf-8")
    async with work(file=path) as desk:
        desk.place.editor.go_to(2)
        await desk.press("ctrl+b")
        await desk.told("Line 2 has a breakpoint.")
    async with work(file=path) as desk:
        await desk.told("Breakpoints: 2.")
        assert desk.place.editor.breakpoints == {2}
        await desk.press("f5")
        await desk.told("Line 2: FW 2")


async def test_each_open_program_has_its_own_breakpoints(work):
    async with work("FW 1\nFW 2") as desk:
        await desk.press("ctrl+b")
        await desk.told("Line 1 has a breakpoint.")
        desk.app.work.files.turn_to(None)
        assert desk.place.editor.breakpoints == frozenset()
        desk.app.work.files.turn_to(0)
        assert desk.place.editor.breakpoints == {1}


async def test_a_program_holds_where_its_breakpoint_has_moved_to(work):
    async with work("FW 1\nFW 2") as desk:
        desk.place.editor.go_to(2)
        await desk.press("ctrl+b")
        await desk.told("Line 2 has a breakpoint.")
        desk.place.editor.insert("TR 90\n", (0, 0))
        await desk.press("f5")
        await desk.told("Line 3: FW 2")


async def test_in_the_plain_layout_the_marks_have_columns_of_their_own(work):
    async with work("FW 5\nTR 90", plain=True) as desk:
        editor = desk.place.editor
        editor.focus()
        editor.set_breakpoints(editor.breakpoints ^ {1})
        await desk.press("end")
        await desk.pilot.pause()

        assert [editor.render_line(y).text.rstrip() for y in range(3)] == [" BFW 5", "  TR 90", ""]
        assert editor.render_line(0).cell_length == editor.size.width
        assert editor.cursor_screen_offset.x == editor.content_region.x + len(" BFW 5")
        assert " BFW 5" in desk.screen
