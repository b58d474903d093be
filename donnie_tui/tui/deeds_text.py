"""What the actions about the text do: completing, mending, searching, moving in it, laying it out."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from textual.widgets.text_area import Selection

from donnie_tui import LANGUAGES
from donnie_tui.core import finding
from donnie_tui.core.harmless import printable
from donnie_tui.core.holding_lines import toggled, told_elsewhere
from donnie_tui.core.mistakes import mended
from donnie_tui.core.reading import ProgramText, line_in_words, place_in_words
from donnie_tui.core.typed_program import first_difference
from donnie_tui.core.typed_words import language_named, number_in
from donnie_tui.tui.running import Answer
from donnie_tui.tui.screens.chooser import Choice
from language.formatter import formatted
from language.source import lines_in

if TYPE_CHECKING:
    from donnie_tui.core.mistakes import Mistake
    from donnie_tui.tui.host import WorkHost


class TextDeeds:
    """One method an action. Those that ask something are coroutines."""

    def __init__(self, host: WorkHost) -> None:
        self._host = host
        self._editor = host.workplace.editor
        self._searched = ""

    # --- words and mistakes

    async def complete(self, _argument: str) -> None:
        editor = self._editor
        editor.focus()
        found = self._host.while_typing.completion(editor.text, editor.offset_of_cursor)
        if not found.words:
            self._host.talk.tell(Answer("screen-nothing-to-complete"))
            return
        word, letter = await self._host.talk.choose_word(found.words, editor.cursor_screen_offset)
        if word:
            editor.put_in_place_of(found.typed, word)
        elif letter:
            editor.insert(letter)

    def fix(self, _argument: str) -> None:
        """What was probably meant, in the place of what stands there."""
        self._host.while_typing.check_now()
        mistake = self._editor.next_mistake
        if mistake is None or not mistake.meant:
            self._host.talk.tell(Answer("screen-nothing-to-fix" if mistake is None else "screen-no-fix"))
            return
        self._put(mended(self._editor.text, mistake), self._after_mending(mistake))
        self._host.talk.tell(Answer("screen-fixed", {"line": mistake.mended_line, "word": mistake.meant}))
        self._host.while_typing.check_now()

    def _after_mending(self, mistake: Mistake) -> int:
        """Where the cursor stands then: behind the same letter of its line, or behind what was mended."""
        here, end = self._editor.offset_of_cursor, mistake.start + len(mistake.put)
        if self._editor.line not in (mistake.line, mistake.mended_line) or mistake.start < here < mistake.end:
            return end
        return here if here <= mistake.start else here + end - mistake.end

    def break_(self, argument: str) -> bool:
        line = number_in(argument, self._editor.line)
        if line is None:
            return False
        if 1 <= line <= self._editor.line_count:
            self._toggle_breakpoint(line)
        else:
            self._host.talk.tell(Answer("answer-no-line", {"line": line, "last": self._editor.line_count}))
        return True

    def _toggle_breakpoint(self, line: int) -> None:
        breakpoints, at = toggled(
            self._editor.breakpoints, line, self._editor.text, self._host.donnie.session.parse
        )
        self._host.talk.tell_sentences(*told_elsewhere(line, at, self._host.words))
        if at is None:
            return
        self._editor.set_breakpoints(breakpoints)
        self._host.running.breakpoints_changed()
        self._host.files.keep_breakpoints()
        self._host.talk.tell(
            Answer("screen-break-on" if at in breakpoints else "screen-break-off", {"line": at})
        )

    # --- searching

    async def search(self, argument: str) -> None:
        wanted = argument or await self._host.talk.ask(self._host.words("ask-search"), value=self._searched)
        if wanted:
            self._searched = wanted
            self._search(wanted)

    async def search_again(self, _argument: str) -> None:
        await self.search(self._searched)

    def _search(self, wanted: str) -> None:
        """From the cursor on, and once round: what is found is selected, and its line told."""
        editor = self._editor
        place = finding.found_from(editor.document.lines, wanted, *editor.cursor_location)
        if place is None:
            self._host.talk.tell_sentences(finding.not_found(wanted, self._host.words))
            return
        editor.focus()
        editor.selection = Selection((place.row, place.start), (place.row, place.end))
        self._host.talk.tell(Answer("answer-line", {"line": place.row + 1, "text": self._line(place.row)}))

    async def replace(self, argument: str) -> None:
        wanted = argument or await self._host.talk.ask(self._host.words("ask-search"), value=self._searched)
        if not wanted:
            return
        count = self._editor.text.count(wanted)
        if not count:
            lines = self._editor.document.lines
            self._host.talk.tell_sentences(finding.not_to_replace(lines, wanted, self._host.words))
            return
        asked = self._host.words("ask-replace-by", word=finding.told(wanted))
        instead = finding.replacement(await self._host.talk.ask(asked))
        if instead is None:
            self._host.talk.tell(Answer("answer-unchanged"))
        else:
            self._put(self._editor.text.replace(wanted, instead), self._editor.offset_of_cursor)
            self._host.talk.tell(Answer("screen-replaced", {"count": count}))

    def undo(self, _argument: str) -> None:
        """The last change is taken back; the first line that is another one now is told."""
        self._change_by(self._editor.undo)

    def redo(self, _argument: str) -> None:
        """The same, for the change that was taken back last."""
        self._change_by(self._editor.redo)

    def _change_by(self, step: Callable[[], None]) -> None:
        before = lines_in(self._editor.text)
        step()
        after = lines_in(self._editor.text)
        row = first_difference(before, after)
        if before == after:
            self._host.talk.tell(Answer("answer-unchanged"))
        elif row < len(after):
            self._host.talk.tell(Answer("answer-line", {"line": row + 1, "text": self._line(row)}))
        else:
            self._host.talk.tell(Answer("linear-lines", {"lines": len(after)}))

    # --- layout

    async def format(self, _argument: str) -> None:
        await self._lay_out(None)

    async def translate(self, argument: str) -> None:
        words = self._host.words
        chosen = language_named(argument)
        if chosen is None:
            rows = [Choice(each, words(f"language-{each}")) for each in LANGUAGES]
            chosen = await self._host.talk.choose(words("ask-translate"), rows) or ""
        if chosen:
            await self._lay_out(chosen)

    async def _lay_out(self, language: str | None) -> None:
        text = self._editor.text
        result = await self._host.talk.patiently(lambda: formatted(text, language), Answer("slow-layout"))
        if self._editor.text != text:
            self._host.talk.tell(Answer("text-changed-meanwhile"))
            return
        if result.text is None:
            first = result.diagnostics[0]
            self._host.talk.tell(Answer("screen-not-formatted", {"line": first.span.line}))
            return
        line = self._editor.line
        self._put(result.text.removesuffix("\n"), 0)
        self._editor.go_to(line)
        self._host.talk.tell(Answer("screen-formatted"))

    def _put(self, text: str, at: int) -> None:
        """Another text as one edit, which can be undone."""
        self._editor.replace(text, (0, 0), self._editor.document.end)
        self._editor.move_cursor(self._editor.location_of(at))

    # --- moving

    async def go_to(self, argument: str) -> bool:
        typed = argument or await self._host.talk.ask(self._host.words("ask-line"))
        line = number_in(typed or "", self._editor.line)
        return not typed or self._go_to_typed(line)

    async def outline(self, _argument: str) -> None:
        lines = self._text.outline_lines
        words = self._host.words
        if not lines:
            self._host.talk.tell(Answer("outline-none"))
            return
        rows = [
            Choice(
                str(each.number), words("answer-line", line=each.number, text="  " * each.level + each.text)
            )
            for each in lines
        ]
        chosen = await self._host.talk.choose(words("outline-count", count=len(lines)), rows)
        if chosen:
            self._go_to(int(chosen))

    @property
    def _text(self) -> ProgramText:
        return ProgramText(lines_in(self._editor.text))

    def _line(self, row: int) -> str:
        return printable(self._editor.document.get_line(row).strip())

    def _go_to(self, line: int | None) -> None:
        """To a line, telling it as the linear mode does; or that there is none to go to."""
        text = self._text
        if line is None or not 1 <= line <= len(text):
            self._host.talk.tell(Answer("screen-no-way"))
            return
        before = text.line(min(self._editor.line, len(text)))
        self._editor.go_to(line)
        self._editor.focus()
        self._host.talk.tell_sentences(line_in_words(text.line(line), before, self._host.words))

    def read(self, argument: str) -> bool:
        line = number_in(argument, self._editor.line)
        if argument:
            return self._go_to_typed(line)
        self._go_to(line)
        return True

    def _go_to_typed(self, line: int | None) -> bool:
        """To a line by its number, or say which is the last. Whether it is a number."""
        last = len(self._text)
        if line is not None and not 1 <= line <= last:
            self._host.talk.tell(Answer("answer-no-line", {"line": line, "last": last}))
        elif line is not None:
            self._go_to(line)
        return line is not None

    def next(self, _argument: str) -> None:
        self._go_to(self._editor.line + 1)

    def back(self, _argument: str) -> None:
        self._go_to(self._editor.line - 1)

    def first(self, _argument: str) -> None:
        self._go_to(1)

    def last_line(self, _argument: str) -> None:
        self._go_to(len(self._text))

    def up(self, _argument: str) -> None:
        self._go_to(self._move(ProgramText.up))

    def down(self, _argument: str) -> None:
        self._go_to(self._move(ProgramText.down))

    def next_same(self, _argument: str) -> None:
        self._go_to(self._move(ProgramText.next_same))

    def back_same(self, _argument: str) -> None:
        self._go_to(self._move(ProgramText.back_same))

    def _move(self, way: Callable[[ProgramText, int], int | None]) -> int | None:
        text = self._text
        return way(text, self._editor.line) if 1 <= self._editor.line <= len(text) else None

    def place(self, _argument: str) -> None:
        text = self._text
        if 1 <= self._editor.line <= len(text):
            self._host.talk.tell_sentences(*place_in_words(text, self._editor.line, self._host.words))
