"""Mistakes as data: a kind, a place and parameters. The sentences are made in i18n.

Diagnostic                the text, its place, what was expected, what was probably meant
LanguageError             the base class
+-- ProgramError          a mistake of meaning, raised when its line is reached
+-- ActionRefused         raised by an action; the runtime adds the place and makes it a ProgramError
+-- Stopped               the user stopped the program
+-- QuitRequested         QUIT was reached in the terminal
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum

from msgspec import Struct, field

from language.syntax import Program, Span

MOST_MISTAKES = 100
"""Mistakes of form that are reported for one text; no listener needs more."""


class MistakeKind(Enum):
    """The stable kinds. Scripts rely on the values."""

    SYNTAX = "syntax"
    UNKNOWN_COMMAND = "unknown-command"
    UNKNOWN_CHARACTER = "unknown-character"
    UNTERMINATED_STRING = "unterminated-string"
    INVALID_NAME = "invalid-name"
    RESERVED_WORD = "reserved-word"
    BAD_ARGUMENT = "bad-argument"
    MISSING_END = "missing-end"
    WRONG_END = "wrong-end"
    TOO_DEEP = "too-deep"
    """Blocks or parentheses nested beyond the stated limit: a mistake of form."""
    NUMBER_TOO_LARGE = "number-too-large"
    UNDECLARED_VARIABLE = "undeclared-variable"
    UNDECLARED_PROCEDURE = "undeclared-procedure"
    ALREADY_DECLARED = "already-declared"
    WRONG_ARGUMENT_COUNT = "wrong-argument-count"
    DIVISION_BY_ZERO = "division-by-zero"
    RECURSION_LIMIT = "recursion-limit"
    TERMINAL_ONLY = "terminal-only"
    BELT_OFF = "belt-off"
    ROBOT = "robot"
    """The robot can't do what it was asked, or was lost."""
    UNUSED_VALUE = "unused-value"
    """A command that does nothing: a sensor on a line of its own, a step below 0; only ever a hint."""


class Severity(Enum):
    ERROR = "error"
    HINT = "hint"


class Diagnostic(Struct, frozen=True):
    """One mistake, or one hint."""

    kind: MistakeKind
    span: Span
    code: str = ""
    """Selects the sentence where a kind has several, such as ``text-plus``; empty: the kind's own."""
    found: str = ""
    """The text at the span, as typed; empty at the end of the text."""
    expected: tuple[str, ...] = ()
    """Canonical command words (``TIMES``, ``END REPEAT``) or lower-case classes (``number``, ``name``,
    ``expression``, ``command``, ``comparison``, ``direction``, ``axis``, ``colour``, ``on-or-off``,
    ``end of text``)."""
    meant: str = ""
    """The word that was probably meant, in the language of the program, or empty."""
    details: Mapping[str, str | int] = field(default_factory=dict)
    """More values for the sentence: ``name``, ``opener``, ``opener_line``, ``wanted``, ``limit`` ..."""
    severity: Severity = Severity.ERROR
    meant_end: int | None = None
    """The end of the text that ``meant`` replaces, if that is more than the span."""
    meant_at: int | None = None
    """The offset where ``meant`` begins, if not at the span; without ``meant_end`` it replaces nothing."""


def mistake_at(
    program: Program,
    span: Span,
    kind: MistakeKind,
    details: Mapping[str, str | int],
    meant: str = "",
    code: str = "",
) -> Diagnostic:
    """A mistake in a program that can be read; ``found`` is its text."""
    return Diagnostic(kind, span, code, program.typed(span), meant=meant, details=details)


class CallSite(Struct, frozen=True):
    """One level of the call stack of a mistake: the procedure's name as declared, and the calling line."""

    procedure: str
    line: int


class LanguageError(Exception):
    """Ends a program before its last statement."""


class ProgramError(LanguageError):
    """A mistake of meaning, with the open calls, innermost first."""

    def __init__(self, diagnostic: Diagnostic, calls: tuple[CallSite, ...] = ()) -> None:
        super().__init__(diagnostic.kind.value)
        self.diagnostic = diagnostic
        self.calls = calls


class ActionRefused(LanguageError):
    """An action that is impossible now, such as VIBRATE while the belt is off."""

    def __init__(self, kind: MistakeKind, **details: str | int) -> None:
        super().__init__(kind.value)
        self.kind = kind
        self.details = details


class Stopped(LanguageError):
    """The user stopped the program."""


class QuitRequested(LanguageError):
    """QUIT was reached where it is allowed."""
