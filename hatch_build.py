"""The build's own step: compiles the sentences and words of all languages, see ``donnie_tui/i18n``."""

from __future__ import annotations

import sys
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class CompileTranslations(BuildHookInterface):  # type: ignore[type-arg] # hatchling ships no types for it
    """Runs before a wheel is built, and before an editable installation."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:  # noqa: ARG002
        sys.path.insert(0, self.root)
        from donnie_tui.i18n.translations import compile_all, is_built_in

        mistakes = [str(each) for each in compile_all() if is_built_in(each)]
        if mistakes:
            raise SystemExit("\n".join(mistakes))
