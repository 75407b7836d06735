"""Triangles and edges while vertices are merged to a graph, from which the curve is extracted; merges in any order.

A merge contracts an edge. If the solid has handles, edges have homology classes (see `solid.handles`), and a merge that
would pinch a loop that the curve must keep waits until no other merge is left.
"""

import numpy as np

from msf_jax.meso import ring_tables
from msf_jax.topology import graphs


class Complex:
    """A closed surface, and then the remaining simplices; ``root`` is a union-find forest. rings: (n, K). classes:
    (n, K) or None. pinned: vertices that are not merged with each other unless forced."""

    def __init__(self, rings: np.ndarray, classes: np.ndarray | None, pinned: np.ndarray | None) -> None:
        self.pinned = set() if pinned is None else set(pinned.tolist())  # roots
        self.has_classes = classes is not None
        self.root = list(range(len(rings)))
        # apexes[u][v]: the third vertices of the faces at uv. classes[u][v]: the class of the edge from u to v.
        self.apexes, self.classes = list[dict[int, set[int]]](), list[dict[int, int]]()
        degrees, values = ring_tables.ring_degrees(rings), rings[:, :0] if classes is None else classes
        for degree, row, own in zip(degrees.tolist(), rings.tolist(), values.tolist(), strict=True):
            ring = row[:degree]
            sides = zip(ring, ring[-1:] + ring[:-1], ring[1:] + ring[:1], strict=True)
            self.apexes.append({v: {before, after} for v, before, after in sides})
            self.classes.append(dict(zip(ring, own, strict=False)))

    def find(self, u: int) -> int:
        """The vertex that u was merged into."""
        root = self.root
        while root[u] != u:
            root[u] = root[root[u]]
            u = root[u]
        return u

    def merge(self, u: int, v: int, *, force: bool) -> bool:
        """Merge the ends of an edge that has a face; False if it must wait because it would pinch a loop."""
        u, v = self.find(u), self.find(v)
        if u == v or not self.apexes[u].get(v):
            return True
        is_kept_apart = u in self.pinned and v in self.pinned
        if not force and (is_kept_apart or (self.has_classes and self._pinches(u, v))):
            return False
        self.root[v] = u
        if v in self.pinned:
            self.pinned.add(u)
        self._move_classes(u, v)
        around_v, self.apexes[v] = self.apexes[v], {}
        for x, thirds in around_v.items():  # faces (v, x, z) become (u, x, z); those with u vanish
            around_x = self.apexes[x]
            around_x.pop(v, None)
            for z in thirds:
                if z != u and x != u:
                    self.apexes[u].setdefault(x, set()).add(z)
                    around_x.setdefault(u, set()).add(z)
                around_xz = around_x.get(z)
                if around_xz is not None:
                    around_xz.discard(v)
                    if x != u and z != u:
                        around_xz.add(u)
        return True

    def open_face(self, edges: list[tuple[int, int]]) -> bool:
        """Remove a face, with the first of ``edges`` that has no other face; if every edge has several, a face of the
        first edge alone, and `cut_discs` removes the cycle later. False if no edge has a face."""
        closed = None
        for u, v in edges:
            u, v = self.find(u), self.find(v)
            thirds = self.apexes[u].get(v, ())
            if u != v and len(thirds) == 1:
                self._take_away(u, v, next(iter(thirds)))
                self.classes[u].pop(v)
                self.classes[v].pop(u)
                return True
            if u != v and thirds and closed is None:
                closed = u, v, min(thirds)
        if closed is not None:
            self._take_away(*closed)
        return closed is not None

    def _take_away(self, u: int, v: int, w: int) -> None:
        for x, y, z in ((u, v, w), (v, w, u), (w, u, v)):
            self.apexes[x][y].discard(z)
            self.apexes[y][x].discard(z)

    def edges(self) -> tuple[np.ndarray, np.ndarray]:
        """The ends (E, 2) of every remaining edge, and its class; no edges if there are no classes."""
        found = [(u, v, value) for u, classes in enumerate(self.classes) for v, value in classes.items() if u < v]
        left = np.array(found, dtype=np.int64).reshape(-1, 3)
        return left[:, :2], left[:, 2]

    def _pinches(self, u: int, v: int) -> bool:
        """Whether the class of a loop u -> v -> x -> u is not zero."""
        of_u, of_v = self.classes[u], self.classes[v]
        own = of_u[v]
        return any(x in of_u and of_u[x] != own + value for x, value in of_v.items() if x != u)

    def _move_classes(self, u: int, v: int) -> None:
        of_v, self.classes[v] = self.classes[v], {}
        own = self.classes[u].pop(v, 0)
        for x, value in of_v.items():
            self.classes[x].pop(v, None)
            if x != u:
                self.classes[u].setdefault(x, own + value)
                self.classes[x].setdefault(u, -self.classes[u][x])


def cut_discs(num: int, edges: np.ndarray, value: np.ndarray, order: np.ndarray) -> np.ndarray:
    """Which ``edges`` (E, 2) of class ``value``, of ``num`` vertices, stay if each cycle is cut whose class is zero or
    the sum of up to three others', earlier in the ``order``."""
    stays = np.ones(len(edges), dtype=bool)
    closing, around, _ = graphs.cycles(num, edges, value, np.argsort(order))
    known, sums = {0}, {0}  # classes of cycles, and sums of two of them
    for edge, one in zip(closing.tolist(), around.tolist(), strict=True):
        stays[edge] = not any(one - other in sums for other in known)
        if stays[edge]:
            known |= {one, -one}
            sums |= {other + sign * one for other in known for sign in (-1, 1)}
    return stays
