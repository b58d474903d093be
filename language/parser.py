"""Text to tree, or to all mistakes of form at once.

A text without a mistake is read once, by the tables that lark made (tables.py). Only when that meets a
mistake does the recovery read the tokens again, to find all of them; so mistakes cost those who make them.
Colours that the robot at hand can't see are mistakes of form too.
Rule: whatever the text, the answer is a program or mistakes, in time and memory linear in its length.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from devices.ports.hints import TYPE_CHECKING, Any
from devices.ports.values import Frozen
from language.diagnostics import Diagnostic, Kind
from language.keywords import argument
from language.lexer import Lexed, Token, lex, span_of
from language.syntax import Program
from language.tables import ACTIONS, END, GOTOS, RULES, START
from language.tree import MOST_LEVELS, Reductions, TooDeep

if TYPE_CHECKING:
    from language.scopes import Declared

SHALLOW = 200
"""With fewer states on the stack than these, nothing can be nested too deeply."""

_REDUCTION_NAMES = [rule[2] for rule in RULES]


class Parsed(Frozen):
    """A program, or None and why."""

    program: Program | None
    diagnostics: tuple[Diagnostic, ...]
    """Mistakes of form in the order of the text; empty if there is a program."""


def parse(
    source: str,
    *,
    first_line: int = 1,
    colours: frozenset[str] | None = None,
    declared: Mapping[str, Declared] | None = None,
) -> Parsed:
    """Read a program.

    ``first_line`` is the number of its first line. ``colours`` are the colours that the robot can see, as
    English words; another one is a mistake. None allows all. ``declared`` are the procedures of earlier
    batches, by folded name: who calls one wrongly is told how.
    """
    lexed = lex(source, first_line)
    mistakes = unseen_colours(lexed, colours)
    if not mistakes and not lexed.mistakes:
        try:
            body = _tree(lexed)
        except TooDeep as error:
            limit = {"limit": MOST_LEVELS}
            mistakes = (Diagnostic(Kind.TOO_DEEP, error.span, "expression", details=limit),)
        else:
            if body is not None:
                return Parsed(Program(source, body), ())
    return Parsed(None, _mistakes(lexed, mistakes, first_line, colours, declared))


def _mistakes(
    lexed: Lexed,
    known: tuple[Diagnostic, ...],
    first_line: int,
    colours: frozenset[str] | None,
    declared: Mapping[str, Declared] | None,
) -> tuple[Diagnostic, ...]:
    from language.recovery.finder import mistakes_in  # only texts with mistakes need it

    return mistakes_in(lexed, known + _nested_too_deeply(lexed), first_line, colours, declared)


def _nested_too_deeply(lexed: Lexed) -> tuple[Diagnostic, ...]:
    from language.depth import nested_too_deeply  # only deep texts and wrong ones need it

    return nested_too_deeply(lexed.tokens)


def _tree(lexed: Lexed) -> tuple[Any, ...] | None:
    """The statements, or None if there is a mistake. Long for its speed: it sees every token.

    Any: what a reduction makes is as various as the tree.
    """
    actions, gotos, is_deep = ACTIONS, GOTOS, False
    end: Token = (0, 0, 0, 0, 0, "")
    states = [START]
    parts: list[Any] = []
    state = START
    reduce = _reductions(lexed.source)
    for token in (*lexed.tokens, end):
        kind = token[0]
        action = actions[state][kind]
        while action < 0:
            nonterminal, count, function = reduce[action]
            if function is None:
                state = states[-1] = gotos[states[-2]][nonterminal]
                if state == END:
                    return None if is_deep and _nested_too_deeply(lexed) else tuple(parts[-1])
            elif count == 1:
                parts[-1] = function(parts[-1])
                state = states[-1] = gotos[states[-2]][nonterminal]
            elif count == 2:
                last = parts.pop()
                parts[-1] = function(parts[-1], last)
                del states[-1]
                state = states[-1] = gotos[states[-2]][nonterminal]
            elif count == 0:
                parts.append(function())
                state = gotos[state][nonterminal]
                states.append(state)
            else:
                is_deep = is_deep or len(states) > SHALLOW
                made = function(*parts[-count:])
                del parts[-count:], states[-count:]
                parts.append(made)
                state = gotos[states[-1]][nonterminal]
                states.append(state)
            action = actions[state][kind]
        if action == 0:
            return None
        states.append(action)
        parts.append(token)
        state = action
    return None


def _reductions(source: str) -> list[tuple[int, int, Callable[..., Any] | None]]:
    functions = Reductions(source).functions(_REDUCTION_NAMES)
    return [(rule[0], rule[1], function) for rule, function in zip(RULES, functions, strict=True)]


def unseen_colours(lexed: Lexed, colours: frozenset[str] | None) -> tuple[Diagnostic, ...]:
    """A mistake for each colour outside ``colours``, which are English words; None allows all."""
    if colours is None:
        return ()
    return tuple(
        _unseen(lexed.source, token, colours) for token in lexed.colours if _english(token) not in colours
    )


def _english(token: Token) -> str:
    found = argument("COLOUR", token[5])
    return str(found.value) if found else ""


def _unseen(source: str, token: Token, colours: frozenset[str]) -> Diagnostic:
    return Diagnostic(
        Kind.BAD_ARGUMENT,
        span_of(token),
        code="unseen-colour",
        found=source[token[1] : token[2]],
        expected=("colour",),
        details={"word": "COLOR", "wanted": ", ".join(sorted(colours))},
    )
