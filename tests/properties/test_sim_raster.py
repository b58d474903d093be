"""The squares that a polygon covers are those that overlap with it, found one by one."""

from hypothesis import given
from hypothesis import strategies as st

from sim.geometry import Point, Raster, covered, overlapping

RASTER = Raster(-3, -2, 2, 6, 5)
places = st.tuples(st.floats(-6, 12, allow_subnormal=False), st.floats(-6, 10, allow_subnormal=False))


def square(row: int, column: int, half: float, hair: float) -> tuple[Point, ...]:
    """Each side is moved by another hair, so that no corner stays on a line on which it lay."""
    x, y = RASTER.left + column * RASTER.cell, RASTER.bottom + row * RASTER.cell
    west, east, south, north = (
        x - half - hair,
        x + half + 1.7 * hair,
        y - half - 2.3 * hair,
        y + half + 3.1 * hair,
    )
    return ((west, south), (east, south), (east, north), (west, north))


def cells(outline: tuple[Point, ...], half: float) -> set[tuple[int, int]]:
    return {
        (row, column)
        for row, first, last in covered(outline, RASTER, half)
        for column in range(first, last + 1)
    }


@given(st.lists(places, min_size=3, max_size=7, unique=True), st.floats(0.4, 1.0))
def test_a_polygon_covers_exactly_the_squares_that_overlap_with_it(points: list[Point], half: float) -> None:
    """Squares a hair smaller are all found, and of squares a hair larger no others."""
    outline = tuple(points)

    found = cells(outline, half)

    every = [(row, column) for row in range(RASTER.height) for column in range(RASTER.width)]
    assert {cell for cell in every if overlapping(square(*cell, half, -1e-6), outline)} <= found
    assert found <= {cell for cell in every if overlapping(square(*cell, half, 1e-6), outline)}


def test_a_square_that_only_borders_on_the_polygon_is_not_covered() -> None:
    assert cells(((-2.0, -3.0), (0.0, -3.0), (0.0, -1.0), (-2.0, -1.0)), 1.0) == {(0, 1)}


def test_a_polygon_beyond_the_grid_covers_nothing_and_a_huge_one_everything() -> None:
    far = ((1e9, 0.0), (1e9 + 1, 0.0), (1e9, 1.0))
    huge = ((-1e9, -1e9), (1e9, -1e9), (1e9, 1e9), (-1e9, 1e9))

    assert cells(far, 1.0) == set()
    assert len(cells(huge, 1.0)) == 30
