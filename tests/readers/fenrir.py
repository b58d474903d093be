"""Starts the installed Fenrir with a speech driver that writes down what it is asked to say.

Arguments: a folder with ``logDriver.py``, then Fenrir's own.
"""

from __future__ import annotations

import runpy
import shutil
import sys
from pathlib import Path

from fenrirscreenreader.utils import module_utils  # type: ignore[import-not-found] # Debian's

OURS = Path(sys.argv.pop(1))
THEIRS = module_utils.importModule


def import_module(name: str, path: str) -> object:
    own = OURS / Path(path).name
    return THEIRS(name, str(own) if own.exists() else path)


module_utils.importModule = import_module
runpy.run_path(shutil.which("fenrir") or "fenrir", run_name="__main__")
