"""Rays through a space: the fast method and that of pymunk agree, and the fast one may be missing."""

import importlib
from collections.abc import Iterator
from types import ModuleType, SimpleNamespace

import pymunk
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sim import rays
from sim.rays import Hit, Rays
from tests.effort import examples

PLACES = st.tuples(st.floats(-5, 5), st.floats(-5, 5))
EVERYTHING = pymunk.ShapeFilter()


def boxes(places: list[tuple[float, float]]) -> tuple[pymunk.Space, list[pymunk.Shape]]:
    space = pymunk.Space()
    corners = [(0.0, 0.0), (0.6, 0.1), (0.4, 0.5)]
    shapes: list[pymunk.Shape] = [
        pymunk.Poly(space.static_body, [(x + dx, y + dy) for dx, dy in corners]) for x, y in places
    ]
    shapes += [pymunk.Segment(space.static_body, (x, y + 1), (x + 1, y + 1), 0.0) for x, y in places]
    space.add(*shapes)
    return space, shapes


def owned(space: pymunk.Space, shapes: list[pymunk.Shape], direct: bool) -> Rays[int]:
    found: Rays[int] = Rays(space, direct=direct)
    for i, shape in enumerate(shapes):
        found.own(shape, i)
    return found


@settings(max_examples=examples(150))
@given(
    st.lists(
        PLACES, min_size=1, max_size=8, unique_by=lambda place: (round(place[0], 1), round(place[1], 1))
    ),
    PLACES,
    st.lists(PLACES, min_size=1, max_size=30),
)
def test_both_methods_give_the_same_hits(
    places: list[tuple[float, float]], start: tuple[float, float], ends: list[tuple[float, float]]
) -> None:
    space, shapes = boxes(places)

    quick, plain = (
        owned(space, shapes, direct).first_hits(*start, ends, EVERYTHING) for direct in (True, False)
    )

    assert quick == plain
    assert len(quick) == len(ends)


@settings(max_examples=examples(100))
@given(st.lists(PLACES, max_size=8), PLACES, st.sampled_from((0.1, 2.0, 9.0)))
def test_both_methods_give_the_same_distance(
    places: list[tuple[float, float]], place: tuple[float, float], most: float
) -> None:
    space, shapes = boxes(places)

    quick, plain = (owned(space, shapes, direct).distance(*place, most) for direct in (True, False))

    assert quick == plain <= most


@pytest.mark.parametrize("direct", [True, False])
def test_a_distance_counts_from_the_border_and_is_below_0_inside(direct: bool) -> None:
    space = pymunk.Space()
    space.add(pymunk.Poly.create_box(space.static_body, (2.0, 2.0)))
    it: Rays[int] = Rays(space, direct=direct)

    assert [it.distance(x, 0.25, 5.0) for x in (4.0, 0.5, 7.0)] == [3.0, -0.5, 5.0]


@pytest.mark.parametrize("direct", [True, False])
def test_a_shape_that_left_is_not_hit_and_a_filter_holds(direct: bool) -> None:
    space, shapes = boxes([(1, 0)])
    shapes[0].filter, shapes[1].filter = pymunk.ShapeFilter(categories=1), pymunk.ShapeFilter(categories=2)
    it = owned(space, shapes, direct)

    def hit(mask: int) -> Hit[int]:
        return it.first_hits(1.3, -1, [(1.3, 3)], pymunk.ShapeFilter(mask=mask))[0]

    assert hit(1)[0] == 0
    assert hit(2) == (1, 0.5)
    space.remove(shapes[0])
    assert hit(pymunk.ShapeFilter.ALL_MASKS()) == (1, 0.5)


@pytest.fixture
def forgotten() -> Iterator[None]:
    rays._library.cache_clear()
    yield
    rays._library.cache_clear()


BROKEN = {
    "gone": ImportError,
    "empty": SimpleNamespace(),
    "other functions": SimpleNamespace(
        lib=SimpleNamespace(), ffi=SimpleNamespace(error=RuntimeError, new=None)
    ),
}


@pytest.mark.usefixtures("forgotten")
@pytest.mark.parametrize("state", BROKEN)
def test_the_public_method_answers_where_the_private_library_has_changed(
    state: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = BROKEN[state]

    def module(name: str) -> ModuleType:
        if found is ImportError:
            raise ImportError(name)
        return found  # type: ignore[return-value]

    monkeypatch.setattr(importlib, "import_module", module)
    space, shapes = boxes([(1, 0)])

    assert rays._library() is None
    assert owned(space, shapes, True).first_hits(1.3, -1, [(1.3, 3)], EVERYTHING)[0][0] == 0


@pytest.mark.usefixtures("forgotten")
def test_the_pinned_version_of_pymunk_has_the_fast_method() -> None:
    assert rays._library() is not None


@pytest.mark.usefixtures("forgotten")
@pytest.mark.parametrize("far", [3.0, 0.5])
@pytest.mark.parametrize("most", [5.0, 1.0])
def test_the_fast_method_is_not_used_where_its_distances_differ(
    far: float, most: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Outside and inside of a box, and beyond what was asked for."""
    direct = rays._direct_distance

    def wrong(library: object, space: pymunk.Space) -> object:
        distance = direct(library, space)
        return lambda x, y, limit: distance(x, y, limit) + (x == far and limit == most) * 0.1

    monkeypatch.setattr(rays, "_direct_distance", wrong)

    assert (rays._library() is None) is ((far, most) != (0.5, 1.0))


@pytest.mark.usefixtures("forgotten")
@pytest.mark.parametrize("ray", [0, 1])
def test_the_fast_method_is_not_used_where_its_hits_differ(ray: int, monkeypatch: pytest.MonkeyPatch) -> None:
    direct = rays._direct

    def wrong(*arguments: object) -> object:
        first_hits = direct(*arguments)  # type: ignore[arg-type]

        def changed(*question: object) -> list[Hit[object]]:
            hits = first_hits(*question)  # type: ignore[arg-type]
            hits[ray] = (hits[ray][0], hits[ray][1] * 0.5)
            return hits

        return changed

    monkeypatch.setattr(rays, "_direct", wrong)

    assert rays._library() is None


@pytest.mark.usefixtures("forgotten")
@pytest.mark.parametrize("error", [AttributeError, TypeError, KeyError, ValueError])
def test_the_fast_method_is_not_used_where_it_fails(
    error: type[Exception], monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(_library: object) -> bool:
        raise error

    monkeypatch.setattr(rays, "_trial", failing)

    assert rays._library() is None


@pytest.mark.parametrize("direct", [True, False])
def test_rays_answer_in_the_order_of_their_ends(direct: bool) -> None:
    """The box reaches from 1 to 3; a ray from 0 to 4 meets it after a quarter of its way."""
    space = pymunk.Space()
    shape = pymunk.Poly(space.static_body, [(1, -1), (3, -1), (3, 1), (1, 1)])
    space.add(shape)
    it: Rays[str] = Rays(space, direct=direct)
    it.own(shape, "box")

    ends = [(4.0, 0.0), (0.0, 4.0), (2.0, 0.0), (0.9, 0.0), (-4.0, 0.0)]
    hits = it.first_hits(0.0, 0.0, ends, EVERYTHING)

    assert hits == [("box", 0.25), (None, 1.0), ("box", 0.5), (None, 1.0), (None, 1.0)]
    it.clear()
    with pytest.raises(KeyError):
        it.first_hits(0.0, 0.0, ends, EVERYTHING)
