"""The surgery of Au et al. 2008: half-edge collapses down to a curve, and the recentring of its nodes.

A half-edge collapse i -> j moves vertex i, with all its edges, to where j is. It costs

    F(i, j) = F_a + 0.1 F_b,    F_a = sum over the edges gathered in i and in j of |a x (v_j - v)|^2,
                                F_b = |v_i - v_j| sum over the neighbours k of i of |v_i - v_k|,

a shape cost, of v_j's distance from the lines of edges (through v, of direction a) that have been contracted into the
two, as a quadric, and a sampling cost, which is against long edges. The cheapest goes first, of the edges that bear a
face, until there is none. What may not go is up to `complex.Complex`: a merge that would pinch a loop of the solid.
"""

import heapq

import numpy as np
from scipy import spatial

from msf_jax.host.meso.complex import Complex

SAMPLING = 0.1  # weight of the sampling cost
STALE = 1e-9  # an entry of the heap that has become dearer by more than this part goes back
CHEAPER = 0.9  # factor on a vertex's edge lengths, from which on its entries are made anew: most change by far less

Quadric = tuple[float, ...]  # xx, xy, xz, yy, yz, zz of M, then M v, and v . M v, summed over lines


def operate(complex_: Complex, positions: np.ndarray, a: np.ndarray, b: np.ndarray) -> None:
    """Collapse, in place, what bears a face, for vertices at ``positions`` (n, 3) and all edges ab (E,).

    An edge that would pinch a loop waits until all others have gone; where nothing else is left, one face is opened,
    or, without classes, one edge goes all the same. O(E log E), but for vertices of many neighbours.
    """
    work = _Costs(positions, a, b)
    heap = [(work.cost(i, j), i, j) for u, v in zip(a.tolist(), b.tolist(), strict=True) for i, j in ((u, v), (v, u))]
    heapq.heapify(heap)
    waiting: list[tuple[int, int]] = []
    has_moved = True
    while heap or waiting:
        if not heap:
            if not has_moved and complex_.has_classes and not complex_.open_face(waiting):
                return
            if not has_moved and not complex_.has_classes:
                i, j = waiting.pop()
                complex_.merge(j, i, force=True)
                waiting += work.merge(i, j)
            heap = [(work.cost(i, j), i, j) for i, j in waiting if _is_open(complex_, i, j)]
            heapq.heapify(heap)
            waiting, has_moved = [], False
            continue
        cost, i, j = heapq.heappop(heap)
        if not _is_open(complex_, i, j):
            continue
        now = work.cost(i, j)  # an entry tells what it cost then: what has been gathered since makes it dearer
        if now > cost * (1 + STALE):
            heapq.heappush(heap, (now, i, j))
        elif complex_.merge(j, i, force=False):
            has_moved = True
            for k, m in work.merge(i, j):
                if _is_open(complex_, k, m):
                    heapq.heappush(heap, (work.cost(k, m), k, m))
        else:
            waiting.append((i, j))


def _is_open(complex_: Complex, i: int, j: int) -> bool:
    """Whether i and j are still there, with an edge between them that bears a face."""
    return complex_.root[i] == i and complex_.root[j] == j and bool(complex_.apexes[i].get(j))


