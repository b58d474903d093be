"""What things of GoDonnie are called in the translated code: names of Python that can't clash."""

from __future__ import annotations

VARIABLE = "v_"
"""What the Python name of a variable begins with."""

OWNER = "o_"
"""What the Python name of a variable's declaration begins with."""

EARLIER = -1
"""The declaration of a variable that an earlier batch left; others are the sites of a declaration."""

PARAMETER = -2
"""The declaration of a variable that is a parameter."""


def wanted_at(line: int) -> str:
    """The global that says whether anything is wanted at a line."""
    return f"w_{line}"


def procedure_taking(name: str, count: int) -> str:
    """The global that is a procedure, called with so many arguments."""
    return f"p_{name}_{count}"
