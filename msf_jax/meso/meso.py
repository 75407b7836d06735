"""The surface while it contracts: positions, one-rings, and data of vertices.

The host edits only this object. Its arrays have a row for every vertex that existed since the last `compacted`. Merged
vertices leave dead rows with an empty ring.
"""

from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np

from msf_jax.meso import kernels, ring_tables
from msf_jax.solid.geometry import signed_volume, triangle_areas

ROWS = kernels.MesoArrays._fields  # the arrays with a row for each vertex


class Compaction(NamedTuple):
    """An edit: rows ``live`` (m,) became rows 0, 1, ..., and the others were dropped."""

    live: np.ndarray


@dataclass
class Meso:
    """A closed surface under contraction. Lengths are fractions of the input's bounding-box diagonal.

    positions: (n, 3). rings: (n, K), see `ring_tables`. degree: (n,), 0 for a dead row. poles: (n, 3), finite
    everywhere. has_pole: (n,), False where the pole must not pull. is_fixed: (n,), True where the vertex has reached
    the skeleton and no longer moves. node_of_input: (V,), the row that every vertex of the input has been merged into.
    classes: (n, K), the class of every edge (see `solid.handles`), or None for a surface without handles. scale: (n,)
    factor on lengths, up to 1, smaller on thin limbs (see `inside.balls.scales`), or None if no limb is thin. weights:
    (n, 4), w_L, w_H, w_M and smoothing of every vertex, or None if they are the same everywhere. edits: those of the
    connectivity, in order: `CollapseRound`, `SplitRound`, `Compaction`.
    """

    positions: np.ndarray
    rings: np.ndarray
    degree: np.ndarray
    poles: np.ndarray
    has_pole: np.ndarray
    is_fixed: np.ndarray
    node_of_input: np.ndarray
    classes: np.ndarray | None = None
    scale: np.ndarray | None = None
    weights: np.ndarray | None = None
    edits: list[Any] = field(default_factory=list)

    @classmethod
    def from_mesh(cls, vertices: np.ndarray, faces: np.ndarray) -> "Meso":
        """The surface before contraction: no vertex fixed or merged, no poles."""
        rings = ring_tables.rings_from_faces(faces, len(vertices))
        return cls(
            positions=np.array(vertices, dtype=np.float64),
            rings=rings,
            degree=ring_tables.ring_degrees(rings),
            poles=np.array(vertices, dtype=np.float64),
            has_pole=np.zeros(len(vertices), dtype=bool),
            is_fixed=np.zeros(len(vertices), dtype=bool),
            node_of_input=np.arange(len(vertices)),
        )

    @property
    def num_rows(self) -> int:
        """The number of rows, with dead rows."""
        return len(self.positions)

    @property
    def num_live(self) -> int:
        """The number of vertices of the surface."""
        return int(np.count_nonzero(self.degree))

    def faces(self) -> np.ndarray:
        """(F, 3), the rows of the corners."""
        return ring_tables.faces_from_rings(self.rings)

    def volume(self) -> float:
        """Signed enclosed volume, one sixth of the sum of det(a, b, c) over the faces."""
        return signed_volume(self.positions, self.faces())

    def area(self) -> float:
        """Area of the surface."""
        return float(triangle_areas(self.positions[self.faces()]).sum())

    def surface(self) -> kernels.MesoArrays:
        """The arrays for kernels, which may change them."""
        neutral = {"scale": np.ones(self.num_rows), "weights": np.empty((self.num_rows, 0))}
        if self.classes is None:
            neutral["classes"] = np.zeros_like(self.rings)
        for name in ROWS:  # a kernel would change a copy of an array of another kind
            if (value := getattr(self, name)) is not None:
                kind = kernels.MesoArrays.__annotations__[name].__metadata__[0]
                setattr(self, name, np.require(value, kind, ["C", "W"]))
        return kernels.MesoArrays(**(neutral | self.arrays()))

    def arrays(self) -> dict[str, np.ndarray]:
        """The arrays with a row for each vertex, by name, without those that are None."""
        return {name: value for name in ROWS if (value := getattr(self, name)) is not None}

    def append(self, count: int, whole: dict[str, np.ndarray]) -> None:
        """Add ``count`` dead rows, with zeros. ``whole`` has the arrays with spare rows of the call before, if any."""
        num = self.num_rows + count
        for name, value in self.arrays().items():
            if name not in whole or value.base is not whole[name] or len(whole[name]) < num:
                whole[name] = np.full((num * 5 // 4, *value.shape[1:]), -1 if name == "rings" else 0, value.dtype)
                whole[name][: len(value)] = value
            setattr(self, name, whole[name][:num])

    def widen(self, degree: int) -> None:
        """Add slots until every row has at least ``degree``."""
        missing = ring_tables.ring_capacity(degree) - self.rings.shape[1]
        if missing > 0:
            self.rings = np.pad(self.rings, ((0, 0), (0, missing)), constant_values=-1)
            if self.classes is not None:
                self.classes = np.pad(self.classes, ((0, 0), (0, missing)))

    def copied(self) -> "Meso":
        return replace(self, **{name: value.copy() for name, value in vars(self).items() if value is not None})

    def compacted(self) -> "Meso":
        """The same surface without its dead rows."""
        live = np.flatnonzero(self.degree)
        if len(live) == self.num_rows:
            return self
        number = np.full(self.num_rows + 1, -1)  # the last entry serves the padding -1
        number[live] = np.arange(len(live))
        self.edits.append(Compaction(live))
        rows = {name: value[live] for name, value in self.arrays().items()}
        return replace(self, **(rows | {"rings": number[rows["rings"]], "node_of_input": number[self.node_of_input]}))