class _Costs:
    """Positions, neighbours and quadrics of vertices that are merged one into the other."""

    def __init__(self, positions: np.ndarray, a: np.ndarray, b: np.ndarray) -> None:
        ends, others = np.concatenate([a, b]), np.concatenate([b, a])
        along = positions[others] - positions[ends]
        length = np.linalg.norm(along, axis=1)
        along /= np.where(length > 0, length, 1.0)[:, None]
        M = np.eye(3) - along[:, :, None] * along[:, None, :]
        M[length == 0] = 0  # no line, no distance from it
        Mv = np.einsum("eij,ej->ei", M, positions[ends])
        columns = [M[:, i, j] for i in range(3) for j in range(i, 3)]
        columns += [*Mv.T, np.einsum("ei,ei->e", Mv, positions[ends])]
        num = len(positions)
        summed = [np.bincount(ends, weights=column, minlength=num) for column in columns]
        self.quadric: list[Quadric] = list(map(tuple, np.stack(summed, axis=1).tolist()))
        self.position: list[tuple[float, float, float]] = list(map(tuple, positions.tolist()))
        self.reach = np.bincount(ends, weights=length, minlength=num).tolist()  # sum of a vertex's edge lengths
        self.around: list[set[int]] = [set() for _ in range(num)]
        for i, j in zip(ends.tolist(), others.tolist(), strict=True):
            self.around[i].add(j)

    def cost(self, i: int, j: int) -> float:
        """Of the collapse of i into j."""
        x, y, z = self.position[j]
        shape = 0.0
        for xx, xy, xz, yy, yz, zz, bx, by, bz, c in (self.quadric[i], self.quadric[j]):
            shape += x * (xx * x + 2 * (xy * y + xz * z - bx)) + y * (yy * y + 2 * (yz * z - by))
            shape += z * (zz * z - 2 * bz) + c
        return max(shape, 0.0) + SAMPLING * self._length(i, j) * self.reach[i]

    def merge(self, i: int, j: int) -> list[tuple[int, int]]:
        """Merge i into j; returns the half-edges that are new, or may be much cheaper than they were."""
        around, own = self.around[i], self.around[j]
        fresh, cheaper, reach = [], [], self.reach[j]
        for k in around:
            before = self.reach[k]
            self.reach[k] -= self._length(i, k)
            self.around[k].discard(i)
            if k != j and k not in own:
                fresh += [(k, j), (j, k)]
                own.add(k)
                self.around[k].add(j)
                length = self._length(j, k)
                self.reach[k] += length
                self.reach[j] += length
            if k != j and self.reach[k] < CHEAPER * before:
                cheaper.append(k)
        self.around[i] = set()
        if self.reach[j] < CHEAPER * reach:
            cheaper.append(j)
        self.quadric[j] = tuple(p + q for p, q in zip(self.quadric[i], self.quadric[j], strict=True))
        return fresh + [(k, m) for k in cheaper for m in self.around[k]]

    def _length(self, i: int, j: int) -> float:
        (a, b, c), (x, y, z) = self.position[i], self.position[j]
        return ((a - x) ** 2 + (b - y) ** 2 + (c - z) ** 2) ** 0.5


def recentred(
    nodes: np.ndarray,
    edges: np.ndarray,
    node_of_vertex: np.ndarray,
    contracted: np.ndarray,
    vertices: np.ndarray,
    faces: np.ndarray,
) -> np.ndarray:
    """The ``nodes`` (N, 3), moved back by how far the boundaries of their regions have come in the contraction.

    The region of a node is the vertices (V,) of ``node_of_vertex``. Its boundary loops run half-way between its
    vertices and others, through the faces that have both; of all their points, the mean of ``contracted - vertices``
    (V, 3) each is taken by length, so that a short loop, around a hole in the region, counts little. A node without a
    boundary goes with the nearest that has one. A leaf goes with the node before it: as often as not its region is a
    patch on one side of a limb, and its own loop would take it out there.
    """
    label, away = node_of_vertex[faces], contracted - vertices
    num, ends, weights, moves = len(nodes), [], [], []
    for k in range(3):  # faces that have corner k on one side of a boundary, and the two others on the other
        (c, a, b), (own, other, same) = (np.roll(rows, -k, axis=1).T for rows in (faces, label))
        is_cut = (other == same) & (own != other)
        c, a, b = c[is_cut], a[is_cut], b[is_cut]
        length = np.linalg.norm(vertices[a] - vertices[b], axis=1) / 2
        moved = length[:, None] * (2 * away[c] + away[a] + away[b]) / 4
        for side in (own[is_cut], other[is_cut]):
            ends.append(side)
            weights.append(length)
            moves.append(moved)
    end, moved = np.concatenate(ends), np.concatenate(moves)
    total = np.bincount(end, weights=np.concatenate(weights), minlength=num)
    sums = [np.bincount(end, weights=moved[:, axis], minlength=num) for axis in range(3)]
    shift = np.stack(sums, axis=1) / np.where(total > 0, total, 1.0)[:, None]
    known = np.flatnonzero(total > 0)
    if len(known):
        shift = shift[known[spatial.KDTree(nodes[known]).query(nodes)[1]]]
    degree = np.bincount(edges.ravel(), minlength=num)
    for leaf, before in (edges.T, edges.T[::-1]):
        is_leaf = (degree[leaf] == 1) & (degree[before] > 1)
        shift[leaf[is_leaf]] = shift[before[is_leaf]]
    return nodes - shift
