"""Makes ``language/tables.py`` from grammar.lark. Run ``python -m tests.tools.make_tables`` after a change.

The parser runs without lark. States are numbered in the order in which they are reached over sorted symbols,
because lark's own numbers change from run to run.
"""

from __future__ import annotations

import re
import textwrap
from pathlib import Path
from typing import Any

from lark import Lark
from lark.parsers.lalr_analysis import Shift

FOLDER = Path(__file__).parents[2] / "language"

_HEADER = '''"""The parser's tables, made from grammar.lark by ``python -m tests.tools.make_tables``.

An action above 0 shifts to that state, one below 0 reduces by RULES[action], 0 is a mistake.
"""

# fmt: off
# ruff: noqa: E501
'''


def make_tables() -> str:
    """The text that tables.py must have."""
    grammar = (FOLDER / "grammar.lark").read_text(encoding="utf-8")
    terminals = ["$END", *_declared(grammar)]
    table = Lark(grammar, parser="lalr", lexer="basic", start="program").parser.parser._parse_table
    return _HEADER + "\n".join(_tables(table, terminals))


def _declared(grammar: str) -> list[str]:
    return [name for line in re.findall(r"^%declare (.+)$", grammar, re.M) for name in line.split()]


def _tables(table: Any, terminals: list[str]) -> list[str]:
    """``table`` is lark's ParseTable: it has no public type."""
    order = _order(table)
    number = {state: index + 1 for index, state in enumerate(order)}
    found = {act for row in table.states.values() for kind, act in row.values() if kind is not Shift}
    rules = sorted(found, key=_shape)
    nonterminals = sorted({str(rule.origin.name) for rule in rules})
    rule_number = {rule: index - len(rules) for index, rule in enumerate(rules)}
    actions, gotos = [[0] * len(terminals)], [[0] * len(nonterminals)]
    for state in order:
        actions.append([0] * len(terminals))
        gotos.append([0] * len(nonterminals))
        for symbol, (kind, act) in table.states[state].items():
            value = number[act] if kind is Shift else rule_number[act]
            if symbol in terminals:
                actions[-1][terminals.index(symbol)] = value
            else:
                gotos[-1][nonterminals.index(symbol)] = value
    shapes = [
        (nonterminals.index(rule.origin.name), len(rule.expansion), rule.alias or "", _parts(rule))
        for rule in rules
    ]
    _shorten(actions, gotos, shapes)
    return [
        f"START = {number[table.start_states['program']]}",
        f"END = {number[table.end_states['program']]}",
        _names("TERMINALS", terminals),
        _names("NONTERMINALS", nonterminals),
        "# nonterminal, number of parts, the method of tree_builder.py, the parts",
        _rows("RULES", shapes),
        _rows("ACTIONS", map(tuple, actions)),
        _rows("GOTOS", map(tuple, gotos)),
        "",
    ]


def _shorten(actions: list[list[int]], gotos: list[list[int]], shapes: list[Any]) -> None:
    """Skip each state that only renames a part, such as an atom to a factor."""
    for row in gotos:
        for nonterminal, state in enumerate(row):
            only = set(actions[state]) - {0}
            while state and len(only) == 1 and min(only) < 0 and shapes[min(only)][1:3] == (1, ""):
                state = row[nonterminal] = row[shapes[min(only)][0]]
                only = set(actions[state]) - {0}


def _parts(rule: Any) -> tuple[str, ...]:
    return tuple(str(symbol.name) for symbol in rule.expansion)


def _shape(rule: Any) -> tuple[str, tuple[str, ...]]:
    return str(rule.origin.name), _parts(rule)


def _order(table: Any) -> list[Any]:
    """The states in the order in which they are reached."""
    found = [table.start_states["program"]]
    for state in found:
        for _, (kind, target) in sorted(table.states[state].items(), key=lambda item: item[0]):
            if kind is Shift and target not in found:
                found.append(target)
    return found


def _names(name: str, values: list[str]) -> str:
    lines = textwrap.wrap(", ".join(map(repr, values)), 106)
    return f"{name} = (\n" + "".join(f"    {line}\n" for line in lines) + ")"


def _rows(name: str, values: Any) -> str:
    return f"{name} = (\n" + "".join(f"    {value!r},\n" for value in values) + ")"


if __name__ == "__main__":
    (FOLDER / "tables.py").write_text(make_tables(), encoding="utf-8")
