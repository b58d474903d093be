"""Pictures that a camera could make, drawn by the tests."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TypeAlias

import cv2
import numpy as np

RED, GREEN, BLUE, WALL = (200, 30, 30), (20, 160, 40), (20, 60, 200), (190, 190, 190)
"""Red, green and blue of a pixel."""

Rectangle: TypeAlias = tuple[int, int, int, int, tuple[int, int, int]]
"""Left, top, right, bottom, in pixels; and the colour."""


def drawn(*things: Rectangle, width: int = 640, height: int = 480) -> np.ndarray:
    """Things before a grey wall."""
    picture = np.full((height, width, 3), WALL, np.uint8)
    for left, top, right, bottom, colour in things:
        cv2.rectangle(picture, (left, top), (right - 1, bottom - 1), colour, -1)
    return picture


def save(folder: Path, pictures: Mapping[str, np.ndarray]) -> Path:
    folder.mkdir(exist_ok=True)
    for name, picture in pictures.items():
        cv2.imwrite(str(folder / name), cv2.cvtColor(picture, cv2.COLOR_RGB2BGR))
    return folder
