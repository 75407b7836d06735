"""The layout of a surface in fixed-capacity buffers, which both the host and `device` know.

Each capacity is a compiled program, so there are few. Rows are sorted by degree, the largest first, so that the rows
that use slot k of the one-rings are a prefix of all rows. The slots form a staircase of four levels: 7.9 numbers a
vertex, for 24 in a rectangle for the largest degree of a flow. A CG step spends nearly all its time gathering them.
"""

from itertools import accumulate
from typing import NamedTuple

SMALLEST_CAPACITY = 2048  # vertices: the smallest capacity; smaller ones would not be faster
LARGER = (3.5, 10.5)  # times the smallest capacity: the next ones, 7168 and 21504 vertices; then each is twice the last
RAGGED_TAIL = 28  # slots of the last level, unless a vertex needs more
FEW = 32  # least capacity for iterations, rounds, terms, neighbours of a tape, so that most of a size share a program


class Level(NamedTuple):
    """``slots`` one-ring slots for the first ``rows`` rows, stored slot by slot from ``offset``."""

    slots: int
    rows: int
    offset: int

    @property
    def end(self) -> int:
        """Where the next level starts."""
        return self.offset + self.slots * self.rows


class Layout(NamedTuple):
    """Capacity in vertices, and the levels of the staircase; hashable, so that a jitted step can depend on it."""

    capacity: int
    levels: tuple[Level, ...]

    @property
    def num_slots(self) -> int:
        """Length of a flat array with one entry for every slot."""
        return self.levels[-1].end


def _layout(capacity: int, *shape: tuple[int, int]) -> Layout:
    offsets = accumulate((slots * rows for slots, rows in shape), initial=0)
    return Layout(capacity, tuple(Level(*each, offset) for each, offset in zip(shape, offsets, strict=False)))


def staircase(capacity: int, largest_degree: int) -> Layout:
    """The usual layout: 6, 2, 4 and 28 slots for all, 1/2, 1/8 and 1/64 of the rows."""
    tail = RAGGED_TAIL if largest_degree <= 12 + RAGGED_TAIL else -(-(largest_degree - 12) // 32) * 32
    return _layout(capacity, (6, capacity), (2, capacity // 2), (4, capacity // 8), (tail, capacity // 64))


def rectangle(capacity: int, largest_degree: int) -> Layout:
    """The layout for a surface whose degrees fit no staircase: the same number of slots for every row."""
    return _layout(capacity, (-(-largest_degree // 8) * 8, capacity))


def capacity_for(count: int, smallest: int | None = None) -> int:
    """The smallest capacity for ``count`` vertices: 2048, 7168, 21504, 43008, ...; or with another ``smallest``."""
    sizes = [int((smallest or SMALLEST_CAPACITY) * times) for times in (1, *LARGER)]
    while sizes[-1] < count:
        sizes.append(2 * sizes[-1])
    return next(size for size in sizes if size >= count)


def fits(layout: Layout, count: int, rows_beyond: list[int]) -> bool:
    """Whether ``count`` vertices fit into ``layout``, if ``rows_beyond[k]`` of them have more than k neighbours."""
    if count > layout.capacity:
        return False
    first = 0
    for level in layout.levels:
        if first < len(rows_beyond) and rows_beyond[first] > level.rows:
            return False
        first += level.slots
    return first >= len(rows_beyond)


def layout_for(count: int, rows_beyond: list[int]) -> Layout:
    """The smallest layout for ``count`` vertices, of which ``rows_beyond[k]`` have more than k neighbours; the next
    larger staircase before the rectangle, because a few more rows cost less than many more slots."""
    largest_degree = len(rows_beyond)
    for size in (capacity_for(count), capacity_for(capacity_for(count) + 1)):
        layout = staircase(size, largest_degree)
        if fits(layout, count, rows_beyond):
            return layout
    return rectangle(capacity_for(count), largest_degree)


def smaller_layouts(layout: Layout) -> list[Layout]:
    """The usual layouts that a surface in ``layout`` passes through as it shrinks, the largest first."""
    sizes = [int(SMALLEST_CAPACITY * times) for times in (*LARGER[::-1], 1)]
    return [staircase(size, 0) for size in sizes if size < layout.capacity]
