"""The padded layout: few capacities, room for every neighbour, and nothing lost or doubled in packing."""

import numpy as np
import pytest
from conftest import OWN_SMALLEST_CAPACITY, blob, torus
from hypothesis import given, settings
from hypothesis import strategies as st

from msf_jax.base import layout as capacities
from msf_jax.base.layout import Layout, capacity_for, fits, layout_for, rectangle, staircase
from msf_jax.meso import edits, packing
from msf_jax.meso.meso import Meso


@pytest.fixture(scope="module", autouse=True)
def of_the_package():
    """The smallest capacity is the package's own here; other tests have a smaller one (see conftest)."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(capacities, "SMALLEST_CAPACITY", OWN_SMALLEST_CAPACITY)
        yield


def spindle(sides: int) -> Meso:
    """A double pyramid: two vertices of degree ``sides``, as many of degree 4."""
    around = np.arange(sides)
    after = (around + 1) % sides
    faces = [
        np.stack([around, after, np.full(sides, sides)], 1),
        np.stack([after, around, np.full(sides, sides + 1)], 1),
    ]
    angle = 2 * np.pi * around / sides
    rim = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    return Meso.from_mesh(np.concatenate([rim, [[0, 0, 1.0], [0, 0, -1.0]]]), np.concatenate(faces))


def ragged() -> Meso:
    """A collapsed blob: degrees from 3 to many."""
    mesh = blob(31)
    meso = Meso.from_mesh(np.array(mesh.vertices), np.array(mesh.faces))
    edits.collapse_short_edges(meso, 0.25)
    return meso.compacted()


def regular() -> Meso:
    """A torus: every vertex of degree 6."""
    mesh = torus()
    return Meso.from_mesh(np.array(mesh.vertices), np.array(mesh.faces))


SURFACES = {"regular": regular, "ragged": ragged, "spindle": lambda: spindle(40), "huge spindle": lambda: spindle(300)}


def degree_counts(degrees: np.ndarray) -> list[int]:
    """How many of ``degrees`` exceed k, for k from 0 to the largest, less one."""
    return [int((degrees > k).sum()) for k in range(int(degrees.max()))]


def test_capacities_are_monotone_tight_and_few():
    """Enough room, at most 3.5 times as much from 2048 on, and three up to 20,000 vertices, nine up to a million."""
    counts = np.arange(1, 100_000, 37)
    capacities = np.array([capacity_for(int(count)) for count in counts])
    assert (capacities >= counts).all() and (np.diff(capacities) >= 0).all()
    assert (capacities <= 3.5 * counts)[counts > 2048].all()
    assert len({capacity_for(count) for count in range(1, 20_000, 97)}) == 3
    assert len({capacity_for(count) for count in range(1, 1_000_000, 97)}) == 9


@pytest.mark.parametrize("layout", [staircase(256, 6), staircase(384, 30), staircase(1024, 90), rectangle(256, 17)])
def test_levels_follow_one_another_without_gap_and_are_full_at_their_rows(layout: Layout):
    assert layout.levels[0].offset == 0 and layout.levels[0].rows == layout.capacity
    for one, two in zip(layout.levels, layout.levels[1:], strict=False):
        assert two.offset == one.end and 0 < two.rows <= one.rows
    beyond = [level.rows for level in layout.levels for _ in range(level.slots)]
    assert layout.num_slots == sum(beyond)
    assert fits(layout, layout.capacity, beyond) and not fits(layout, layout.capacity + 1, beyond)
    assert not fits(layout, layout.capacity, [*beyond, 1])  # one neighbour more than there are slots
    first = 0
    for level in layout.levels:  # one row more than a level has
        assert not fits(layout, layout.capacity, beyond[:first] + [level.rows + 1] + beyond[first + 1 :])
        first += level.slots


@settings(deadline=None)
@given(st.lists(st.integers(3, 60), min_size=4, max_size=3000).map(lambda x: -np.sort(-np.array(x))))
def test_every_vertex_has_a_slot_for_each_neighbour(degrees):
    beyond = degree_counts(degrees)
    layout = layout_for(len(degrees), beyond)
    slots = np.zeros(layout.capacity, dtype=int)
    for level in layout.levels:
        slots[: level.rows] += level.slots
    assert (slots[: len(degrees)] >= degrees).all() and fits(layout, len(degrees), beyond)


def packed_directed_edges(layout: Layout, rings, order: np.ndarray) -> list[tuple[int, int, int, int]]:
    """(i, j, after, before) of every used slot, as vertices."""
    neighbour, after, before, is_used = rings
    row = np.concatenate([np.arange(level.rows) for level in layout.levels for _ in range(level.slots)])
    columns = (row[is_used], neighbour[is_used], after[is_used], before[is_used])
    return list(zip(*(order[column].tolist() for column in columns), strict=True))


@pytest.mark.parametrize("kind", ["usual", "rectangle", "next size"])
@pytest.mark.parametrize("name", SURFACES)
def test_every_directed_edge_has_one_slot_with_its_two_apexes(name, kind):
    meso = SURFACES[name]()
    largest = int(meso.degree.max())
    layout = layout_for(meso.num_rows, packing.rows_beyond(meso.degree))
    if kind == "rectangle":
        layout = rectangle(capacity_for(meso.num_rows), largest)
    elif kind == "next size":
        layout = staircase(4 * layout.capacity, largest)
    assert fits(layout, meso.num_rows, packing.rows_beyond(meso.degree))
    order, _, fields = packing.pack(meso, layout, np.empty(0), np.dtype(np.float64))
    third = {}
    for a, b, c in meso.faces().tolist():
        third[a, b], third[b, c], third[c, a] = c, a, b
    found = packed_directed_edges(layout, fields["rings"], order)
    assert sorted(found) == sorted((i, j, third[i, j], third[j, i]) for i, j in third)

    neighbour, after, before, is_used = fields["rings"]
    row = np.concatenate([np.arange(level.rows) for level in layout.levels for _ in range(level.slots)])
    for table in (neighbour, after, before):
        assert table.dtype == np.int32 and table.shape == (layout.num_slots,)
        np.testing.assert_array_equal(table[~is_used], row[~is_used])  # an unused slot names its own row
    np.testing.assert_array_equal(np.bincount(row[is_used], minlength=layout.capacity), fields["degree"])
    assert (np.diff(fields["degree"]) <= 0).all()


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("name", SURFACES)
def test_pack_and_unpack(name, dtype):
    """Values of the vertices go in and come out, in their order; padding is still and empty."""
    meso = SURFACES[name]()
    random = np.random.default_rng(1)
    meso.poles = random.normal(size=meso.positions.shape)
    meso.has_pole = random.random(meso.num_rows) < 0.5
    meso.is_fixed = random.random(meso.num_rows) < 0.3
    area = random.uniform(1, 2, meso.num_rows)
    layout = layout_for(meso.num_rows, packing.rows_beyond(meso.degree))
    order, _, fields = packing.pack(meso, layout, area, np.dtype(dtype))
    expected = {
        "positions": meso.positions,
        "poles": meso.poles,
        "pull": meso.has_pole.astype(float),
        "free": (~meso.is_fixed).astype(float),
        "degree": meso.degree.astype(float),
        "area": area,
    }
    np.testing.assert_array_equal(np.sort(order), np.arange(meso.num_rows))
    for key, value in expected.items():
        assert fields[key].dtype == dtype and len(fields[key]) == layout.capacity
        back = packing.unpack(fields[key], order)
        assert back.dtype == np.float64
        np.testing.assert_array_equal(back, value.astype(dtype).astype(np.float64))
        assert (fields[key][meso.num_rows :] == (1 if key == "area" else 0)).all()
