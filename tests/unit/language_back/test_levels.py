"""What is read of a frame that runs meanwhile."""

from __future__ import annotations

from language.levels import variables_in


class Asked:
    """No number, and whoever asks whether it is one has another thread fill the names anew."""

    def __init__(self, names: dict[str, object]) -> None:
        self.names = names

    @property
    def __class__(self) -> type:
        self.names["v_new"] = 1
        return object


def test_variables_that_come_while_they_are_looked_at_end_nobody() -> None:
    names: dict[str, object] = {}
    names |= {"v_asked": Asked(names), "v_a": 5}

    assert variables_in(names) == {"a": 5}
