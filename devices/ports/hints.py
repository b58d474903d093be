"""What hints are written with in the modules that a start loads: ``typing``, for who checks them.

Nothing that runs asks ``typing`` anything, and to load it takes as long as thirty modules of ours. Whatever
else is loaded may use ``typing`` itself.
"""

from __future__ import annotations

TYPE_CHECKING = False

if TYPE_CHECKING:
    from typing import Any as Any
    from typing import ClassVar as ClassVar
    from typing import NoReturn as NoReturn
    from typing import Protocol as Protocol
    from typing import Self as Self
    from typing import TextIO as TextIO
    from typing import TypeAlias as TypeAlias
    from typing import TypeGuard as TypeGuard
    from typing import cast as cast
    from typing import dataclass_transform as dataclass_transform
else:
    Any = ClassVar = NoReturn = Self = TextIO = TypeAlias = TypeGuard = object

    class Protocol:
        """A port: never made, never asked for."""

        __slots__ = ()

    def cast(_kind, value):
        """``typing``'s."""
        return value

    def dataclass_transform(**_options):
        """``typing``'s: leaves what it stands above as it is."""
        return lambda written: written
